//! How near a mechanism comes to its singular positions, how much each length may change before it no longer assembles,
//! and what each method loses on the way to a singular position.
//!
//! A walk puts the mechanism at distances 1e-1 to 1e-15 from a singular position and compares what a method gives there
//! with a computation in 32 digits from the same numbers. A backward-stable method gives the exact answer to data that are
//! changed by a rounding; so its error is at most `C eps / health^k`, where the health is the dimensionless determinant. A
//! method must keep that bound, or say that it has no answer.

mod compare;
mod exact;
mod margin;
mod nearest;
mod report;
mod row;
mod target;
mod text;
mod walk;

pub use margin::Margin;
pub use nearest::GroupHealth;
pub use report::{Stability, stability};
pub use row::{DISTANCES, FACTOR, Row};

#[cfg(test)]
mod tests;
