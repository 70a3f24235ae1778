//! Motion over time: how it was found, its samples, energies, and the greatest reactions.

use super::Source;
use super::forces::{modulus, shown};
use super::layout::{Column, Page};
use super::number::{short, single};
use super::units::SECOND;
use assur_analysis::results::{Event, Integration, MotionSample};

/// Rows of the table; of more samples every so many are shown.
const ROWS: usize = 51;
/// Events that are listed.
const EVENTS: usize = 20;

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    if let Some(problem) = &source.analysis.no_motion {
        page.section("Motion");
        page.paragraph(&format!("There is no motion to report: {problem}"));
    }
    if let Some(found) = &source.analysis.integration {
        page.section("Motion");
        integration(source, found, page);
        samples(source, page);
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
    if let Some(error) = cost.error {
        page.paragraph(&format!(
            "Estimated error of the motion, as a part of its largest speed and of its travel: {}",
            short(error)
        ));
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

/// Every n-th sample, so that at most [`ROWS`] are shown, always including the last one.
fn some(all: &[MotionSample]) -> Vec<&MotionSample> {
    let stride = all.len().saturating_sub(1).div_ceil(ROWS - 1).max(1);
    let mut rows: Vec<_> = all.iter().step_by(stride).collect();
    if let Some(last) = all.last().filter(|_| all.len() % stride != 1 && stride > 1) {
        rows.push(last);
    }
    rows
}

fn samples(source: &Source<'_>, page: &mut Page) {
    let all = &source.analysis.trajectory;
    let (rows, units) = (some(all), &source.units);
    let rows = || rows.iter().copied();
    let time = Column::of(rows(), "time", SECOND, |row| Some(row.time));
    let input = &source.analysis.input.link;
    let mut columns = vec![
        Column::of(rows(), input, units.coordinate, |row| Some(row.coordinate)),
        Column::of(rows(), "speed", units.rates[0], |row| Some(row.speed)),
        Column::of(rows(), "acceleration", units.rates[1], |row| Some(row.acceleration)),
    ];
    if source.mechanism.drive.is_some() && all.iter().any(|row| row.balancing.is_some()) {
        columns.push(Column::of(rows(), "drive", units.reduced[2], |row| row.balancing));
    }
    let (some, all) = (rows().count(), all.len());
    let part = if some < all { format!(" ({some} of {all} samples)") } else { String::new() };
    page.table(&format!("Course{part}"), &[time], vec![columns]);
    holding(source, page);
}

/// The load that holds the motion at rest or at its speed, from the first sample of each interval of holding.
fn holding(source: &Source<'_>, page: &mut Page) {
    let (moment, rate) = (source.units.reduced[2], source.units.rates[0]);
    let all = &source.analysis.trajectory;
    let before = std::iter::once(None).chain(all.iter().map(|sample| sample.holding));
    for (sample, before) in all.iter().zip(before) {
        let (Some(held), None) = (sample.holding, before) else { continue };
        page.paragraph(&format!(
            "Held at {} {} from {} s at the latest: what resists the motion takes on {} {} on the input, of {} {} at most",
            single(sample.speed * rate.factor),
            rate.name,
            single(sample.time),
            single(held.moment * moment.factor),
            moment.name,
            single(held.bound * moment.factor),
            moment.name
        ));
    }
}

fn events(source: &Source<'_>, found: &Integration, page: &mut Page) {
    if found.events.is_empty() {
        return;
    }
    let (unit, rate) = (source.units.coordinate, source.units.rates[0]);
    let row = |event: &Event| {
        let Event { kind, state } = event;
        let [coordinate, speed] = [state.coordinate * unit.factor, state.speed * rate.factor].map(single);
        vec![kind.name().to_owned(), single(state.time), coordinate, speed]
    };
    let rows: Vec<_> = found.events.iter().take(EVENTS).map(row).collect();
    page.caption(&format!("Events: jumps, reversals, rest (first {} of {})", rows.len(), found.events.len()));
    let head = ["event", "time, s", &format!("coordinate, {}", unit.name), &format!("speed, {}", rate.name)];
    page.rows(&head, &rows);
}

/// The greatest reaction of each pair over the samples.
fn greatest(source: &Source<'_>, page: &mut Page) {
    let all = &source.analysis.trajectory;
    let Some(first) = all.iter().find_map(|row| row.reactions.as_ref()) else { return };
    let mut rows = Vec::new();
    for (pair, name, links) in shown(source, first) {
        for (link, on) in links {
            let force = |row: &MotionSample| Some((modulus(row.reactions.as_ref()?, pair, link)?, row.time));
            let Some((size, time)) = all.iter().filter_map(force).max_by(|a, b| a.0.total_cmp(&b.0)) else {
                continue;
            };
            rows.push(vec![name.to_owned(), on.to_owned(), single(size), single(time)]);
        }
    }
    page.caption("Greatest reactions at the samples");
    page.rows(&["pair", "on", "greatest R, N", "time, s"], &rows);
}
