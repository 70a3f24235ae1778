//! Runs the plan of a scene: position after position, from transfer functions to named reactions.
//!
//! [`Study::of`] takes a mechanism apart, plans and compiles it; [`Study::analyze`] calculates everything that the scene
//! asks for. Knows no concrete plugin, no file and no terminal.

mod angles;
mod checks;
mod course;
mod dynamics;
mod error;
mod forces;
mod motions;
mod names;
mod notes;
pub mod plan;
mod plans;
mod progress;
mod proof;
pub mod results;
mod run;
mod structure;
mod study;
mod trajectory;

pub use course::{Course, explain_motion};
pub use error::AnalysisError;
pub use progress::Progress;
pub use study::{DEFAULT_INTEGRATOR, Options, Study, methods};

#[cfg(test)]
mod tests;
