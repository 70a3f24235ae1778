//! Structural analysis (S, stage 1): mobility, decomposition into Assur groups, formula and class.
//!
//! The mechanism is read as a system of equations that are counted, not solved. Each moving link has 3 unknowns and
//! each pin 2 (its position); each membership of a link in a pin, and each slide, gives 2 equations. A matching of
//! equations to unknowns shows which links are loose and which pairs are surplus. The strongly connected parts of the
//! matched system are the Assur groups, of any class and order, in solving order.
//!
//! ```
//! use assur_all as _; // the kinds of groups that ship
//!
//! let mechanism = assur_scene::read("shaper.toml", assur_fixtures::scene("shaper"))?;
//! let structure = assur_structure::Structure::of(&mechanism)?;
//! assert_eq!(structure.formula.as_str(), "I(ground,crank) -> II3(stone2,rocker) -> II5(stone4,ram)");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod compose;
mod error;
mod frame;
mod graph;
mod taken_apart;

assur_words::resources!();

pub use compose::Excess;
pub use error::{MissingBlock, StructureError};
pub use taken_apart::{Group, Mobility, NamedPair, Passive, PassivePart, Structure, roman};

#[cfg(test)]
mod tests;
