//! The reference of the walks: the mechanism in about 32 digits.

use std::f64::consts::PI;

use assur_group::{Body, Wrench};
use assur_kinematics::{Chain, Interpolation, Linkage};
use assur_number::{Dd, Real, greater};

use crate::chart::work::closed;

/// Number of nodes on each side of the interpolation across a change point, from its reach to six times as far, at the
/// zeros of the Chebyshev polynomial in the square of the distance: enough for 30 digits of a motion that is analytic
/// within ten times the reach.
const NODES: u32 = 32;
const SPREAD: f64 = 6.0;

/// The mechanism in double-double.
pub(crate) struct Exact<'a> {
    linkage: &'a Linkage,
    chain: Chain<Dd>,
}

/// Motion, reactions and determinants at one coordinate.
pub(crate) struct Reference {
    pub(crate) bodies: Vec<Body<Dd>>,
    pub(crate) pairs: Vec<Wrench<Dd>>,
    /// Of each group: the size of its dimensionless determinant.
    pub(crate) health: Vec<f64>,
}

impl<'a> Exact<'a> {
    /// `None` where a kernel can't be built in this number type.
    pub(crate) fn of(linkage: &'a Linkage) -> Option<Self> {
        let chain = Chain::compile(&linkage.mechanism, &linkage.structure).ok()?;
        Some(Self { linkage, chain })
    }

    /// Everything at a coordinate under the given loads; `None` where the position or its reactions do not exist.
    pub(crate) fn at(&self, q: f64, loads: &[Wrench<f64>]) -> Option<Reference> {
        let bodies = match self.linkage.interpolation(q) {
            Some(across) => self.interpolated(across, q)?,
            None => closed(self.linkage, &self.chain, q)?,
        };
        let mut loads: Vec<_> = loads.iter().map(|one| one.map(Dd::from_f64)).collect();
        let mut pairs = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        for kernel in self.chain.groups.iter().rev() {
            kernel.reactions(&bodies, &mut loads, &mut pairs).ok()?;
        }
        let health = self.chain.groups.iter().map(|kernel| kernel.health(&bodies).abs().to_f64()).collect();
        Some(Reference { bodies, pairs, health })
    }

    /// All bodies at `q` near a change point, where the equations of the group have the form 0/0.
    ///
    /// With rounded lengths the change point is not exact: the exact motion departs within 1e-8 rad of it. The intended
    /// motion is the smooth one, which nodes farther out determine.
    fn interpolated(&self, across: Interpolation, q: f64) -> Option<Vec<Body<Dd>>> {
        let nodes: Vec<f64> = (0..NODES)
            .flat_map(|i| {
                let cosine = (PI * (f64::from(i) + 0.5) / f64::from(NODES)).cos();
                let square = 0.5 * ((SPREAD * SPREAD + 1.0) + (SPREAD * SPREAD - 1.0) * cosine);
                [1.0, -1.0].map(|side| across.center + side * square.sqrt() * across.half_width)
            })
            .collect();
        let mut sum = vec![[Dd::ZERO; 10]; self.linkage.structure.links];
        for (k, &node) in nodes.iter().enumerate() {
            let others = nodes.iter().enumerate().filter(|(i, _)| *i != k);
            let weight = others.fold(Dd::ONE, |weight, (_, &other)| {
                let from_other = |at: f64| Dd::from_f64(at) - Dd::from_f64(other);
                weight * from_other(q) / from_other(node)
            });
            for (total, body) in sum.iter_mut().zip(&closed(self.linkage, &self.chain, node)?) {
                for (total, value) in total.iter_mut().zip(body.numbers()) {
                    *total += weight * value;
                }
            }
        }
        Some(sum.into_iter().map(Body::of_numbers).collect())
    }
}

/// The three orders of transfer functions, as rows name them.
pub(crate) const ORDERS: [&str; 3] = ["pf0", "pf1", "pf2"];

/// The numbers of a body that belong to an order, lengths in units of `scale`, angles and directions unchanged.
fn of_order<T: Real>(body: &Body<T>, order: usize, scale: f64) -> [T; 4] {
    let unit = T::from_f64(1.0 / scale);
    let [x, y, c, s, x1, y1, w1, x2, y2, w2] = body.numbers();
    match order {
        0 => [x * unit, y * unit, c, s],
        1 => [x1 * unit, y1 * unit, w1, T::ZERO],
        _ => [x2 * unit, y2 * unit, w2, T::ZERO],
    }
}

/// Largest deviation of some links, relative to the largest size of the order, but at least to `floor`: where a
/// derivative passes through zero its digits are lost, which is no error.
pub(crate) fn transfer(
    found: &[Body<f64>],
    reference: &[Body<Dd>],
    links: &[usize],
    order: usize,
    scale: f64,
    floor: f64,
) -> f64 {
    let (mut deviation, mut size) = (0.0, floor);
    for &link in links {
        let exact = of_order(&reference[link], order, scale);
        let mine = of_order(&found[link].map(Dd::from_f64), order, scale);
        for (exact, mine) in exact.into_iter().zip(mine) {
            size = f64::max(size, exact.to_f64().abs());
            deviation = greater(deviation, (mine - exact).to_f64().abs());
        }
    }
    deviation / size
}

/// Largest number of an order of some links, at least `floor`.
pub(crate) fn size(reference: &[Body<Dd>], links: &[usize], order: usize, scale: f64, floor: f64) -> f64 {
    let numbers = links.iter().flat_map(|&link| of_order(&reference[link], order, scale));
    numbers.fold(floor, |size, number| size.max(number.to_f64().abs()))
}

/// Largest deviation of reactions relative to the largest of them, moments in units of force times `scale`.
pub(crate) fn reactions(found: &[Wrench<f64>], reference: &[Wrench<Dd>], scale: f64) -> f64 {
    let (mut deviation, mut size) = (0.0, f64::MIN_POSITIVE);
    for (found, exact) in found.iter().zip(reference) {
        let pairs = [(found.fx, exact.fx, 1.0), (found.fy, exact.fy, 1.0), (found.m, exact.m, scale)];
        for (found, exact, unit) in pairs {
            size = f64::max(size, exact.to_f64().abs() / unit);
            deviation = greater(deviation, (Dd::from_f64(found) - exact).to_f64().abs() / unit);
        }
    }
    deviation / size
}
