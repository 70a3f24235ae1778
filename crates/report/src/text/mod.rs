//! The text report: tables that can be handed in, and plain aligned columns for lists.
//!
//! Angles in degrees, lengths in millimeters, the rest in SI; each column with as many digits as its largest value needs.

mod layout;

use assur_analysis::Methods;
use assur_analysis::plan::Plan;
use assur_analysis::results::{Analysis, Check, MotorAdvice};
use assur_book::Document;
use assur_diagram::Sheet;
use assur_geometry::Geometry;
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_shaking::Shaking;
use assur_structure::Structure;
use assur_words::Text;

use crate::json::NotFinite;
use crate::json::analysis::finite as finite_analysis;
use crate::json::finite;
use crate::topic::{self, Source};
pub use layout::{Style, columns, wrapped, written};

/// The lines of the blocks that a topic adds to a document.
fn lines(style: Style<'_>, topic: impl FnOnce(&mut Document)) -> String {
    let mut page = Document::default();
    topic(&mut page);
    written(&page, style)
}

/// The whole report: first the results that are asked for first, then the tables. `positions`: the numbers of the
/// positions that the tables show, `None` for all.
///
/// # Errors
///
/// [`NotFinite`] for a number that is not finite.
pub fn report(
    analysis: &Analysis,
    linkage: &Linkage,
    positions: Option<&[usize]>,
    style: Style<'_>,
) -> Result<String, NotFinite> {
    let source = Source::of(finite_analysis(analysis)?, linkage, positions);
    Ok(written(&topic::report(&source), style))
}

/// The checks, one line each, and below what was not checked.
pub fn checks(checks: &[Check], style: Style<'_>) -> String {
    lines(style, |page| topic::checks(checks, page))
}

/// The motors that suit a scene, the best first, out of `count`.
pub fn advice(motors: &[MotorAdvice], count: usize, style: Style<'_>) -> String {
    lines(style, |page| topic::advice(motors, count, page))
}

/// What is calculated for a scene and how, what is modelled and what is not; see [`topic::explain`].
pub fn explain(
    mechanism: &Mechanism,
    structure: &Structure,
    plan: &Plan,
    methods: &Methods,
    equation: Option<&Text>,
    style: Style<'_>,
) -> String {
    lines(style, |page| topic::explain(mechanism, structure, plan, methods, equation, page))
}

/// All plans of a position, one table after the other.
pub fn plans(sheet: &Sheet, style: Style<'_>) -> String {
    lines(style, |page| topic::plans(sheet, page))
}

/// What was measured on the motion.
///
/// # Errors
///
/// [`NotFinite`] for a number that is not finite.
pub fn geometry(found: &Geometry, style: Style<'_>) -> Result<String, NotFinite> {
    let found = finite(found)?;
    Ok(lines(style, |page| topic::geometry(found, page)))
}

/// Shaking force and counterweights.
///
/// # Errors
///
/// [`NotFinite`] for a number that is not finite.
pub fn shaking(found: &Shaking, style: Style<'_>) -> Result<String, NotFinite> {
    let found = finite(found)?;
    Ok(lines(style, |page| topic::shaking(found, page)))
}

#[cfg(test)]
mod tests;
