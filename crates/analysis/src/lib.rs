//! Runs the plan of a scene: position after position, from transfer functions to named reactions.
//!
//! [`Calculation::of`] decomposes a mechanism into groups, plans and compiles it; [`Calculation::analyze`] calculates
//! the results of the scene. Knows no concrete plugin, no file and no terminal.
//!
//! ```
//! use assur_all as _; // the plugins that ship
//! use assur_analysis::{Calculation, Options, unwatched};
//!
//! let mechanism = assur_scene::read("shaper.toml", assur_fixtures::scene("shaper"))?;
//! let calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched)?;
//! let analysis = calculation.analyze(&mut unwatched).expect("nothing stops it");
//! assert_eq!(analysis.positions.len() + analysis.failures.len(), calculation.linkage.mechanism.input.positions);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod acting;
mod angles;
mod blocks;
mod calculation;
mod checks;
mod dynamics;
mod edges;
mod energies;
mod error;
mod extremes;
mod families;
mod filler;
mod friction;
mod inputs;
mod instants;
mod joints;
mod modes;
mod motion;
pub mod plan;
mod plans;
mod positions;
mod progress;
mod proof;
pub mod results;
mod several;
mod trajectory;
mod warnings;

assur_words::resources!();

pub use assur_check::Coverage;
pub use calculation::{Calculation, DEFAULT_INTEGRATOR, Methods, Options, Varied, methods, plan};
pub use edges::DRAWN;
pub use error::AnalysisError;
pub use inputs::{PossibleInput, StructureStudy};
pub use modes::{GroupModes, modes};
pub use motion::{InputMotion, method_of_motion};
pub use positions::lost_positions;
pub use progress::{Progress, Stopped, Watch, unwatched};
pub use warnings::MOST_FAILURES;

#[cfg(test)]
mod tests;
