//! Steady regime, drive and flywheel.

use assur_analysis::results::{
    Column as Values, Dynamics, FlywheelByMethod, Iteration, MotorAdvice, MotorReport, Owner, Quantity,
    RegimePoint, RegimeReport, RunnerUp, Table, Trial,
};
use assur_motor::{USUAL_SOURCE, USUAL_UNEVENNESS, rpm};

use super::Source;
use super::layout::{Column, Page};
use super::motion::each;
use super::number::{short, single};
use super::units::Unit;

/// Rows of the table over a cycle, without the first.
const ROWS: usize = 48;

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let Some(found) = &source.analysis.dynamics else { return };
    let regime = &found.regime;
    page.section("Steady regime");
    numbers(source, found, regime, page);
    iteration(source, regime, page);
    course(source, regime, page);
    if found.motor.is_some() || found.flywheel.is_some() {
        page.section("Drive and flywheel");
        drive(source, found, page);
        flywheels(found, page);
    }
}

fn row(page: &mut Page, what: &str, value: &str, unit: &str) {
    page.paragraph(format!("{what}: {value} {unit}").trim_end());
}

/// The power that the motor needs, W; `None` without a motor where it is only rounding of the powers in the cycle.
fn required_power(found: &Dynamics, regime: &RegimeReport) -> Option<f64> {
    /// In parts of the power that accelerates and brakes the links.
    const ROUNDING: f64 = 1e-9;
    let is_rounding =
        found.figures.required_power.abs() * regime.cycle_time <= ROUNDING * found.figures.excess_work.abs();
    (found.motor.is_some() || !is_rounding).then_some(found.figures.required_power)
}

fn numbers(source: &Source<'_>, found: &Dynamics, regime: &RegimeReport, page: &mut Page) {
    let (rate, place) = (source.units.rates[0], source.units.coordinate);
    let moment = source.units.reduced[2].name;
    let at = |q: f64| format!("{} {}", single(q * place.factor), place.name);
    let all = [
        ("Mean speed (greatest + least)/2", Some(found.figures.mean_speed), rate.name),
        ("Unevenness (greatest - least)/mean", Some(found.figures.unevenness), ""),
        (
            "Excess work between least and greatest speed, in this motion",
            Some(found.figures.excess_work),
            "J",
        ),
        ("Dynamic unevenness (Artobolevsky)", found.figures.dynamic_unevenness, ""),
        ("Mean resisting moment, reduced to the input", Some(regime.mean_resistance), moment),
        ("Net work that the loads take in a cycle", Some(regime.resistance_work), "J"),
        ("Constant moment of the drive, along its motion", found.figures.torque, moment),
        ("Power that the motor needs, at the mean speed", required_power(found, regime), "W"),
        ("Time of a cycle", Some(regime.cycle_time), "s"),
        ("A small change of the speed is multiplied over a cycle by", Some(regime.multiplier), ""),
    ];
    for (what, value, unit) in all {
        if let Some(value) = value {
            row(page, what, &single(value), unit);
        }
    }
    for (what, speed, q) in [
        ("Least speed", found.figures.speed_min, found.figures.coordinate_at_min),
        ("Greatest speed", found.figures.speed_max, found.figures.coordinate_at_max),
    ] {
        row(page, what, &single(speed), &format!("{} at {}", rate.name, at(q)));
    }
    energies(&source.analysis.trajectory, page);
    let effort = &regime.effort;
    page.paragraph(&format!(
        "Found by shooting on collocation of order 15: {} cycles, {} panels a cycle, {} evaluations of the mechanism; the \
         equation of motion is missed between the nodes by {:.1e} of the kinetic energy",
        effort.cycles, effort.panels, effort.evaluations, effort.residual
    ));
}

/// Works over the cycle, and the range of the kinetic energy (E eq. 1).
fn energies(cycle: &Table, page: &mut Page) {
    let of = |quantity| each(cycle, Values::of(quantity, Owner::Input)).into_iter().flatten();
    let last = |quantity| of(quantity).last();
    if let (Some(driving), Some(resisting)) = (last(Quantity::DrivingWork), last(Quantity::ResistingWork)) {
        row(page, "Work of driving loads over a cycle", &single(driving), "J");
        row(page, "Work of resisting loads over a cycle", &single(resisting), "J");
    }
    let energy = || of(Quantity::KineticEnergy);
    if let (Some(least), Some(most)) = (energy().reduce(f64::min), energy().reduce(f64::max)) {
        let range = format!("{} to {}", single(least), single(most));
        row(page, "Kinetic energy with flywheel and rotor", &range, "J");
    }
}

fn iteration(source: &Source<'_>, regime: &RegimeReport, page: &mut Page) {
    let rate = source.units.rates[0].name;
    if !regime.iteration.is_empty() {
        let row = |turn: &Iteration| {
            let [start, end] = [turn.speed_start, turn.speed_end].map(digits);
            vec![turn.number.to_string(), start, end, format!("{:.3e}", turn.residual)]
        };
        let [start, end] = ["start", "end"].map(|end| format!("speed at the {end}, {rate}"));
        let head = ["cycle", &start, &end, &format!("end - start, {rate}")];
        page.caption("Iteration to the periodic regime from the mean speed (S fig. 10)");
        page.rows(&head, &regime.iteration.iter().map(row).collect::<Vec<_>>());
    }
    if regime.trials.len() > 1 {
        let row = |trial: &Trial| {
            let mut cells = vec![trial.number.to_string(), optional(trial.ratio, digits)];
            cells.extend([trial.flywheel, trial.mean_speed, trial.unevenness].map(digits));
            cells
        };
        let head = ["trial", "ratio", "flywheel, kg m^2", &format!("mean speed, {rate}"), "unevenness"];
        page.caption("Trials of ratio and flywheel, each with its periodic regime (S stage 6)");
        page.rows(&head, &regime.trials.iter().map(row).collect::<Vec<_>>());
    }
}

/// A dash for what is not known.
fn optional(value: Option<f64>, show: fn(f64) -> String) -> String {
    value.map_or_else(|| "-".to_owned(), show)
}

/// Ten digits, to show how the iteration converges.
fn digits(value: f64) -> String {
    let size = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if !(-4.0..10.0).contains(&size) {
        return format!("{value:.9e}");
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 13")]
    let decimals = (9.0 - size).max(0.0) as usize;
    format!("{value:.decimals$}")
}

fn course(source: &Source<'_>, regime: &RegimeReport, page: &mut Page) {
    let units = &source.units;
    // Every so many rows, both ends included; JSON has all.
    let stride = (regime.course.len().saturating_sub(1) / ROWS).max(1);
    let rows: Vec<_> = regime.course.iter().step_by(stride).collect();
    let column = |head: &str, unit: Unit, value: fn(&RegimePoint) -> Option<f64>| {
        Column::of(rows.iter().copied(), head, unit, value)
    };
    let key = column(&source.analysis.input.link, units.coordinate, |row| Some(row.coordinate));
    let mean = regime.mean_resistance;
    let columns = vec![
        column("speed", units.rates[0], |row| Some(row.speed)),
        column("first turn", units.rates[0], |row| row.first_turn),
        column("loads", units.reduced[2], |row| Some(row.load)),
        column("drive", units.reduced[2], |row| Some(row.drive)),
        Column::of(rows.iter().copied(), "mean load", units.reduced[2], |row| {
            Some(-mean * if row.speed < 0.0 { -1.0 } else { 1.0 })
        }),
        column("J", units.reduced[0], |row| Some(row.inertia)),
        column("dJ/dq", units.reduced[1], |row| Some(row.inertia_derivative)),
    ];
    let caption = "Speed in the regime and in the first turn (S fig. 9), moments and inertia reduced to the input (S fig. 12)";
    page.table(caption, &[key], vec![columns]);
}

fn drive(source: &Source<'_>, found: &Dynamics, page: &mut Page) {
    if let Some(motor) = &found.motor {
        motor_lines(motor, page);
    }
    if let Some(ratio) = found.figures.ratio {
        row(page, "Gear ratio (motor speed / input speed)", &single(ratio), "");
    }
    let unit = source.units.reduced[0].name;
    if found.regime.shaft_inertia > 0.0 {
        row(page, "Flywheel and rotor, reduced to the input", &single(found.regime.shaft_inertia), unit);
    }
    if !found.motors_by_unevenness.is_empty() {
        row(
            page,
            "Greatest unevenness for which the motor stays on its stable section",
            &single(found.figures.unevenness),
            "",
        );
        compared(&found.motors_by_unevenness, page);
    }
    if let Some(flywheel) = found.flywheel {
        row(page, "Flywheel, on its own shaft, without the rotor", &single(flywheel), "kg·m²");
    }
    if found.regime.flywheel_needless {
        page.paragraph("The wanted unevenness is met without a flywheel.");
    }
    let Some(motor) = &found.motor else { return };
    for warning in &motor.warnings {
        page.paragraph(&format!("Warning: {warning}"));
    }
    if !motor.runners_up.is_empty() {
        let row = |other: &RunnerUp| {
            let [power, speed] = [other.power / 1e3, rpm(other.rated_speed)].map(short);
            let (name, catalogue) = (other.designation.clone(), other.catalogue.clone());
            vec![name, catalogue, power, speed, single(other.ratio), optional(other.mass, short)]
        };
        let rows: Vec<_> = motor.runners_up.iter().take(10).map(row).collect();
        page.caption(&format!(
            "Other motors that would do, with the ratio that each would need (first {} of {})",
            rows.len(),
            motor.runners_up.len()
        ));
        page.rows(&["motor", "catalogue", "kW", "rpm", "ratio", "mass, kg"], &rows);
    }
}

fn motor_lines(motor: &MotorReport, page: &mut Page) {
    let name = if motor.designation.is_empty() { "given by its rated data" } else { &motor.designation };
    let catalogue = motor.catalogue.as_ref().map_or_else(String::new, |name| format!(" (catalogue {name})"));
    row(page, "Motor", &format!("{name}{catalogue}"), "");
    row(page, "  Rated power", &single(motor.rated.power), "W");
    for (what, speed) in
        [("  Synchronous speed", motor.rated.synchronous_speed), ("  Rated speed", motor.rated.rated_speed)]
    {
        row(page, what, &single(speed), &format!("rad/s ({} rpm)", short(rpm(speed))));
    }
    let optional = [
        ("  Breakdown torque / rated torque", motor.rated.max_torque_ratio, ""),
        ("  Rotor", motor.rated.inertia, "kg·m²"),
        ("  Mass", motor.mass, "kg"),
        ("  Length", motor.length.map(|length| 1e3 * length), "mm"),
        ("  Diameter", motor.diameter.map(|diameter| 1e3 * diameter), "mm"),
    ];
    for (what, value, unit) in optional {
        if let Some(value) = value {
            row(page, what, &short(value), unit);
        }
    }
    let work = &motor.work;
    row(page, "  Characteristic", work.characteristic, "");
    row(page, "  Rated torque", &single(work.rated_torque), "N·m");
    if let Some(breakdown) = work.breakdown_torque {
        row(page, "  Breakdown torque", &single(breakdown), "N·m");
    }
    let [slow, fast] = work.speed.map(single);
    row(page, "  Working section, speed", &format!("{slow} to {fast}"), "rad/s");
    let [low, high] = work.torque.map(single);
    row(page, "  Working section, torque", &format!("{low} to {high}"), "N·m");
    row(page, "  Root mean square torque", &single(work.rms_torque), "N·m");
    row(page, "  Greatest torque of the load at rest", &single(work.starting_load), "N·m");
}

fn flywheels(found: &Dynamics, page: &mut Page) {
    if !found.flywheel_methods.is_empty() {
        let row = |one: &FlywheelByMethod| {
            let difference = optional(one.difference, |part| format!("{:.3}", 100.0 * part));
            vec![one.method.to_owned(), single(one.flywheel), difference, one.formula.to_owned()]
        };
        let rows: Vec<_> = found.flywheel_methods.iter().map(row).collect();
        page.caption("Flywheel by each method (all but the exact one take a constant drive: another excess work A than above)");
        page.rows(&["method", "flywheel, kg·m²", "from exact, %", "formula"], &rows);
    }
    if !found.flywheel_places.is_empty() {
        let rows = found.flywheel_places.iter().map(|one| {
            let kept = if one.ok { "kept" } else { "EXCEEDED" };
            let numbers = [one.inertia, 1e3 * one.diameter, 1e3 * one.width, one.mass, one.rim_speed];
            let mut cells = vec![one.shaft.to_owned()];
            cells.extend(numbers.map(single));
            cells.extend([short(one.admissible_rim_speed), kept.to_owned()]);
            cells
        });
        let head = [
            "shaft",
            "J, kg·m²",
            "diameter, mm",
            "width, mm",
            "mass, kg",
            "rim, m/s",
            "allowed",
            "rim speed",
        ];
        page.caption(
            "The two places of the flywheel (S fig. 13), as a steel disc of width b = 0.1 D: J = π ρ b D⁴/32, m = π ρ b D²/4",
        );
        page.rows(&head, &rows.collect::<Vec<_>>());
    }
}

/// The motors that suit a scene, the best first, out of `count`; `ascii`: no character beyond ASCII.
pub fn advice(motors: &[MotorAdvice], count: usize, ascii: bool) -> String {
    let mut page = Page::new(ascii);
    page.paragraph(&format!(
        "The first {} of {count} motors that have the power and keep the limit of speed",
        motors.len()
    ));
    compared(motors, &mut page);
    page.finish()
}

/// The table of the motors, and the usual values.
fn compared(motors: &[MotorAdvice], page: &mut Page) {
    let row = |motor: &MotorAdvice| {
        let of = |value: fn(&assur_analysis::results::AdvisedRegime) -> f64| {
            motor.regime.as_ref().map_or_else(|| "-".to_owned(), |regime| single(value(regime)))
        };
        vec![
            motor.designation.clone(),
            motor.catalogue.clone(),
            short(motor.power / 1e3),
            short(rpm(motor.rated_speed)),
            of(|regime| regime.unevenness),
            of(|regime| regime.ratio),
            of(|regime| regime.flywheel),
            optional(motor.regime.as_ref().and_then(|regime| regime.torque_reserve), short),
            optional(motor.mass, short),
        ]
    };
    let head =
        ["motor", "catalogue", "kW", "rpm", "unevenness", "ratio", "flywheel, kg·m²", "reserve", "mass, kg"];
    page.caption(
        "Greatest unevenness for which each motor stays on the stable section of its characteristic, with the flywheel for it; \
         reserve: breakdown torque over the greatest torque of the cycle",
    );
    page.rows(&head, &motors.iter().map(row).collect::<Vec<_>>());
    page.caption(&format!("Usual unevenness of machines ({USUAL_SOURCE})"));
    let usual: Vec<_> = USUAL_UNEVENNESS
        .iter()
        .map(|usual| {
            let [least, most] = usual.range.map(short);
            vec![usual.machine.to_owned(), if least == most { least } else { format!("{least} to {most}") }]
        })
        .collect();
    page.rows(&["machine", "unevenness"], &usual);
}
