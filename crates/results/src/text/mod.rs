//! The text report: tables that can be handed in, and plain aligned columns for lists.
//!
//! Angles in degrees, lengths in millimeters, the rest in SI; each column with as many digits as its largest value needs.

mod causes;
mod condition;
mod contact;
mod course;
mod drive;
mod forces;
mod geometry;
mod layout;
mod motion;
mod number;
mod point;
mod structure;
mod units;

use assur_mechanism::Mechanism;

use crate::{Analysis, CheckRow};

pub use layout::columns;
use layout::{Page, wrap};
use units::Units;

/// What the sections of a report are made from.
struct Source<'a> {
    analysis: &'a Analysis,
    mechanism: &'a Mechanism,
    units: Units,
}

/// The whole report; `ascii`: no character beyond ASCII.
pub fn report(analysis: &Analysis, mechanism: &Mechanism, ascii: bool) -> String {
    let source = Source { analysis, mechanism, units: Units::of(analysis.input.angular) };
    let mut page = Page::new(ascii);
    if !analysis.title.is_empty() {
        page.title(&analysis.title);
    }
    structure::write(&source, &mut page);
    geometry::write(&source, &mut page);
    motion::write(&source, &mut page);
    course::write(&source, &mut page);
    drive::write(&source, &mut page);
    forces::write(&source, &mut page);
    causes::write(&source, &mut page);
    contact::write(&source, &mut page);
    condition::write(&source, &mut page);
    if !analysis.notes.is_empty() {
        page.section("Notes");
        for note in &analysis.notes {
            page.paragraph(note);
        }
    }
    if !analysis.failures.is_empty() {
        page.section("Positions without a solution");
        for failure in &analysis.failures {
            page.paragraph(&failure.message);
        }
    }
    if !analysis.checks.is_empty() {
        page.section("Checks");
        page.text(&checks(&analysis.checks, ascii));
    }
    page.finish()
}

/// The checks, one line each: name, largest residual, where, limit, ok or FAILED.
pub fn checks(checks: &[CheckRow], ascii: bool) -> String {
    let mut rows =
        vec![["check", "residual", "position", "place", "limit", "result"].map(String::from).to_vec()];
    rows.extend(checks.iter().map(|check| {
        vec![
            check.name.clone(),
            scientific(check.residual),
            check.at.map_or_else(|| "-".to_owned(), |at| at.to_string()),
            if check.place.is_empty() { "-".to_owned() } else { check.place.clone() },
            scientific(check.limit),
            if check.ok { "ok" } else { "FAILED" }.to_owned(),
        ]
    }));
    columns(&rows, ascii)
}

/// Broken into lines of the report's width, the ones after the first `indent` columns in.
pub fn wrapped(words: &str, indent: usize, ascii: bool) -> String {
    wrap(&if ascii { crate::to_ascii(words) } else { words.into() }, indent)
}

fn scientific(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.2e}") }
}

#[cfg(test)]
mod tests;
