//! Checks of the calculated numbers of one mechanism (S, stages 3, 8, 9 and 10).
//!
//! Every check compares a result with one from an independent computation, over all positions of the scene, and gives
//! its largest residual, where it occurs, and a limit. Each limit follows from the rounding unit, the sizes of the
//! terms of sums, the nearness to a singular position, and, for differences, from their own error estimate. A check
//! that does not apply is left out.
//!
//! Residual and limit are those of the element that is closest to failing, so they belong together.

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
