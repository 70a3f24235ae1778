//! Structural analysis (S, stage 1): mobility, decomposition into Assur groups, formula and class.
//!
//! The mechanism is read as a system of equations that are counted, not solved. Each moving link has 3 unknowns and
//! each pin 2 (its position); each membership of a link in a pin, and each slide, gives 2 equations. A matching of
//! equations to unknowns shows which links are loose and which pairs are surplus. The strongly connected parts of the
//! matched system are the Assur groups, of any class and order, in solving order.

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
