//! The contract of an Assur group, and the registry of its kinds.
//!
//! A group is a chain of links of zero mobility: if the motion of the outer bodies (those that its outer pairs join)
//! is given, its own motion can be solved. This crate is independent of concrete groups, of scene files and of the
//! terminal. Units are SI; angles are counter-clockwise.
//!
//! * [`Body`]: pose of a link and its derivatives with respect to the input coordinate q (not to time).
//! * [`GroupFrame`], [`Pair`]: the links and pairs of a group, as indices and lengths in the compiled chain.
//! * [`AssurGroup`]: places the links (PF0), differentiates (PF1, PF2), and finds the pair reactions. Only the
//!   places are required; the rest follows from one linear system, `J u' = ...` and `J^T lambda = ...`.
//! * [`GroupPlugin`]: the entry of a kind in the registry.
//!
//! A point 0.1 m along the x axis of a link that has turned a quarter about the origin, and its first derivative by the angle:
//!
//! ```
//! use assur_group::Body;
//!
//! let crank = Body { c: 0.0, s: 1.0, w1: 1.0, ..Body::<f64>::ground() };
//! let arm = crank.arm([0.1, 0.0]);
//! assert_eq!(crank.point([0.1, 0.0]), [0.0, 0.1]);
//! assert_eq!(crank.first(arm), [-0.1, 0.0]);
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod body;
mod builders;
mod closed;
mod driven;
mod error;
mod general;
mod joint;
mod kernel;
mod newton;
mod pair;
mod pattern;
pub mod plane;
mod registry;
mod solver;

assur_words::resources!();

pub use assur_plugin::RegistryError;
pub use body::{Anchor, Body, Forces, Order, Wrench};
pub use builders::{Builders, GroupKind, Number};
pub use closed::{Closed, ClosedForm, ClosedKind};
pub use error::{BuildError, GroupError, LEAST_HEALTH};
pub use general::{derive_generally, health_generally, reactions_generally};
pub use joint::{PinJoint, SlideJoint, motion_at};
pub use kernel::{AssurGroup, Mode};
pub use newton::{Iterated, certify_generally, place_by_newton};
pub use pair::{Driven, GroupFrame, Pair, PairGeometry};
pub use pattern::{PairSort, Pattern, Reading, SeenPair};
pub use registry::{Assemblies, ForceAngle, GroupPlugin, groups, plugin_for};
pub use solver::{constraints, driven_constraint};

pub use inventory;

#[cfg(test)]
mod tests;
