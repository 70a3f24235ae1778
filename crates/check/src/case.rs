//! One state with the data that the checks of forces compare.

use assur_force::{JointReaction, LoadState, Loads, Reactions};
use assur_group::Wrench;

use crate::subject::{Solved, Subject};
use crate::written::Items;

/// One state, its loads and its reactions.
pub(crate) struct Case<'a> {
    pub(crate) subject: &'a Subject<'a>,
    pub(crate) loads: &'a Loads,
    pub(crate) one: &'a Solved,
    pub(crate) state: &'a LoadState,
    /// The loads, computed independently from the scene.
    pub(crate) items: &'a Items,
    /// The result of each method; `None` where it fails.
    pub(crate) answers: &'a [Option<Reactions>],
    /// Index of the method whose results all checks use.
    pub(crate) full: usize,
    /// The result of that method.
    pub(crate) reactions: &'a Reactions,
    /// The result of that method by pins and slides.
    pub(crate) joints: Vec<JointReaction>,
}

impl Case<'_> {
    /// How much greater the rounding of the reactions is than that of the loads: a force of friction has that of the normal force
    /// times the coefficient.
    pub(crate) fn condition(&self) -> f64 {
        let frictions = &self.subject.linkage.mechanism.frictions;
        self.one.condition * frictions.iter().map(|friction| friction.coefficient).fold(1.0, f64::max)
    }
}

/// The largest force of a result, N; moments of slides count as forces by the typical length.
pub(crate) fn largest(reactions: &[Wrench<f64>], scale: f64) -> f64 {
    reactions.iter().map(|r| r.fx.hypot(r.fy) + r.m.abs() / scale).fold(0.0, f64::max)
}
