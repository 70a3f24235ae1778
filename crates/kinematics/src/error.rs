//! Errors in compiling a mechanism and in calculating a position.

use assur_group::{BuildError, GroupError};
use assur_structure::StructureError;

/// Why a mechanism can't be compiled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompileError {
    /// The mechanism can't be decomposed into groups.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// The lengths don't form a group of the kind.
    #[error("{group}: {source}")]
    Build {
        /// The group.
        group: String,
        /// What is wrong.
        source: BuildError,
        /// The link that is at fault, where it is one.
        link: Option<String>,
    },
}

impl CompileError {
    /// The key of the scene that the error concerns, step by step, if it is about a link.
    pub fn key(&self) -> Option<Vec<&str>> {
        match self {
            Self::Structure(error) => Some(vec!["link", error.link()?]),
            Self::Build { link, .. } => Some(vec!["link", link.as_deref()?, "points"]),
        }
    }
}

/// Why there is no position at a coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct PositionError {
    /// Index of the group.
    pub group: usize,
    /// The group in words: `group 1 (RRR rod, rocker)`.
    pub group_name: String,
    /// Number of the position, if the coordinate is that of a position of the scene.
    pub index: Option<usize>,
    /// The coordinate, rad or m.
    pub coordinate: f64,
    /// Whether the coordinate is an angle.
    pub angular: bool,
    /// Why the group has no solution.
    pub source: GroupError,
    /// The range around the first position in which the mechanism can be assembled, rad or m, in increasing order;
    /// `None` if it can't be assembled in the first position.
    pub range: Option<[f64; 2]>,
}

/// Gaps above this suggest a length written without its unit, m.
const VAST: f64 = 10.0;

impl PositionError {
    fn unit_hint(&self) -> &'static str {
        match self.source {
            GroupError::NoAssembly { gap_m } if gap_m >= VAST => {
                " and their units (a number without one is in meters)"
            }
            _ => "",
        }
    }

    /// A coordinate in the units of messages: degrees or millimeters.
    fn show(&self, coordinate: f64) -> String {
        if self.angular {
            format!("{:.4} deg", coordinate.to_degrees())
        } else {
            format!("{:.4} mm", coordinate * 1e3)
        }
    }
}

impl std::fmt::Display for PositionError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.group_name)?;
        if let Some(index) = self.index {
            write!(f, ", position {index}")?;
        }
        write!(f, ", coordinate {}: {}", self.show(self.coordinate), self.source)?;
        match self.range {
            Some([low, high]) => {
                write!(f, "; the mechanism can be assembled from {} to {}", self.show(low), self.show(high))
            }
            None => write!(
                f,
                "; it can't be assembled in the first position: check the lengths{}, or start elsewhere (`input.from`)",
                self.unit_hint()
            ),
        }
    }
}

impl std::error::Error for PositionError {}
