//! Speed, acceleration, J, J', Q over the positions, or the course over time; the numbers of the regime.

use assur_analysis::results::{Analysis, Dynamics};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{curves, put, regime};
use crate::screen::draw::chart::Chart;
use crate::screen::draw::raster::short;
use crate::screen::found::Found;
use crate::screen::number::{digits, number, plain};
use crate::screen::state::{Pane, State};
use crate::screen::study::Study;
use crate::screen::text::{Texts, fill};
use crate::screen::theme::Role;

/// Rows that a chart needs to be read.
const LEAST_ROWS: u16 = 5;
/// Columns for the numbers of the regime.
const NUMBERS: u16 = 30;

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &study.found else { return };
    let lines = found
        .analysis
        .dynamics
        .as_ref()
        .map(|d| numbers(state.texts, d, found.analysis.input.angular))
        .unwrap_or_default();
    let (role, text) = heading(state, study, found);
    let [title, area] =
        Layout::vertical([Constraint::Length(u16::from(!text.is_empty())), Constraint::Min(0)]).areas(area);
    put(buffer, title, 1, 0, &text, state.look.theme.style(role));
    let width = if lines.is_empty() { 0 } else { NUMBERS };
    let [charts, numbers] = Layout::horizontal([Constraint::Min(0), Constraint::Length(width)]).areas(area);
    let regime = found.analysis.dynamics.as_ref().map(|dynamics| &dynamics.regime);
    // Its table needs the whole width.
    if let (Some(regime), Pane::Hodograph) = (regime, state.pane) {
        return regime::draw_iteration(state, regime, area, buffer);
    }
    for (row, line) in lines.iter().enumerate() {
        put(buffer, numbers, 1, short(row), line, state.look.theme.style(Role::Plain));
    }
    if let (Some(regime), Pane::Curves) = (regime, state.pane) {
        return regime::draw_course(state, study, regime, charts, buffer);
    }
    let over_time =
        matches!(state.pane, Pane::Curves | Pane::Hodograph) && !found.analysis.trajectory.is_empty();
    if over_time || found.motion.is_empty() {
        draw_course(state, &found.analysis, charts, buffer);
    } else {
        draw_positions(state, study, found, charts, buffer);
    }
}

/// What the reader looks for first: the unevenness of a regime; or why there is no speed.
fn heading(state: &State, study: &Study, found: &Found) -> (Role, String) {
    let texts = state.texts;
    if let Some(dynamics) = &found.analysis.dynamics {
        let unit = speed_unit(found.analysis.input.angular);
        let [unevenness, mean] = [dynamics.unevenness, dynamics.mean_speed];
        let text = fill(texts.motion_heading, &[&digits(unevenness, 5), &digits(mean, 5), &unit]);
        return (Role::Header, text);
    }
    match (&found.analysis.no_motion, &study.linkage.mechanism.motion) {
        (Some(reason), _) => (Role::Bad, fill(texts.motion_not_found, &[reason]).replace('\n', " ")),
        (None, None) => (Role::Dim, texts.no_motion_heading.to_owned()),
        (None, Some(_)) => (Role::Plain, String::new()),
    }
}

/// Unit of the speed of the input.
pub(crate) fn speed_unit(angular: bool) -> &'static str {
    if angular { "rad/s" } else { "m/s" }
}

fn draw_positions(state: &State, study: &Study, found: &Found, area: Rect, buffer: &mut Buffer) {
    let [charts, axis] = Layout::vertical([Constraint::Min(0), Constraint::Length(2)]).areas(area);
    let shown = usize::from(charts.height / LEAST_ROWS).clamp(1, found.motion.len());
    let count = u32::try_from(shown).unwrap_or(1);
    let stacked = Layout::vertical(vec![Constraint::Ratio(1, count); shown]).split(charts);
    let first = state.chosen.motion % found.motion.len().max(1);
    for (slot, place) in stacked.iter().enumerate() {
        let index = found.motion[(first + slot) % found.motion.len()];
        let series = &found.series[index];
        let chart = Chart {
            title: format!("{}  {}", series.of, series.show(state.position)),
            curves: vec![(series.values.as_slice(), state.look.theme.style(Role::First))],
            marks: Vec::new(),
            cursor: state.position,
            floor: series.floor,
            places: None,
        };
        chart.draw(*place, curves::LABELS, state.look, buffer);
    }
    curves::coordinate_axis(state, study, axis, buffer);
}

/// Coordinate, speed and acceleration over time.
fn draw_course(state: &State, analysis: &Analysis, area: Rect, buffer: &mut Buffer) {
    let course = &analysis.trajectory;
    let (Some(first), Some(last)) = (course.first(), course.last()) else { return };
    let q = if analysis.input.angular { "rad" } else { "m" };
    let [charts, axis] = Layout::vertical([Constraint::Min(0), Constraint::Length(2)]).areas(area);
    let stacked: [Rect; 3] = Layout::vertical([Constraint::Ratio(1, 3); 3]).areas(charts);
    let span = (last.time - first.time).max(f64::MIN_POSITIVE);
    let times: Vec<f64> = course.iter().map(|sample| (sample.time - first.time) / span).collect();
    let columns: [(&str, String, Vec<f64>); 3] = [
        (state.texts.coordinate, q.to_owned(), course.iter().map(|s| s.coordinate).collect()),
        (state.texts.speed, format!("{q}/s"), course.iter().map(|s| s.speed).collect()),
        (state.texts.acceleration, format!("{q}/s2"), course.iter().map(|s| s.acceleration).collect()),
    ];
    let cursor = state.position.min(course.len() - 1);
    for ((name, unit, values), place) in columns.iter().zip(stacked) {
        let chart = Chart {
            title: format!("{name}  {} {unit}", number(values[cursor])),
            curves: vec![(values.as_slice(), state.look.theme.style(Role::First))],
            marks: Vec::new(),
            cursor,
            floor: 0.0,
            places: Some(&times),
        };
        chart.draw(place, curves::LABELS, state.look, buffer);
    }
    let style = state.look.theme.style(Role::Plain);
    put(buffer, axis, curves::LABELS, 0, &plain(first.time), style);
    let end = plain(last.time);
    put(buffer, axis, axis.width.saturating_sub(short(end.len()) + 1), 0, &end, style);
    put(buffer, axis, curves::LABELS, 1, state.texts.time, state.look.theme.style(Role::Dim));
}

/// The numbers of the regime, one a line.
pub(crate) fn numbers(texts: &Texts, dynamics: &Dynamics, angular: bool) -> Vec<String> {
    let speed = speed_unit(angular);
    let degrees = |q: f64| if angular { q.to_degrees() } else { 1e3 * q };
    let place = if angular { "deg" } else { "mm" };
    let all: [(&str, Option<f64>, &str); 10] = [
        (texts.mean_speed, Some(dynamics.mean_speed), speed),
        (texts.unevenness, Some(dynamics.unevenness), ""),
        (texts.least_speed, Some(dynamics.speed_min), speed),
        (texts.at_coordinate, Some(degrees(dynamics.coordinate_at_min)), place),
        (texts.greatest_speed, Some(dynamics.speed_max), speed),
        (texts.at_coordinate, Some(degrees(dynamics.coordinate_at_max)), place),
        (texts.excess_work, Some(dynamics.excess_work), "J"),
        (texts.dynamic_unevenness, dynamics.dynamic_unevenness, ""),
        (texts.torque, dynamics.torque, "N m"),
        (texts.required_power, Some(dynamics.required_power), "W"),
    ];
    let lines = all
        .into_iter()
        .filter_map(|(name, value, unit)| value.map(|value| format!("{name} {} {unit}", digits(value, 5))));
    lines.collect()
}
