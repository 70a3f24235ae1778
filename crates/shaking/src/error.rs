//! Why there is no shaking force.

use assur_force::LoadError;
use assur_kinematics::PositionError;

/// Why the shaking force of a scene is not found.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ShakingError {
    /// The positions are no closed cycle.
    #[error("the shaking force is found over a cycle: give `[input] cycle` instead of `to`")]
    NoCycle,
    /// Nothing moves.
    #[error(
        "the shaking force needs a motion over the cycle: give `[motion]` of the kind prescribed or steady"
    )]
    NoMotion,
    /// No link has a mass.
    #[error(
        "no moving link has a mass or a moment of inertia, so there is no shaking force: give `[link.NAME] mass`"
    )]
    NoMass,
    /// A load can't be compiled.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A position of the cycle has no solution.
    #[error(transparent)]
    Position(#[from] PositionError),
}
