//! Through change points, from both sides and on the very point, against the motion in closed form.

use assur_check::Finding;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_number::{Dd, Real};
use assur_words::{Describe, name, text};

use super::closed::{KNOWN, Known};
use crate::stability::exact::{ORDERS, transfer};
use crate::stability::row::{Comparison, DISTANCES, FACTOR};
use crate::stability::tests::Law;

pub(super) static LAW: Law = Law {
    section: "Across change points",
    along: "distance of the coordinate from the change point, rad",
    expected: "16 eps / determinant^(1, 2, 3) for PF0, PF1, PF2, in parts of the largest number of its order \
               around; where the motion is interpolated across the change point, the health where that \
               begins",
};

/// All rows, or one that says why there are none.
pub(crate) fn rows() -> Vec<Comparison> {
    KNOWN.iter().flat_map(of).collect()
}

fn of(known: &Known) -> Vec<Comparison> {
    let linkage = assur_scene::read("bench.toml", &known.scene())
        .map_err(|error| error.to_string())
        .and_then(|mechanism| Linkage::compile(mechanism).map_err(|error| error.to_string()));
    let mut rows = Vec::new();
    match linkage {
        Ok(linkage) => {
            for &center in known.centers {
                for distance in DISTANCES.into_iter().chain([0.0]) {
                    for side in [-1.0, 1.0] {
                        step(known, &linkage, (center, side * distance), &mut rows);
                    }
                }
            }
        }
        Err(why) => rows.push(subject(known.name, "pf0", 0.0, 0.0, 0.0).judged_or(Err(name(why)), false)),
    }
    rows
}

fn subject(place: &str, quantity: &'static str, distance: f64, health: f64, bound: f64) -> Comparison {
    let place = name(place.to_owned());
    let finding = Finding::within(place, bound);
    Comparison { method: text!("stability-closed-forms"), quantity, distance, health, finding }
}

fn step(known: &Known, linkage: &Linkage, (center, offset): (f64, f64), rows: &mut Vec<Comparison>) {
    let q = center + offset;
    let exact = known.bodies(Dd::from_f64(q));
    let mut position = linkage.position();
    let solved = linkage.solve(q, Order::Second, &mut position);
    let place = format!("{}, change point at {:.0} deg", known.name, center.to_degrees());
    let health = match linkage.interpolation(q) {
        Some(across) => known_health(linkage, across.center + across.half_width),
        None => position.health[0].abs(),
    };
    let sizes = sizes(known, center);
    for (order, quantity) in ORDERS.into_iter().enumerate() {
        let power = i32::try_from(order).unwrap_or(2) + 1;
        let bound = FACTOR * f64::EPSILON * health.powi(-power);
        let outcome = match &solved {
            Ok(()) => Ok(transfer(&position.bodies[1..], &exact, &[0, 1, 2], order, 1.0, sizes[order])),
            Err(error) => Err(error.describe()),
        };
        rows.push(subject(&place, quantity, offset.abs(), health, bound).judged_or(outcome, false));
    }
}

/// Determinant of the only group.
fn known_health(linkage: &Linkage, q: f64) -> f64 {
    let mut position = linkage.position();
    match linkage.solve(q, Order::Place, &mut position) {
        Ok(()) => position.health[0].abs(),
        Err(_) => f64::NAN,
    }
}

/// Largest number of each order on the change point and beside it: where PF2 passes through zero nothing is lost.
fn sizes(known: &Known, center: f64) -> [f64; 3] {
    let mut sizes = [1.0_f64; 3];
    for offset in [-REACH, -0.25 * REACH, 0.0, 0.25 * REACH, REACH] {
        for body in known.bodies(Dd::from_f64(center + offset)) {
            let orders = [[body.x, body.y, body.c], [body.x1, body.y1, body.w1], [body.x2, body.y2, body.w2]];
            for (size, numbers) in sizes.iter_mut().zip(orders) {
                *size = numbers.iter().fold(*size, |size, number| size.max(number.to_f64().abs()));
            }
        }
    }
    sizes
}

/// Around the change point, rad.
const REACH: f64 = 0.0125;
