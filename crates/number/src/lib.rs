//! The numbers that the formulas of the groups are generic over.
//!
//! A formula is written once, over [`Real`]: `f64` is the program's number, `f32` shows what single precision costs,
//! [`Dd`] (about 32 digits) gives references for the accuracy charts, and [`Lanes`] carries several positions of the
//! mechanism through one instruction stream. [`search`] has the searches along one variable that the project needs:
//! bisection, bracketed roots, golden sections.

mod dd;
mod lanes;
mod real;
pub mod search;

pub use dd::Dd;
pub use lanes::Lanes;
pub use real::Real;

/// The lanes that batches of positions run in.
pub type F64x4 = Lanes<4>;

#[cfg(test)]
mod tests;
