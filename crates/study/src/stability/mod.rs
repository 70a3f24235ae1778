//! Where methods fail: walks towards singular positions, and how near a mechanism comes to its own.
//!
//! A walk puts a group, or the whole mechanism, at distances 1e-1 to 1e-15 from a singular position and compares what a
//! method gives there with a computation in 32 digits from the same numbers. A backward-stable method gives the exact
//! answer to data that are changed by a rounding; so its error is at most `C eps / health^k`, where the health is the
//! dimensionless determinant. A method must keep that, or say that it has no answer.

mod across;
mod bench;
mod compare;
mod cycle;
mod differences;
mod isolated;
mod margin;
mod pole;
mod report;
mod row;
mod scales;
mod target;
mod text;
mod turns;
mod walk_cycle;
mod walk_group;

pub use bench::bench;
pub use cycle::GroupHealth;
pub use margin::Margin;
pub use report::{Stability, stability, stability_watched};
pub use row::{DISTANCES, Law, Row};
pub use walk_group::FACTOR;

#[cfg(test)]
mod metamorphic;
#[cfg(test)]
mod near;
#[cfg(test)]
mod tests;
