//! Motor and flywheel.

use assur_analysis::results::{
    AdvisedRegime, Dynamics, FlywheelByMethod, MotorAdvice, MotorReport, RunnerUp,
};
use assur_book::{Cell, Column, Document, Fact, Table, Unit, row};
use assur_motor::{USUAL_SOURCE, USUAL_UNEVENNESS, rpm};
use assur_words::{Text, joined, name, text};

use super::Source;
use super::units::{INERTIA, KILOGRAM, LENGTH, MOMENT, MOVING, POWER, TURNING};

/// Motors that are listed beside the chosen one.
const MOST: usize = 10;
/// Kilowatts of a power in W.
const KILOWATT: Unit = Unit::of("kW", 1e-3);

/// The motor with its characteristic, the motors that would do, and the flywheel by each method and on each shaft.
pub fn drive(source: &Source<'_>, page: &mut Document) {
    let Some(found) = &source.analysis.dynamics else { return };
    if let Some(motor) = &found.motor {
        page.facts(text!("report-motor"), motor_facts(motor));
    }
    if !found.motors_by_unevenness.is_empty() {
        compared(&found.motors_by_unevenness, page);
    }
    if found.regime.flywheel_needless {
        page.paragraph(text!("report-flywheel-needless"));
    }
    if let Some(motor) = &found.motor {
        for warning in &motor.warnings {
            page.paragraph(text!("report-warning", warning));
        }
        runners_up(motor, page);
    }
    page.table(flywheel_methods(found));
    page.table(flywheel_places(found));
}

/// The motor: what it is rated for, and how it works in the regime.
pub fn motor_facts(motor: &MotorReport) -> Vec<Fact> {
    let given = motor.designation.is_empty();
    let designation = if given { text!("fact-motor-given") } else { name(motor.designation.clone()) };
    let catalogue = motor.catalogue.clone().map(|of| Fact::text("fact-catalogue", name(of)));
    let speed = |id, speed: f64| {
        let both = [TURNING[0].show(speed), Unit::of("rpm", 1.0).show(rpm(speed))];
        Fact::text(id, joined(" = ", both))
    };
    let (rated, work) = (&motor.rated, &motor.work);
    let some = |id, value: Option<f64>, unit| value.map(|value| Fact::number(id, value, unit));
    [
        Some(Fact::text("fact-motor", designation)),
        catalogue,
        some("fact-rated-power", Some(rated.power), POWER),
        Some(speed("fact-synchronous-speed", rated.synchronous_speed)),
        Some(speed("fact-rated-speed", rated.rated_speed)),
        some("fact-breakdown-ratio", rated.max_torque_ratio, Unit::NONE),
        some("fact-rotor", rated.inertia, INERTIA),
        some("fact-motor-mass", motor.mass, KILOGRAM),
        some("fact-motor-length", motor.length, LENGTH),
        some("fact-motor-diameter", motor.diameter, LENGTH),
        Some(Fact::text("fact-characteristic", characteristic(work.characteristic))),
        some("fact-rated-torque", Some(work.rated_torque), MOMENT),
        some("fact-breakdown-torque", work.breakdown_torque, MOMENT),
        Some(Fact::range("fact-working-speed", work.speed, TURNING[0])),
        Some(Fact::range("fact-working-torque", work.torque, MOMENT)),
        some("fact-rms-torque", Some(work.rms_torque), MOMENT),
        some("fact-starting-load", Some(work.starting_load), MOMENT),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A part of a whole; 0 where it is rounding.
fn clean(part: f64) -> f64 {
    if part.abs() < 1e-9 { 0.0 } else { part }
}

/// The words of a method for the flywheel by its key.
fn flywheel_method(key: &'static str) -> Text {
    match key {
        "excess-work" => text!("drive-excess-work"),
        "excess-work-less-inertia" => text!("drive-excess-work-less-inertia"),
        "mertsalov" => text!("drive-mertsalov"),
        "wittenbauer" => text!("drive-wittenbauer"),
        "exact" => text!("drive-exact"),
        other => name(other),
    }
}

/// The words of a characteristic by its key.
fn characteristic(key: &'static str) -> Text {
    if key == "kloss" { text!("drive-kloss") } else { text!("drive-linear") }
}

/// The words of the shaft of a flywheel by its key.
pub fn flywheel_shaft(key: &'static str) -> Text {
    if key == "input" { text!("drive-input-shaft") } else { text!("drive-motor-shaft") }
}

/// Columns that say which motor it is: name, catalogue, power, speed.
fn motor_columns() -> [Column; 4] {
    [
        Column::of(text!("head-motor")),
        Column::of(text!("head-catalogue")),
        Column::short(text!("head-power"), KILOWATT),
        Column::short(text!("head-rated-speed"), Unit::of("rpm", rpm(1.0))),
    ]
}

fn runners_up(motor: &MotorReport, page: &mut Document) {
    let others = motor.runners_up.iter().take(MOST);
    let row = |other: &RunnerUp| {
        row![&other.designation, &other.catalogue, other.power, other.rated_speed, other.ratio, other.mass]
    };
    let caption = text!("report-runners-up", shown = others.len(), all = motor.runners_up.len());
    let last = [Column::of(text!("head-ratio")), Column::short(text!("head-mass"), KILOGRAM)];
    page.table(Table::list(caption, motor_columns().into_iter().chain(last)).rows(others.map(row)));
}

/// The flywheel by each method, and how far from the exact one.
pub fn flywheel_methods(found: &Dynamics) -> Table {
    let heads = [
        Column::of(text!("head-method")),
        Column::short(text!("head-flywheel"), INERTIA),
        Column::short(text!("head-from-exact"), Unit::of("%", 100.0)),
        Column::of(text!("head-formula")),
    ];
    let row = |one: &FlywheelByMethod| {
        row![flywheel_method(one.method), one.flywheel, one.difference.map(clean), one.formula.clone()]
    };
    Table::list(text!("report-flywheel-methods"), heads).rows(found.flywheel_methods.iter().map(row))
}

/// The flywheel on each of the two shafts.
fn flywheel_places(found: &Dynamics) -> Table {
    let heads = [
        Column::of(text!("head-shaft")),
        Column::short(name("J"), INERTIA),
        Column::short(text!("head-diameter"), LENGTH),
        Column::short(text!("head-width"), LENGTH),
        Column::short(text!("head-mass"), KILOGRAM),
        Column::short(text!("head-rim-speed"), MOVING[0]),
        Column::short(text!("head-allowed"), MOVING[0]),
        Column::of(text!("head-result")),
    ];
    let mut table = Table::list(text!("report-flywheel-places"), heads);
    for one in &found.flywheel_places {
        let kept = if one.ok { text!("report-kept") } else { text!("report-exceeded") };
        table.row(row![
            flywheel_shaft(one.shaft),
            one.inertia,
            one.diameter,
            one.width,
            one.mass,
            one.rim_speed,
            one.admissible_rim_speed,
            kept
        ]);
    }
    table
}

/// The motors that suit a scene, the best first, out of `count`.
pub fn advice(motors: &[MotorAdvice], count: usize, page: &mut Document) {
    page.paragraph(text!("report-motors-first", shown = motors.len(), all = count));
    compared(motors, page);
}

/// The table of the motors, and the usual values.
fn compared(motors: &[MotorAdvice], page: &mut Document) {
    let row = |motor: &MotorAdvice| {
        let of = |value: fn(&AdvisedRegime) -> f64| motor.regime.as_ref().map(value);
        let reserve = motor.regime.as_ref().and_then(|regime| regime.torque_reserve);
        row![
            &motor.designation,
            &motor.catalogue,
            motor.power,
            motor.rated_speed,
            of(|regime| regime.unevenness),
            of(|regime| regime.ratio),
            of(|regime| regime.flywheel),
            reserve,
            motor.mass
        ]
    };
    let last = [
        Column::of(text!("head-unevenness")),
        Column::of(text!("head-ratio")),
        Column::short(text!("head-flywheel"), INERTIA),
        Column::of(text!("head-reserve")),
        Column::short(text!("head-mass"), KILOGRAM),
    ];
    let columns = motor_columns().into_iter().chain(last);
    page.table(Table::list(text!("report-motors"), columns).rows(motors.iter().map(row)));
    let heads = [text!("head-machine"), text!("head-unevenness")].map(Column::of);
    let mut table = Table::list(text!("report-usual", source = name(USUAL_SOURCE)), heads);
    for usual in &USUAL_UNEVENNESS {
        let [least, most] = usual.range.map(|value| Unit::NONE.number(value));
        let range: Text = if least == most { least } else { text!("fact-range", least, most) };
        table.row([Cell::from(usual.machine.clone()), Cell::from(range)]);
    }
    page.table(table);
}
