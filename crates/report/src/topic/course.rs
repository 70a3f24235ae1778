//! Motion over time: how it was found, its samples, energies, and the greatest reactions.

use assur_analysis::results::{Integration, Owner, Part, Quantity, Statistic, Table as Results};
use assur_book::{Column, Document, Table, Unit, catalogue};
use assur_integrator::{EventKind, Knob};
use assur_mechanism::{Motion, StepLength};
use assur_words::{Text, name, number, text};

use super::forces::{force, has_reactions};
use super::{Source, Values, each};

/// Rows of the table; of more samples every so many are shown.
const ROWS: usize = 51;
/// Events that are listed.
const EVENTS: usize = 20;

/// Why the motion is not found, where it is not.
pub(super) fn no_motion(source: &Source<'_>, page: &mut Document) {
    if let Some(problem) = &source.analysis.no_motion {
        page.heading(text!("report-motion"));
        page.paragraph(text!("report-no-motion", reason = problem));
    }
}

/// How a motion from an initial state was found, and its course.
pub(super) fn motion_over_time(source: &Source<'_>, page: &mut Document) {
    if let Some(found) = &source.analysis.integration {
        page.heading(text!("report-motion"));
        integration(source, found, page);
        samples(source, page);
        holding(source, page);
        events(source, found, page);
        greatest(source, page);
    }
}

fn integration(source: &Source<'_>, found: &Integration, page: &mut Document) {
    let case = number(found.case);
    page.paragraph(text!("report-equation", equation = &found.equation, case));
    let method = name(found.method.clone());
    page.paragraph(text!("report-integrator", method, reason = &found.reason));
    let cost = &found.statistics;
    let (evaluations, jacobians, pieces) = (cost.evaluations, cost.jacobians, cost.pieces);
    let has_fixed_steps = assur_integrator::find(&found.method).is_ok_and(|method| method.knob == Knob::Step);
    page.paragraph(if has_fixed_steps {
        let step = match source.mechanism.motion {
            Some(Motion::Transient { step: Some(StepLength::Time(step)), .. }) => Unit::SECOND.show(step),
            Some(Motion::Transient { step: Some(StepLength::Way(step)), .. }) => {
                source.coordinate().show(step)
            }
            _ => {
                text!("report-mean-step", step = Unit::SECOND.show(found.end.time / cost.steps.max(1) as f64))
            }
        };
        text!("report-integration-fixed", step, steps = cost.steps, evaluations, jacobians, pieces)
    } else {
        text!(
            "report-integration-cost",
            tolerance = number(format_args!("{:e}", found.tolerance)),
            steps = cost.steps,
            rejected = cost.rejected,
            evaluations,
            jacobians,
            pieces
        )
    });
    if let Some(product) = cost.stiffness {
        page.paragraph(text!("report-stiffness", value = Unit::NONE.show(product)));
    }
    if let Some(error) = cost.error {
        page.paragraph(text!("report-motion-error", value = Unit::NONE.show(error)));
    }
    let raw = Unit::si(if source.kind.is_angle() { "rad" } else { "m" });
    page.paragraph(text!(
        "report-end",
        time = Unit::SECOND.show(found.end.time),
        raw = raw.show(found.end.coordinate),
        coordinate = source.coordinate().show(found.end.coordinate),
        speed = Unit::rates_of(source.kind)[0].show(found.end.speed)
    ));
    let energy = &found.energy;
    page.paragraph(text!(
        "report-energies",
        start = Unit::JOULE.show(energy.kinetic_start),
        end = Unit::JOULE.show(energy.kinetic_end),
        potential_start = Unit::JOULE.show(energy.potential_start),
        potential_end = Unit::JOULE.show(energy.potential_end)
    ));
    let change = number(format_args!("{:.2e}", energy.change));
    page.paragraph(if energy.conservative {
        text!("report-energy-drift", change)
    } else {
        text!("report-energy-work", change)
    });
}

/// The rows that are shown: every n-th, so that there are at most [`ROWS`], always with the last one.
fn some(all: &Results) -> Vec<usize> {
    let stride = all.len().saturating_sub(1).div_ceil(ROWS - 1).max(1);
    let mut rows: Vec<_> = (0..all.len()).step_by(stride).collect();
    if !all.is_empty() && all.len() % stride != 1 && stride > 1 {
        rows.push(all.len() - 1);
    }
    rows
}

fn samples(source: &Source<'_>, page: &mut Document) {
    let all = &source.analysis.trajectory;
    let rows = some(all);
    let column = |head, values| {
        let column = super::column(all, head, values);
        Column { cells: rows.iter().map(|row| column.cells[*row].clone()).collect(), ..column }
    };
    let of = |quantity| Values::of(quantity, Owner::Input);
    let mut columns = vec![column(source.coordinate_head(), Values::COORDINATE)];
    for (head, quantity) in [
        (text!("head-speed"), Quantity::Velocity),
        (text!("head-acceleration"), Quantity::Acceleration),
        (text!("head-driving-work"), Quantity::DrivingWork),
        (text!("head-resisting-work"), Quantity::ResistingWork),
        (text!("head-friction-work-of-course"), Quantity::FrictionWork),
        (text!("head-kinetic-energy"), Quantity::KineticEnergy),
    ] {
        if all.schema().find(of(quantity)).is_some() {
            columns.push(column(head, of(quantity)));
        }
    }
    let drive = all.schema().find(Values::BALANCING).filter(|column| all.has(*column));
    if source.mechanism.drive.is_some() && drive.is_some() {
        columns.push(column(text!("head-drive"), Values::BALANCING));
    }
    let time = column(text!("head-time"), of(Quantity::Time));
    let caption = text!("report-course", shown = rows.len(), all = all.len());
    page.table(Table::over(caption, vec![time], columns));
}

/// The load that holds the motion at rest or at its speed, from the first sample of each interval of holding.
fn holding(source: &Source<'_>, page: &mut Document) {
    let (moment, rate) = (Unit::load_of(source.kind), Unit::rates_of(source.kind)[0]);
    let all = &source.analysis.trajectory;
    let of = |quantity| each(all, Values::of(quantity, Owner::Input));
    let [time, speed, held, bound] =
        [Quantity::Time, Quantity::Velocity, Quantity::Holding, Quantity::HoldingBound].map(of);
    for row in 0..all.len() {
        let (Some(holds), Some(bound), false) =
            (held[row], bound[row], row.checked_sub(1).is_some_and(|before| held[before].is_some()))
        else {
            continue;
        };
        page.paragraph(text!(
            "report-held",
            speed = rate.show(speed[row].unwrap_or_default()),
            time = Unit::SECOND.show(time[row].unwrap_or_default()),
            held = moment.show(holds),
            bound = moment.show(bound)
        ));
    }
}

fn events(source: &Source<'_>, found: &Integration, page: &mut Document) {
    let shown = found.events.iter().take(EVENTS);
    let caption = text!("report-events", shown = shown.len(), all = found.events.len());
    let table = Table::each(caption, shown)
        .column(text!("head-event"), |event| words_of(event.kind))
        .measured(text!("head-time"), Unit::SECOND, |event| event.state.time)
        .measured(text!("head-coordinate"), source.coordinate(), |event| event.state.coordinate)
        .measured(text!("head-speed"), Unit::rates_of(source.kind)[0], |event| event.state.speed);
    page.table(table.table());
}

/// What happened.
fn words_of(kind: EventKind) -> Text {
    match kind {
        EventKind::Coordinate => text!("event-coordinate"),
        EventKind::Speed => text!("event-speed"),
        EventKind::Time => text!("event-time"),
        EventKind::Switch => text!("event-switch"),
        EventKind::Reversal => text!("event-reversal"),
        EventKind::Rest => text!("event-rest"),
        EventKind::Held => text!("event-held"),
        EventKind::Release => text!("event-release"),
        EventKind::Face => text!("event-face"),
    }
}

/// The greatest reaction of each pair over the samples.
fn greatest(source: &Source<'_>, page: &mut Document) {
    let all = &source.analysis.trajectory;
    if !has_reactions(all) {
        return;
    }
    let times = each(all, Values::TIME);
    let greatest = |(pair, link)| {
        let sizes = each(all, force(pair, link).part(Part::Modulus)).into_iter().enumerate();
        let found: Statistic = sizes.filter_map(|(row, size)| Some((row, size?))).collect();
        let found = found.greatest()?;
        Some((pair, link, (found.value, times[found.number]?)))
    };
    let rows = catalogue::reactions(all.schema()).into_iter().filter_map(greatest);
    let table = Table::each(text!("report-greatest-at-samples"), rows)
        .column(text!("head-pair"), |(pair, ..)| source.name(Owner::Pair(*pair)))
        .column(text!("head-on"), |(_, link, _)| source.name(Owner::Link(*link)))
        .measured(text!("head-greatest-force"), Unit::FORCE, |(.., (size, _))| *size)
        .measured(text!("head-time"), Unit::SECOND, |(.., (_, time))| *time);
    page.table(table.table());
}
