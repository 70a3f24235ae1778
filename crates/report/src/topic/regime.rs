//! The periodic regime: its numbers, how it was found, its course over the cycle.

use assur_analysis::results::{Analysis, Dynamics, Owner, Quantity, Regime, RegimeState};
use assur_book::{Column, Digits, Document, Fact, Table, Unit};
use assur_words::{Text, name, number, text};

use super::{Source, Values, each};

/// Rows of the table over a cycle, without the first.
const ROWS: usize = 48;

/// The numbers of the regime and of its drive; none without a regime. Every form takes them from here.
pub fn facts(analysis: &Analysis) -> Vec<Fact> {
    let Some(found) = &analysis.dynamics else { return Vec::new() };
    let kind = analysis.input.kind;
    let ([rate, _], place, moment) = (Unit::rates_of(kind), Unit::coordinate(kind), Unit::load_of(kind));
    let (figures, regime) = (&found.figures, &found.regime.found);
    let some = |id, value: Option<f64>, unit: Unit| value.map(|value| Fact::number(id, value, unit));
    // Where the loads drive, these facts are named for braking and have the other sign.
    let loads_drive = found.loads_drive();
    let one_of = |[usual, other]: [&'static str; 2], value: Option<f64>, unit| {
        if loads_drive { some(other, value.map(|value| -value), unit) } else { some(usual, value, unit) }
    };
    let motor = found.motor.as_ref().map(|found| &*found.motor);
    let named = motor.filter(|motor| !motor.designation.is_empty());
    let speed_min = Fact::number("fact-least-speed", figures.speed_min, rate);
    let speed_max = Fact::number("fact-greatest-speed", figures.speed_max, rate);
    let [driving, resisting, friction] =
        [Quantity::DrivingWork, Quantity::ResistingWork, Quantity::FrictionWork].map(|of| last(analysis, of));
    [
        some("fact-mean-speed", Some(figures.mean_speed), rate),
        some("fact-unevenness", Some(figures.unevenness), Unit::NONE),
        some("fact-dynamic-unevenness", figures.dynamic_unevenness, Unit::NONE),
        Some(speed_min.at(&[figures.coordinate_at_min], place)),
        Some(speed_max.at(&[figures.coordinate_at_max], place)),
        some("fact-cycle-time", Some(regime.cycle_time), Unit::SECOND),
        some("fact-excess-work", Some(figures.excess_work), Unit::JOULE),
        one_of(["fact-mean-resistance", "fact-mean-driving"], Some(regime.mean_resistance), moment),
        one_of(["fact-resistance-work", "fact-net-driving-work"], Some(regime.resistance_work), Unit::JOULE),
        some("fact-driving-work", driving, Unit::JOULE),
        some("fact-resisting-work", resisting, Unit::JOULE),
        some("fact-friction-work", friction, Unit::JOULE),
        energies(analysis).map(|range| Fact::range("fact-kinetic-energy", range, Unit::JOULE)),
        one_of(["fact-driving-moment", "fact-braking-moment"], figures.torque, moment),
        one_of(["fact-required-power", "fact-power-taken"], required_power(found, regime), Unit::POWER),
        named.map(|motor| Fact::text("fact-motor", name(motor.designation.clone()))),
        some("fact-rated-power", motor.map(|motor| motor.rated_power), Unit::POWER),
        some("fact-gear-ratio", figures.ratio, Unit::NONE),
        some("fact-flywheel", found.flywheel, Unit::INERTIA),
        some(
            "fact-shaft-inertia",
            Some(regime.drive_inertia).filter(|inertia| *inertia > 0.0),
            Unit::inertias(kind)[0],
        ),
        some("fact-multiplier", Some(regime.multiplier), Unit::NONE),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The power that the motor needs, W; `None` without a motor where it is only rounding of the powers in the cycle.
fn required_power(found: &Dynamics, regime: &Regime) -> Option<f64> {
    /// In parts of the power that accelerates and brakes the links.
    const ROUNDING: f64 = 1e-9;
    let is_rounding =
        found.figures.required_power.abs() * regime.cycle_time <= ROUNDING * found.figures.excess_work.abs();
    (found.motor.is_some() || !is_rounding).then_some(found.figures.required_power)
}

/// The work over the whole cycle.
fn last(analysis: &Analysis, work: Quantity) -> Option<f64> {
    each(&analysis.trajectory, Values::of(work, Owner::Input)).into_iter().flatten().last()
}

/// The range of the kinetic energy (E eq. 1).
fn energies(analysis: &Analysis) -> Option<[f64; 2]> {
    let all = || {
        each(&analysis.trajectory, Values::of(Quantity::KineticEnergy, Owner::Input)).into_iter().flatten()
    };
    Some([all().reduce(f64::min)?, all().reduce(f64::max)?])
}

/// How the regime was found, and the trials of ratio and flywheel.
pub fn iteration(source: &Source<'_>, page: &mut Document) {
    let Some(regime) = source.analysis.dynamics.as_ref().map(|found| &found.regime.found) else { return };
    let effort = &regime.effort;
    page.paragraph(text!(
        "report-effort",
        cycles = effort.cycles,
        panels = effort.panels,
        evaluations = effort.evaluations,
        residual = number(format_args!("{:.1e}", effort.residual))
    ));
    let [rate, _] = Unit::rates_of(source.kind);
    let long = |head: Text, unit: Unit| Column::short(head, unit).with(Digits::Long);
    let table = Table::each(text!("report-iteration"), &regime.iterations)
        .column(text!("head-cycle"), |turn| number(turn.number))
        .add(long(text!("head-start-speed"), rate), |turn| turn.speed_start)
        .add(long(text!("head-end-speed"), rate), |turn| turn.speed_end)
        .add(Column::short(text!("head-difference"), rate).with(Digits::Exponent), |turn| turn.residual);
    page.table(table.table());
    if regime.trials.len() > 1 {
        let table = Table::each(text!("report-trials"), &regime.trials)
            .column(text!("head-trial"), |trial| number(trial.number))
            .add(long(text!("head-ratio"), Unit::NONE), |trial| trial.ratio)
            .add(long(text!("head-flywheel"), Unit::INERTIA), |trial| trial.flywheel)
            .add(long(text!("head-mean-speed"), rate), |trial| trial.mean_speed)
            .add(long(text!("head-unevenness"), Unit::NONE), |trial| trial.unevenness);
        page.table(table.table());
    }
}

/// Speed, moments and inertia over the cycle.
pub(super) fn course(source: &Source<'_>, page: &mut Document) {
    let Some(regime) = source.analysis.dynamics.as_ref().map(|found| &found.regime) else { return };
    let ([rate, _], load) = (Unit::rates_of(source.kind), Unit::load_of(source.kind));
    let [inertia, derivative] = Unit::inertias(source.kind);
    // Every so many rows, both ends included; JSON has all.
    let stride = (regime.course.len().saturating_sub(1) / ROWS).max(1);
    let rows: Vec<_> = regime.course.iter().step_by(stride).collect();
    let column = |head, unit: Unit, value: &dyn Fn(&RegimeState) -> Option<f64>| {
        Column::numbers(head, unit, rows.iter().map(|row| value(row)))
    };
    let key = column(source.coordinate_head(), source.coordinate(), &|row| Some(row.coordinate));
    let mean = regime.found.mean_resistance;
    let columns = vec![
        column(text!("head-speed"), rate, &|row| Some(row.speed)),
        column(text!("head-first-turn"), rate, &|row| row.first_turn),
        column(text!("head-loads"), load, &|row| Some(row.load)),
        column(text!("head-drive"), load, &|row| Some(row.drive)),
        column(text!("head-mean-load"), load, &|row| Some(-mean * if row.speed < 0.0 { -1.0 } else { 1.0 })),
        column(name("J"), inertia, &|row| Some(row.inertia)),
        column(name("J'"), derivative, &|row| Some(row.inertia_derivative)),
    ];
    page.table(Table::over(text!("report-regime-course"), vec![key], columns));
}
