//! The working of type 5 by hand.

use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory};
use assur_words::text;
use assur_worksheet::dyad::{across, along, compose, minus, opposite, plus};
use assur_worksheet::{Expr, Guide, Point, Sheet, Symbol, WorkingPlugin};

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
    sheet.outline(&a);
    sheet.outline_angle(carrier);
    let (theta, guides) = angles(sheet, &pairs);
    let t = guides.each_ref().map(|guide| guide.t.clone());
    let name = sheet.place_name(two, pairs.outer.own);
    let what = text!("rpp-working-offset", a = &a.name, point = &name);
    let k = sheet.fixed_length("k", pairs.across, what);
    sheet.note(text!("rpp-working-position", a = &a.name, point = &name));
    let (d_name, b_name) = (sheet.local("D"), sheet.local("b"));
    let d = sheet.work(d_name, &across(&t[0], &t[1]), "");
    let b = sheet.work(b_name, &across(&t[1], &through.from(&a, 0)), "m");
    let to_p = [0, 1].map(|i| (&k * &t[1][i] - &b * &t[0][i]) / &d);
    let p = sheet.vector(&name, 0, &plus(&a.pf[0], &to_p));
    let pf = derive(sheet, &pairs, [&a, &through], &t, &p, &d);
    let p = sheet.set_point(two, pairs.outer.own, pf);
    let tilt = sheet.tilt(pairs.inner.id, one, pairs.inner.tilt_angle);
    sheet.place_turned(two, &p, pairs.outer.own, &theta, carrier);
    sheet.place_turned(one, &a, pairs.end.own, &(&guides[0].alpha + tilt), carrier);
    Ok(())
}

/// Writes the angle of the link between the guides; returns inner and outer guide.
fn angles(sheet: &mut Sheet, pairs: &Rpp<f64>) -> (Expr, [Guide; 2]) {
    sheet.note(text!("rpp-working-angles"));
    let (inner, outer) = (&pairs.inner, &pairs.outer);
    let second = sheet.guide_of(outer);
    let tilt = sheet.tilt(outer.id, pairs.links[1], outer.tilt_angle);
    let theta = &second.alpha + tilt;
    let tag = sheet.pair_name(inner.id);
    let what = text!("worksheet-guide-angle", link = sheet.body_name(pairs.links[1]));
    let gamma = sheet.fixed_angle(Symbol::from("γ").of(&tag), inner.along_angle, what);
    let alpha = sheet.work(Symbol::from("α").of(&tag), &(&theta + gamma), "rad");
    let t = sheet.components("t", tag, &[alpha.cos(), alpha.sin()], "");
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
    let carrier_name = sheet.body_name(carrier);
    sheet.note(text!("rpp-working-first", carrier = carrier_name, a = &a.name, point = &name));
    let under = [&a.pf[0], p].map(|point| sheet.under(carrier, through, point, 1));
    let of = sheet.group_number();
    let v = sheet.components("v", &of, &minus(&a.pf[1], &under[0]), units[1]);
    let u = sheet.work_unless_zero(sheet.local("u"), &(across(&t[0], &v) / d), units[1]);
    let relative = [0, 1].map(|i| &u * &t[1][i]);
    let p1 = sheet.vector(&name, 1, &plus(&under[1], &relative));
    sheet.note(if rate.is_zero() {
        text!("rpp-working-second")
    } else {
        text!("rpp-working-second-with-coriolis")
    });
    let twice = Expr::number(2.0) * &rate;
    let coriolis = |v: &[Expr; 2]| [-(&twice * &v[1]), &twice * &v[0]];
    let under = [&a.pf[0], p].map(|point| sheet.under(carrier, through, point, 2));
    let acceleration = minus(&minus(&a.pf[2], &under[0]), &coriolis(&v));
    let acceleration = sheet.components("a", of, &acceleration, units[2]);
    let c = sheet.work_unless_zero(sheet.local("c"), &(across(&t[0], &acceleration) / d), units[2]);
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
    let t1 = sheet.direction_of(pairs.inner.id).map(|part| part.unwrap_or_else(Expr::zero));
    let d = sheet.recall("D");
    let forces = pairs.links.map(|link| sheet.resultant(link));
    sheet.note(text!("rpp-working-transmitted", link = sheet.body_name(two)));
    let name = sheet.local(Symbol::from("N").of(1));
    let normal = sheet.work_unless_zero(name, &(along(&t2, &forces[1]) / d), "N");
    let inner = compose(&t1, &Expr::zero(), &normal);
    sheet.note(text!("rpp-working-moments", a = &a.name));
    let moment = -(sheet.moment_about(one, &a) + on_inner.moment_about(&a, &inner));
    let (inner, moment) = sheet.slide_reaction(pairs.inner.id, one, &on_inner, &inner, &moment);
    let at_a = sheet.pin_reaction(pairs.end.id, one, &a, &opposite(&plus(&forces[0], &inner)));
    sheet.hand_on(pairs.end.body, &a, &at_a, &Expr::zero());
    sheet.note(text!("rpp-working-rest"));
    let name = sheet.local(Symbol::from("N").of(2));
    let pressure = sheet.work(name, &-across(&t2, &minus(&forces[1], &inner)), "N");
    let force = compose(&t2, &Expr::zero(), &pressure);
    let load = sheet.moment_about(two, &p) - on_inner.moment_about(&p, &inner) - moment;
    let (force, moment) = sheet.slide_reaction(outer.id, two, &p, &force, &-load);
    sheet.hand_on(outer.body, &p, &force, &moment);
    Ok(())
}
