//! J constant and M(w) (D's case 2): t = J ∫ dw/M(w) and q = q0 + J ∫ w dw/M(w), by panels of the speed.
//!
//! The acceleration e = M/J is fitted over a panel; time and way are integrals of polynomials, and no further evaluation is
//! needed. Where the moment vanishes at a speed, 1/e has a pole; it is divided out, so that the endless approach to that speed is
//! one logarithm, and one panel.

mod march;
mod panel;
mod passage;

pub(crate) use march::run;

#[cfg(test)]
mod tests;
