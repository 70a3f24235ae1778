//! The drive: motor, ratio, flywheel by every method; its characteristic and moments; the two places of the flywheel
//! and other motors.

use assur_analysis::results::Dynamics;
use assur_picture::{in_a_line, regime};
use assur_report::text::Line;
use assur_report::topic::{self, Source};
use assur_words::{Text, name, text};
use ratatui::layout::{Constraint, Layout, Rect};
use unicode_width::UnicodeWidthStr;

use super::motion::numbers;
use super::page;
use crate::screen::draw::{Pen, cut, short};
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

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    let Some(found) = &scene.found else { return };
    let Some(dynamics) = &found.analysis.dynamics else { return };
    let [title, area] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let facts = topic::regime_facts(&found.analysis);
    let heading = in_a_line(&facts, &["fact-unevenness", "fact-mean-speed", "fact-flywheel"]);
    pen.tell(title, 1, 0, heading, Role::Header);
    match state.part(View::Drive) {
        ViewPart::Curves | ViewPart::EnergyMass | ViewPart::Inertia | ViewPart::Reduction => {
            pen.paint(&regime::drive(scene, &state.pictured(), state.part(View::Drive), 1), area);
        }
        ViewPart::Places => {
            let lines = whole(state, scene, area.width);
            // The two drives have room below, or stand in the picture of this part.
            let rows = short(lines.len()) + 1;
            page::draw(pen, &lines, state.chosen.line, &|_| Role::Plain, area);
            if area.height > rows + PLOTS {
                let below = Rect { y: area.y + rows, height: area.height - rows, ..area };
                pen.paint(&regime::drive(scene, &state.pictured(), state.part(View::Drive), 2), below);
            }
        }
        _ => overview(pen, scene, found, dynamics, area),
    }
}

/// Motor and flywheel, beside them the regime, below them the plots where there is room.
fn overview(pen: &mut Pen<'_>, scene: &Scene, found: &Found, dynamics: &Dynamics, area: Rect) {
    let state = pen.state;
    let area = warned(pen, dynamics, area);
    let [left, right] = Layout::horizontal([Constraint::Length(LEFT), Constraint::Min(0)]).areas(area);
    let lines = motor_and_flywheel(state, found, dynamics);
    page::draw(pen, &lines, 0, &|_| Role::Plain, left);
    let numbers = numbers(state, &found.analysis, right.width.saturating_sub(1));
    page::draw(pen, &numbers, 0, &|_| Role::Plain, right);
    let rows = short(lines.len().max(numbers.len())) + 1;
    if area.height > rows + PLOTS {
        let below = Rect { y: area.y + rows, height: area.height - rows, ..area };
        pen.paint(&regime::drive(scene, &state.pictured(), state.part(View::Drive), 2), below);
    }
}

/// A notice if there are warnings, whose full text is in the page of the whole drive; returns the remaining area.
fn warned(pen: &mut Pen<'_>, dynamics: &Dynamics, area: Rect) -> Rect {
    let Some(first) = dynamics.motor.as_ref().and_then(|motor| motor.warnings.first()) else { return area };
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    let more = pen.state.told(text!("drive-warning-more", key = name(pen.state.keys.first("part"))));
    let room = usize::from(area.width.saturating_sub(6)).saturating_sub(more.width());
    let first = pen.state.told(&first.text);
    pen.put(line, 1, 0, &format!("! {}  {more}", cut(&first, room)), Role::Bad);
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
