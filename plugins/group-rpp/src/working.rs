//! The working of type 5 by hand.

use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory};
use assur_worksheet::dyad::{across, along, compose, minus, opposite, plus};
use assur_worksheet::{Expr, Guide, Point, Sheet, WorkingPlugin};

use crate::Rpp;

inventory::submit! {
    WorkingPlugin { group: "rpp", crate_name: env!("CARGO_PKG_NAME"), motion, reactions }
}

fn motion(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rpp::<f64>::new(frame)?;
    let [one, two] = pairs.links;
    let carrier = pairs.outer.body;
    let a = sheet.point(pairs.end.body, pairs.end.at);
    let through = sheet.point(carrier, pairs.outer.through);
    sheet.outline("outer pin", &a);
    sheet.outline_angle("body with the outer guide", carrier);
    let (theta, guides) = angles(sheet, &pairs);
    let t = guides.each_ref().map(|guide| guide.t.clone());
    let name = sheet.place_name(two, pairs.outer.own);
    let what = format!("distance of {name} to the left of {}, across the inner guide", a.name);
    let k = sheet.fixed_length("k", pairs.across, &what);
    sheet.note(format!(
        "PF0: {name} is on the outer guide and keeps its distance from {} across the inner one",
        a.name
    ));
    let (d_name, b_name) = (sheet.local("D"), sheet.local("b"));
    let d = sheet.work(&d_name, &across(&t[0], &t[1]), "");
    let b = sheet.work(&b_name, &across(&t[1], &through.from(&a, 0)), "m");
    let to_p = [0, 1].map(|i| (&k * &t[1][i] - &b * &t[0][i]) / &d);
    let p = sheet.vector(&name, 0, &plus(&a.pf[0], &to_p));
    let pf = derive(sheet, &pairs, [&a, &through], &t, &p, &d);
    let p = sheet.set_point(two, pairs.outer.own, pf);
    let tilt = fixed(
        sheet,
        "tilt",
        pairs.inner.id,
        pairs.inner.tilt_angle,
        "of the first link from the inner guide",
    );
    sheet.place_turned(two, &p, pairs.outer.own, &theta, carrier);
    sheet.place_turned(one, &a, pairs.end.own, &(&guides[0].alpha + tilt), carrier);
    Ok(())
}

fn fixed(sheet: &mut Sheet, letter: &str, pair: usize, value: f64, what: &str) -> Expr {
    let name = format!("{letter}_{}", sheet.pair_tag(pair));
    sheet.fixed_angle(&name, value, what)
}

/// Writes the angle of the link between the guides; returns inner and outer guide.
fn angles(sheet: &mut Sheet, pairs: &Rpp<f64>) -> (Expr, [Guide; 2]) {
    sheet.note("the links can't turn against the body with the outer guide: all angles are known");
    let (inner, outer) = (&pairs.inner, &pairs.outer);
    let second = sheet.guide_of(outer);
    let tilt = fixed(sheet, "tilt", outer.id, outer.tilt_angle, "of the second link from the outer guide");
    let theta = &second.alpha + tilt;
    let gamma = fixed(sheet, "gamma", inner.id, inner.along_angle, "of the inner guide in the second link");
    let tag = sheet.pair_tag(inner.id);
    let alpha = sheet.work(&format!("alpha_{tag}"), &(&theta + gamma), "rad");
    let t = sheet.components("t", &tag, &[alpha.cos(), alpha.sin()], "");
    (theta, [Guide { alpha, t }, second])
}

/// Relative to the carrier g of the outer guide, the pin moves with v and a; the point P moves along the outer guide.
fn derive(
    sheet: &mut Sheet,
    pairs: &Rpp<f64>,
    [a, through]: [&Point; 2],
    t: &[[Expr; 2]; 2],
    p: &[Expr; 2],
    d: &Expr,
) -> [[Expr; 2]; 3] {
    let carrier = pairs.outer.body;
    let (units, rate) = (sheet.units.length, sheet.angle(carrier)[1].clone());
    let name = sheet.place_name(pairs.links[1], pairs.outer.own);
    let g = sheet.body_name(carrier).to_owned();
    let (v_name, u_name) = (sheet.local("v"), sheet.local("u"));
    sheet.note(format!(
        "PF1: seen from {g}, {} moves with v, and {name} with u along the outer guide",
        a.name
    ));
    let under = [&a.pf[0], p].map(|point| sheet.under(carrier, through, point, 1));
    let of = sheet.group_number();
    let v = sheet.components("v", &of, &minus(&a.pf[1], &under[0]), units[1]);
    let u = sheet.work_unless_zero(&u_name, &(across(&t[0], &v) / d), units[1]);
    let relative = [0, 1].map(|i| &u * &t[1][i]);
    let p1 = sheet.vector(&name, 1, &plus(&under[1], &relative));
    let words = if rate.is_zero() { "" } else { ", without and with the Coriolis part 2 phi' x (v, u)" };
    sheet.note(format!("PF2: the same with the accelerations a and c{words}"));
    let twice = Expr::number(2.0) * &rate;
    let coriolis = |v: &[Expr; 2]| [-(&twice * &v[1]), &twice * &v[0]];
    let under = [&a.pf[0], p].map(|point| sheet.under(carrier, through, point, 2));
    let acceleration = minus(&minus(&a.pf[2], &under[0]), &coriolis(&v));
    let acceleration = sheet.components("a", &of, &acceleration, units[2]);
    let c_name = v_name.replacen('v', "c", 1);
    let c = sheet.work_unless_zero(&c_name, &(across(&t[0], &acceleration) / d), units[2]);
    let turning = plus(&under[1], &coriolis(&relative));
    let p2 = sheet.vector(&name, 2, &plus(&turning, &[0, 1].map(|i| &c * &t[1][i])));
    [p.clone(), p1, p2]
}

fn reactions(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rpp::<f64>::new(frame)?;
    let [one, two] = pairs.links;
    let a = sheet.point(pairs.end.body, pairs.end.at);
    let p = sheet.point(two, pairs.outer.own);
    let on_inner = sheet.point(one, pairs.inner.own);
    let outer = &pairs.outer;
    let t2 = sheet.guide_of(outer).t;
    let t1 = {
        let tag = sheet.pair_tag(pairs.inner.id);
        ["x", "y"].map(|axis| sheet.find(&format!("t{axis}_{tag}")).unwrap_or_else(Expr::zero))
    };
    let d = sheet.recall("D");
    let forces = pairs.links.map(|link| sheet.resultant(link));
    sheet.note(format!("along the outer guide {} transmits its load to the inner one", sheet.body_name(two)));
    let name = sheet.local("N1");
    let normal = sheet.work_unless_zero(&name, &(along(&t2, &forces[1]) / d), "N");
    let inner = compose(&t1, &Expr::zero(), &normal);
    sheet.note(format!("moments about {} give the moment in the inner guide", a.name));
    let moment = -(sheet.moment_about(one, &a) + on_inner.moment_about(&a, &inner));
    let (inner, moment) = sheet.slide_reaction(pairs.inner.id, one, &on_inner, &inner, &moment);
    let at_a = sheet.pin_reaction(pairs.end.id, one, &a, &opposite(&plus(&forces[0], &inner)));
    sheet.hand_on(pairs.end.body, &a, &at_a, &Expr::zero());
    sheet.note("the rest is carried by the outer guide");
    let name = sheet.local("N2");
    let pressure = sheet.work(&name, &-across(&t2, &minus(&forces[1], &inner)), "N");
    let force = compose(&t2, &Expr::zero(), &pressure);
    let load = sheet.moment_about(two, &p) - on_inner.moment_about(&p, &inner) - moment;
    let (force, moment) = sheet.slide_reaction(outer.id, two, &p, &force, &-load);
    sheet.hand_on(outer.body, &p, &force, &moment);
    Ok(())
}
