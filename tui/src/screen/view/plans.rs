//! Plans of the position: force polygon of a group, velocities, accelerations, the constructions step by step.

use assur_diagram::{Plan, PlanVector, VectorKind};
use assur_figure::{Figure, Ink, Panel};
use assur_force::{Construction, Drawing, Step, StepKind};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::advice;
use super::vectors::{self, Vector};
use crate::number::digits;
use crate::screen::draw::{cut, paint, put_lines, wrapped};
use crate::screen::state::{Bounds, Found, Part, Plans, Role, Scene, State, View};

/// Columns of the list beside the drawing.
const LIST: u16 = 42;
/// A vector smaller than this part of the greatest counts as zero.
const LEAST: f64 = 1e-12;

/// Name of the pole of a plan of velocities or accelerations.
const POLE: &str = "p";

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let [list, drawing] = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(area);
    let plans = found.plans.at(state.position);
    match shown(state, found, &plans) {
        Shown::Plan(plan) => list_of_plan(state, plan, list, buffer),
        Shown::Construction(construction, last) => list_of_steps(state, construction, last, list, buffer),
        Shown::Nothing(text) => {
            let text = text.unwrap_or_else(|| advice::text(state, scene));
            return say(state, &text, list, buffer);
        }
    }
    paint(state, &figure(state, scene), drawing, buffer);
}

/// What the view shows.
enum Shown<'a> {
    Plan(&'a Plan),
    /// A construction up to a step.
    Construction(&'a Construction, usize),
    /// Why there is nothing; `None`: the advice on the scene.
    Nothing(Option<String>),
}

fn shown<'a>(state: &State, found: &Found, plans: &'a Plans) -> Shown<'a> {
    let nothing = |text: &str| Shown::Nothing(Some(text.to_owned()));
    let sheet = match (&plans.sheet, state.part(View::Plans)) {
        (_, Part::Construction) => {
            return match chosen_step(plans, state.chosen.step) {
                Some((construction, last)) => Shown::Construction(construction, last),
                None => nothing("no method with a construction fits here"),
            };
        }
        (Err(error), _) => return nothing(&error.to_string()),
        (Ok(sheet), _) => sheet,
    };
    let plan = match state.part(View::Plans) {
        Part::Velocities => Some(&sheet.velocities),
        Part::Accelerations => Some(&sheet.accelerations),
        _ if !has_forces(state, found) => None,
        _ => sheet.polygons.get(state.chosen.polygon.min(sheet.polygons.len().saturating_sub(1))),
    };
    match plan {
        Some(plan) => Shown::Plan(plan),
        None if found.reactions.is_empty() => Shown::Nothing(None),
        None => nothing("no forces are determined in this position"),
    }
}

/// The chosen plan, or the construction up to the chosen step.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let plans = found.plans.at(state.position);
    match shown(state, found, &plans) {
        Shown::Plan(plan) => Figure { title: plan.title.clone(), ..Figure::of(panel_of_plan(state, plan)) },
        Shown::Construction(construction, last) => {
            let title = format!("{}, step {}", construction.title, last + 1);
            Figure { title, ..Figure::of(panel_of_steps(construction, last)) }
        }
        Shown::Nothing(_) => Figure::default(),
    }
}

/// Whether forces are determined in this position.
pub(crate) fn has_forces(state: &State, found: &Found) -> bool {
    found.balancing().is_some_and(|series| series.at(state.position).is_finite())
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

/// The vectors of a plan that are not only rounding, each with its label.
pub(crate) fn labelled(part: Part, plan: &Plan) -> Vec<(String, &PlanVector)> {
    let least = LEAST * plan.greatest();
    let drawn = plan.items.iter().filter(|item| item.size > least).enumerate();
    drawn.map(|(number, item)| (label(part, item, number), item)).collect()
}

/// The vectors of a plan, and its closure error.
fn list_of_plan(state: &State, plan: &Plan, list: Rect, buffer: &mut Buffer) {
    let width = usize::from(list.width.max(12)) - 2;
    let mut rows: Vec<(Role, String)> =
        wrapped(&plan.title, width).into_iter().map(|line| (Role::Header, line)).collect();
    if state.part(View::Plans) == Part::Forces {
        rows.push((Role::Dim, "F load  R reaction  .. inside the group".to_owned()));
    }
    let shown = labelled(state.part(View::Plans), plan);
    // The last rows show the closure error; a long list must not push them out.
    let room = usize::from(list.height).saturating_sub(rows.len() + 1);
    let skip = match state.part(View::Plans) {
        Part::Forces => 0,
        _ => state.chosen.vector.min(shown.len().saturating_sub(room)),
    };
    for (label, item) in shown.iter().skip(skip).take(room) {
        let text = format!("{label:<4}{:<20}{:>9} {}", cut(&item.name, 19), digits(item.size, 5), item.unit);
        rows.push((Role::Plain, text));
    }
    rows.push((Role::Header, format!("left open: {:.1e} of the greatest", plan.residual)));
    lines(state, &rows, list, buffer);
}

fn panel_of_plan(state: &State, plan: &Plan) -> Panel {
    let vectors = labelled(state.part(View::Plans), plan).into_iter().map(|(label, item)| {
        let absolute = state.part(View::Plans) == Part::Accelerations && item.kind == VectorKind::Absolute;
        let ink = if absolute { Ink::Acceleration } else { ink(item.kind) };
        let name = if ink == Ink::Trace { String::new() } else { label };
        Vector { from: item.start, to: item.end, name, ink }
    });
    let (unit, symbol, pole) = match state.part(View::Plans) {
        Part::Velocities => (plan.unit.as_str(), "v", Some(POLE)),
        Part::Accelerations => (plan.unit.as_str(), "a", Some(POLE)),
        _ => (plan.unit.as_str(), "F", None),
    };
    vectors::panel(String::new(), &vectors.collect::<Vec<_>>(), (unit, symbol), pole)
}

/// The label of a vector in the drawing and in the list: `R3`, or the point of an absolute velocity.
fn label(part: Part, item: &PlanVector, number: usize) -> String {
    match (part, item.kind) {
        (Part::Forces, VectorKind::Reaction) => format!("R{}", number + 1),
        (Part::Forces, VectorKind::Inner) => "..".to_owned(),
        (Part::Forces, _) => format!("F{}", number + 1),
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

fn ink(kind: VectorKind) -> Ink {
    match kind {
        VectorKind::Load | VectorKind::Weight | VectorKind::Inertia | VectorKind::Part => Ink::Second,
        VectorKind::Reaction | VectorKind::Balancing | VectorKind::Closing => Ink::First,
        VectorKind::Absolute => Ink::Velocity,
        _ => Ink::Trace,
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

/// The chosen step of a construction, with the sentence that explains it.
fn list_of_steps(state: &State, construction: &Construction, last: usize, list: Rect, buffer: &mut Buffer) {
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
}

fn panel_of_steps(construction: &Construction, last: usize) -> Panel {
    let kind = construction.steps.get(last).map_or(Drawing::Mechanism, |step| step.drawing);
    let shown = construction.steps.iter().take(last + 1).filter(|step| step.drawing == kind);
    let size = force_size(construction, kind);
    let scale = match kind {
        Drawing::Mechanism => ("m", "l"),
        Drawing::Polygon => ("N", "F"),
        Drawing::Lever => ("m/rad", "v"),
    };
    let steps: Vec<Vector> = shown.map(|step| step_vector(step, size)).collect();
    vectors::panel(String::new(), &steps, scale, None)
}

fn step_vector(step: &Step, size: f64) -> Vector {
    let factor = if step.unit == "N" { size } else { 1.0 };
    Vector {
        from: step.start,
        to: [0, 1].map(|axis| step.start[axis] + step.vector[axis] * factor),
        name: step.name.clone(),
        ink: match step.kind {
            StepKind::Line | StepKind::Point => Ink::Trace,
            StepKind::Load | StepKind::Part => Ink::Second,
            _ => Ink::First,
        },
    }
}
