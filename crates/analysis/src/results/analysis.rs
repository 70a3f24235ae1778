//! The whole result.

use assur_check::Check;
use serde::Serialize;

use crate::results::{Cycle, Dynamics, Integration, Starts, StructureReport, Survey, Table};

/// All results of one calculation of a scene. What doesn't apply is absent or empty.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// Title of the scene; may be empty.
    pub title: String,
    /// The input link and its coordinate.
    pub input: InputReport,
    /// Mobility, groups, formula.
    pub structure: StructureReport,
    /// Positions that exist, in order, each with its number: all, or of very many every so many.
    pub positions: Table,
    /// What is known about all positions.
    pub survey: Survey,
    /// What lets single blocks of positions be calculated again.
    pub starts: Starts,
    /// Positions that have no solution.
    pub failures: Vec<Failure>,
    /// Transient and steady motion: samples over time.
    pub trajectory: Table,
    /// Periodic regime, drive, flywheel.
    pub dynamics: Option<Dynamics>,
    /// How a transient motion was found.
    pub integration: Option<Integration>,
    /// Why the requested motion is not found; results that do not depend on it are given nevertheless.
    pub no_motion: Option<String>,
    /// What had to be left out, and what was decided during the calculation.
    pub notes: Vec<String>,
    /// Reactions over the cycle, contacts, plans.
    pub cycle: Cycle,
    /// Checks of the numbers.
    pub checks: Vec<Check>,
    /// Residuals of the checked positions, which [`positions`](Self::positions) have as well.
    pub residuals: Table,
}

impl Analysis {
    /// Whether all positions are kept.
    pub fn is_complete(&self) -> bool {
        self.positions.len() == self.survey.rows
    }

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
