//! Runs the chain of groups: positions and transfer functions at any value of the input coordinate.
//!
//! [`Linkage::compile`] takes a mechanism apart, builds the kernel of each group, chooses the assembly of the first
//! position and follows it once over the whole cycle. From then on [`Linkage::solve`] is a pure function of the
//! coordinate: it has no memory of where it was called before, allocates nothing and takes no lock.
//!
//! Where two ways of a group meet (a change point: parallelogram, kite) the assembly goes through by continuity. Such
//! coordinates are found at compile time; the way of each group is then known for every coordinate, and close to a
//! change point, where the group's equations lose all their digits, the smooth motion is interpolated across it.

mod branch;
mod chain;
mod dependence;
mod error;
mod first;
mod follow;
mod follower;
mod guesses;
mod interpolant;
mod interpolants;
mod linkage;
mod meeting;
mod motion;
mod poles;
mod rank;
mod samples;
mod ways;
mod wide;

pub use chain::{Chain, ChainError, Input};
pub use error::{CompileError, PositionError};
pub use guesses::iterated;
pub use interpolant::Interpolation;
pub use linkage::{Linkage, Position};
pub use motion::{PointMotion, ScalarMotion, continuous_angle};
pub use rank::mobility_in;
pub use ways::{Range, Transition, Ways};

#[cfg(test)]
mod tests;
