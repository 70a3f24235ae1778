//! Motor and flywheel.

use assur_analysis::results::{Advice, AdvisedRegime, Dynamics, SteadyMotor};
use assur_book::{Document, Fact, Listing, Table, Unit};
use assur_motor::{CharacteristicKind, Motor, USUAL_SOURCE, USUAL_UNEVENNESS, rpm};
use assur_words::{Text, joined, name, text};

use super::Source;

/// Motors that are listed beside the chosen one.
const MOST: usize = 10;
/// Kilowatts of a power in W.
const KILOWATT: Unit = Unit::POWER.shown("kW", 1e-3);
/// Turns in a minute of a speed in rad/s.
const RPM: Unit = Unit::TURNING[0].shown("rpm", rpm(1.0));

/// The motor with its characteristic, the motors that would do, and the flywheel by each method and on each shaft.
pub fn drive(source: &Source<'_>, page: &mut Document) {
    let Some(found) = &source.analysis.dynamics else { return };
    if let Some(motor) = &found.motor {
        page.facts(text!("report-motor"), motor_facts(motor));
    }
    if !found.motors_by_unevenness.is_empty() {
        compared(&found.motors_by_unevenness, page);
    }
    if found.regime.found.flywheel_needless {
        page.paragraph(text!("report-flywheel-needless"));
    }
    if let Some(motor) = &found.motor {
        for warning in &motor.warnings {
            page.paragraph(text!("report-warning", warning = &warning.text));
        }
        runners_up(motor, page);
    }
    page.table(flywheel_methods(found));
    page.table(flywheel_places(found));
}

/// The motor: what it is rated for, and how it works in the regime.
pub fn motor_facts(found: &SteadyMotor) -> Vec<Fact> {
    let (motor, work) = (&*found.motor, &found.work);
    let given = motor.designation.is_empty();
    let designation = if given { text!("fact-motor-given") } else { name(motor.designation.clone()) };
    let catalogue = || Fact::text("fact-catalogue", name(motor.catalogue.clone()));
    let speed =
        |id, speed: f64| Fact::text(id, joined(" = ", [Unit::TURNING[0], RPM].map(|unit| unit.show(speed))));
    let some = |id, value: Option<f64>, unit| value.map(|value| Fact::number(id, value, unit));
    [
        Some(Fact::text("fact-motor", designation)),
        (!given).then(catalogue),
        some("fact-rated-power", Some(motor.rated_power), Unit::POWER),
        Some(speed("fact-synchronous-speed", motor.synchronous_speed)),
        Some(speed("fact-rated-speed", motor.rated_speed)),
        some("fact-breakdown-ratio", motor.max_torque_ratio, Unit::NONE),
        some("fact-rotor", motor.rotor_inertia, Unit::INERTIA),
        some("fact-motor-mass", motor.mass, Unit::KILOGRAM),
        some("fact-motor-length", motor.length, Unit::LENGTH),
        some("fact-motor-diameter", motor.diameter, Unit::LENGTH),
        Some(Fact::text("fact-characteristic", characteristic(work.characteristic.kind))),
        some("fact-rated-torque", Some(work.characteristic.rated_torque), Unit::MOMENT),
        some("fact-breakdown-torque", work.characteristic.breakdown_torque, Unit::MOMENT),
        Some(Fact::range("fact-working-speed", work.speed, Unit::TURNING[0])),
        Some(Fact::range("fact-working-torque", work.torque, Unit::MOMENT)),
        some("fact-rms-torque", Some(work.rms_torque), Unit::MOMENT),
        some("fact-starting-load", Some(work.starting_load), Unit::MOMENT),
        some("fact-starting-torque", work.starting_torque, Unit::MOMENT),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A part of a whole; 0 where it is rounding.
fn clean(part: f64) -> f64 {
    if part.abs() < 1e-9 { 0.0 } else { part }
}

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

fn characteristic(kind: CharacteristicKind) -> Text {
    if kind == CharacteristicKind::Kloss { text!("drive-kloss") } else { text!("drive-linear") }
}

/// The words of the shaft of a flywheel by its key.
pub fn flywheel_shaft(key: &'static str) -> Text {
    if key == "input" { text!("drive-input-shaft") } else { text!("drive-motor-shaft") }
}

/// The table of some motors with their rated data.
fn motors<T>(caption: Text, motors: &[T], of: fn(&T) -> &Motor) -> Listing<&T> {
    Table::each(caption, motors)
        .column(text!("head-motor"), |one| &of(one).designation)
        .column(text!("head-catalogue"), |one| &of(one).catalogue)
        .measured(text!("head-power"), KILOWATT, |one| of(one).rated_power)
        .measured(text!("head-rated-speed"), RPM, |one| of(one).rated_speed)
}

fn runners_up(motor: &SteadyMotor, page: &mut Document) {
    let others = &motor.runners_up[..motor.runners_up.len().min(MOST)];
    let caption = text!("report-runners-up", shown = others.len(), all = motor.runners_up.len());
    let table = motors(caption, others, |one| one.motor)
        .column(text!("head-ratio"), |other| other.ratio)
        .measured(text!("head-mass"), Unit::KILOGRAM, |other| other.motor.mass);
    page.table(table.table());
}

/// The flywheel by each method, and how far from the exact one.
pub fn flywheel_methods(found: &Dynamics) -> Table {
    Table::each(text!("report-flywheel-methods"), &found.flywheel_methods)
        .column(text!("head-method"), |one| flywheel_method(one.method))
        .measured(text!("head-flywheel"), Unit::INERTIA, |one| one.flywheel)
        .measured(text!("head-from-exact"), Unit::NONE.shown("%", 100.0), |one| one.difference.map(clean))
        .column(text!("head-formula"), |one| one.formula.clone())
        .table()
}

/// The flywheel on each of the two shafts.
fn flywheel_places(found: &Dynamics) -> Table {
    let kept = |ok| if ok { text!("report-kept") } else { text!("report-exceeded") };
    Table::each(text!("report-flywheel-places"), &found.flywheel_places)
        .column(text!("head-shaft"), |one| flywheel_shaft(one.shaft))
        .measured(name("J"), Unit::INERTIA, |one| one.inertia)
        .measured(text!("head-diameter"), Unit::LENGTH, |one| one.diameter)
        .measured(text!("head-width"), Unit::LENGTH, |one| one.width)
        .measured(text!("head-mass"), Unit::KILOGRAM, |one| one.mass)
        .measured(text!("head-rim-speed"), Unit::MOVING[0], |one| one.rim_speed)
        .measured(text!("head-allowed"), Unit::MOVING[0], |one| one.admissible_rim_speed)
        .column(text!("head-result"), |one| kept(one.ok))
        .table()
}

/// The motors that suit a scene, the best first, out of `count`.
pub fn advice(motors: &[Advice], count: usize, page: &mut Document) {
    page.paragraph(text!("report-motors-first", shown = motors.len(), all = count));
    compared(motors, page);
}

/// Whether a motor starts the mechanism; empty where its torque at rest is not known.
fn starts(regime: &AdvisedRegime) -> Text {
    match regime.starts() {
        Some(true) => text!("report-starts"),
        Some(false) => text!("report-starts-not"),
        None => Text::default(),
    }
}

/// The table of the motors, and the usual values.
fn compared(motors: &[Advice], page: &mut Document) {
    let of = |motor: &Advice, value: fn(&AdvisedRegime) -> f64| motor.regime.as_ref().map(value);
    let table = self::motors(text!("report-motors"), motors, |one| one.motor)
        .column(text!("head-unevenness"), |motor| of(motor, |regime| regime.unevenness))
        .column(text!("head-ratio"), |motor| of(motor, |regime| regime.ratio))
        .measured(text!("head-flywheel"), Unit::INERTIA, |motor| of(motor, |regime| regime.flywheel))
        .column(text!("head-reserve"), |motor| motor.regime.as_ref().and_then(|regime| regime.torque_reserve))
        .measured(text!("head-starting-torque"), Unit::MOMENT, |motor| motor.regime.as_ref()?.starting_torque)
        .measured(text!("head-starting-load"), Unit::MOMENT, |motor| of(motor, |regime| regime.starting_load))
        .column(text!("head-starts"), |motor| motor.regime.as_ref().map_or_else(Text::default, starts))
        .measured(text!("head-mass"), Unit::KILOGRAM, |one| one.motor.mass);
    page.table(table.table());
    let range = |[least, most]: [f64; 2]| {
        let [least, most] = [least, most].map(|value| Unit::NONE.number(value));
        if least == most { least } else { text!("fact-range", least, most) }
    };
    let table = Table::each(text!("report-usual", source = name(USUAL_SOURCE)), &USUAL_UNEVENNESS)
        .column(text!("head-machine"), |usual| usual.machine.clone())
        .column(text!("head-unevenness"), |usual| range(usual.range));
    page.table(table.table());
}
