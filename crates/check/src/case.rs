//! One state with the data that the checks of forces compare.

use assur_force::{JointReaction, LoadState, Loads, Reactions};
use assur_group::Wrench;

use crate::subject::{Solved, Subject};
use crate::written::Items;

/// Rounding errors of the solution of one group, or of the system of all, and of a sum of the terms of one load. In
/// units of the last place of the largest force, per unit of the condition number.
pub(crate) const ROUNDINGS: f64 = 64.0;

/// Rounding of a sum over loads and of its terms, as part of their sizes `total`; `added`: the sizes of all its partial sums, one
/// after the other. Each addition may be off by half a unit of what was added up before, in the sum of the program and in that
/// of the check, and equal loads round in the same direction.
pub(crate) fn rounding_of_sum(added: f64, total: f64) -> f64 {
    ROUNDINGS.max(added / total) * f64::EPSILON
}

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

/// The largest force of a result, N; moments of slides count as forces by the typical length.
pub(crate) fn largest(reactions: &[Wrench<f64>], scale: f64) -> f64 {
    reactions.iter().map(|r| r.fx.hypot(r.fy) + r.m.abs() / scale).fold(0.0, f64::max)
}
