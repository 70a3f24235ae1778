//! J constant and M(w) (D's case 2): t = J ∫ dw/M(w) and q = q0 + J ∫ w dw/M(w), by panels of the speed.
//!
//! The acceleration e = M/J is fitted over a panel; time and displacement are integrals of polynomials and need no
//! further evaluation. Where the moment vanishes at a speed, 1/e has a pole. It is divided out, so the asymptotic
//! approach to that speed is one logarithm, in one panel.

mod march;
mod panel;

pub(crate) use march::run;

#[cfg(test)]
mod tests;
