//! Why there is no plan.

use assur_force::{ForceError, LoadError, RegistryError};
use assur_kinematics::PositionError;

/// Why there is no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DiagramError {
    /// The mechanism has no such position.
    #[error(transparent)]
    Position(#[from] PositionError),
    /// The reactions can't be found.
    #[error(transparent)]
    Force(#[from] ForceError),
    /// The loads can't be compiled.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The registry of force analyzers is faulty.
    #[error(transparent)]
    Registry(#[from] RegistryError),
}
