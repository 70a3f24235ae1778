//! The exact motion across a change point, where the equations of the group say nothing.
//!
//! Lengths that are rounded are no exact change point: their exact motion turns away within 1e-8 rad of it. What is meant is
//! the smooth motion, which nodes farther out determine.

use std::f64::consts::PI;

use assur_group::{Body, Order};
use assur_kinematics::{Chain, Interpolation, Linkage};
use assur_number::{Dd, Real};

/// Nodes on each side, from the reach to six times as far, at the zeros of Chebyshev's polynomial in the square of the
/// distance: of a motion that changes within ten times the reach 30 digits are left.
const NODES: u32 = 32;
const SPREAD: f64 = 6.0;

/// All bodies at `q`, from nodes in 32 digits on both sides of the change point; `None` where one can't be solved.
pub(crate) fn interpolated(
    linkage: &Linkage,
    chain: &Chain<Dd>,
    across: Interpolation,
    q: f64,
) -> Option<Vec<Body<Dd>>> {
    let places: Vec<f64> = (0..NODES)
        .flat_map(|i| {
            let cosine = (PI * (f64::from(i) + 0.5) / f64::from(NODES)).cos();
            let square = 0.5 * ((SPREAD * SPREAD + 1.0) + (SPREAD * SPREAD - 1.0) * cosine);
            [1.0, -1.0].map(|side| across.center + side * square.sqrt() * across.half_width)
        })
        .collect();
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
            let values = b.numbers();
            for (total, value) in total.iter_mut().zip(values) {
                *total += weight * value;
            }
        }
    }
    sum.map(|all| all.into_iter().map(Body::of_numbers).collect())
}
