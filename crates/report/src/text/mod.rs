//! The text report: tables that can be handed in, and plain aligned columns for lists.
//!
//! Angles in degrees, lengths in millimeters, the rest in SI; each column with as many digits as its largest value needs.

mod grid;
mod layout;
mod line;

use assur_analysis::results::Analysis;
use assur_book::Document;
use assur_kinematics::Linkage;
use serde::Serialize;

use crate::json::analysis::finite as finite_analysis;
use crate::json::{NotFinite, finite};
use crate::topic::{self, Source};
pub use grid::columns;
use layout::WIDTH;
pub use layout::lines;
use line::joined;
pub use line::{Line, LineKind, Style};

/// The text of a topic alone: of the blocks that it adds to a document.
pub fn told(style: Style<'_>, topic: impl FnOnce(&mut Document)) -> String {
    told_within(WIDTH, style, topic)
}

/// The text of a topic alone in lines of at most `width` columns.
pub fn told_within(width: usize, style: Style<'_>, topic: impl FnOnce(&mut Document)) -> String {
    let mut page = Document::default();
    topic(&mut page);
    joined(&lines(&page.blocks, style, width))
}

/// The whole report: first the results that are asked for first, then the tables. `positions`: the numbers of the
/// positions that the tables show, `None` for all.
pub fn report(
    analysis: &Analysis,
    linkage: &Linkage,
    positions: Option<&[usize]>,
    style: Style<'_>,
) -> Result<String, NotFinite> {
    let source = Source::of(finite_analysis(analysis)?, linkage, positions);
    Ok(joined(&lines(&topic::report(&source).blocks, style, WIDTH)))
}

/// What a study found as a page of its topic.
pub fn page<T: Serialize>(
    found: &T,
    style: Style<'_>,
    topic: fn(&T, &mut Document),
) -> Result<String, NotFinite> {
    let found = finite(found)?;
    Ok(told(style, |page| topic(found, page)))
}

#[cfg(test)]
mod tests;
