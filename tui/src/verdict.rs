//! What of the results of a scene is missing or not proved: the one place in which what was calculated becomes what is reported, by
//! commands and in the terminal UI. No position or motion is lost in silence.

use std::collections::BTreeSet;

use assur_analysis::results::{Analysis, Check, Failure};
use assur_analysis::{Calculation, StructureStudy, lost_positions};
use assur_kinematics::{Linkage, Misfit};
use assur_mechanism::CoordinateKind;
use assur_report::json::analysis::finite;
use assur_report::topic;
use assur_words::{Describe, Text, list, name, number, text};

use crate::session::Session;

/// Most failures that are reported in full; of the others only the numbers.
const MOST: usize = 3;
/// Most numbers of further failures.
const MOST_NUMBERS: usize = 100;

/// What is to be reported of results, and how a command that has them ends.
#[derive(Debug, Default)]
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
    /// Of the results of a scene, with the checks that were made. With a session, faults are reported at their lines.
    pub(crate) fn of(analysis: &Analysis, calculation: &Calculation, session: Option<&Session>) -> Self {
        let mut losses = failures(&analysis.failures, analysis.survey.failures, session);
        losses.extend(no_motion(calculation, session));
        losses.extend(misfits(&analysis.structure.passive, calculation.linkage.kind()));
        let not_finite = finite(analysis).err();
        let writable = not_finite.is_none();
        losses.extend(not_finite.map(|problem| text!("cli-error", problem = problem.describe())));
        let all = &analysis.checks;
        let judged = all.is_empty() || all.iter().any(|check| check.finding.holds.is_some());
        let mut checks = checks(all);
        if !judged {
            checks.push(text!("verdict-nothing-judged"));
        }
        Self { losses, checks, unproved: !judged || all.iter().any(|check| check.finding.failed()), writable }
    }

    /// Of the motion of a scene, for a command that calculates a single position or sample.
    pub(crate) fn of_motion(calculation: &Calculation, session: &Session) -> Self {
        Self::of_losses(no_motion(calculation, Some(session)).into_iter().collect())
    }

    /// Of the positions of a mechanism, for a command that needs neither loads nor motion.
    pub(crate) fn of_positions(linkage: &Linkage, session: &Session) -> Self {
        let (lost, count) = lost_positions(linkage);
        let mut losses = failures(&lost, count, Some(session));
        losses.extend(misfits(&linkage.misfits, linkage.kind()));
        Self::of_losses(losses)
    }

    pub(crate) fn of_structure(found: &StructureStudy) -> Self {
        let passive = found.structure.iter().flat_map(|structure| &structure.passive);
        Self::of_losses(misfits(passive, found.kind))
    }

    fn of_losses(losses: Vec<Text>) -> Self {
        Self { losses, checks: Vec::new(), unproved: false, writable: true }
    }

    pub(crate) fn is_complete(&self) -> bool {
        self.losses.is_empty()
    }

    /// Whether nothing is missing, and no check fails.
    pub(crate) fn is_proved(&self) -> bool {
        self.is_complete() && !self.unproved
    }

    /// Everything that is to be reported, what is missing first.
    pub(crate) fn messages(&self) -> impl Iterator<Item = &Text> {
        self.losses.iter().chain(&self.checks)
    }
}

/// Positions without a solution, the first ones in full, each fault of the scene once with its place; `count`: how many
/// there are.
fn failures(failures: &[Failure], count: usize, session: Option<&Session>) -> Vec<Text> {
    let mut located = BTreeSet::new();
    let message = |Failure { message, key, .. }: &Failure| {
        let first = key.as_ref().filter(|key| located.insert((*key).clone()));
        let placed = session.and_then(|session| session.at_key(first?, message.clone()));
        placed.unwrap_or_else(|| text!("cli-error", problem = message))
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

fn misfits<'a>(passive: impl IntoIterator<Item = &'a Misfit>, kind: CoordinateKind) -> Vec<Text> {
    let wrong = passive.into_iter().filter(|passive| !passive.fits());
    wrong.map(|passive| text!("cli-error", problem = topic::passive_part(passive, kind))).collect()
}

fn no_motion(calculation: &Calculation, session: Option<&Session>) -> Option<Text> {
    calculation.no_motion.as_ref().map(|error| match session {
        Some(session) => session.fault(error),
        None => text!("cli-error", problem = error.describe()),
    })
}

fn checks(all: &[Check]) -> Vec<Text> {
    let told = |id: &'static str, check: &Check, reason: &Text| text!(id, check = &check.name, reason);
    let failed = all.iter().filter(|check| check.finding.failed());
    let failed = failed.map(|check| told("verdict-failed", check, &check.reason));
    let open = all.iter().filter(|check| check.finding.holds.is_none());
    let open = open.map(|check| told("verdict-not-judged", check, &check.finding.why));
    failed.chain(open).collect()
}
