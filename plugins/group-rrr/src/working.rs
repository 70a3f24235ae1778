//! The working of type 1 by hand.

use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory, plane::cross};
use assur_words::text;
use assur_worksheet::dyad::{across, along, minus, opposite, plus};
use assur_worksheet::{Expr, Point, Rod, Sheet, Symbol, WorkingPlugin};

use crate::Rrr;

inventory::submit! {
    WorkingPlugin { group: "rrr", crate_name: env!("CARGO_PKG_NAME"), motion, reactions }
}

fn motion(sheet: &mut Sheet, frame: &GroupFrame, bodies: &[Body<f64>]) -> Result<(), BuildError> {
    let pins = Rrr::<f64>::new(frame)?;
    let outer = [0, 1].map(|i| sheet.point(pins.ends[i].body, pins.ends[i].at));
    for point in &outer {
        sheet.outline(point);
    }
    let own = [pins.inner.own, pins.inner.at];
    let rods = [0, 1].map(|i| sheet.rod(pins.links[i], pins.ends[i].own, own[i]));
    let reach = |i: usize| {
        let link: &Body<f64> = &bodies[pins.links[i]];
        minus_numbers(link.point(own[i]), link.point(pins.ends[i].own))
    };
    let left = cross(reach(0), reach(1)) > 0.0;
    let c = place(sheet, &pins, &outer, &rods, left);
    let r = [0, 1].map(|i| minus(&c, &outer[i].pf[0]));
    let phi = [0, 1].map(|i| sheet.rod_angle(pins.links[i], &rods[i], &r[i]));
    derive(sheet, &pins, &outer, &c, &r, phi);
    Ok(())
}

fn minus_numbers(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Writes the two circles: the inner pin from its foot on the line of the outer pins, and its height above it.
fn place(sheet: &mut Sheet, pins: &Rrr<f64>, outer: &[Point; 2], rods: &[Rod; 2], left: bool) -> [Expr; 2] {
    let name = sheet.place_name(pins.links[0], pins.inner.own);
    let [a, b] = [&outer[0].name, &outer[1].name];
    sheet.note(text!("rrr-working-circles", a, b, pin = &name));
    sheet.note(if left {
        text!("rrr-working-left", a, b, pin = &name)
    } else {
        text!("rrr-working-right", a, b, pin = &name)
    });
    let d = outer[1].from(&outer[0], 0);
    let (local_d, alpha, beta) = (sheet.local("d"), sheet.local("α"), sheet.local("β"));
    let square = (d[0].squared() + d[1].squared()).sqrt();
    let length = sheet.work(local_d, &square, "m");
    let [l1, l2] = [&rods[0].length, &rods[1].length];
    let two = Expr::number(2.0);
    let twice = &two * length.squared();
    let part = (length.squared() + l1.squared() - l2.squared()) / &twice;
    let alpha = sheet.work(alpha, &part, "");
    let far = (l1 + l2).squared() - length.squared();
    let near = length.squared() - (l1 - l2).squared();
    let height = (far * near).sqrt() / &twice;
    let beta = sheet.work(beta, &(if left { height } else { -height }), "");
    let [xa, ya] = &outer[0].pf[0];
    let x = xa + &alpha * &d[0] - &beta * &d[1];
    let y = ya + &alpha * &d[1] + &beta * &d[0];
    sheet.vector(&name, 0, &[x, y])
}

/// Writes PF1 and PF2 from the loop A - C - B, with the determinant D = r1 x r2.
fn derive(
    sheet: &mut Sheet,
    pins: &Rrr<f64>,
    outer: &[Point; 2],
    c: &[Expr; 2],
    r: &[[Expr; 2]; 2],
    phi: [Expr; 2],
) {
    let name = sheet.place_name(pins.links[0], pins.inner.own);
    let [a, b] = [outer[0].name.clone(), outer[1].name.clone()];
    let [phi1, phi2] = pins.links.map(|link| Symbol::from("φ").prime(1).of(sheet.body_name(link)));
    let [a1, b1] = [&a, &b].map(|end| end.clone().prime(1));
    sheet.note(text!(
        "rrr-working-loop",
        a = &a,
        b = &b,
        a1 = &a1,
        b1 = &b1,
        phi1 = &phi1,
        phi2 = &phi2,
        pin = &name
    ));
    sheet.note(text!("rrr-working-determinant"));
    let local = sheet.local("D");
    let determinant = sheet.work(local, &across(&r[0], &r[1]), "m²");
    let v = outer[1].from(&outer[0], 1);
    let solve = |v: &[Expr; 2], i: usize| along(v, &r[1 - i]) / &determinant;
    let first = [0, 1].map(|i| sheet.link_rate(pins.links[i], 1, &solve(&v, i)));
    let turned = |rate: &Expr, r: &[Expr; 2]| [-(rate * &r[1]), rate * &r[0]];
    let c1 = sheet.vector(&name, 1, &plus(&outer[0].pf[1], &turned(&first[0], &r[0])));
    sheet.note(text!("rrr-working-normal-parts", a = &a, b = &b, pin = &name));
    let normal = [0, 1].map(|i| sheet.normal_part(name.clone().of(&outer[i].name), &first[i], &r[i]));
    let w = plus(&outer[1].from(&outer[0], 2), &minus(&normal[1], &normal[0]));
    let unit = sheet.units.length[2];
    let w = sheet.components("W", sheet.group_number(), &w, unit);
    let second = [0, 1].map(|i| sheet.link_rate(pins.links[i], 2, &solve(&w, i)));
    let c2 = plus(&plus(&outer[0].pf[2], &turned(&second[0], &r[0])), &normal[0]);
    let c2 = sheet.vector(&name, 2, &c2);
    sheet.set_point(pins.links[0], pins.inner.own, [c.clone(), c1, c2]);
    for (i, phi) in phi.into_iter().enumerate() {
        let rates = [phi, first[i].clone(), second[i].clone()];
        sheet.place(pins.links[i], &outer[i], pins.ends[i].own, rates);
    }
}

fn reactions(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pins = Rrr::<f64>::new(frame)?;
    let outer = [0, 1].map(|i| sheet.point(pins.ends[i].body, pins.ends[i].at));
    let c = sheet.point(pins.links[0], pins.inner.own);
    let r = [0, 1].map(|i| c.from(&outer[i], 0));
    let forces = pins.links.map(|link| sheet.resultant(link));
    let [a, b] = outer.each_ref().map(|point| &point.name);
    sheet.note(text!("rrr-working-moments", a, b, pin = &c.name));
    let m = [0, 1].map(|i| sheet.moment_about(pins.links[i], &outer[i]));
    let d = sheet.recall("D");
    let inner = [0, 1].map(|i| -((&m[1] * &r[0][i] + &m[0] * &r[1][i]) / &d));
    let inner = sheet.pin_reaction(pins.inner.id, pins.links[0], &c, &inner);
    sheet.note(text!("worksheet-forces-on-links"));
    let at_ends = [opposite(&plus(&forces[0], &inner)), minus(&inner, &forces[1])];
    for (i, force) in at_ends.iter().enumerate() {
        let end = &pins.ends[i];
        let force = sheet.pin_reaction(end.id, pins.links[i], &outer[i], force);
        sheet.hand_on(end.body, &outer[i], &force, &Expr::zero());
    }
    Ok(())
}
