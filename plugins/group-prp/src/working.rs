//! The working of type 4 by hand.

use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory};
use assur_words::text;
use assur_worksheet::dyad::{across, along, compose, minus, opposite, plus};
use assur_worksheet::{Expr, Point, Sheet, Symbol, WorkingPlugin};

use crate::Prp;

inventory::submit! {
    WorkingPlugin { group: "prp", crate_name: env!("CARGO_PKG_NAME"), motion, reactions }
}

/// The vector with given components across two directions.
fn meet(t: &[[Expr; 2]; 2], b: &[Expr; 2], d: &Expr) -> [Expr; 2] {
    [0, 1].map(|i| (&b[0] * &t[1][i] - &b[1] * &t[0][i]) / d)
}

fn motion(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Prp::<f64>::new(frame)?;
    let through = pairs.slides.each_ref().map(|slide| sheet.point(slide.body, slide.through));
    for slide in &pairs.slides {
        sheet.outline_angle(slide.body);
    }
    let guides = pairs.slides.each_ref().map(|slide| sheet.guide_of(slide));
    let t = guides.each_ref().map(|guide| guide.t.clone());
    let name = sheet.place_name(pairs.links[0], pairs.inner.own);
    let own = pairs.pin;
    let k = [0, 1].map(|i| {
        let what = text!("prp-working-offset", pin = &name, guide = i + 1);
        sheet.fixed_length(Symbol::from("k").of(i + 1), pairs.slides[i].offset(own[i]), what)
    });
    sheet.note(text!("prp-working-intersection", pin = &name));
    let (d_name, b_name) = (sheet.local("D"), sheet.local(Symbol::from("b").of(2)));
    let d = sheet.work(d_name, &across(&t[0], &t[1]), "");
    let [k1, k2] = k;
    let b = [k1, sheet.work(b_name, &(k2 + across(&t[1], &through[1].from(&through[0], 0))), "m")];
    let c = sheet.vector(&name, 0, &plus(&through[0].pf[0], &meet(&t, &b, &d)));
    derive(sheet, &pairs, &through, &t, &c, &d);
    let pin = sheet.point(pairs.links[0], own[0]);
    for (i, guide) in guides.iter().enumerate() {
        let slide = &pairs.slides[i];
        let tilt = sheet.tilt(slide.id, pairs.links[i], slide.tilt_angle);
        sheet.place_turned(pairs.links[i], &pin, own[i], &(&guide.alpha + tilt), slide.body);
    }
    Ok(())
}

/// Across each guide the pin moves like the coinciding point of its carrier; a rotating guide adds the Coriolis term.
fn derive(
    sheet: &mut Sheet,
    pairs: &Prp<f64>,
    through: &[Point; 2],
    t: &[[Expr; 2]; 2],
    c: &[Expr; 2],
    d: &Expr,
) {
    let name = sheet.place_name(pairs.links[0], pairs.inner.own);
    let units = sheet.units.length;
    let of = [1_usize, 2].map(|i| sheet.local(i));
    sheet.note(text!("prp-working-first", pin = &name));
    let mut v = [(); 2].map(|()| [Expr::zero(), Expr::zero()]);
    let mut b = [Expr::zero(), Expr::zero()];
    for i in 0..2 {
        let under = sheet.under(pairs.slides[i].body, &through[i], c, 1);
        v[i] = sheet.components("V", &of[i], &under, units[1]);
        let label = sheet.local(Symbol::from("b").prime(1).of(i + 1));
        b[i] = sheet.work_unless_zero(label, &across(&t[i], &v[i]), units[1]);
    }
    let c1 = sheet.vector(&name, 1, &meet(t, &b, d));
    let coriolis_of = |i: usize| Symbol::from("a").of(text!("prp-working-coriolis")).of(i + 1);
    let [one, two] = [0, 1].map(|i| sheet.local(coriolis_of(i)));
    sheet.note(text!("prp-working-second", one = &one, two = &two));
    for i in 0..2 {
        let body = pairs.slides[i].body;
        let under = sheet.under(body, &through[i], c, 2);
        let w = sheet.components("W", &of[i], &under, units[2]);
        let rate = sheet.angle(body)[1].clone();
        let relative = along(&t[i], &minus(&c1, &v[i]));
        let label = sheet.local(coriolis_of(i));
        let coriolis = sheet.work_unless_zero(label, &(Expr::number(2.0) * rate * relative), units[2]);
        let label = sheet.local(Symbol::from("b").prime(2).of(i + 1));
        b[i] = sheet.work_unless_zero(label, &(across(&t[i], &w) + coriolis), units[2]);
    }
    let c2 = sheet.vector(&name, 2, &meet(t, &b, d));
    sheet.set_point(pairs.links[0], pairs.inner.own, [c.clone(), c1, c2]);
}

fn reactions(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Prp::<f64>::new(frame)?;
    let own = pairs.pin;
    let c = sheet.point(pairs.links[0], own[0]);
    let t = pairs.slides.each_ref().map(|slide| sheet.guide_of(slide).t);
    let d = sheet.recall("D");
    let given = pairs.links.map(|link| sheet.resultant(link));
    sheet.note(text!("prp-working-transmitted", pin = &c.name));
    let part = [0, 1].map(|i| {
        let name = sheet.local(Symbol::from("F").of(i + 1));
        sheet.work_unless_zero(name, &along(&t[i], &given[i]), "N")
    });
    let n = t.each_ref().map(|t| [-&t[1], t[0].clone()]);
    let inner = [0, 1].map(|i| (&part[1] * &n[0][i] + &part[0] * &n[1][i]) / &d);
    let inner = sheet.pin_reaction(pairs.inner.id, pairs.links[0], &c, &inner);
    sheet.note(text!("prp-working-rest"));
    for (i, at_pin) in [inner.clone(), opposite(&inner)].iter().enumerate() {
        let (link, slide) = (pairs.links[i], &pairs.slides[i]);
        let on_line = sheet.point(link, slide.own);
        let name = sheet.local(Symbol::from("N").of(i + 1));
        let normal = sheet.work(name, &-across(&t[i], &plus(&given[i], at_pin)), "N");
        let force = compose(&t[i], &Expr::zero(), &normal);
        let moment = -(sheet.moment_about(link, &on_line) + c.moment_about(&on_line, at_pin));
        let (force, moment) = sheet.slide_reaction(slide.id, link, &on_line, &force, &moment);
        sheet.hand_on(slide.body, &on_line, &force, &moment);
    }
    Ok(())
}
