//! What was found, as a reader meets it: quantities with their names, and courses over their own coordinates.
//!
//! A result is a number of a [`Table`](assur_analysis::results::Table), identified by its
//! [`Column`](assur_analysis::results::Column): which quantity, of whom, which part. Everything that shows it takes it from
//! here: a [`Course`] keeps each value with the coordinate (or time) at which it was found, so that no drawing can place
//! it elsewhere, and it ends where the cycle was calculated to end, whether or not that is where it began.

pub mod catalogue;
mod course;
mod document;
pub mod glossary;
mod number;
mod peaks;
mod table;

pub use assur_worksheet::Term;
pub use catalogue::Unit;
pub use course::{Course, Jump, Node};
pub use document::{Block, Document, Fact, Value, driven_link, link_name};
pub use number::{Digits, ROUNDING, zero_if_rounding};
pub use peaks::{Range, Read, extreme, peaks, range, range_of};
pub use table::{Cell, Column, Group, Listing, Printed, Table};

assur_words::resources!();

#[cfg(test)]
mod tests;
