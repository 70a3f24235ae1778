//! Why a scene can't be calculated at all.

use assur_force::{LoadError, RegistryError};
use assur_kinematics::CompileError;
use assur_mechanism::Mechanism;

use crate::Stopped;

/// Why a scene can't be calculated at all; what fails in one position only is part of the results.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AnalysisError {
    /// The mechanism can't be compiled.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The loads can't be compiled.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The force analyzer does not exist.
    #[error(transparent)]
    Analyzer(#[from] RegistryError),
    /// The force analyzer can't treat this mechanism.
    #[error("force analyzer `{analyzer}` can't do this scene: {reason}")]
    Unfit {
        /// Its name.
        analyzer: &'static str,
        /// Why not.
        reason: String,
    },
    /// The watcher stopped the calculation.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// There is no motion.
    #[error("{message}")]
    Motion {
        /// What went wrong, where, and what to do.
        message: String,
        /// Whether the scene or the chosen method is at fault, rather than the machine that it describes.
        usage: bool,
        /// The key of the scene that it concerns, step by step.
        key: Option<&'static [&'static str]>,
    },
}

impl From<assur_dynamics::DynamicsError> for AnalysisError {
    fn from(error: assur_dynamics::DynamicsError) -> Self {
        let (usage, key) = (crate::motion::is_usage(&error), Some(error.key()));
        Self::Motion { message: error.to_string(), usage, key }
    }
}

impl AnalysisError {
    /// There is no speed or acceleration at a coordinate, rad or m.
    pub(crate) fn infinite(coordinate: f64) -> Self {
        let message = format!(
            "the steady regime has no finite speed and acceleration at the coordinate {coordinate:.6}: the machine has no \
             inertia there, or loads grow beyond measure; give its links mass and inertia, or a `flywheel`"
        );
        Self::Motion { message, usage: false, key: Some(&["motion"]) }
    }

    /// The key of the scene that the error concerns, step by step; an element of a list is given by its number.
    pub fn key(&self, mechanism: &Mechanism) -> Option<Vec<String>> {
        match self {
            Self::Compile(error) => Some(error.key()?.into_iter().map(str::to_owned).collect()),
            Self::Load(error) => error.key(mechanism),
            Self::Motion { key: Some(key), .. } => Some(key.iter().map(|step| (*step).to_owned()).collect()),
            _ => None,
        }
    }

    /// Whether the machine has no solution, though the scene is sound.
    pub fn is_no_solution(&self) -> bool {
        matches!(self, Self::Motion { usage: false, .. })
    }
}
