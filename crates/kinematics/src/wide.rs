//! The chain in about 32 digits, for the few questions about an assembly that 16 digits can't answer.
//!
//! Near a meeting of two ways the determinant is a square root of what the lengths leave: 16 digits of the lengths are 8
//! of the determinant, and whether the ways meet, pass beside each other or leave a gap is lost in them.

use assur_group::{AssurGroup, Body, GroupError, Number};
use assur_mechanism::Mechanism;
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::Chain;

/// The chain in double-double.
#[derive(Debug)]
pub(crate) struct Wide {
    pub(crate) chain: Chain<Dd>,
}

impl Wide {
    /// `None` where a kernel can't be built: the caller then does without.
    pub(crate) fn of(mechanism: &Mechanism, structure: &Structure) -> Option<Self> {
        Chain::compile(mechanism, structure).ok().map(|chain| Self { chain })
    }

    /// Kernel of a group.
    pub(crate) fn kernel(&self, group: usize) -> &dyn AssurGroup<Dd> {
        self.chain.groups[group].as_ref()
    }

    /// Bodies in this precision; the input link is placed anew, its direction to all digits.
    pub(crate) fn bodies(&self, q: Dd, from: &[Body<f64>]) -> Vec<Body<Dd>> {
        let mut bodies: Vec<_> = from.iter().map(|body| body.map(Dd::from_f64)).collect();
        self.chain.set_input(q, &mut bodies);
        bodies
    }

    /// Square of the determinant of a group, the groups before it in the ways given (`None`: not needed).
    pub(crate) fn square(&self, q: Dd, from: &[Body<f64>], ways: &[Option<usize>]) -> Result<Dd, GroupError> {
        let mut bodies = self.bodies(q, from);
        let mut health = Dd::ZERO;
        for (kernel, way) in self.chain.groups.iter().zip(ways) {
            let Some(way) = way else { continue };
            health = kernel.place(&mut bodies, *way)?;
        }
        Ok(health * health)
    }
}

/// The way of each group that is needed.
pub(crate) fn needed_ways<T: Number>(chain: &Chain<T>, way: impl Fn(usize) -> usize) -> Vec<Option<usize>> {
    let way = |i: usize| way(i).min(chain.groups[i].ways() - 1);
    (0..chain.groups.len()).map(|i| chain.is_needed(i).then(|| way(i))).collect()
}
