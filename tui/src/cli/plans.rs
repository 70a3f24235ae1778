//! `assur analyze --plans N`, `--by-cause`.

use std::ops::RangeInclusive;

use assur_analysis::Calculation;
use assur_analysis::results::{Analysis, PositionPlans};
use assur_mechanism::MOST_PARTS_KEPT;
use assur_words::{self as words, Describe, Told, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::Format;
use super::style::Style;

/// Reads a number of a position, or two with `..` between them: the positions from the first to the second.
pub(crate) fn interval(text: &str) -> Result<RangeInclusive<usize>, Told> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let number = |text: &str| text.trim().trim_start_matches('=').parse::<usize>().ok();
    match (number(first), number(last)) {
        (Some(first), Some(last)) if first <= last => Ok(first..=last),
        _ => Err(Told(text!("cli-write-positions"))),
    }
}

/// The positions that are written; `None`: all.
///
/// # Errors
///
/// A position that does not exist, or, for a text, one that was not kept.
pub(crate) fn chosen(
    intervals: &[RangeInclusive<usize>],
    is_text: bool,
    analysis: &Analysis,
    count: usize,
) -> Result<Option<Vec<usize>>, Fault> {
    let Some(last) = intervals.iter().map(|interval| *interval.end()).max() else { return Ok(None) };
    if last >= count {
        return Err(no_position("--positions", last, count));
    }
    let numbers: Vec<usize> = intervals.iter().cloned().flatten().collect();
    let dropped = numbers.iter().find(|number| analysis.positions.row_of(**number).is_none());
    if let Some(number) = dropped.filter(|_| is_text && !analysis.is_complete()) {
        let (position, kept) = (words::number(*number), words::number(analysis.positions.len()));
        return Err(Fault::Other(text!("cli-position-not-kept", position, kept)));
    }
    Ok(Some(numbers))
}

fn no_position(option: &'static str, position: usize, count: usize) -> Fault {
    let [position, last] = [position, count - 1].map(words::number);
    Fault::Other(text!("cli-no-position", option = words::name(option), position, last))
}

/// Additional results.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct PlanArgs {
    /// Add the plans of these positions: velocities, accelerations, instant centers, force polygons, constructions
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub(crate) plans: Vec<usize>,
    /// Split the reactions by cause: weight, inertia, each load; json: their polar diagrams too
    #[arg(long)]
    pub(crate) by_cause: bool,
}

impl PlanArgs {
    /// Rejects a request that can't be fulfilled, before anything is calculated.
    pub(crate) fn refuse(&self, format: Format, study: &Calculation) -> Result<(), Fault> {
        if format == Format::Csv && (self.by_cause || !self.plans.is_empty()) {
            return Err(Fault::Other(text!("cli-plans-no-csv")));
        }
        let count = study.linkage.mechanism.input.positions;
        let mechanism = &study.linkage.mechanism;
        // Each load has a share in the reactions of each part, beside weight and inertia.
        let shares = mechanism.parts() * (mechanism.loads.len() + 2);
        let most = mechanism.most_kept().min(10 * MOST_PARTS_KEPT / shares);
        if self.by_cause && count > most {
            let [most, count] = [most, count].map(words::number);
            return Err(Fault::Other(text!("cli-by-cause-most", most, count)));
        }
        match self.plans.iter().find(|index| **index >= count) {
            Some(index) => Err(no_position("--plans", *index, count)),
            None => Ok(()),
        }
    }

    /// Adds the requested plans, of the `whole` mechanism; a position without plans is reported and makes the command fail.
    pub(crate) fn add(
        &self,
        study: &Calculation,
        whole: impl FnOnce() -> Result<Calculation, Fault>,
        style: Style,
        analysis: &mut Analysis,
    ) -> Result<Status, Fault> {
        let mut status = Status::Done;
        if self.by_cause
            && let Err(error) = study.add_causes(analysis)
        {
            style.tell(text!("cli-no-causes", problem = error.describe()));
            status = Status::Failed;
        }
        if self.plans.is_empty() {
            return Ok(status);
        }
        // The plans show the whole mechanism, whatever results the scene requests.
        let whole = if study.plan.is_partial() { Some(whole()?) } else { None };
        let study = whole.as_ref().unwrap_or(study);
        let mut indices = self.plans.clone();
        indices.sort_unstable();
        indices.dedup();
        for index in indices {
            match study.sheet(index) {
                Ok(sheet) => analysis.cycle.plans.push(PositionPlans { index, sheet }),
                Err(error) => {
                    let problem = error.describe();
                    style.tell(text!("cli-no-plans", position = words::number(index), problem));
                    status = Status::Failed;
                }
            }
        }
        Ok(status)
    }
}
