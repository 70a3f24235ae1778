//! Why there is no plan.

use assur_force::{ForceError, LoadError, RegistryError};
use assur_kinematics::PositionError;

/// Why there is no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlansError {
    /// The position can't be taken.
    #[error(transparent)]
    Position(#[from] PositionError),
    /// The reactions can't be found.
    #[error(transparent)]
    Force(#[from] ForceError),
    /// The loads can't be compiled.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The force analyzers are not in order.
    #[error(transparent)]
    Registry(#[from] RegistryError),
    /// No reaction of this name.
    #[error("no reaction of joint `{joint}` on link `{on}`; there are: {}", known.join(", "))]
    NoReaction {
        /// Joint asked for.
        joint: String,
        /// Link asked for.
        on: String,
        /// What there is.
        known: Vec<String>,
    },
    /// No contact of this number.
    #[error("no contact number {number}: the scene has {count}; add `[[contact]]`")]
    NoContact {
        /// Number asked for, from 0.
        number: usize,
        /// How many there are.
        count: usize,
    },
    /// No slide of this number.
    #[error("no slide number {number}: the scene has {count}")]
    NoSlide {
        /// Number asked for, from 0.
        number: usize,
        /// How many there are.
        count: usize,
    },
    /// A path needs two positions.
    #[error("{count} positions make no path; ask for 2 or more")]
    TooFew {
        /// How many were asked for.
        count: usize,
    },
}
