//! Runs the chain of groups: positions and transfer functions at any value of the input coordinate.
//!
//! [`Linkage::compile`] decomposes a mechanism, builds the kernel of each group, chooses the assembly of the first
//! position and follows it once over the whole cycle. After that, [`Linkage::solve`] is a pure function of the
//! coordinate: it does not depend on earlier calls, allocates nothing and takes no lock. [`Linkage::solve_lanes`] solves
//! eight positions at once.
//!
//! At a change point (parallelogram, kite) two modes of a group meet, and the assembly continues in the mode that makes
//! the motion smooth. These coordinates are found when the mechanism is compiled, so the mode of each group is known
//! at every coordinate. Close to a change point the group's equations lose all their digits; the smooth motion is
//! interpolated across it.
//!
//! Where the piston of a compressor is when its crank of 60 mm and its rod of 240 mm are in line with the guide, and that it stands still:
//!
//! ```
//! use assur_all as _; // the kinds of groups that ship
//! use assur_group::Order;
//! use assur_kinematics::Linkage;
//!
//! let linkage = Linkage::compile(assur_scene::read("compressor.toml", assur_fixtures::scene("slider-crank"))?)?;
//! let mut position = linkage.position();
//! linkage.solve(std::f64::consts::FRAC_PI_2, Order::Second, &mut position)?;
//! let piston = position.bodies.last().expect("the ground is one");
//! assert!((piston.y - 0.300).abs() < 1e-12 && piston.y1.abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod branch;
mod chain;
mod courses;
mod dependence;
mod elsewhere;
mod enclosures;
mod error;
mod first;
mod follow;
mod follower;
mod gaps;
mod interpolant;
mod interpolants;
mod lanes;
mod linkage;
mod meeting;
mod modes;
mod motion;
mod passive;
mod poles;
mod poses;
mod rank;
mod samples;
mod start;
mod track;
mod ways;
mod wide;

assur_words::resources!();

pub use chain::{Chain, ChainError, ChainInput};
pub use courses::{CountFrom, CourseEnd, ModeCourse, ModeCourses, ModeMeeting, Unlisted};
pub use enclosures::Enclosures;
pub use error::{CompileError, PositionError};
pub use interpolant::Interpolation;
pub use lanes::LanePosition;
pub use linkage::{Linkage, Position};
pub use modes::Modes;
pub use motion::{PointMotion, ScalarMotion, continuous_angle, first_angle};
pub use passive::{Closing, Misfit, decompose};
pub use poses::iterated;
pub use rank::mobility_in;
pub use ways::{AssemblyRange, Transition, Ways};

#[cfg(test)]
mod tests;
