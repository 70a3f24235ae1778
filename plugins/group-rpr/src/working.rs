//! The working of type 3 by hand.

use assur_group::plane::{direction, dot, minus as minus_numbers};
use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory};
use assur_words::text;
use assur_worksheet::dyad::{across, along, compose, minus, opposite, plus};
use assur_worksheet::{Expr, Point, Sheet, Symbol, WorkingPlugin};

use crate::Rpr;

inventory::submit! {
    WorkingPlugin { group: "rpr", crate_name: env!("CARGO_PKG_NAME"), motion, reactions }
}

fn motion(sheet: &mut Sheet, frame: &GroupFrame, bodies: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rpr::<f64>::new(frame)?;
    let outer = [0, 1].map(|i| sheet.point(pairs.ends[i].body, pairs.ends[i].at));
    for point in &outer {
        sheet.outline(point);
    }
    let end = pairs.inner;
    let t = bodies[pairs.links[1]].turned(direction(end.along_angle));
    let [a, b] = [0, 1].map(|i| bodies[pairs.links[i]].point(pairs.ends[i].own));
    let ahead = dot(t, minus_numbers(a, b)) >= 0.0;
    let (e, s, t) = place(sheet, &pairs, &outer, ahead);
    let tag = sheet.pair_name(pairs.inner.id);
    let theta = sheet.work(Symbol::from("α").of(&tag), &t[1].atan2(&t[0]), "rad");
    let [slider, guide] = pairs.links;
    let tilt = sheet.tilt(pairs.inner.id, slider, end.tilt_angle);
    let what = text!("worksheet-guide-angle", link = sheet.body_name(guide));
    let gamma = sheet.fixed_angle(Symbol::from("γ").of(tag), end.along_angle, what);
    let phi = [sheet.link_angle(slider, &(&theta + tilt)), sheet.link_angle(guide, &(&theta - gamma))];
    derive(sheet, &pairs, &outer, [&e, &s], &t, phi);
    Ok(())
}

/// Writes the right triangle of the outer pins and the guide: offset, distance along the guide, direction of the
/// guide.
fn place(sheet: &mut Sheet, pairs: &Rpr<f64>, outer: &[Point; 2], ahead: bool) -> (Expr, Expr, [Expr; 2]) {
    let [a, b] = [outer[0].name.clone(), outer[1].name.clone()];
    let e = sheet.fixed_length("e", pairs.e, text!("rpr-working-offset", a = &a, b = &b));
    sheet.note(text!("rpr-working-components", a = &a, b = &b));
    sheet.note(if ahead {
        text!("rpr-working-ahead", a = &a, b = &b)
    } else {
        text!("rpr-working-behind", a = &a, b = &b)
    });
    let (d_name, s_name, t_name) = (sheet.local("d"), sheet.local("s"), sheet.pair_name(pairs.inner.id));
    let d = outer[0].from(&outer[1], 0);
    let number = sheet.group_number();
    let d = sheet.components("d", number, &d, "m");
    let length = sheet.work(d_name, &(d[0].squared() + d[1].squared()).sqrt(), "m");
    let square = length.squared();
    let root = (&square - e.squared()).sqrt();
    let s = sheet.work(s_name, &(if ahead { root } else { -root }), "m");
    let t = [(&s * &d[0] + &e * &d[1]) / &square, (&s * &d[1] - &e * &d[0]) / &square];
    let t = sheet.components("t", t_name, &t, "");
    (e, s, t)
}

fn derive(
    sheet: &mut Sheet,
    pairs: &Rpr<f64>,
    outer: &[Point; 2],
    [e, s]: [&Expr; 2],
    t: &[Expr; 2],
    phi: [Expr; 2],
) {
    let [slider, guide] = pairs.links;
    let units = (sheet.units.length, sheet.units.angle);
    sheet.note(text!("rpr-working-first"));
    let of = sheet.group_number();
    let d1 = outer[0].from(&outer[1], 1);
    let d1 = sheet.components(Symbol::from("d").prime(1), &of, &d1, units.0[1]);
    let first = sheet.link_rate(guide, 1, &(across(t, &d1) / s));
    let slider_first = sheet.link_rate(slider, 1, &first);
    sheet.note(text!("rpr-working-second"));
    let d2 = outer[0].from(&outer[1], 2);
    let d2 = sheet.components(Symbol::from("d").prime(2), of, &d2, units.0[2]);
    let name = sheet.local(Symbol::from("s").prime(1));
    let s1 = sheet.work_unless_zero(name, &(along(t, &d1) + e * &first), units.0[1]);
    let part = across(t, &d2) - Expr::number(2.0) * &s1 * &first + e * first.squared();
    let second = sheet.link_rate(guide, 2, &(part / s));
    let slider_second = sheet.link_rate(slider, 2, &second);
    let [one, two] = phi;
    sheet.place(slider, &outer[0], pairs.ends[0].own, [one, slider_first, slider_second]);
    sheet.place(guide, &outer[1], pairs.ends[1].own, [two, first, second]);
}

fn reactions(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rpr::<f64>::new(frame)?;
    let outer = [0, 1].map(|i| sheet.point(pairs.ends[i].body, pairs.ends[i].at));
    let slider = pairs.links[0];
    let on_line = sheet.point(slider, pairs.inner.own);
    let t = sheet.guide_of(&pairs.inner).t;
    let s = sheet.recall("s");
    let forces = pairs.links.map(|link| sheet.resultant(link));
    sheet.note(text!("rpr-working-moments"));
    let m = [0, 1].map(|i| sheet.moment_about(pairs.links[i], &outer[i]));
    let name = sheet.local("N");
    let normal = sheet.work_unless_zero(name, &((&m[0] + &m[1]) / s), "N");
    let force = compose(&t, &Expr::zero(), &normal);
    let moment = if on_line.name == outer[0].name {
        -&m[0]
    } else {
        -(&m[0] + &normal * along(&t, &on_line.from(&outer[0], 0)))
    };
    let (force, _) = sheet.slide_reaction(pairs.inner.id, slider, &on_line, &force, &moment);
    sheet.note(text!("worksheet-forces-on-links"));
    let at_ends = [opposite(&plus(&forces[0], &force)), minus(&force, &forces[1])];
    for (i, force) in at_ends.iter().enumerate() {
        let end = &pairs.ends[i];
        let force = sheet.pin_reaction(end.id, pairs.links[i], &outer[i], force);
        sheet.hand_on(end.body, &outer[i], &force, &Expr::zero());
    }
    Ok(())
}
