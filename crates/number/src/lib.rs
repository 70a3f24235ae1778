//! The number types over which the formulas of the groups are generic.
//!
//! A formula is written once, over [`Real`]: `f64` is the usual number, `f32` shows the effect of single precision,
//! [`Dd`] (about 32 digits) gives references for the accuracy charts, [`Lanes`] computes several positions of the
//! mechanism at once, and [`Intervals`] enclose a quantity between positions. [`search`] has bisection, bracketed roots and golden
//! sections along one variable, [`panel`] what a function on an interval is approximated by, and [`quadrature`] integrals with their
//! errors. A [`Statistic`] gathers extremes and means, and [`components`]
//! puts what depends on each other in order.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod components;
mod dd;
pub mod elementary;
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
pub use real::Real;
pub use statistic::{Extreme, Statistic};

/// The greater of two numbers; NaN if one is, so that a number without a value is not hidden by others.
pub fn greater(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

#[cfg(test)]
mod tests;
