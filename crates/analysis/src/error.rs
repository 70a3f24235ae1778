//! Why a scene can't be calculated at all.

use assur_force::{LoadError, RegistryError};
use assur_kinematics::CompileError;
use assur_mechanism::{Key, Mechanism};
use assur_words::{Describe, Text, name, text};

use crate::Stopped;

/// Why a scene can't be calculated at all; what fails in one position only is part of the results.
#[derive(Clone, PartialEq)]
pub enum AnalysisError {
    /// The mechanism can't be compiled.
    Compile(CompileError),
    /// The loads can't be compiled.
    Load(LoadError),
    /// The force analyzer does not exist.
    Analyzer(RegistryError),
    /// The force analyzer does not support this mechanism.
    Unfit {
        /// Its name.
        analyzer: &'static str,
        /// Why not.
        reason: Text,
    },
    /// The watcher stopped the calculation.
    Stopped(Stopped),
    /// There is no motion.
    Motion {
        /// What went wrong, where, and what to do.
        message: Text,
        /// Whether the scene or the chosen method is at fault, rather than the machine that it describes.
        usage: bool,
        /// The key of the scene that it concerns.
        key: Key,
    },
}

assur_words::errors!(AnalysisError; Compile(CompileError), Load(LoadError), Analyzer(RegistryError), Stopped(Stopped));

impl Describe for AnalysisError {
    fn describe(&self) -> Text {
        match self {
            Self::Compile(error) => error.describe(),
            Self::Load(error) => error.describe(),
            Self::Analyzer(error) => error.describe(),
            Self::Unfit { analyzer, reason } => {
                text!("analysis-unfit", method = name(*analyzer), reason)
            }
            Self::Stopped(stopped) => stopped.describe(),
            Self::Motion { message, .. } => message.clone(),
        }
    }
}

impl From<assur_dynamics::DynamicsError> for AnalysisError {
    fn from(error: assur_dynamics::DynamicsError) -> Self {
        let (usage, key) = (crate::motion::is_usage(&error), error.key());
        Self::Motion { message: error.describe(), usage, key }
    }
}

impl AnalysisError {
    /// The key of the scene that the error concerns.
    pub fn key(&self, mechanism: &Mechanism) -> Option<Key> {
        match self {
            Self::Compile(error) => error.key(),
            Self::Load(error) => error.key(mechanism),
            Self::Motion { key, .. } => Some(key.clone()),
            _ => None,
        }
    }

    /// Whether the machine has no solution, though the scene is sound.
    pub fn is_no_solution(&self) -> bool {
        matches!(self, Self::Motion { usage: false, .. })
    }
}
