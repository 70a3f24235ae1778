//! The output formats of results: text, JSON, CSV; and explanations in words of what is calculated.
//!
//! [`json`], [`text`] and [`csv`] write to a string or a writer, never to a file. Everything is SI, angles in rad; only
//! the text report converts (degrees, millimeters).

pub mod csv;
pub mod json;
mod template;
pub mod text;
pub mod topic;

assur_words::resources!();

#[cfg(test)]
mod tests;
