//! Plans of the position: force polygon of a group, velocities, accelerations, the constructions step by step.

use assur_diagram::{Plan, PlanVector, VectorKind};
use assur_force::{Construction, Drawing, Step, StepKind};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::advice;
use crate::number::digits;
use crate::screen::draw::{Arrow, Diagram, cut, put_lines, wrapped};
use crate::screen::state::{Bounds, Found, PlanKind, Plans, Role, Scene, State};

/// Columns of the list beside the drawing.
const LIST: u16 = 42;
/// A vector smaller than this part of the greatest counts as zero.
const LEAST: f64 = 1e-12;

/// Name of the pole of a plan of velocities or accelerations.
const POLE: &str = "p";

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let areas = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(area);
    let plans = found.plans.at(state.position);
    if state.plan == PlanKind::Construction {
        return construction(state, &plans, areas, buffer);
    }
    let plan = match &plans.sheet {
        Err(error) => return say(state, &error.to_string(), areas[0], buffer),
        Ok(sheet) => match state.plan {
            PlanKind::Velocity => Some(&sheet.velocities),
            PlanKind::Acceleration => Some(&sheet.accelerations),
            _ if !has_forces(state, found) => None,
            _ => sheet.polygons.get(state.chosen.polygon.min(sheet.polygons.len().saturating_sub(1))),
        },
    };
    match plan {
        Some(plan) => draw_plan(state, plan, areas, buffer),
        None if !found.reactions.is_empty() => {
            say(state, "no forces are determined in this position", areas[0], buffer);
        }
        None => say(state, &advice::text(state, scene), areas[0], buffer),
    }
}

/// Whether forces are determined in this position.
pub(crate) fn has_forces(state: &State, found: &Found) -> bool {
    found.position(state.position).is_some_and(|position| position.balancing.is_some())
}

fn say(state: &State, text: &str, area: Rect, buffer: &mut Buffer) {
    let rows = advice::rows(text, usize::from(area.width.max(12)) - 2);
    let rows: Vec<_> = rows.into_iter().map(|line| (Role::Plain, line)).collect();
    lines(state, &rows, area, buffer);
}

fn lines(state: &State, lines: &[(Role, String)], area: Rect, buffer: &mut Buffer) {
    let cut = Rect { width: area.width.saturating_sub(1), ..area };
    put_lines(buffer, cut, 1, state.look, lines);
}

/// A plan: its vectors as a list, its closure error, and the drawing.
fn draw_plan(state: &State, plan: &Plan, [list, drawing]: [Rect; 2], buffer: &mut Buffer) {
    let width = usize::from(list.width.max(12)) - 2;
    let mut rows: Vec<(Role, String)> =
        wrapped(&plan.title, width).into_iter().map(|line| (Role::Header, line)).collect();
    if state.plan == PlanKind::Forces {
        rows.push((Role::Dim, "F load  R reaction  .. inside the group".to_owned()));
    }
    let least = LEAST * plan.greatest();
    let shown: Vec<&PlanVector> = plan.items.iter().filter(|item| item.size > least).collect();
    // The last rows show the closure error; a long list must not push them out.
    let room = usize::from(list.height).saturating_sub(rows.len() + 1);
    let skip = match state.plan {
        PlanKind::Forces => 0,
        _ => state.chosen.vector.min(shown.len().saturating_sub(room)),
    };
    for (number, item) in shown.iter().enumerate().skip(skip).take(room) {
        let text = format!(
            "{:<4}{:<20}{:>9} {}",
            label(state, item, number),
            cut(&item.name, 19),
            digits(item.size, 5),
            item.unit
        );
        rows.push((Role::Plain, text));
    }
    rows.push((Role::Header, format!("left open: {:.1e} of the greatest", plan.residual)));
    lines(state, &rows, list, buffer);
    let arrows = shown.iter().enumerate().map(|(number, item)| Arrow {
        from: item.start,
        to: item.end,
        name: if role(item.kind) == Role::Trace { String::new() } else { label(state, item, number) },
        role: if state.plan == PlanKind::Acceleration && item.kind == VectorKind::Absolute {
            Role::Acceleration
        } else {
            role(item.kind)
        },
    });
    let pole = matches!(state.plan, PlanKind::Velocity | PlanKind::Acceleration).then_some(POLE);
    Diagram { arrows: arrows.collect(), unit: &plan.unit, pole }.draw(state.look, drawing, buffer);
}

/// The label of a vector in the drawing and in the list: `R3`, or the point of an absolute velocity.
fn label(state: &State, item: &PlanVector, number: usize) -> String {
    match (state.plan, item.kind) {
        (PlanKind::Forces, VectorKind::Reaction) => format!("R{}", number + 1),
        (PlanKind::Forces, VectorKind::Inner) => "..".to_owned(),
        (PlanKind::Forces, _) => format!("F{}", number + 1),
        (_, VectorKind::Absolute) => image(&item.name),
        _ => "..".to_owned(),
    }
}

/// The image of a point in a plan: `a` of `v(A)`, `a'` of `v(A on rocker)`.
fn image(name: &str) -> String {
    let point = name.split_once('(').map_or(name, |(_, point)| point.trim_end_matches(')'));
    match point.split_once(' ') {
        Some((point, _)) => format!("{}'", point.to_lowercase()),
        None => point.to_lowercase(),
    }
}

fn role(kind: VectorKind) -> Role {
    match kind {
        VectorKind::Load | VectorKind::Weight | VectorKind::Inertia | VectorKind::Part => Role::Second,
        VectorKind::Reaction | VectorKind::Balancing | VectorKind::Closing => Role::First,
        VectorKind::Absolute => Role::Velocity,
        _ => Role::Trace,
    }
}

/// Length at which 1 N is drawn: in the drawing of the mechanism the largest force is half as long as the mechanism.
fn force_size(construction: &Construction, kind: Drawing) -> f64 {
    if kind != Drawing::Mechanism {
        return 1.0;
    }
    let steps = construction.steps.iter().filter(|step| step.drawing == kind);
    let (forces, lines): (Vec<_>, Vec<_>) = steps.partition(|step| step.unit == "N");
    let most = forces.iter().map(|step| step.vector[0].hypot(step.vector[1])).fold(0.0, f64::max);
    let ends =
        lines.iter().flat_map(|step| [step.start, [0, 1].map(|axis| step.start[axis] + step.vector[axis])]);
    let [width, height] = Bounds::around(ends).size();
    if most > 0.0 { 0.5 * width.max(height) / most } else { 1.0 }
}

/// The construction and its step that belong to the number of a step over all constructions.
fn chosen_step(plans: &Plans, step: usize) -> Option<(&Construction, usize)> {
    let mut left = step.min(plans.step_count().saturating_sub(1));
    for construction in &plans.constructions {
        if left < construction.steps.len() {
            return Some((construction, left));
        }
        left -= construction.steps.len();
    }
    None
}

/// A construction up to the chosen step, with the sentence that explains it.
fn construction(state: &State, plans: &Plans, [list, drawing]: [Rect; 2], buffer: &mut Buffer) {
    let Some((construction, last)) = chosen_step(plans, state.chosen.step) else {
        return say(state, "no method with a construction fits here", list, buffer);
    };
    let width = usize::from(list.width.max(12)) - 2;
    let mut rows: Vec<(Role, String)> =
        wrapped(&construction.title, width).into_iter().map(|line| (Role::Header, line)).collect();
    let next = state.keys.first("next-step");
    rows.push((
        Role::Plain,
        format!("step {} of {} ({next} draws the next)", last + 1, construction.steps.len()),
    ));
    let Some(step) = construction.steps.get(last) else { return };
    let size = digits(step.vector[0].hypot(step.vector[1]), 5);
    rows.push((Role::Key, format!("{} ({}) {size} {}", step.name, step.kind.word(), step.unit)));
    rows.extend(wrapped(&step.note, width).into_iter().map(|line| (Role::Plain, line)));
    lines(state, &rows, list, buffer);
    let kind = step.drawing;
    let shown = construction.steps.iter().take(last + 1).filter(|step| step.drawing == kind);
    let size = force_size(construction, kind);
    let unit = match kind {
        Drawing::Mechanism => "m",
        Drawing::Polygon => "N",
        Drawing::Lever => "m/rad",
    };
    Diagram { arrows: shown.map(|step| step_arrow(step, size)).collect(), unit, pole: None }
        .draw(state.look, drawing, buffer);
}

fn step_arrow(step: &Step, size: f64) -> Arrow {
    let factor = if step.unit == "N" { size } else { 1.0 };
    Arrow {
        from: step.start,
        to: [0, 1].map(|axis| step.start[axis] + step.vector[axis] * factor),
        name: step.name.clone(),
        role: match step.kind {
            StepKind::Line | StepKind::Point => Role::Trace,
            StepKind::Load | StepKind::Part => Role::Second,
            _ => Role::First,
        },
    }
}
