//! The drive: motor, ratio, flywheel by every method; its characteristic and moments; the two places of the flywheel
//! and other motors.

use assur_analysis::results::{Dynamics, MotorReport};
use assur_figure::Figure;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::motion::{numbers, unevenness};
use super::{energy, regime};
use crate::number::digits;
use crate::screen::draw::{cut, paint, put, put_lines, short, wrapped};
use crate::screen::state::{Part, Role, Scene, State, View};

/// Second column of the view.
const RIGHT: u16 = 46;
/// Rows that the plots below the numbers need.
const PLOTS: u16 = 12;

type Line = (Role, String);

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let Some(dynamics) = &found.analysis.dynamics else { return };
    let [title, area] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let angular = found.analysis.input.angular;
    let flywheel = dynamics.flywheel.map(|flywheel| format!(", flywheel {} kg m2", digits(flywheel, 5)));
    let heading = unevenness(dynamics, angular) + flywheel.as_deref().unwrap_or_default();
    put(buffer, title, 1, 0, &state.words().shown(&heading), state.look.theme.style(Role::Header));
    match state.part(View::Drive) {
        Part::Curves | Part::EnergyMass | Part::Inertia | Part::Reduction => {
            paint(state, &figure(state, scene, 1), area, buffer);
        }
        Part::Places => put_lines(buffer, area, 1, state, &places_and_motors(dynamics)),
        _ => {
            let area = warned(state, dynamics, area, buffer);
            let left = motor_and_flywheel(dynamics);
            let rows = short(left.len().max(12)) + 1;
            put_lines(buffer, area, 1, state, &left);
            put_lines(buffer, area, RIGHT, state, &numbers(dynamics, angular));
            if area.height > rows + PLOTS {
                let below = Rect { y: area.y + rows, height: area.height - rows, ..area };
                paint(state, &figure(state, scene, 2), below, buffer);
            }
        }
    }
}

/// A notice if there are warnings, whose full text is in the last part; returns the remaining area.
fn warned(state: &State, dynamics: &Dynamics, area: Rect, buffer: &mut Buffer) -> Rect {
    let warnings = dynamics.motor.as_ref().map_or(&[][..], |motor| &motor.warnings);
    let Some(first) = warnings.first() else { return area };
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let part = state.keys.first("part");
    let more = format!("  ({part} {part}: whole)");
    let room = usize::from(area.width.saturating_sub(4)).saturating_sub(more.chars().count());
    put(buffer, line, 1, 0, &format!("! {}{more}", cut(first, room)), state.look.theme.style(Role::Bad));
    rest
}

/// Characteristic and moments, the energy-mass diagram, or the shares of the reduced inertia, in so many columns.
pub(super) fn figure(state: &State, scene: &Scene, columns: usize) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let Some(dynamics) = &found.analysis.dynamics else { return Figure::default() };
    let panels = match state.part(View::Drive) {
        Part::EnergyMass => vec![energy::energy_mass(&dynamics.energy_mass)],
        Part::Reduction => energy::reduction(state, scene, found, dynamics).into_iter().collect(),
        Part::Inertia => vec![energy::shares(state, scene, found, dynamics)],
        _ => {
            let moments = regime::moments(state, scene, &dynamics.regime);
            regime::characteristic(dynamics).into_iter().chain([moments]).collect()
        }
    };
    Figure { title: "drive".to_owned(), panels, columns, legend: Vec::new() }
}

fn motor_and_flywheel(dynamics: &Dynamics) -> Vec<Line> {
    let mut lines = dynamics.motor.as_ref().map(motor_rows).unwrap_or_default();
    lines.extend(dynamics.figures.ratio.map(|x| (Role::Header, format!("ratio {}", digits(x, 6)))));
    lines.extend(dynamics.flywheel.map(|x| (Role::Header, format!("flywheel {} kg m2", digits(x, 6)))));
    for row in &dynamics.flywheel_methods {
        let off = row.difference.map_or_else(String::new, |part| format!("{:+.2} %", 1e2 * part));
        lines.push((Role::Plain, format!("  {:<25} {:>9} {off:>8}", row.method, digits(row.flywheel, 5))));
    }
    if lines.is_empty() {
        lines.push((Role::Dim, "this regime has no motor of a catalogue".to_owned()));
    }
    lines
}

/// Rated data, and the motor's operation in the regime.
fn motor_rows(motor: &MotorReport) -> Vec<Line> {
    let title = match &motor.catalogue {
        Some(catalogue) => format!("motor {} ({catalogue})", motor.designation),
        None => "motor (rated data of the scene)".to_owned(),
    };
    let mut lines = vec![(Role::Header, title)];
    let mut add = |name: &str, value: String| lines.push((Role::Plain, format!("  {name:<18} {value}")));
    add("rated power", format!("{} W", digits(motor.rated.power, 5)));
    add("synchronous speed", format!("{} rad/s", digits(motor.rated.synchronous_speed, 5)));
    add("rated speed", format!("{} rad/s", digits(motor.rated.rated_speed, 5)));
    if let Some(ratio) = motor.rated.max_torque_ratio {
        add("breakdown / rated", digits(ratio, 4));
    }
    if let Some(inertia) = motor.rated.inertia {
        add("rotor inertia", format!("{} kg m2", digits(inertia, 5)));
    }
    let work = &motor.work;
    let [low, high] = work.speed.map(|speed| digits(speed, 5));
    add("works at", format!("{low} .. {high} rad/s"));
    let [low, high] = work.torque.map(|torque| digits(torque, 4));
    add("torque", format!("{low} .. {high} N m"));
    add("rms torque", format!("{} N m", digits(work.rms_torque, 4)));
    lines
}

/// The two places of the flywheel, warnings, and other suitable motors of the catalogue.
fn places_and_motors(dynamics: &Dynamics) -> Vec<Line> {
    let mut lines = vec![(
        Role::Header,
        "flywheel on the input or on the motor shaft: a steel disc, width 1/10".to_owned(),
    )];
    lines.push((
        Role::Dim,
        "shaft          kg m2        D, mm     b, mm          kg     rim, most m/s".to_owned(),
    ));
    for wheel in &dynamics.flywheel_places {
        let word = if wheel.ok { "ok" } else { "FAILED" };
        let [inertia, diameter, width, mass] =
            [wheel.inertia, 1e3 * wheel.diameter, 1e3 * wheel.width, wheel.mass].map(|x| digits(x, 5));
        let rim = format!("{} / {}", digits(wheel.rim_speed, 4), digits(wheel.admissible_rim_speed, 4));
        let row =
            format!("{:<8}{inertia:>12}{diameter:>12}{width:>10}{mass:>12}{rim:>17} {word}", wheel.shaft);
        lines.push((Role::Plain, row));
    }
    if let Some(motor) = &dynamics.motor {
        if let (Some(length), Some(diameter)) = (motor.length, motor.diameter) {
            let size = [1e3 * length, 1e3 * diameter].map(|x| digits(x, 4));
            let mass = motor.mass.map_or_else(|| "-".to_owned(), |mass| digits(mass, 4));
            let name = &motor.designation;
            let text = format!("motor {name}: {} x {} mm, {mass} kg", size[0], size[1]);
            lines.push((Role::Plain, text));
        }
        lines.push((Role::Plain, String::new()));
        if !motor.runners_up.is_empty() {
            lines.push((Role::Header, "other motors that would do, the best first".to_owned()));
            lines.push((
                Role::Dim,
                "motor                                 power, W       rad/s      ratio        kg".to_owned(),
            ));
        }
        for other in &motor.runners_up {
            let mass = other.mass.map_or_else(|| "-".to_owned(), |mass| digits(mass, 4));
            let [power, speed, ratio] = [other.power, other.rated_speed, other.ratio].map(|x| digits(x, 5));
            let name = format!("{} ({})", other.designation, other.catalogue);
            lines.push((Role::Plain, format!("{name:<32}{power:>11}{speed:>12}{ratio:>11}{mass:>10}")));
        }
        lines.push((Role::Plain, String::new()));
        for warning in &motor.warnings {
            let rows = wrapped(warning, 75);
            lines.extend(rows.into_iter().map(|row| (Role::Plain, format!("! {row}"))));
        }
    }
    lines
}
