//! The result of a force analyzer, and the place where the balancing load acts.

use assur_group::{Body, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Balance, InputPair, Mechanism};

use crate::ForceError;

/// Reactions in all pairs, and the balancing load: the result of an analyzer, with its scratch memory.
#[derive(Debug, Clone, PartialEq)]
pub struct Reactions {
    /// For each pair of the structure: force (N) and moment (N m) on its body `a`, about the pin or about the point of the sliding
    /// link. NaN where the method gives no reactions.
    pub pairs: Vec<Wrench<f64>>,
    /// Moment (N m, counter-clockwise) or force (N, along the slide or along the direction of `[balance]`) that keeps the
    /// mechanism in its motion.
    pub balancing: f64,
    /// For each group, whether its equations are solved. The reactions of the others stay exactly zero: those of a
    /// group that carries no load, or is not placed. Respected by methods that solve [by
    /// groups](crate::AnalyzerPlugin::by_groups).
    pub solved: Vec<bool>,
    /// Scratch of a method: one wrench for each pair.
    pub scratch_pairs: Vec<Wrench<f64>>,
    /// Scratch of a method: one wrench for each body.
    pub scratch_bodies: Vec<Wrench<f64>>,
}

impl Reactions {
    /// Memory for the reactions of a mechanism, of all groups that are placed.
    pub fn new(linkage: &Linkage) -> Self {
        let groups = 0..linkage.groups().len();
        let solved = groups.map(|group| linkage.chain.is_needed(group)).collect();
        let pairs = vec![Wrench::ZERO; linkage.structure.pairs.len()];
        let bodies = vec![Wrench::ZERO; linkage.structure.links];
        Self { scratch_pairs: pairs.clone(), pairs, balancing: f64::NAN, solved, scratch_bodies: bodies }
    }

    /// Memory for the reactions, without the groups of these indices, which carry no load: their reactions stay zero.
    #[must_use]
    pub fn without_idle(mut self, carrying: &[bool]) -> Self {
        for (solved, carrying) in self.solved.iter_mut().zip(carrying) {
            *solved &= *carrying;
        }
        self
    }
}

/// A balancing load of size 1 on a link that is not the drive's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitBalance {
    /// The loaded link.
    pub link: usize,
    /// The load about the origin of the link's frame.
    pub wrench: Wrench<f64>,
}

impl UnitBalance {
    /// The load of `[balance]`; `None` where the balancing load acts on the input link with its coordinate.
    #[inline]
    pub fn of(mechanism: &Mechanism, bodies: &[Body<f64>]) -> Option<Self> {
        let balance = mechanism.balance?;
        let mut wrench = Wrench::ZERO;
        let link = match balance {
            Balance::Moment(link) => {
                let pinned = matches!(mechanism.input.pair, InputPair::Pin(_));
                if pinned && link == mechanism.input.link {
                    return None;
                }
                wrench.m = 1.0;
                link
            }
            Balance::Force { at, angle } => {
                wrench.add_at(bodies[at.link].arm(at.at), [angle.cos(), angle.sin()], 0.0);
                at.link
            }
        };
        Some(Self { link, wrench })
    }

    /// Virtual power of the load for dq = 1.
    #[inline]
    pub fn power(&self, bodies: &[Body<f64>]) -> f64 {
        power(&self.wrench, &bodies[self.link])
    }

    /// The size of the balancing load at which the drive is idle: `others` is the drive's load under all other loads,
    /// `unit` that under a balancing load of size 1.
    ///
    /// # Errors
    ///
    /// [`ForceError::IdleBalance`] where the load does no work.
    pub fn size(
        &self,
        others: f64,
        unit: f64,
        linkage: &Linkage,
        position: &Position,
    ) -> Result<f64, ForceError> {
        /// Below this part of a typical displacement a transfer function is rounding.
        const LEAST_SHARE: f64 = 1e-12;
        let scale = linkage.structure.scale;
        let is_force = self.wrench.fx != 0.0 || self.wrench.fy != 0.0;
        let typical = match (is_force, linkage.mechanism.input.pair) {
            (true, InputPair::Pin(_)) => scale,
            (true, InputPair::Slide(_)) | (false, InputPair::Pin(_)) => 1.0,
            (false, InputPair::Slide(_)) => 1.0 / scale,
        };
        let share = unit.abs() / typical;
        if share > LEAST_SHARE {
            return Ok(-others / unit);
        }
        Err(ForceError::IdleBalance { load: self.words(linkage), coordinate: position.coordinate, share })
    }

    fn words(&self, linkage: &Linkage) -> String {
        let is_force = self.wrench.fx != 0.0 || self.wrench.fy != 0.0;
        let kind = if is_force { "force" } else { "moment" };
        format!("the balancing {kind} on `{}`", linkage.mechanism.links[self.link].name)
    }
}

/// Virtual power of a wrench about the origin of a body for dq = 1.
#[inline]
pub fn power(wrench: &Wrench<f64>, body: &Body<f64>) -> f64 {
    wrench.fx * body.x1 + wrench.fy * body.y1 + wrench.m * body.w1
}
