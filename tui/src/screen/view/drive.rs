//! The drive: motor, ratio, flywheel by every method; its characteristic and moments; the two places of the flywheel
//! and other motors.

use assur_analysis::results::{Dynamics, MotorReport, RunnerUp};
use assur_figure::Figure;
use assur_motor::FlywheelSize;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::motion::{numbers, unevenness};
use super::regime;
use crate::number::digits;
use crate::screen::draw::{cut, paint, put, put_lines, short, table, wrapped};
use crate::screen::state::{Part, Role, Scene, State, View};
use crate::words::Words;

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
            let left = motor_and_flywheel(dynamics, state.words());
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
    put(
        buffer,
        line,
        1,
        0,
        &format!("! {}{more}", cut(&first.to_string(), room)),
        state.look.theme.style(Role::Bad),
    );
    rest
}

/// Characteristic and moments, the energy-mass diagram, or the shares of the reduced inertia, in so many columns.
pub(super) fn figure(state: &State, scene: &Scene, columns: usize) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let Some(dynamics) = &found.analysis.dynamics else { return Figure::default() };
    let panels = match state.part(View::Drive) {
        Part::EnergyMass => vec![regime::energy_mass(&dynamics.energy_mass)],
        Part::Reduction => regime::reduction(state, scene, found, dynamics).into_iter().collect(),
        Part::Inertia => vec![regime::shares(state, scene, found, dynamics)],
        _ => {
            let moments = regime::moments(state, scene, &dynamics.regime);
            regime::characteristic(dynamics).into_iter().chain([moments]).collect()
        }
    };
    Figure { title: "drive".to_owned(), panels, columns, legend: Vec::new() }
}

/// Rows of a name in the words of the screen, and what follows it, one below the other.
fn aligned(rows: &[(String, String)], words: &Words) -> Vec<Line> {
    let names: Vec<String> = rows.iter().map(|(name, _)| words.shown(name)).collect();
    let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let lines = names.iter().zip(rows);
    lines.map(|(name, (_, value))| (Role::Plain, format!("  {name:<width$} {value}"))).collect()
}

fn motor_and_flywheel(dynamics: &Dynamics, words: &Words) -> Vec<Line> {
    let mut lines = dynamics.motor.as_ref().map(|motor| motor_rows(motor, words)).unwrap_or_default();
    lines.extend(dynamics.figures.ratio.map(|x| (Role::Header, format!("ratio {}", digits(x, 6)))));
    lines.extend(dynamics.flywheel.map(|x| (Role::Header, format!("flywheel {} kg m2", digits(x, 6)))));
    let sizes = dynamics.flywheel_methods.iter().map(|row| {
        let off = row.difference.map_or_else(String::new, |part| format!("{:+.2} %", 1e2 * part));
        (row.method.to_string(), format!("{:>9} {off:>8}", digits(row.flywheel, 5)))
    });
    lines.extend(aligned(&sizes.collect::<Vec<_>>(), words));
    if lines.is_empty() {
        lines.push((Role::Dim, "this regime has no motor of a catalogue".to_owned()));
    }
    lines
}

/// Rated data, and the motor's operation in the regime.
fn motor_rows(motor: &MotorReport, words: &Words) -> Vec<Line> {
    let title = match &motor.catalogue {
        Some(catalogue) => format!("motor {} ({catalogue})", motor.designation),
        None => "motor (rated data of the scene)".to_owned(),
    };
    let mut rows = Vec::new();
    let mut add = |name: &str, value: String| rows.push((name.to_owned(), value));
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
    std::iter::once((Role::Header, title)).chain(aligned(&rows, words)).collect()
}

/// The two places of the flywheel, warnings, and other suitable motors of the catalogue.
fn places_and_motors(dynamics: &Dynamics) -> Vec<Line> {
    let title = "flywheel on the input or on the motor shaft: a steel disc, width 1/10";
    let mut lines = vec![(Role::Header, title.to_owned())];
    let wheel = |wheel: &FlywheelSize| {
        let numbers =
            [wheel.inertia, 1e3 * wheel.diameter, 1e3 * wheel.width, wheel.mass].map(|x| digits(x, 5));
        let speeds = [wheel.rim_speed, wheel.admissible_rim_speed].map(|x| digits(x, 4));
        let word = if wheel.ok { "ok" } else { "FAILED" };
        std::iter::once(wheel.shaft.to_owned())
            .chain(numbers)
            .chain(speeds)
            .chain([word.to_owned()])
            .collect()
    };
    let wheels: Vec<Vec<String>> = dynamics.flywheel_places.iter().map(wheel).collect();
    lines.extend(table(&["shaft", "kg m2", "D, mm", "b, mm", "kg", "rim, m/s", "at most", ""], &wheels));
    if let Some(motor) = &dynamics.motor {
        if let (Some(length), Some(diameter)) = (motor.length, motor.diameter) {
            let size = [1e3 * length, 1e3 * diameter].map(|x| digits(x, 4));
            let mass = motor.mass.map_or_else(|| "-".to_owned(), |mass| digits(mass, 4));
            let name = &motor.designation;
            let text = format!("motor {name}: {} x {} mm, {mass} kg", size[0], size[1]);
            lines.push((Role::Plain, text));
        }
        lines.push((Role::Plain, String::new()));
        let other = |other: &RunnerUp| {
            let mass = other.mass.map_or_else(|| "-".to_owned(), |mass| digits(mass, 4));
            let numbers = [other.power, other.rated_speed, other.ratio].map(|x| digits(x, 5));
            let name = format!("{} ({})", other.designation, other.catalogue);
            std::iter::once(name).chain(numbers).chain([mass]).collect()
        };
        if !motor.runners_up.is_empty() {
            lines.push((Role::Header, "other motors that would do, the best first".to_owned()));
            let others: Vec<Vec<String>> = motor.runners_up.iter().map(other).collect();
            lines.extend(table(&["motor", "power, W", "rad/s", "ratio", "kg"], &others));
        }
        lines.push((Role::Plain, String::new()));
        for warning in &motor.warnings {
            let rows = wrapped(&warning.to_string(), 75);
            lines.extend(rows.into_iter().map(|row| (Role::Plain, format!("! {row}"))));
        }
    }
    lines
}
