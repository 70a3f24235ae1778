//! The forms in which what was found is handed over: text, JSON, CSV; and what is calculated, explained in words.
//!
//! [`json`], [`text`] and [`csv`] write it to a string or a writer and touch no file. Everything is SI, angles in rad; only
//! the text report converts (degrees, millimeters).

pub mod csv;
mod explain;
mod fold;
pub mod json;
pub mod text;

pub use explain::explain;
pub use fold::to_ascii;

#[cfg(test)]
mod tests;
