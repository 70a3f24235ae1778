//! The number types over which the formulas of the groups are generic.
//!
//! A formula is written once, over [`Real`]: `f64` is the usual number, `f32` shows the effect of single precision,
//! [`Dd`] (about 32 digits) gives references for the accuracy charts, [`Lanes`] computes several positions of the
//! mechanism at once, and [`Intervals`] enclose a quantity between positions. [`search`] has bisection, bracketed roots and golden
//! sections along one variable, [`elimination`] solves linear systems, [`panel`] has what a function on an interval is approximated
//! by, and [`quadrature`] integrals with their errors. A [`Statistic`] gathers extremes and means, [`components`] puts what depends
//! on each other in order, and [`ROUNDING`] is what counts as zero.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod components;
mod dd;
pub mod elementary;
pub mod elimination;
mod intervals;
mod lanes;
pub mod panel;
pub mod quadrature;
mod real;
pub mod search;
mod sine;
mod statistic;

pub use components::components;
pub use dd::Dd;
pub use intervals::Intervals;
pub use lanes::Lanes;
pub use real::{Curve, Real};
pub use statistic::{Extreme, Statistic};

/// A result is zero but for rounding where it is no greater than this part of what it consists of: of the greatest of its terms, of
/// its kind, or of a typical length. Some thousand operations of 16 digits each lose as much.
///
/// What loses more (a root, a certificate, an iteration that ends) has a limit of its own, with its reason.
pub const ROUNDING: f64 = 1e-12;

/// The greater of two numbers; NaN if one is, so that a number without a value is not hidden by others.
pub fn greater(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

#[cfg(test)]
mod tests;
