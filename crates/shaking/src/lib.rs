//! What a mechanism does to its foundation: shaking force and shaking moment over the cycle, their harmonics, and the
//! counterweights that make the shaking force least; beside them the harmonics of the input torque.
//!
//! The shaking force is the sum of the inertia loads -m a of all moving links, the shaking moment the sum of their moments
//! about the origin of the ground, with -I e of each link. They act on the ground in addition to the applied loads.
//! A link that turns about a pin on the ground can carry a counterweight; the shaking force depends linearly on its mass
//! times radius, so that the best one is found without iteration (least squares) or as a convex problem, with the proof by its dual (least maximum).
//! What is greatest over the cycle is found between samples.
//!
//! SI units, angles in rad.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod balance;
mod cone;
mod course;
mod data;
mod samples;
mod study;

assur_words::resources!();

pub use data::{
    AtPosition, Balanced, Counterweight, Criterion, Harmonic, Proof, Shaking, ShakingError, Size,
};
pub use study::{shaking, shaking_size};
