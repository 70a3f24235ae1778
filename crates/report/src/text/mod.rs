//! The text report: tables that can be handed in, and plain aligned columns for lists.
//!
//! Angles in degrees, lengths in millimeters, the rest in SI; each column with as many digits as its largest value needs.

mod contact;
mod course;
mod drive;
mod forces;
mod geometry;
mod layout;
mod measured;
mod motion;
mod number;
mod plans;
mod shaking;
mod structure;
mod summary;
mod units;

use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;

use assur_analysis::results::{Analysis, Check};

use crate::json::NotFinite;
use crate::json::analysis::finite;
pub use drive::advice;
use layout::Page;
pub use layout::columns;
pub(crate) use layout::wrap;
pub use measured::geometry;
use number::scientific;
pub use plans::plans;
pub use shaking::shaking;
pub use summary::{Finding, summary};
use units::Units;

/// A result of more bytes has lines of its own, since columns don't break.
const LONG: usize = 30;

/// The data of a report.
struct Source<'a> {
    analysis: &'a Analysis,
    mechanism: &'a Mechanism,
    units: Units,
}

/// The whole report: first the results that are asked for first, then the tables. `positions`: the numbers of the
/// positions that the tables show, `None` for all; `ascii`: no character beyond ASCII.
///
/// # Errors
///
/// [`NotFinite`] for a number that is not finite.
pub fn report(
    analysis: &Analysis,
    linkage: &Linkage,
    positions: Option<&[usize]>,
    ascii: bool,
) -> Result<String, NotFinite> {
    let found = summary(finite(analysis)?, linkage);
    let chosen = positions.map(|list| Analysis {
        positions: analysis.positions.only(|number| list.contains(&number)),
        ..analysis.clone()
    });
    let analysis = chosen.as_ref().unwrap_or(analysis);
    let mechanism = &linkage.mechanism;
    let source = Source { analysis, mechanism, units: Units::of(analysis.input.angular) };
    let mut page = Page::new(ascii);
    if !analysis.title.is_empty() {
        page.title(&analysis.title);
    }
    page.section("Results");
    let (long, short): (Vec<_>, Vec<_>) = found.into_iter().partition(|one| one.value.len() > LONG);
    for one in long {
        page.paragraph(&format!("{}: {}", one.what, one.value));
    }
    let rows = short.into_iter().map(|one| vec![one.what, one.value, one.unit.to_owned(), one.at]);
    page.rows(&["result", "value", "unit", "at"], &rows.collect::<Vec<_>>());
    structure::write(&source, &mut page);
    geometry::write(&source, &mut page);
    motion::write(&source, &mut page);
    course::write(&source, &mut page);
    drive::write(&source, &mut page);
    forces::write_loads(&source, &mut page);
    forces::write(&source, &mut page);
    contact::write(&source, &mut page);
    motion::condition(&source, &mut page);
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
    Ok(page.finish())
}

/// The checks, one line each: name, largest residual, where, limit, ok or FAILED, or that nothing could be checked;
/// below, how many positions were checked where not all were, and in which of them checks were not possible, and why.
pub fn checks(checks: &[Check], ascii: bool) -> String {
    let row = |check: &Check| {
        vec![
            check.name.to_owned(),
            scientific(check.residual),
            check.at.map_or_else(|| "-".to_owned(), |at| at.to_string()),
            if check.place.is_empty() { "-".to_owned() } else { check.place.clone() },
            scientific(check.limit),
            verdict(check).to_owned(),
        ]
    };
    let rows: Vec<_> = checks.iter().map(row).collect();
    let sentences = sampled(checks).into_iter().chain(not_judged(checks));
    let lines = sentences.map(|line| wrapped(&line, 2, ascii)).collect::<String>();
    columns(&["check", "residual", "position", "place", "limit", "result"], &rows, ascii) + &lines
}

/// Of how many positions a sample was checked: one sentence for the checks that have it in common.
fn sampled(checks: &[Check]) -> Vec<String> {
    let mut kinds: Vec<([usize; 2], Vec<&str>)> = Vec::new();
    for check in checks {
        let Some(sample) = check.sample else { continue };
        match kinds.iter_mut().find(|kind| kind.0 == sample) {
            Some((_, names)) => names.push(check.name),
            None => kinds.push((sample, vec![check.name])),
        }
    }
    let sentence = |([checked, of], names): ([usize; 2], Vec<&str>)| {
        format!("checked in {checked} of {}: {}", thousands(of), names.join(", "))
    };
    kinds.into_iter().map(sentence).collect()
}

/// A number with a comma after every third digit: 1,000,000.
fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let from_the_end = digits.chars().rev().enumerate();
    let grouped =
        from_the_end.flat_map(|(i, digit)| (i > 0 && i % 3 == 0).then_some(',').into_iter().chain([digit]));
    grouped.collect::<String>().chars().rev().collect()
}

fn verdict(check: &Check) -> &'static str {
    match check.verdict() {
        Some(false) => "FAILED",
        Some(true) => "ok",
        None => "not judged",
    }
}

/// In how many positions which checks were not possible, and why: one sentence for those that have both in common.
pub fn not_judged(checks: &[Check]) -> Vec<String> {
    let mut kinds: Vec<(usize, &str, Vec<&str>)> = Vec::new();
    for check in checks.iter().filter(|check| check.left_out > 0) {
        let (count, why) = (check.left_out, check.why_left_out);
        match kinds.iter_mut().find(|kind| (kind.0, kind.1) == (count, why)) {
            Some((_, _, names)) => names.push(check.name),
            None => kinds.push((count, why, vec![check.name])),
        }
    }
    let sentence = |(count, why, names): (usize, &str, Vec<&str>)| {
        let positions = if count == 1 { "position" } else { "positions" };
        format!("not judged in {count} {positions}: {}: {why}", names.join(", "))
    };
    let alone = checks.iter().filter(|check| check.verdict().is_none() && check.left_out == 0);
    let alone = alone.map(|check| format!("not judged: {}: {}", check.name, check.why_left_out));
    kinds.into_iter().map(sentence).chain(alone).collect()
}

/// Broken into lines of the report's width; all but the first are indented by `indent` columns.
pub fn wrapped(words: &str, indent: usize, ascii: bool) -> String {
    wrap(&if ascii { crate::to_ascii(words) } else { words.into() }, 0, indent)
}

#[cfg(test)]
mod tests;
