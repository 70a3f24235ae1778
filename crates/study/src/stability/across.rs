//! The exact motion across a change point, where even 32 digits are lost in 0/0.

use assur_group::{Body, Order};
use assur_kinematics::{Chain, Linkage};
use assur_number::{Dd, Real};

/// Nodes on each side, a thousandth of a radian apart: the polynomial of degree 11 is exact to some 1e-30 there, and each
/// node keeps more than 20 digits of PF2.
const NODES: i32 = 6;
const STEP: f64 = 1e-3;

/// All bodies at `q`, from nodes in 32 digits on both sides of the change point; `None` where one can't be solved.
pub(crate) fn interpolated(
    linkage: &Linkage,
    chain: &Chain<Dd>,
    center: f64,
    q: f64,
) -> Option<Vec<Body<Dd>>> {
    let unit = STEP * if linkage.angular() { 1.0 } else { linkage.structure.scale };
    let places: Vec<f64> =
        (-NODES..=NODES).filter(|k| *k != 0).map(|k| center + unit * f64::from(k)).collect();
    let mut sum: Option<Vec<[Dd; 10]>> = None;
    for (k, &place) in places.iter().enumerate() {
        let weight =
            places.iter().enumerate().filter(|(i, _)| *i != k).fold(Dd::ONE, |weight, (_, &other)| {
                let part = |at: f64| Dd::from_f64(at) - Dd::from_f64(other);
                weight * part(q) / part(place)
            });
        let (mut bodies, mut health) = (chain.bodies(), vec![Dd::ZERO; chain.groups.len()]);
        let ways = linkage.ways.at(place);
        chain.solve(Dd::from_f64(place), ways, Order::Second, &mut bodies, &mut health).ok()?;
        let total = sum.get_or_insert_with(|| vec![[Dd::ZERO; 10]; bodies.len()]);
        for (total, b) in total.iter_mut().zip(&bodies) {
            let values = [b.x, b.y, b.c, b.s, b.x1, b.y1, b.w1, b.x2, b.y2, b.w2];
            for (total, value) in total.iter_mut().zip(values) {
                *total += weight * value;
            }
        }
    }
    let body = |[x, y, c, s, x1, y1, w1, x2, y2, w2]: [Dd; 10]| Body { x, y, c, s, x1, y1, w1, x2, y2, w2 };
    sum.map(|all| all.into_iter().map(body).collect())
}
