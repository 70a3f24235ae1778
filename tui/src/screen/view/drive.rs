//! The drive: motor, ratio, flywheel by every method; its characteristic and moments; the two places of the flywheel
//! and other motors.

use assur_analysis::results::{Dynamics, MotorReport, RunnerUp};
use assur_figure::Figure;
use assur_motor::FlywheelSize;
use assur_report::topic::{flywheel_method, flywheel_shaft};
use assur_words::{Text, joined, list, name, number, quantity, text, unit};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use unicode_width::UnicodeWidthStr;

use super::motion::{numbers, unevenness};
use super::regime;
use crate::number::digits;
use crate::screen::draw::{cut, paint, put, put_lines, short, table, wrapped};
use crate::screen::state::{Part, Role, Scene, State, View};

/// Second column of the view, unless the first one is wider.
const RIGHT: usize = 46;
/// Rows that the plots below the numbers need.
const PLOTS: u16 = 12;

type Line = (Role, String);

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let Some(dynamics) = &found.analysis.dynamics else { return };
    let [title, area] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let angular = found.analysis.input.angular;
    let regime = unevenness(dynamics, angular);
    let heading = match dynamics.flywheel {
        Some(inertia) => text!("drive-heading", regime = regime, flywheel = told(inertia, 5, "kg m2")),
        None => regime,
    };
    put(buffer, title, 1, 0, &state.told(heading), state.look.theme.style(Role::Header));
    match state.part(View::Drive) {
        Part::Curves | Part::EnergyMass | Part::Inertia | Part::Reduction => {
            paint(state, &figure(state, scene, 1), area, buffer);
        }
        Part::Places => put_lines(buffer, area, 1, state, &places_and_motors(state, dynamics)),
        _ => {
            let area = warned(state, dynamics, area, buffer);
            let left = motor_and_flywheel(state, dynamics);
            let rows = short(left.len().max(12)) + 1;
            put_lines(buffer, area, 1, state, &left);
            let wide = left.iter().map(|(_, line)| line.width() + 3).max();
            let right = short(wide.unwrap_or_default().max(RIGHT));
            put_lines(buffer, area, right, state, &numbers(state, &found.analysis));
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
    let more = state.told(text!("drive-warning-more", key = name(state.keys.first("part"))));
    let room = usize::from(area.width.saturating_sub(6)).saturating_sub(more.width());
    let first = state.told(first.clone());
    put(buffer, line, 1, 0, &format!("! {}  {more}", cut(&first, room)), state.look.theme.style(Role::Bad));
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
    Figure { title: text!("drive-title"), panels, columns, legend: Vec::new() }
}

/// A number with its unit.
fn told(value: f64, many: usize, unit: &'static str) -> Text {
    quantity(digits(value, many), unit)
}

/// Rows of a name and what follows it, one below the other.
fn aligned(state: &State, rows: Vec<(Text, Text)>) -> Vec<Line> {
    let rows: Vec<[String; 2]> =
        rows.into_iter().map(|(name, value)| [name, value].map(|text| state.told(text))).collect();
    let width = rows.iter().map(|[name, _]| name.width()).max().unwrap_or(0);
    rows.into_iter().map(|[name, value]| (Role::Plain, format!("  {name:<width$} {value}"))).collect()
}

fn motor_and_flywheel(state: &State, dynamics: &Dynamics) -> Vec<Line> {
    let mut lines = dynamics.motor.as_ref().map(|motor| motor_rows(state, motor)).unwrap_or_default();
    let ratio = dynamics.figures.ratio.map(|ratio| text!("drive-ratio", ratio = told(ratio, 6, "")));
    let flywheel =
        dynamics.flywheel.map(|inertia| text!("drive-flywheel", flywheel = told(inertia, 6, "kg m2")));
    lines.extend(ratio.into_iter().chain(flywheel).map(|text| (Role::Header, state.told(text))));
    let sizes = dynamics.flywheel_methods.iter().map(|row| {
        let off = row
            .difference
            .map_or_else(String::new, |part| state.told(number(format_args!("{:+.2}", 1e2 * part))) + " %");
        let size = state.told(told(row.flywheel, 5, ""));
        (flywheel_method(row.method), name(format!("{size:>9} {off:>8}")))
    });
    lines.extend(aligned(state, sizes.collect()));
    if lines.is_empty() {
        lines.push((Role::Dim, state.told(text!("drive-no-motor"))));
    }
    lines
}

/// Rated data, and the motor's operation in the regime.
fn motor_rows(state: &State, motor: &MotorReport) -> Vec<Line> {
    let title = match &motor.catalogue {
        Some(catalogue) => {
            let [motor, catalogue] = [&motor.designation, catalogue].map(|text| name(text.clone()));
            text!("drive-motor", motor = motor, catalogue = catalogue)
        }
        None => text!("drive-motor-of-scene"),
    };
    let range = |[low, high]: [f64; 2], many, unit| {
        joined(" .. ", [number(digits(low, many)), told(high, many, unit)])
    };
    let (rated, work) = (&motor.rated, &motor.work);
    let rows = [
        Some((text!("drive-rated-power"), told(rated.power, 5, "W"))),
        Some((text!("drive-synchronous-speed"), told(rated.synchronous_speed, 5, "rad/s"))),
        Some((text!("drive-rated-speed"), told(rated.rated_speed, 5, "rad/s"))),
        rated.max_torque_ratio.map(|ratio| (text!("drive-breakdown"), told(ratio, 4, ""))),
        rated.inertia.map(|inertia| (text!("drive-rotor"), told(inertia, 5, "kg m2"))),
        Some((text!("drive-works-at"), range(work.speed, 5, "rad/s"))),
        Some((text!("drive-torque"), range(work.torque, 4, "N m"))),
        Some((text!("drive-rms-torque"), told(work.rms_torque, 4, "N m"))),
    ];
    let rows = aligned(state, rows.into_iter().flatten().collect());
    std::iter::once((Role::Header, state.told(title))).chain(rows).collect()
}

/// The two places of the flywheel, warnings, and other suitable motors of the catalogue.
fn places_and_motors(state: &State, dynamics: &Dynamics) -> Vec<Line> {
    let mut lines = vec![(Role::Header, state.told(text!("drive-places")))];
    let wheel = |wheel: &FlywheelSize| {
        let [inertia, diameter, width, mass] =
            [wheel.inertia, 1e3 * wheel.diameter, 1e3 * wheel.width, wheel.mass].map(|x| told(x, 5, ""));
        let [rim, most] = [wheel.rim_speed, wheel.admissible_rim_speed].map(|x| told(x, 4, ""));
        let verdict = if wheel.ok { text!("check-holds") } else { text!("check-fails") };
        [flywheel_shaft(wheel.shaft), inertia, diameter, width, mass, rim, most, verdict]
    };
    let of = |letter, symbol| list([name(letter), unit(symbol)]);
    let head = [
        text!("drive-shaft"),
        unit("kg m2"),
        of("D", "mm"),
        of("b", "mm"),
        unit("kg"),
        text!("drive-rim"),
        text!("drive-at-most"),
        Text::default(),
    ];
    lines.extend(table(state, head, dynamics.flywheel_places.iter().map(wheel)));
    let Some(motor) = &dynamics.motor else { return lines };
    let mass_of = |mass: Option<f64>, unit| mass.map_or_else(|| name("-"), |mass| told(mass, 4, unit));
    if let (Some(length), Some(diameter)) = (motor.length, motor.diameter) {
        let [length, diameter] = [told(1e3 * length, 4, ""), told(1e3 * diameter, 4, "mm")];
        let (own, mass) = (name(motor.designation.clone()), mass_of(motor.mass, "kg"));
        let size = text!("drive-motor-size", motor = own, length = length, diameter = diameter, mass = mass);
        lines.push((Role::Plain, state.told(size)));
    }
    lines.push((Role::Plain, String::new()));
    let other = |other: &RunnerUp| {
        let [power, speed, ratio] = [other.power, other.rated_speed, other.ratio].map(|x| told(x, 5, ""));
        let own = name(format!("{} ({})", other.designation, other.catalogue));
        [own, power, speed, ratio, mass_of(other.mass, "")]
    };
    if !motor.runners_up.is_empty() {
        lines.push((Role::Header, state.told(text!("drive-other-motors"))));
        let head = [
            text!("drive-column-motor"),
            text!("drive-column-power"),
            unit("rad/s"),
            text!("drive-column-ratio"),
            unit("kg"),
        ];
        lines.extend(table(state, head, motor.runners_up.iter().map(other)));
    }
    lines.push((Role::Plain, String::new()));
    for warning in &motor.warnings {
        let rows = wrapped(&state.told(warning.clone()), 75);
        lines.extend(rows.into_iter().map(|row| (Role::Plain, format!("! {row}"))));
    }
    lines
}
