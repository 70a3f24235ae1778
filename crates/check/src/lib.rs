//! Checks of the calculated numbers of one mechanism (S, stages 3, 8, 9 and 10).
//!
//! Every check compares a result with one from an independent computation, over the positions of the scene or a sample
//! of them ([`Coverage`]), and gives its largest residual, where it occurs, and a limit. Each limit follows from the rounding unit, the sizes of the
//! terms of sums, the nearness to a singular position, and, for differences, from their own error estimate. A check
//! that does not apply is left out.
//!
//! Residual and limit are those of the element that is closest to failing, so they belong together.

mod agreement;
mod case;
mod check;
mod closure;
mod coverage;
mod elements;
mod equilibrium;
mod forces;
mod friction;
mod kinetics;
mod numbers;
mod perturbation;
mod power;
mod run;
mod stroke;
mod subject;
mod surroundings;
mod test_pf;
mod written;

assur_words::resources!();

pub use check::{Check, Finding, ForceResiduals, Residuals, verdict};
pub use coverage::{Chosen, Coverage, Notable, SAMPLE};
pub use run::checks;
pub use subject::{InputLoad, Subject, methods};

#[cfg(test)]
mod tests;
