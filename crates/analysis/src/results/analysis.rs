//! The whole result.

use assur_check::Check;
use serde::Serialize;

use crate::results::{Cycle, Dynamics, Integration, MotionSample, PositionResult, StructureReport};

/// All results of one calculation of a scene. Sections that don't apply are absent.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Analysis {
    /// Version of the format of the results: 1.
    pub format: u32,
    /// Title of the scene; may be empty.
    pub title: String,
    /// The input link and its coordinate.
    pub input: InputReport,
    /// Mobility, groups, formula.
    pub structure: StructureReport,
    /// The positions that exist, in order; their `index` shows which are missing.
    pub positions: Vec<PositionResult>,
    /// Positions that have no solution.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub failures: Vec<Failure>,
    /// Transient and steady motion: samples over time.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub trajectory: Vec<MotionSample>,
    /// Periodic regime, drive, flywheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dynamics: Option<Dynamics>,
    /// How a transient motion was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub integration: Option<Integration>,
    /// Why the requested motion is not found; results that do not depend on it are given nevertheless.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_motion: Option<String>,
    /// What had to be left out, and what was decided during the calculation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Reactions over the cycle, contacts, plans.
    #[serde(flatten)]
    pub cycle: Cycle,
    /// Checks of the numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<Check>,
}

impl Analysis {
    /// The version of the format that is written.
    pub const FORMAT: u32 = 1;

    /// Whether a position, the motion, or a check, failed.
    pub fn failed(&self) -> bool {
        self.no_motion.is_some() || !self.failures.is_empty() || self.checks.iter().any(Check::failed)
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
