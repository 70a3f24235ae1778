//! The calculation of one point.

use assur_analysis::results::Failure;
use assur_analysis::{AnalysisError, Calculation, Options, unwatched};
use assur_group::{GroupError, Order};
use assur_mechanism::{Mechanism, Motion};

use crate::row::{Row, SharedNames};
use crate::{Status, measure};

/// Calculates a mechanism and extracts the values of the columns.
pub(crate) fn row(mechanism: Mechanism, options: &Options, names: &SharedNames) -> Row {
    let refused = |error: AnalysisError| {
        let status = if error.is_no_solution() { Status::NoSolution } else { Status::Error };
        Row::without(status, &error.to_string(), None)
    };
    let calculation = match Calculation::of(mechanism, options, &mut unwatched) {
        Ok(calculation) => calculation,
        Err(error) => return refused(error),
    };
    let analysis = match calculation.analyze_positions(&mut unwatched) {
        Ok(analysis) => analysis,
        Err(stopped) => return refused(stopped.into()),
    };
    if let Some(first) = analysis.failures.first() {
        return Row::without(status(&calculation, first), &first.message, Some(failed(&analysis.failures)));
    }
    if let Some(message) = &analysis.no_motion {
        return Row::without(Status::NoSolution, message, Some(0));
    }
    let groups = calculation.plan.groups_needed.iter().filter(|needed| **needed).count();
    let transient = matches!(calculation.linkage.mechanism.motion, Some(Motion::Transient { .. }));
    let cells = measure::cells(&analysis, groups, transient);
    if let Some(column) = cells.not_finite() {
        let message = format!("the number found for `{column}` is not finite");
        return Row::without(Status::Error, &message, Some(0));
    }
    let motor = analysis.dynamics.and_then(|found| found.motor).map(|motor| motor.designation);
    Row {
        motor,
        names: names.shared(cells.names),
        values: cells.values,
        ..Row::without(Status::Ok, "", Some(0))
    }
}

/// Number of positions with failures; a position may have several failures.
fn failed(failures: &[Failure]) -> usize {
    let mut positions: Vec<_> = failures.iter().map(|failure| failure.index).collect();
    positions.sort_unstable();
    positions.dedup();
    positions.len()
}

/// Whether the assembly failed.
fn status(calculation: &Calculation, first: &Failure) -> Status {
    let mut position = calculation.linkage.position();
    match calculation.linkage.solve_index(first.index, Order::Place, &mut position) {
        Err(error) if matches!(error.source, GroupError::NoAssembly { .. }) => Status::NoAssembly,
        _ => Status::NoSolution,
    }
}
