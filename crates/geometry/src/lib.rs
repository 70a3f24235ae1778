//! Geometry of the motion of a mechanism: what can be said about its paths, strokes and centers without loads.
//!
//! * [`geometry`]: strokes with their dead points, time ratio, extremes, force angles and positions of rest over the
//!   cycle, found between positions; centrodes, inflection circles and curvature in every position.
//! * [`instant_centers`]: absolute and relative, at infinity as a direction.
//! * [`Centers`], [`Curvature`]: the instant center of one link, the curvature of the path of one point, in one position.
//!
//! SI units, angles in rad. Derivatives are by the input coordinate, so that nothing here needs a motion; only mean
//! speeds do.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod course;
mod crank;
mod data;
mod instant;
mod measure;
mod rigid;

assur_words::resources!();

pub use course::{Extremes, Stroke};
pub use crank::{CrankCondition, crank_conditions};
pub use data::{AtPosition, ForceAngles, Geometry, PartCourse};
pub use instant::{Center, CenterAt, Centers, Curvature, centers_of, instant_centers};
pub use measure::{GeometryError, Overview, courses, distances, geometry, overview};
