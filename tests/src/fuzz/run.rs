//! One scene from its text to the results, as the command `analyze` calculates it.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};

use assur_all as _;
use assur_analysis::results::Analysis;
use assur_analysis::{Calculation, Coverage, Options, Progress};
use assur_kinematics::Misfit;
use assur_report::{csv, json as writer, text};

use super::{exact, json};

/// Pieces of work after which a calculation is stopped: the same for the same scene, whatever the machine.
const MOST_PIECES: usize = 20_000;

/// Positions and samples that are asked for at most: beyond, one input would take the time of thousands.
const MOST_POSITIONS: usize = 2_000;

/// What became of a scene.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// The scene has faults, each told with its place.
    Refused,
    /// The scene is good, but there is no mechanism in it, or no motion can be found.
    Unsolved,
    /// Stopped after very much work, or not begun since very many positions are asked for.
    Stopped,
    /// Calculated; every check that could judge holds.
    Solved,
    /// Calculated; a check fails, and 32 digits can't say that the numbers are right: which one, and by how much.
    CheckFailed(String),
}

/// What must not be.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{what}: {detail}")]
pub struct Finding {
    /// The kind of it, the same for findings of one kind.
    pub what: &'static str,
    /// The message, the key, the check.
    pub detail: String,
}

impl Finding {
    fn new(what: &'static str, detail: impl std::fmt::Display) -> Self {
        Self { what, detail: detail.to_string() }
    }
}

/// Calculates a scene, and holds it to all that must be true of any.
///
/// # Errors
///
/// [`Finding`] where something is not.
pub fn run(scene: &str) -> Result<Outcome, Finding> {
    match catch_unwind(AssertUnwindSafe(|| calculated(scene))) {
        Ok(outcome) => outcome,
        Err(panic) => {
            let text = panic.downcast_ref::<String>().map(String::as_str);
            let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
            Err(Finding::new("panic", text.unwrap_or("without a message")))
        }
    }
}

fn calculated(scene: &str) -> Result<Outcome, Finding> {
    let mechanism = match assur_scene::read("scene.toml", scene) {
        Ok(mechanism) => mechanism,
        Err(errors) => {
            let message = errors.to_string();
            // A fault of a number says that `inf` is none.
            clean("fault of the scene", &message, "inf")?;
            if !message.contains("scene.toml, line ") {
                return Err(Finding::new("fault without a place", message));
            }
            return Ok(Outcome::Refused);
        }
    };
    if mechanism.input.positions > MOST_POSITIONS {
        return Ok(Outcome::Stopped);
    }
    let mut pieces = 0;
    let mut watch = |_: Progress| {
        pieces += 1;
        if pieces > MOST_PIECES { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let calculation = match Calculation::of(mechanism, &Options::default(), &mut watch) {
        Ok(calculation) => calculation,
        Err(error) => {
            clean("error", &error.to_string(), scene)?;
            return Ok(Outcome::Unsolved);
        }
    };
    let Ok(mut analysis) = calculation.analyze(&mut watch) else { return Ok(Outcome::Stopped) };
    let Ok(checks) = calculation.checks(Coverage::Sample, &mut watch) else { return Ok(Outcome::Stopped) };
    analysis.add_checks(checks);
    written(&calculation, &analysis, scene)?;
    judged(&calculation, &analysis)
}

/// What is written of a calculation has only numbers, and no column twice.
fn written(calculation: &Calculation, analysis: &Analysis, scene: &str) -> Result<(), Finding> {
    let written =
        writer::analysis::to_json(analysis, false).map_err(|why| Finding::new("not finite", why))?;
    json::check(&written).map_err(|why| Finding::new("JSON", why))?;
    let report = text::report(
        analysis,
        &calculation.linkage,
        None,
        text::Style { ascii: true, ..text::Style::english() },
    );
    clean("report", &report.map_err(|why| Finding::new("not finite", why))?, scene)?;
    for sheet in csv::of_positions(analysis, true).into_iter().chain(csv::of_trajectory(analysis, true)) {
        let header = sheet.header().map_err(|why| Finding::new("CSV", why))?;
        unique_columns(&String::from_utf8_lossy(&header))?;
    }
    let messages = analysis.failures.iter().map(|failure| &failure.message).chain(&analysis.no_motion);
    for message in messages {
        clean("error", &message.to_string(), scene)?;
    }
    Ok(())
}

/// What became of a calculation: a check that fails must be confirmed by 32 digits.
fn judged(calculation: &Calculation, analysis: &Analysis) -> Result<Outcome, Finding> {
    let failed = analysis.checks.iter().find(|check| check.finding.failed());
    match failed {
        // What a passive part that does not fit misses by, the checks find too.
        Some(_) if !calculation.linkage.misfits.iter().all(Misfit::fits) => Ok(Outcome::Unsolved),
        Some(check) => {
            let detail = format!(
                "{} at {:?} {}: {:e} of {:e}",
                check.name, check.at, check.finding.place, check.finding.error, check.finding.bound
            );
            if exact::places_are_right(&calculation.linkage) {
                return Err(Finding::new("check FAILED where 32 digits find the places right", detail));
            }
            Ok(Outcome::CheckFailed(detail))
        }
        None if analysis.failures.is_empty() && analysis.no_motion.is_none() => Ok(Outcome::Solved),
        None => Ok(Outcome::Unsolved),
    }
}

/// A text for a person has no number that is none, unless the scene has that word, and no character that a terminal obeys.
fn clean(what: &'static str, text: &str, scene: &str) -> Result<(), Finding> {
    let has = |text: &str, word: &str| text.split(|c: char| !c.is_alphanumeric()).any(|other| other == word);
    if ["NaN", "inf"].into_iter().any(|word| has(text, word) && !has(scene, word)) {
        return Err(Finding::new("NaN or inf in a text", format!("{what}: {text}")));
    }
    match text.chars().find(|c| c.is_control() && *c != '\n') {
        Some(c) => Err(Finding::new("control character in a text", format!("{c:?} in {what}"))),
        None => Ok(()),
    }
}

/// The header of a table has no column twice.
fn unique_columns(table: &str) -> Result<(), Finding> {
    let mut columns: Vec<&str> = table.lines().next().unwrap_or_default().split(',').collect();
    columns.sort_unstable();
    match columns.windows(2).find(|two| two[0] == two[1]) {
        Some(two) => Err(Finding::new("column of CSV stands twice", two[0])),
        None => Ok(()),
    }
}
