//! Texts that a person reads.
//!
//! A [`Text`] is an identity with values. It becomes words in a [`Language`] at the very end, from the resources that every
//! crate brings along ([`resources!`]); a plugin adds its own in the same way. No sentence is read back, and none is
//! translated by its English words.

mod language;
mod text;

pub use inventory;
pub use language::Resource;
pub use language::{LANGUAGES, Language};
pub use text::{Describe, Text, Told, count, joined, list, name, number, quantity, text_of, unit};

resources!();

#[cfg(test)]
mod tests;
