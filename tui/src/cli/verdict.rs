//! How a command that calculates a scene ends: the one place in which what was calculated becomes an exit status and what
//! is told on standard error. No position or motion is lost in silence, whichever command lost it.

use std::collections::BTreeSet;
use std::path::Path;

use assur_analysis::results::{Analysis, Check, Failure};
use assur_analysis::{Calculation, lost_positions};
use assur_kinematics::Linkage;
use assur_report::json::analysis::finite;
use assur_words::{Describe, Text, list, name, number, text};

use super::fault::Status;
use super::scene;
use super::style::Style;

/// Most failures that are told in full; of the others only the numbers.
const MOST: usize = 3;
/// Most numbers of further failures.
const MOST_NUMBERS: usize = 100;

/// What is to be told of results, and how a command that has them ends.
#[derive(Debug)]
pub(crate) struct Verdict {
    /// Positions, a motion, or numbers that there are not; the first is the reason for the exit status.
    losses: Vec<Text>,
    /// Checks that fail, or that could judge nothing.
    checks: Vec<Text>,
    /// Whether a check fails, or none of several could judge anything.
    unproved: bool,
    /// Whether all numbers of the results are finite, so that they can be written.
    pub(crate) writable: bool,
}

impl Verdict {
    /// Of the results of a scene, with the checks that were made.
    pub(crate) fn of(analysis: &Analysis, calculation: &Calculation, path: &Path) -> Self {
        let mut losses = failures(&analysis.failures, analysis.survey.failures, path);
        losses.extend(no_motion(calculation, path));
        let not_finite = finite(analysis).err();
        let writable = not_finite.is_none();
        losses.extend(not_finite.map(|problem| text!("cli-error", problem = name(problem.to_string()))));
        let all = &analysis.checks;
        let judged = all.is_empty() || all.iter().any(|check| check.verdict().is_some());
        let mut checks = checks(all);
        if !judged {
            checks.push(text!("verdict-nothing-judged"));
        }
        Self { losses, checks, unproved: !judged || all.iter().any(Check::failed), writable }
    }

    /// Of the motion of a scene, for a command that calculates a single position or sample.
    pub(crate) fn of_motion(calculation: &Calculation, path: &Path) -> Self {
        Self::of_losses(no_motion(calculation, path).into_iter().collect())
    }

    /// Of the positions of a mechanism, for a command that needs neither loads nor motion.
    pub(crate) fn of_positions(linkage: &Linkage, path: &Path) -> Self {
        let (lost, count) = lost_positions(linkage);
        Self::of_losses(failures(&lost, count, path))
    }

    fn of_losses(losses: Vec<Text>) -> Self {
        Self { losses, checks: Vec::new(), unproved: false, writable: true }
    }

    /// The exit status of a command that gives results: 1 where some of them are missing.
    pub(crate) fn status(&self) -> Status {
        if self.losses.is_empty() { Status::Done } else { Status::Failed }
    }

    /// The exit status of a command that vouches for the results: 1 also where a check fails.
    pub(crate) fn proved(&self) -> Status {
        if self.unproved { Status::Failed } else { self.status() }
    }

    /// Tells everything on standard error, what is missing first.
    pub(crate) fn tell(&self, style: Style) {
        self.losses.iter().chain(&self.checks).for_each(|message| style.tell(message));
    }
}

/// Positions without a solution, the first ones in full, each fault of the scene once with its place; `count`: how many
/// there are.
fn failures(failures: &[Failure], count: usize, path: &Path) -> Vec<Text> {
    let mut located = BTreeSet::new();
    let message = |Failure { message, key, .. }: &Failure| {
        let first = key.as_ref().filter(|key| located.insert((*key).clone()));
        let place = first.and_then(|key| scene::at_key(path, key, name(message.clone())));
        place.map_or_else(|| text!("cli-error", problem = name(message.clone())), |fault| fault.describe())
    };
    let mut told: Vec<Text> = failures.iter().take(MOST).map(message).collect();
    if let Some(more) = count.checked_sub(MOST).filter(|more| *more > 0) {
        let rest = failures.iter().skip(MOST).take(MOST_NUMBERS);
        let rest: Vec<_> = rest.map(|failure| number(failure.index)).collect();
        let dots = if rest.len() < more { Some(name("...")) } else { None };
        told.push(text!(
            "verdict-more-positions",
            count = more,
            positions = list(rest.into_iter().chain(dots))
        ));
    }
    told
}

/// Why the requested motion is not found.
fn no_motion(calculation: &Calculation, path: &Path) -> Option<Text> {
    calculation.no_motion.as_ref().map(|error| scene::fault(path, error).describe())
}

fn checks(all: &[Check]) -> Vec<Text> {
    let told = |id: &'static str, check: &Check, reason: &str| {
        text!(id, check = name(check.name), reason = name(reason.to_owned()))
    };
    let failed = all.iter().filter(|check| check.failed());
    let failed = failed.map(|check| told("verdict-failed", check, &check.reason));
    let open = all.iter().filter(|check| check.verdict().is_none());
    let open = open.map(|check| told("verdict-not-judged", check, &check.why_left_out));
    failed.chain(open).collect()
}
