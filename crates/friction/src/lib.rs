//! Dry friction as equations in magnitudes of reactions.
//!
//! With the linear equilibrium eliminated, what friction depends on are the magnitudes z of some vectors that are themselves
//! affine in z: the force of a pin (two components) and the pressing forces of a slide (one component),
//!
//! ```text
//! z_j = |a_j + sum over k of W_jk z_k|,    z_j >= 0.
//! ```
//!
//! The matrix L of the lengths `|W_jk|` is nonnegative. The map on the right is a P-contraction with L (Ortega and
//! Rheinboldt 1970, section 13.1): where the spectral radius of L is below 1 there is exactly one solution, and the textbook
//! iteration converges to it at this rate. From 1 on there may be none (jamming), one, or several; [`Moduli::solutions`] finds
//! them all by algebra: the signs of vectors of one component are enumerated, and the remaining equations are quadrics, whose
//! common points are the eigenvalues of a multiplication matrix. Where these are too many, Newton's method looks for solutions from many
//! places, and a [`path`] leads to one from small friction.
//!
//! Nothing here knows of mechanisms; numbers may have any unit.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod every;
mod matrix;
mod moduli;
mod quadrics;
mod steps;
mod unique;

pub use every::{Solutions, nearest};
pub use matrix::spectral_radius;
pub use moduli::{Moduli, PathPoint, SHORTEST, Width, path};
pub use unique::{Sum, Unique};

#[cfg(test)]
mod tests;
