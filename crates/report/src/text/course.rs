//! Motion over time: how it was found, its course, energies, the greatest reactions on the way.

use super::Source;
use super::layout::{Cells, Column, Page};
use super::number::{short, single};
use super::units::Unit;
use assur_analysis::results::{Integration, MotionSample, Named, PairReaction};

/// Rows of the table; of more samples every so many are shown.
const ROWS: usize = 51;
/// Events that are told.
const EVENTS: usize = 20;

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    if let Some(problem) = &source.analysis.no_motion {
        page.section("Motion");
        page.paragraph(&format!("There is no motion to tell: {problem}"));
    }
    if let Some(found) = &source.analysis.integration {
        page.section("Motion");
        integration(source, found, page);
        course(source, page);
        events(source, found, page);
        greatest(source, page);
    }
}

fn integration(source: &Source<'_>, found: &Integration, page: &mut Page) {
    let unit = source.units.coordinate;
    page.paragraph(&format!("Equation of motion: {} (case {} of D 3.21)", found.equation, found.case));
    page.paragraph(&format!("Integrator: {} ({})", found.method, found.reason));
    let cost = &found.statistics;
    page.paragraph(&format!(
        "Tolerance {:e}; {} steps, {} rejected or redone, {} evaluations, {} Jacobians, {} smooth pieces",
        found.tolerance, cost.steps, cost.rejected, cost.evaluations, cost.jacobians, cost.pieces
    ));
    if let Some(product) = cost.stiffness {
        page.paragraph(&format!("Step times largest eigenvalue at the end: {}", short(product)));
    }
    page.paragraph(&format!(
        "End: {} s, {} {} ({} {}), {} {}",
        single(found.end.time),
        single(found.end.coordinate),
        if source.analysis.input.angular { "rad" } else { "m" },
        single(found.end.coordinate * unit.factor),
        unit.name,
        single(found.end.speed),
        source.units.rates[0].name
    ));
    let energy = &found.energy;
    page.paragraph(&format!(
        "Kinetic energy {} J at the start, {} J at the end; potential energy {} J and {} J",
        single(energy.kinetic_start),
        single(energy.kinetic_end),
        single(energy.potential_start),
        single(energy.potential_end)
    ));
    let words = if energy.conservative {
        "Nothing but weights and springs acts; drift of the energy, relative to the largest kinetic energy"
    } else {
        "Work of the other loads, relative to the largest kinetic energy, at most"
    };
    page.paragraph(&format!("{words}: {:.2e}", energy.change));
}

/// Every so many samples that not more than [`ROWS`] are shown, the last one always.
fn shown(all: &[MotionSample]) -> Vec<&MotionSample> {
    let stride = all.len().saturating_sub(1).div_ceil(ROWS - 1).max(1);
    let mut rows: Vec<_> = all.iter().step_by(stride).collect();
    if let Some(last) = all.last().filter(|_| all.len() % stride != 1 && stride > 1) {
        rows.push(last);
    }
    rows
}

/// A column over the samples.
fn column(
    rows: &[&MotionSample],
    head: &str,
    unit: Unit,
    value: impl Fn(&MotionSample) -> Option<f64>,
) -> Column {
    let values = rows.iter().map(|row| value(row).map(|value| value * unit.factor)).collect();
    Column { head: head.to_owned(), unit: unit.name.to_owned(), cells: Cells::Numbers(values) }
}

fn course(source: &Source<'_>, page: &mut Page) {
    let all = &source.analysis.trajectory;
    let rows = shown(all);
    let units = &source.units;
    let seconds = Unit { name: "s", factor: 1.0 };
    let time = column(&rows, "time", seconds, |row| Some(row.time));
    let mut columns = vec![
        column(&rows, &source.analysis.input.link, units.coordinate, |row| Some(row.coordinate)),
        column(&rows, "speed", units.rates[0], |row| Some(row.speed)),
        column(&rows, "acceleration", units.rates[1], |row| Some(row.acceleration)),
    ];
    if source.mechanism.drive.is_some() && all.iter().any(|row| row.balancing.is_some()) {
        columns.push(column(&rows, "drive", units.reduced[2], |row| row.balancing));
    }
    let part = if rows.len() < all.len() {
        format!(" ({} of {} samples)", rows.len(), all.len())
    } else {
        String::new()
    };
    page.caption(&format!("Course{part}"));
    page.table(&[time], vec![columns]);
}

fn events(source: &Source<'_>, found: &Integration, page: &mut Page) {
    if found.events.is_empty() {
        return;
    }
    let (unit, rate) = (source.units.coordinate, source.units.rates[0]);
    let head = ["event", "time, s", &format!("coordinate, {}", unit.name), &format!("speed, {}", rate.name)];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(found.events.iter().take(EVENTS).map(|event| {
        vec![
            event.kind.name().to_owned(),
            single(event.state.time),
            single(event.state.coordinate * unit.factor),
            single(event.state.speed * rate.factor),
        ]
    }));
    page.caption(&format!(
        "Events: jumps, reversals, rest (first {} of {})",
        rows.len() - 1,
        found.events.len()
    ));
    page.rows(&rows);
}

/// The greatest reaction of each pair over the samples.
fn greatest(source: &Source<'_>, page: &mut Page) {
    let all = &source.analysis.trajectory;
    let Some(first) = all.iter().find_map(|row| row.reactions.as_ref()) else { return };
    let force = |row: &MotionSample, pair: usize, link: usize| modulus(row.reactions.as_ref()?, pair, link);
    let mut rows = vec![["pair", "on", "greatest R, N", "time, s"].map(str::to_owned).to_vec()];
    for (pair, (name, reaction)) in first.iter().enumerate() {
        for link in super::forces::shown(source, reaction) {
            let sizes = all.iter().filter_map(|row| Some((force(row, pair, link)?, row.time)));
            let Some((size, time)) = sizes.max_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
            rows.push(vec![name.to_owned(), reaction.forces[link].0.to_string(), single(size), single(time)]);
        }
    }
    page.caption("Greatest reactions at the samples");
    page.rows(&rows);
}

fn modulus(reactions: &Named<PairReaction>, pair: usize, link: usize) -> Option<f64> {
    let (_, reaction) = reactions.0.get(pair)?;
    reaction.forces.get(link).map(|(_, force)| force[0].hypot(force[1]))
}
