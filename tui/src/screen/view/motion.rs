//! Speed, acceleration, J, J', Q over the positions, or the course over time; the numbers of the regime.

use assur_analysis::results::{Analysis, Column, Dynamics, Owner, Quantity};
use assur_figure::{Axis, Cursor, Figure, Panel};
use assur_report::topic::regime_facts;
use assur_words::{self as words, Text, joined, quantity, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{advice, curves, plots, regime};
use crate::number::{digits, number};
use crate::screen::draw::{paint, put, put_lines};
use crate::screen::state::{Found, Part, Role, Scene, State, View};

/// Least number of rows of a readable chart.
const LEAST_ROWS: u16 = 5;
/// Columns for the numbers of the regime.
const NUMBERS: u16 = 30;

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let dynamics = found.analysis.dynamics.as_ref();
    let lines = numbers(state, &found.analysis);
    let (role, text) = heading(scene, found);
    let [title, area] =
        Layout::vertical([Constraint::Length(u16::from(!text.is_empty())), Constraint::Min(0)]).areas(area);
    put(buffer, title, 1, 0, &state.told(text), state.look.theme.style(role));
    let width = if lines.is_empty() { 0 } else { NUMBERS };
    let [charts, numbers] = Layout::horizontal([Constraint::Min(0), Constraint::Length(width)]).areas(area);
    let regime = dynamics.map(|dynamics| &dynamics.regime);
    // The table needs the whole width.
    if let (Some(regime), Part::Iteration) = (regime, state.part(View::Motion)) {
        return regime::draw_iteration(state, regime, area, buffer);
    }
    put_lines(buffer, numbers, 1, state, &lines);
    let most = usize::from(charts.height.saturating_sub(2) / LEAST_ROWS);
    paint(state, &figure(state, scene, most), charts, buffer);
}

/// Speed, acceleration, J, J', Q over the positions (at most `most`), or the course over time.
pub(super) fn figure(state: &State, scene: &Scene, most: usize) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let regime = found.analysis.dynamics.as_ref().map(|dynamics| &dynamics.regime);
    let panels = match (regime, state.part(View::Motion)) {
        (Some(regime), Part::Iteration) => regime::iteration(regime),
        (Some(regime), Part::Course) => regime::course(state, scene, &found.analysis, regime),
        (_, part) if part != Part::Overview || found.motion.is_empty() => course(state, &found.analysis),
        _ => {
            let shown = most.clamp(1, found.motion.len());
            let from_chosen = found.motion.iter().cycle().skip(state.chosen.motion % found.motion.len());
            let wanted: Vec<usize> = from_chosen.take(shown).copied().collect();
            curves::stack(state, scene, found, None, &wanted)
        }
    };
    Figure { title: heading(scene, found).1, panels, columns: 1, legend: Vec::new() }
}

/// The most important line: the unevenness of a regime, or why there is no speed.
fn heading(scene: &Scene, found: &Found) -> (Role, Text) {
    if let Some(dynamics) = &found.analysis.dynamics {
        return (Role::Header, unevenness(dynamics, found.analysis.input.angular));
    }
    match (&found.analysis.no_motion, &scene.linkage.mechanism.motion) {
        (Some(reason), _) => (Role::Bad, advice::not_found(reason, " ")),
        (None, None) => (Role::Dim, text!("motion-none")),
        (None, Some(_)) => (Role::Plain, Text::default()),
    }
}

/// `unevenness 0.05, mean speed 6.2832 rad/s`.
pub(super) fn unevenness(dynamics: &Dynamics, angular: bool) -> Text {
    let mean = quantity(digits(dynamics.figures.mean_speed, 5), speed_unit(angular));
    text!("regime-heading", unevenness = words::number(digits(dynamics.figures.unevenness, 5)), mean = mean)
}

/// Unit of the speed of the input.
fn speed_unit(angular: bool) -> &'static str {
    if angular { "rad/s" } else { "m/s" }
}

/// Coordinate, speed, acceleration and energies over time.
fn course(state: &State, analysis: &Analysis) -> Vec<Panel> {
    let q = if analysis.input.angular { "rad" } else { "m" };
    let all = [
        ("motion-coordinate", q.to_owned(), Quantity::Transfer(0)),
        ("motion-speed", format!("{q}/s"), Quantity::Velocity),
        ("motion-acceleration", format!("{q}/s2"), Quantity::Acceleration),
    ];
    let time = Column::of(Quantity::Time, Owner::Input);
    let Some(last) = analysis.trajectory.len().checked_sub(1) else { return Vec::new() };
    let row = state.position.min(last);
    let Some(now) = analysis.trajectory.get(row, time) else { return Vec::new() };
    let times = (0..=last).filter_map(|row| analysis.trajectory.get(row, time));
    let x = Axis::around(text!("motion-time"), times, 0.0);
    let panel = |(told, unit, of): (&'static str, String, Quantity)| {
        let course = regime::sampled(analysis, time, of);
        let value = course.between(now).unwrap_or(f64::NAN);
        let cursor = Cursor { at: now, value: quantity(number(value), unit) };
        plots::curves(text!(told), vec![(text!(told), course)], (x.clone(), 1.0), Some(cursor))
    };
    let energies = regime::energies(analysis, time, (x.clone(), 1.0), now);
    all.map(panel).into_iter().chain(energies).collect()
}

/// The numbers of the regime that have room beside its curves, one a line.
pub(super) fn numbers(state: &State, analysis: &Analysis) -> Vec<(Role, String)> {
    let shown = [
        "fact-mean-speed",
        "fact-unevenness",
        "fact-least-speed",
        "fact-greatest-speed",
        "fact-excess-work",
        "fact-dynamic-unevenness",
        "fact-driving-moment",
        "fact-braking-moment",
        "fact-required-power",
        "fact-power-taken",
    ];
    let facts = regime_facts(analysis).into_iter().filter(|fact| shown.contains(&fact.id));
    let lines = facts.flat_map(|fact| {
        let place = joined(" ", [text!("regime-at"), fact.place()]);
        let place = (!fact.at.is_empty()).then(|| format!("  {}", state.told(place)));
        std::iter::once(state.told(joined(" ", [fact.what().short(), fact.with_unit()]))).chain(place)
    });
    lines.map(|line| (Role::Plain, line)).collect()
}
