//! Why a scene can't be calculated at all.

use assur_force::{LoadError, RegistryError};
use assur_kinematics::CompileError;

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
    /// The force analyzer can't do this mechanism.
    #[error("force analyzer `{analyzer}` can't do this scene: {reason}")]
    Unfit {
        /// Its name.
        analyzer: &'static str,
        /// Why not.
        reason: String,
    },
    /// A part of the scene that this version does not calculate.
    #[error("{what}: not available yet")]
    NotAvailable {
        /// The part.
        what: &'static str,
    },
}
