//! Why there is no plan.

use assur_force::{ForceError, LoadError, RegistryError};
use assur_kinematics::PositionError;
use assur_words::{Describe, Text, errors};

/// Why there is no plan.
#[derive(Clone, PartialEq)]
pub enum DiagramError {
    /// The mechanism has no such position.
    Position(PositionError),
    /// The reactions can't be found.
    Force(ForceError),
    /// The loads can't be compiled.
    Load(LoadError),
    /// The registry of force analyzers is faulty.
    Registry(RegistryError),
}

impl Describe for DiagramError {
    fn describe(&self) -> Text {
        match self {
            Self::Position(error) => error.describe(),
            Self::Force(error) => error.describe(),
            Self::Load(error) => error.describe(),
            Self::Registry(error) => error.describe(),
        }
    }
}

errors!(DiagramError; Position(PositionError), Force(ForceError), Load(LoadError), Registry(RegistryError));
