//! The drive: motor, ratio, flywheel by every method; its characteristic and moments; places and runners-up.

use assur_analysis::results::{Dynamics, MotorReport};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::motion::{numbers, speed_unit};
use super::panel::cut;
use super::{put, regime};
use crate::screen::draw::raster::short;
use crate::screen::number::digits;
use crate::screen::state::{Pane, State};
use crate::screen::study::Study;
use crate::screen::text::{Texts, fill};
use crate::screen::theme::Role;

/// Second column of the view.
const RIGHT: u16 = 46;
/// Rows that the plots below the numbers need.
const PLOTS: u16 = 12;

type Row = (Role, String);

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &study.found else { return };
    let Some(dynamics) = &found.analysis.dynamics else { return };
    let [title, area] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let heading = heading(state.texts, dynamics, found.analysis.input.angular);
    put(buffer, title, 1, 0, &heading, state.look.theme.style(Role::Header));
    match state.pane {
        Pane::Table | Pane::Causes => {
            let area = warned(state, dynamics, area, buffer);
            let left = motor_and_flywheel(state, dynamics);
            let rows = short(left.len().max(12)) + 1;
            write(state, &left, area, 1, buffer);
            let right: Vec<Row> = numbers(state.texts, dynamics, found.analysis.input.angular)
                .into_iter()
                .map(|line| (Role::Plain, line))
                .collect();
            write(state, &right, area, RIGHT, buffer);
            if area.height > rows + PLOTS {
                let below = Rect { y: area.y + rows, height: area.height - rows, ..area };
                draw_plots(state, study, dynamics, below, true, buffer);
            }
        }
        Pane::Curves => draw_plots(state, study, dynamics, area, false, buffer),
        Pane::Hodograph => write(state, &places_and_motors(state, dynamics), area, 1, buffer),
    }
}

/// What the reader looks for first.
fn heading(texts: &Texts, dynamics: &Dynamics, angular: bool) -> String {
    let [unevenness, mean] = [dynamics.unevenness, dynamics.mean_speed].map(|x| digits(x, 5));
    let unit = speed_unit(angular);
    match dynamics.flywheel {
        Some(flywheel) => fill(texts.drive_heading, &[&unevenness, &mean, &unit, &digits(flywheel, 5)]),
        None => fill(texts.motion_heading, &[&unevenness, &mean, &unit]),
    }
}

fn write(state: &State, rows: &[Row], area: Rect, column: u16, buffer: &mut Buffer) {
    for (row, (role, line)) in rows.iter().enumerate() {
        put(buffer, area, column, short(row), line, state.look.theme.style(*role));
    }
}

/// A line where there are warnings, which stand whole in the last part; what is left of the area.
fn warned(state: &State, dynamics: &Dynamics, area: Rect, buffer: &mut Buffer) -> Rect {
    let warnings = dynamics.motor.as_ref().map_or(&[][..], |motor| &motor.warnings);
    let Some(first) = warnings.first() else { return area };
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let pane = state.keys.first("pane");
    let more = fill(state.texts.warnings_there, &[&pane, &pane]);
    let room = usize::from(area.width.saturating_sub(4)).saturating_sub(more.chars().count());
    put(buffer, line, 1, 0, &format!("! {}{more}", cut(first, room)), state.look.theme.style(Role::Bad));
    rest
}

/// Characteristic and moments, side by side or one above the other.
fn draw_plots(
    state: &State,
    study: &Study,
    dynamics: &Dynamics,
    area: Rect,
    beside: bool,
    buffer: &mut Buffer,
) {
    let halves = [Constraint::Ratio(1, 2); 2];
    let [one, two]: [Rect; 2] =
        if beside { Layout::horizontal(halves).areas(area) } else { Layout::vertical(halves).areas(area) };
    regime::draw_characteristic(state, dynamics, one, buffer);
    regime::draw_moments(state, study, &dynamics.regime, two, buffer);
}

fn motor_and_flywheel(state: &State, dynamics: &Dynamics) -> Vec<Row> {
    let texts = state.texts;
    let mut lines = dynamics.motor.as_ref().map(|motor| motor_rows(texts, motor)).unwrap_or_default();
    lines.extend(dynamics.ratio.map(|x| (Role::Header, fill(texts.ratio_of, &[&digits(x, 6)]))));
    lines.extend(dynamics.flywheel.map(|x| (Role::Header, fill(texts.flywheel_of, &[&digits(x, 6)]))));
    for row in &dynamics.flywheel_methods {
        let off = row.difference.map_or_else(String::new, |part| format!("{:+.2} %", 1e2 * part));
        lines.push((Role::Plain, format!("  {:<25} {:>9} {off:>8}", row.method, digits(row.flywheel, 5))));
    }
    if lines.is_empty() {
        lines.push((Role::Dim, texts.no_motor.to_owned()));
    }
    lines
}

/// Rated data, and how the motor works.
fn motor_rows(texts: &Texts, motor: &MotorReport) -> Vec<Row> {
    let title = match &motor.catalogue {
        Some(catalogue) => fill(texts.motor_of, &[&motor.designation, catalogue]),
        None => texts.own_motor.to_owned(),
    };
    let mut lines = vec![(Role::Header, title)];
    let mut add = |name: &str, value: String| lines.push((Role::Plain, format!("  {name:<18} {value}")));
    add(texts.rated_power, format!("{} W", digits(motor.rated.power, 5)));
    add(texts.synchronous_speed, format!("{} rad/s", digits(motor.rated.synchronous_speed, 5)));
    add(texts.rated_speed, format!("{} rad/s", digits(motor.rated.rated_speed, 5)));
    if let Some(ratio) = motor.rated.max_torque_ratio {
        add(texts.breakdown, digits(ratio, 4));
    }
    if let Some(inertia) = motor.rated.inertia {
        add(texts.rotor_inertia, format!("{} kg m2", digits(inertia, 5)));
    }
    let [low, high] = motor.work.speed.map(|speed| digits(speed, 5));
    add(texts.works_at, format!("{low} .. {high} rad/s"));
    let [low, high] = motor.work.torque.map(|torque| digits(torque, 4));
    add(texts.motor_moment, format!("{low} .. {high} N m"));
    add(texts.rms_torque, format!("{} N m", digits(motor.work.rms_torque, 4)));
    lines
}

/// The two places of the flywheel, warnings, and the runners-up of the catalogue.
fn places_and_motors(state: &State, dynamics: &Dynamics) -> Vec<Row> {
    let mut lines = vec![(Role::Header, state.texts.two_places.to_owned())];
    lines.push((Role::Dim, state.texts.place_columns.to_owned()));
    for wheel in &dynamics.flywheel_places {
        let word = if wheel.ok { state.texts.ok } else { state.texts.failed };
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
            let text = fill(state.texts.motor_size, &[name, &size[0], &size[1], &mass]);
            lines.push((Role::Plain, text));
        }
        lines.push((Role::Plain, String::new()));
        if !motor.runners_up.is_empty() {
            lines.push((Role::Header, state.texts.runners_up.to_owned()));
            lines.push((Role::Dim, state.texts.runner_columns.to_owned()));
        }
        for other in &motor.runners_up {
            let mass = other.mass.map_or_else(|| "-".to_owned(), |mass| digits(mass, 4));
            let [power, speed, ratio] = [other.power, other.rated_speed, other.ratio].map(|x| digits(x, 5));
            let name = format!("{} ({})", other.designation, other.catalogue);
            lines.push((Role::Plain, format!("{name:<32}{power:>11}{speed:>12}{ratio:>11}{mass:>10}")));
        }
        lines.push((Role::Plain, String::new()));
        for warning in &motor.warnings {
            let rows = super::panel::wrapped(warning, 75);
            lines.extend(rows.into_iter().map(|row| (Role::Plain, format!("! {row}"))));
        }
    }
    lines
}
