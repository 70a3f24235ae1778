//! Motion over time: how it was found, its samples, energies, and the greatest reactions.

use super::Source;
use super::forces::{force, has_reactions, shown};
use super::layout::{Column, Page};
use super::motion::{each, modulus};
use super::number::{short, single};
use super::units::{JOULE, SECOND};
use assur_analysis::results::{Column as Values, Event, Integration, Owner, Quantity, Table};

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

/// The rows that are shown: every n-th, so that there are at most [`ROWS`], always with the last one.
fn some(all: &Table) -> Vec<usize> {
    let stride = all.len().saturating_sub(1).div_ceil(ROWS - 1).max(1);
    let mut rows: Vec<_> = (0..all.len()).step_by(stride).collect();
    if !all.is_empty() && all.len() % stride != 1 && stride > 1 {
        rows.push(all.len() - 1);
    }
    rows
}

fn samples(source: &Source<'_>, page: &mut Page) {
    let all = &source.analysis.trajectory;
    let (rows, units) = (some(all), &source.units);
    let column = |head: &str, unit, values| {
        let values = each(all, values);
        Column::numbers(head, unit, rows.iter().map(|row| values[*row]))
    };
    let of = |quantity| Values::of(quantity, Owner::Input);
    let time = column("time", SECOND, of(Quantity::Time));
    let mut columns = vec![
        column(&source.analysis.input.link, units.coordinate, Values::COORDINATE),
        column("speed", units.rates[0], of(Quantity::Velocity)),
        column("acceleration", units.rates[1], of(Quantity::Acceleration)),
    ];
    for (head, quantity) in [
        ("driving work", Quantity::DrivingWork),
        ("resisting work", Quantity::ResistingWork),
        ("kinetic energy", Quantity::KineticEnergy),
    ] {
        if all.schema().find(of(quantity)).is_some() {
            columns.push(column(head, JOULE, of(quantity)));
        }
    }
    let drive = all.schema().find(Values::BALANCING).filter(|column| all.has(*column));
    if source.mechanism.drive.is_some() && drive.is_some() {
        columns.push(column("drive", units.reduced[2], Values::BALANCING));
    }
    let (some, all) = (rows.len(), all.len());
    let part = if some < all { format!(" ({some} of {all} samples)") } else { String::new() };
    page.table(&format!("Course{part}"), &[time], vec![columns]);
    holding(source, page);
}

/// The load that holds the motion at rest or at its speed, from the first sample of each interval of holding.
fn holding(source: &Source<'_>, page: &mut Page) {
    let (moment, rate) = (source.units.reduced[2], source.units.rates[0]);
    let all = &source.analysis.trajectory;
    let of = |quantity| each(all, Values::of(quantity, Owner::Input));
    let [time, speed, held, bound] =
        [Quantity::Time, Quantity::Velocity, Quantity::Holding, Quantity::HoldingBound].map(of);
    for row in 0..all.len() {
        let (Some(held), Some(bound), false) =
            (held[row], bound[row], row.checked_sub(1).is_some_and(|before| held[before].is_some()))
        else {
            continue;
        };
        page.paragraph(&format!(
            "Held at {} {} from {} s at the latest: what resists the motion takes on {} {} on the input, of {} {} at most",
            single(speed[row].unwrap_or_default() * rate.factor),
            rate.name,
            single(time[row].unwrap_or_default()),
            single(held * moment.factor),
            moment.name,
            single(bound * moment.factor),
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
        vec![kind.to_string(), single(state.time), coordinate, speed]
    };
    let rows: Vec<_> = found.events.iter().take(EVENTS).map(row).collect();
    page.caption(&format!("Events: jumps, reversals, rest (first {} of {})", rows.len(), found.events.len()));
    let head = ["event", "time, s", &format!("coordinate, {}", unit.name), &format!("speed, {}", rate.name)];
    page.rows(&head, &rows);
}

/// The greatest reaction of each pair over the samples.
fn greatest(source: &Source<'_>, page: &mut Page) {
    let all = &source.analysis.trajectory;
    if !has_reactions(all) {
        return;
    }
    let (schema, times) = (all.schema(), each(all, Values::of(Quantity::Time, Owner::Input)));
    let mut rows = Vec::new();
    for (pair, links) in shown(all) {
        for link in links {
            let sizes = modulus(all, force(pair, link)).into_iter().zip(&times);
            let found = sizes.filter_map(|(size, time)| Some((size?, (*time)?)));
            let Some((size, time)) = found.max_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
            let name = schema.name(Owner::Pair(pair)).into_owned();
            rows.push(vec![name, schema.link(link).to_owned(), single(size), single(time)]);
        }
    }
    page.caption("Greatest reactions at the samples");
    page.rows(&["pair", "on", "greatest R, N", "time, s"], &rows);
}
