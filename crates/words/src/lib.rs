//! Texts that a person reads.
//!
//! A [`Text`] is an identity with values. It becomes words in a [`Language`] at the very end, from the resources that every
//! crate brings along ([`resources!`]); a plugin adds its own in the same way. No sentence is read back, and none is
//! translated by its English words.

mod ascii;
mod digits;
mod language;
mod text;

pub use ascii::{latin, to_ascii};
pub use digits::{digits, trimmed};
pub use inventory;
pub use language::{LANGUAGES, Language, Resource};
pub use text::{
    CoordinateKind, Describe, Text, Told, coordinate, count, degrees, exact, joined, labelled, list,
    measured, millimeters, name, number, ordinal, quantity, text_of, unit,
};

resources!();

#[cfg(test)]
mod tests;
