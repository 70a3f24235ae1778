//! Plans of the position: force polygon of a group, velocities, accelerations, the constructions step by step.

use assur_diagram::{Plan, PlanVector, construction_plan};
use assur_figure::{Bounds, Figure, Frame, Ink, Panel};
use assur_force::{Construction, Drawing, Step, VectorKind};
use assur_words::{Describe, Text, joined, name, number, quantity, text, unit};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::advice;
use super::plots::{self, Vector};
use crate::number::digits;
use crate::screen::draw::{cut, paint, put_lines, wrapped};
use crate::screen::state::{Found, Part, Plans, Role, Scene, State, View};

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
            let rows = advice::rows(&state.told(text), usize::from(list.width.max(12)) - 2).into_iter();
            let rows: Vec<_> = rows.map(|line| (Role::Plain, line)).collect();
            return lines(state, &rows, list, buffer);
        }
    }
    let mut figure = figure(state, scene);
    // Beside each other where that gives larger drawings than one below the other.
    let wide = f64::from(drawing.width) > state.look.ratio * f64::from(drawing.height);
    figure.columns = if wide { figure.panels.len() } else { 1 };
    paint(state, &figure, drawing, buffer);
}

/// What the view shows.
enum Shown<'a> {
    Plan(&'a Plan),
    /// A construction up to a step.
    Construction(&'a Construction, usize),
    /// Why there is nothing; `None`: the advice on the scene.
    Nothing(Option<Text>),
}

fn shown<'a>(state: &State, found: &Found, plans: &'a Plans) -> Shown<'a> {
    let nothing = |text: Text| Shown::Nothing(Some(text));
    let sheet = match (&plans.sheet, state.part(View::Plans)) {
        (_, Part::Construction) => {
            return match chosen_step(plans, state.chosen.step) {
                Some((construction, last)) => Shown::Construction(construction, last),
                None => nothing(text!("plans-no-construction")),
            };
        }
        (Err(error), _) => return nothing(error.describe()),
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
        None => nothing(text!("forces-not-determined")),
    }
}

/// The chosen plan, beside it the same one of the position that is held; or the construction up to the chosen step.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let plans = found.plans.at(state.position);
    match shown(state, found, &plans) {
        Shown::Plan(plan) => {
            let mut panels = vec![panel_of_plan(state, plan)];
            let held = state.held.map(|position| (position, found.plans.at(position)));
            if let Some((position, plans)) = &held
                && let Shown::Plan(plan) = shown(state, found, plans)
            {
                panels.insert(0, panel_of_plan(state, plan));
                one_scale(&mut panels);
                (panels[0].title, panels[1].title) = (scene.place(*position), scene.place(state.position));
            }
            Figure { title: plan.title.clone(), columns: panels.len(), panels, legend: Vec::new() }
        }
        Shown::Construction(construction, last) => {
            let (method, step) = (construction.title.clone(), number(last + 1));
            let title = text!("plans-step", construction = method, step = step);
            let panel = panel_of_steps(construction, last);
            Figure { title, columns: 1, panels: panel.into_iter().collect(), legend: Vec::new() }
        }
        Shown::Nothing(_) => Figure::default(),
    }
}

/// Gives all panels the bounds of the largest one, so that they have one scale.
fn one_scale(panels: &mut [Panel]) {
    let of =
        |panel: &Panel| if let Frame::Plane { bounds, .. } = &panel.frame { bounds.size() } else { [0.0; 2] };
    let most =
        panels.iter().map(of).fold([0.0_f64; 2], |most, size| [most[0].max(size[0]), most[1].max(size[1])]);
    for panel in panels {
        if let Frame::Plane { bounds, .. } = &mut panel.frame {
            let center = bounds.center();
            let corner = |side: f64| [0, 1].map(|axis| center[axis] + side * most[axis] / 2.0);
            *bounds = Bounds { low: corner(-1.0), high: corner(1.0) };
        }
    }
}

/// Whether forces are determined in this position.
pub(crate) fn has_forces(state: &State, found: &Found) -> bool {
    found.balancing().is_some_and(|series| series.at(state.position).is_finite())
}

fn lines(state: &State, lines: &[(Role, String)], area: Rect, buffer: &mut Buffer) {
    let cut = Rect { width: area.width.saturating_sub(1), ..area };
    put_lines(buffer, cut, 1, state, lines);
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
        wrapped(&state.told(&plan.title), width).into_iter().map(|line| (Role::Header, line)).collect();
    if state.part(View::Plans) == Part::Forces {
        rows.push((Role::Dim, state.told(text!("plans-key"))));
    }
    let shown = labelled(state.part(View::Plans), plan);
    // The last rows show the closure error; a long list must not push them out.
    let room = usize::from(list.height).saturating_sub(rows.len() + 1);
    let skip = match state.part(View::Plans) {
        Part::Forces => 0,
        _ => state.chosen.vector.min(shown.len().saturating_sub(room)),
    };
    for (label, item) in shown.iter().skip(skip).take(room) {
        let name = cut(&state.told(&item.name), 19);
        let size = state.told(number(digits(item.size, 5)));
        let text = format!("{label:<4}{name:<20}{size:>9} {}", state.told(unit(item.unit.clone())));
        rows.push((Role::Plain, text));
    }
    let open = number(format_args!("{:.1e}", plan.residual));
    rows.push((Role::Header, state.told(text!("plans-open", open = open))));
    lines(state, &rows, list, buffer);
}

fn panel_of_plan(state: &State, plan: &Plan) -> Panel {
    let vectors = labelled(state.part(View::Plans), plan).into_iter().map(|(label, item)| {
        let absolute = state.part(View::Plans) == Part::Accelerations && item.kind == VectorKind::Absolute;
        let ink = if absolute { Ink::Acceleration } else { ink(item.kind) };
        let name = if ink == Ink::Trace { Text::default() } else { name(label) };
        Vector { from: item.start, to: item.end, name, ink }
    });
    let (unit, symbol, pole) = match state.part(View::Plans) {
        Part::Velocities => (plan.unit.as_str(), "v", Some(POLE)),
        Part::Accelerations => (plan.unit.as_str(), "a", Some(POLE)),
        _ => (plan.unit.as_str(), "F", None),
    };
    plots::vectors(Text::default(), &vectors.collect::<Vec<_>>(), (unit, symbol), pole)
}

/// The label of a vector in the drawing and in the list: `R3`, or the point of an absolute velocity.
fn label(part: Part, item: &PlanVector, number: usize) -> String {
    match (part, item.kind) {
        (Part::Forces, VectorKind::Reaction) => format!("R{}", number + 1),
        (Part::Forces, VectorKind::Inner) => "..".to_owned(),
        (Part::Forces, _) => format!("F{}", number + 1),
        (_, VectorKind::Absolute) => item.image.clone(),
        _ => "..".to_owned(),
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
    let mut rows: Vec<(Role, String)> = wrapped(&state.told(construction.title.clone()), width)
        .into_iter()
        .map(|line| (Role::Header, line))
        .collect();
    let next = state.keys.first("next-step");
    let [now, count] = [last + 1, construction.steps.len()].map(number);
    let told = text!("plans-step-of", step = now, count = count, key = name(next));
    rows.push((Role::Plain, state.told(told)));
    let Some(step) = construction.steps.get(last) else { return };
    let size = quantity(digits(step.vector[0].hypot(step.vector[1]), 5), step.unit.to_owned());
    let kind = joined("", [name("("), step.kind.describe(), name(")")]);
    rows.push((Role::Key, state.told(joined(" ", [step.name.clone(), kind, size]))));
    rows.extend(wrapped(&state.told(step.note.clone()), width).into_iter().map(|line| (Role::Plain, line)));
    lines(state, &rows, list, buffer);
}

/// The drawing of the last step with the steps up to it, on the place that all its steps take.
fn panel_of_steps(construction: &Construction, last: usize) -> Option<Panel> {
    let drawing = construction.steps.get(last)?.drawing;
    let plan = construction_plan(construction, drawing)?;
    let mut items = plan.items.iter();
    let steps = construction.steps.iter().enumerate().filter(|(_, step)| step.drawing == drawing);
    let mut vector = |step: &Step| {
        let (from, to, ink) = match step.kind {
            VectorKind::Point => (step.start, step.start, Ink::Trace),
            _ => items.next().map(|item| (item.start, item.end, ink(item.kind)))?,
        };
        Some(Vector { from, to, name: step.name.clone(), ink })
    };
    let all: Vec<(usize, Vector)> =
        steps.filter_map(|(number, step)| Some((number, vector(step)?))).collect();
    let place = Bounds::around(all.iter().flat_map(|(_, vector)| [vector.from, vector.to]));
    let made = all.into_iter().take_while(|(number, _)| *number <= last);
    let vectors: Vec<Vector> = made.map(|(_, vector)| vector).collect();
    let symbol = match drawing {
        Drawing::Mechanism => "l",
        Drawing::Polygon => "F",
        Drawing::Lever => "v",
    };
    let mut panel = plots::vectors(Text::default(), &vectors, (&plan.unit, symbol), None);
    if let Frame::Plane { bounds, .. } = &mut panel.frame {
        *bounds = place;
    }
    Some(panel)
}
