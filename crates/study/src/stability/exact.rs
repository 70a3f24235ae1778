//! The reference of the walks: the mechanism in about 32 digits.

use std::f64::consts::PI;

use assur_group::{Body, Wrench};
use assur_kinematics::{Chain, Interpolation, Linkage};
use assur_number::{Dd, Real};

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
