//! How near a mechanism comes to its singular positions, how much each length may change before it no longer assembles,
//! and how much accuracy each method loses on the approach to a singular position.
//!
//! A walk (the approach to a singular position) takes the mechanism to distances 1e-1 to 1e-15 from it and compares
//! each method there with a computation in 32 digits from the same numbers. A backward-stable method gives the exact
//! result for data that are perturbed by rounding, so its error is at most `C eps / health^k`, where the health is the
//! dimensionless determinant. A method must keep that bound, or report that it has no result.

mod exact;
mod friction;
mod margin;
mod nearest;
mod report;
mod row;
mod target;
mod text;
mod walk;

pub use friction::FrictionHealth;
pub use margin::Margin;
pub use nearest::GroupHealth;
pub use report::{Stability, stability};
pub use row::{Comparison, DISTANCES, FACTOR};

#[cfg(test)]
mod tests;
