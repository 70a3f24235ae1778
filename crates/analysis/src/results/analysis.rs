//! The whole result.

use serde::Serialize;

use crate::results::{Cycle, Dynamics, Integration, PositionResult, StructureReport, Trajectory};

/// Everything that one calculation of a scene found. Sections that don't apply are absent.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Analysis {
    /// Version of the form of the results: 1.
    pub format: u32,
    /// Title of the scene; may be empty.
    pub title: String,
    /// The input link and its coordinate.
    pub input: InputReport,
    /// Mobility, groups, formula.
    pub structure: StructureReport,
    /// The positions that exist, in order; their `index` tells which are missing.
    pub positions: Vec<PositionResult>,
    /// Positions that have no solution.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub failures: Vec<Failure>,
    /// Transient and steady motion: the course over time.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub trajectory: Vec<Trajectory>,
    /// Periodic regime, drive, flywheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dynamics: Option<Dynamics>,
    /// How a transient motion was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub integration: Option<Integration>,
    /// Why the motion that was asked for is not found; what does not depend on it is told nevertheless.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_motion: Option<String>,
    /// What had to be left out, and what was decided on the way.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Reactions over the cycle, contacts, plans.
    #[serde(flatten)]
    pub cycle: Cycle,
    /// Checks of the numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<CheckRow>,
}

impl Analysis {
    /// The version of the form that is written.
    pub const FORMAT: u32 = 1;

    /// Whether a position, the motion, or a check, failed.
    pub fn failed(&self) -> bool {
        self.no_motion.is_some() || !self.failures.is_empty() || self.checks.iter().any(CheckRow::failed)
    }
}

/// The input link and its coordinate.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InputReport {
    /// Name of the link.
    pub link: String,
    /// Whether the coordinate is an angle (rad), otherwise a displacement (m).
    pub angular: bool,
    /// Whether the balancing load is a moment (N m), otherwise a force (N).
    pub balancing_is_moment: bool,
}

/// A position that has no solution, or only a part of one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Failure {
    /// Number of the position.
    pub index: usize,
    /// Its coordinate, rad or m.
    pub coordinate: f64,
    /// What is missing, where and by how much.
    pub message: String,
}

/// The largest residual of one check.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckRow {
    /// Name of the check.
    pub name: String,
    /// The largest residual, in the check's own measure.
    pub residual: f64,
    /// What it must not exceed.
    pub limit: f64,
    /// Number of the position of the largest residual; absent where it belongs to none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<usize>,
    /// The place of the largest residual in words: a link, a pair.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub place: String,
    /// What is compared, and where the limit comes from.
    pub reason: String,
    /// Positions that could not be judged, at least not in full.
    pub left_out: usize,
    /// Why, for the first of them.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub why_left_out: String,
    /// Whether it says anything: something failed, or one position at least could be judged in full. Otherwise it is neither
    /// `ok` nor failed.
    pub judged: bool,
    /// Whether it says something, and everything that could be judged holds.
    pub ok: bool,
}

impl CheckRow {
    /// Whether something exceeds its limit. A check that could not judge anything does not fail.
    pub fn failed(&self) -> bool {
        self.judged && !self.ok
    }
}
