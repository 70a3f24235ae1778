//! The drive: motor, ratio, flywheel by every method; its characteristic and moments; the two places of the flywheel
//! and other motors.

use assur_analysis::results::Dynamics;
use assur_picture::drive::figure;
use assur_picture::in_a_line;
use assur_report::text::Line;
use assur_report::topic::{self, Source};
use assur_words::{Text, name, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use unicode_width::UnicodeWidthStr;

use super::motion::numbers;
use super::page;
use crate::screen::draw::{cut, paint, put, short};
use crate::screen::state::{Found, Role, Scene, State, View, ViewPart};

/// Columns of motor and flywheel beside the numbers of the regime.
const LEFT: u16 = 47;
/// Rows that the plots below the numbers need.
const PLOTS: u16 = 12;
/// What the first part tells of the motor; the page of the whole drive has all.
const MOTOR: [&str; 9] = [
    "fact-motor",
    "fact-rated-power",
    "fact-synchronous-speed",
    "fact-rated-speed",
    "fact-breakdown-ratio",
    "fact-rotor",
    "fact-working-speed",
    "fact-working-torque",
    "fact-rms-torque",
];

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let Some(dynamics) = &found.analysis.dynamics else { return };
    let [title, area] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let facts = topic::regime_facts(&found.analysis);
    let heading = in_a_line(&facts, &["fact-unevenness", "fact-mean-speed", "fact-flywheel"]);
    put(buffer, title, 1, 0, &state.told(heading), state.look.theme.style(Role::Header));
    match state.part(View::Drive) {
        ViewPart::Curves | ViewPart::EnergyMass | ViewPart::Inertia | ViewPart::Reduction => {
            paint(state, &figure(scene, &state.pictured(), state.part(View::Drive), 1), area, buffer);
        }
        ViewPart::Places => {
            let lines = whole(state, scene, area.width);
            // The two drives have room below, or stand in the picture of this part.
            let rows = short(lines.len()) + 1;
            let skip = state.chosen.line.min(lines.len().saturating_sub(area.height.into()));
            page::draw(state, &lines[skip..], &|_| Role::Plain, area, buffer);
            if area.height > rows + PLOTS {
                let below = Rect { y: area.y + rows, height: area.height - rows, ..area };
                paint(state, &figure(scene, &state.pictured(), state.part(View::Drive), 2), below, buffer);
            }
        }
        _ => overview(state, scene, found, dynamics, area, buffer),
    }
}

/// Motor and flywheel, beside them the regime, below them the plots where there is room.
fn overview(
    state: &State,
    scene: &Scene,
    found: &Found,
    dynamics: &Dynamics,
    area: Rect,
    buffer: &mut Buffer,
) {
    let area = warned(state, dynamics, area, buffer);
    let [left, right] = Layout::horizontal([Constraint::Length(LEFT), Constraint::Min(0)]).areas(area);
    let lines = motor_and_flywheel(state, found, dynamics);
    page::draw(state, &lines, &|_| Role::Plain, left, buffer);
    let numbers = numbers(state, &found.analysis, right.width.saturating_sub(1));
    page::draw(state, &numbers, &|_| Role::Plain, right, buffer);
    let rows = short(lines.len().max(numbers.len())) + 1;
    if area.height > rows + PLOTS {
        let below = Rect { y: area.y + rows, height: area.height - rows, ..area };
        paint(state, &figure(scene, &state.pictured(), state.part(View::Drive), 2), below, buffer);
    }
}

/// A notice if there are warnings, whose full text is in the page of the whole drive; returns the remaining area.
fn warned(state: &State, dynamics: &Dynamics, area: Rect, buffer: &mut Buffer) -> Rect {
    let Some(first) = dynamics.motor.as_ref().and_then(|motor| motor.warnings.first()) else { return area };
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let more = state.told(text!("drive-warning-more", key = name(state.keys.first("part"))));
    let room = usize::from(area.width.saturating_sub(6)).saturating_sub(more.width());
    let first = state.told(&first.text);
    put(buffer, line, 1, 0, &format!("! {}  {more}", cut(&first, room)), state.look.theme.style(Role::Bad));
    rest
}

fn motor_and_flywheel(state: &State, found: &Found, dynamics: &Dynamics) -> Vec<Line> {
    let motor = dynamics.motor.as_ref().map(topic::motor_facts).unwrap_or_default();
    let mut lines = page::some_facts(state, LEFT - 2, motor, &MOTOR);
    let regime = topic::regime_facts(&found.analysis);
    lines.extend(page::some_facts(state, LEFT - 2, regime, &["fact-gear-ratio", "fact-flywheel"]));
    let mut methods = topic::flywheel_methods(dynamics);
    methods.caption = Text::default();
    // The formulas are in the page of the whole drive.
    methods.groups.iter_mut().for_each(|group| drop(group.columns.pop()));
    lines.extend(page::told(state, LEFT - 2, |page| page.table(methods)));
    if lines.is_empty() {
        lines = page::told(state, LEFT - 2, |page| page.paragraph(text!("drive-no-motor")));
    }
    lines
}

pub(super) fn whole(state: &State, scene: &Scene, width: u16) -> Vec<Line> {
    let Some(found) = &scene.found else { return Vec::new() };
    let source = Source::of(&found.analysis, &scene.linkage, Some(&[]));
    page::told(state, width.saturating_sub(2), |page| topic::drive(&source, page))
}
