//! The working of type 2 by hand.

use assur_group::plane::{direction, dot};
use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory};
use assur_words::text;
use assur_worksheet::dyad::{across, along, compose, minus, opposite, plus};
use assur_worksheet::{Expr, Guide, Point, Sheet, WorkingPlugin};

use crate::Rrp;

inventory::submit! {
    WorkingPlugin { group: "rrp", crate_name: env!("CARGO_PKG_NAME"), motion, reactions }
}

fn motion(sheet: &mut Sheet, frame: &GroupFrame, bodies: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rrp::<f64>::new(frame)?;
    let [rod, slider] = pairs.links;
    let end = &pairs.slide;
    let (a, through) = (sheet.point(pairs.end.body, pairs.end.at), sheet.point(end.body, end.through));
    sheet.outline(&a);
    sheet.outline_angle(end.body);
    let guide = sheet.guide_of(&pairs.slide);
    let name = sheet.place_name(rod, pairs.inner.own);
    let length = sheet.rod(rod, pairs.end.own, pairs.inner.own);
    let what = text!("rrp-working-offset", pin = &name);
    let k = sheet.fixed_length("k", pairs.slide.offset(pairs.inner.at), what);
    let number = bodies[rod].point(pairs.inner.own);
    let foot = bodies[rod].point(pairs.end.own);
    let t = bodies[end.body].turned(direction(end.along_angle));
    let ahead = dot(t, [number[0] - foot[0], number[1] - foot[1]]) >= 0.0;
    sheet.note(text!("rrp-working-distances", a = &a.name, pin = &name));
    sheet.note(if ahead {
        text!("rrp-working-ahead", pin = &name)
    } else {
        text!("rrp-working-behind", pin = &name)
    });
    let (delta_name, sigma_name) = (sheet.local("δ"), sheet.local("σ"));
    let delta = sheet.work(delta_name, &(across(&guide.t, &through.from(&a, 0)) + k), "m");
    let l = &length.length;
    let root = ((l - &delta) * (l + &delta)).sqrt();
    let sigma = sheet.work(sigma_name, &(if ahead { root } else { -root }), "m");
    let c = sheet.vector(&name, 0, &plus(&a.pf[0], &compose(&guide.t, &sigma, &delta)));
    let r = minus(&c, &a.pf[0]);
    let phi = sheet.rod_angle(rod, &length, &r);
    let slider_angle = &guide.alpha + sheet.tilt(end.id, slider, end.tilt_angle);
    let (first, second) = derive(sheet, &pairs, [&a, &through], &guide, [&c, &r], [&delta, &sigma]);
    sheet.place(rod, &a, pairs.end.own, [phi, first, second]);
    let pin = sheet.point(rod, pairs.inner.own);
    sheet.place_turned(slider, &pin, pairs.inner.at, &slider_angle, end.body);
    Ok(())
}

/// Writes PF1 and PF2 of the rod's angle and of the inner pin, which is added to the sheet.
fn derive(
    sheet: &mut Sheet,
    pairs: &Rrp<f64>,
    [a, through]: [&Point; 2],
    guide: &Guide,
    [c, r]: [&[Expr; 2]; 2],
    [delta, sigma]: [&Expr; 2],
) -> (Expr, Expr) {
    let (rod, body, t) = (pairs.links[0], pairs.slide.body, &guide.t);
    let name = sheet.place_name(rod, pairs.inner.own);
    let (carrier, of) = (sheet.body_name(body), sheet.group_number());
    let units = sheet.units.length;
    sheet.note(if body == 0 {
        text!("rrp-working-fixed-guide", carrier, pin = &name)
    } else {
        text!("rrp-working-moving-guide", carrier, pin = &name)
    });
    let v = sheet.under(body, through, c, 1);
    let v = sheet.components("V", &of, &v, units[1]);
    let first = across(t, &minus(&v, &a.pf[1])) / sigma;
    let first = sheet.link_rate(rod, 1, &first);
    let turned = |rate: &Expr| [-(rate * &r[1]), rate * &r[0]];
    let c1 = sheet.vector(&name, 1, &plus(&a.pf[1], &turned(&first)));
    let rate = sheet.angle(body)[1].clone();
    let mut coriolis = Expr::zero();
    if rate.is_zero() {
        sheet.note(text!("rrp-working-normal-part", a = &a.name, pin = &name));
    } else {
        let [v_r, a_cor] = [sheet.local("v").of("r"), sheet.local("a").of(text!("rrp-working-coriolis"))];
        let remark = text!(
            "rrp-working-normal-and-coriolis",
            a = &a.name,
            pin = &name,
            relative = &v_r,
            coriolis = &a_cor
        );
        sheet.note(remark);
        let relative = sheet.work(v_r, &along(t, &minus(&c1, &v)), units[1]);
        coriolis = sheet.work(a_cor, &(Expr::number(2.0) * &rate * &relative), units[2]);
    }
    let w = sheet.under(body, through, c, 2);
    let w = sheet.components("W", &of, &w, units[2]);
    let normal = sheet.normal_part(name.clone().of(&a.name), &first, r);
    let part = across(t, &minus(&w, &a.pf[2])) + coriolis + first.squared() * delta;
    let second = sheet.link_rate(rod, 2, &(part / sigma));
    let c2 = sheet.vector(&name, 2, &plus(&plus(&a.pf[2], &turned(&second)), &normal));
    sheet.set_point(rod, pairs.inner.own, [c.clone(), c1, c2]);
    (first, second)
}

fn reactions(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rrp::<f64>::new(frame)?;
    let [rod, slider] = pairs.links;
    let end = pairs.slide;
    let a = sheet.point(pairs.end.body, pairs.end.at);
    let c = sheet.point(rod, pairs.inner.own);
    let on_line = sheet.point(slider, end.own);
    let guide = sheet.guide_of(&pairs.slide);
    let (one, two) = (sheet.resultant(rod), sheet.resultant(slider));
    let slides = sheet.body_name(slider);
    sheet.note(text!("rrp-working-moments", slider = slides, pin = &c.name, a = &a.name));
    let [ft, fn_] = ["t", "n"].map(|part| sheet.local("F").of(part));
    let along_guide = sheet.work_unless_zero(ft, &along(&guide.t, &two), "N");
    let m = sheet.moment_about(rod, &a);
    let (delta, sigma) = (sheet.recall("δ"), sheet.recall("σ"));
    let normal = sheet.work_unless_zero(fn_, &((&delta * &along_guide - m) / sigma), "N");
    let inner = compose(&guide.t, &along_guide, &normal);
    let inner = sheet.pin_reaction(pairs.inner.id, rod, &c, &inner);
    sheet.note(text!("rrp-working-forces"));
    let at_a = sheet.pin_reaction(pairs.end.id, rod, &a, &opposite(&plus(&one, &inner)));
    sheet.hand_on(pairs.end.body, &a, &at_a, &Expr::zero());
    let name = sheet.local("N");
    let pressure = sheet.work(name, &(normal - across(&guide.t, &two)), "N");
    let force = compose(&guide.t, &Expr::zero(), &pressure);
    let load = sheet.moment_about(slider, &on_line);
    let moment = -(load + c.moment_about(&on_line, &opposite(&inner)));
    let (force, moment) = sheet.slide_reaction(pairs.slide.id, slider, &on_line, &force, &moment);
    sheet.hand_on(end.body, &on_line, &force, &moment);
    Ok(())
}
