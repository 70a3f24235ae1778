//! Checks that prove the numbers of one mechanism (S, stages 3, 8, 9 and 10).
//!
//! Every check compares a result with something that was found in another way, over all positions of the scene, and gives
//! its largest residual, where it is, and a limit. No limit is a guess: each follows from the rounding unit, the sizes of what
//! was added up, the nearness to a singular position, and, for differences, from their own error estimate. A check that does
//! not apply is left out.
//!
//! The limits of the element that comes closest to failing are shown; so `residual` and `limit` belong to each other.

mod agreement;
mod case;
mod check;
mod closure;
mod differences;
mod double_double;
mod elements;
mod equilibrium;
mod forces;
mod kinetics;
mod perturbation;
mod power;
mod rounding;
mod run;
mod sample;
mod stroke;
mod subject;
mod test_pf;
mod written;

pub use check::Check;
pub use run::checks;
pub use subject::{Subject, methods};

#[cfg(test)]
mod tests;
