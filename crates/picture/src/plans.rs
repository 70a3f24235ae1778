//! Plans of a position: force polygon of a group, velocities, accelerations, the constructions step by step.

use assur_diagram::{PlanVector, VectorPlan, construction_picture};
use assur_figure::{
    Bounds, Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Scale, Sign, Stroke, one_scale,
};
use assur_force::{Construction, ConstructionStep, Drawing, VectorKind};
use assur_group::plane::cross;
use assur_words::{Describe, Text, joined, list, measured, name, number, text};

use crate::{Found, Look, Plans, Results, ViewPart, mechanism, plots};

/// A vector smaller than this part of the greatest counts as zero.
const LEAST: f64 = 1e-12;
/// How far beyond the mechanism a construction is drawn, as part of its size.
const FAR: f64 = 1.5;
/// A vector shorter than this part of a construction is not named in it.
const SHORT: f64 = 0.02;
/// A vector shorter than this part of a drawing on paper is a speck in it.
pub(crate) const SMALL: f64 = 0.04;
/// A component of a plan longer than this part of it is named even where its name covers something.
const NAMED: f64 = 0.05;
/// Space around a construction, as part of its size.
const AROUND: f64 = 0.06;
/// Subscripts of the poles of the plans of velocities and of accelerations: a point P has the image p.
const POLES: [&str; 2] = ["v", "a"];
/// What the plans of a position show.
#[derive(Debug)]
pub enum Shown<'a> {
    /// A plan.
    Plan(&'a VectorPlan),
    /// A construction up to a step.
    Construction(&'a Construction, usize),
    /// Why there is nothing.
    Nothing(Text),
}

/// What a part of the plans shows.
pub fn shown<'a>(found: &Found, look: &Look<'_>, part: ViewPart, plans: &'a Plans) -> Shown<'a> {
    let sheet = match (&plans.sheet, part) {
        (_, ViewPart::Construction) => {
            return match chosen_step(plans, look.step) {
                Some((construction, last)) => Shown::Construction(construction, last),
                None => Shown::Nothing(text!("plans-no-construction")),
            };
        }
        (Err(error), _) => return Shown::Nothing(error.describe()),
        (Ok(sheet), _) => sheet,
    };
    let plan = match part {
        ViewPart::Velocities => Some(&sheet.velocities),
        ViewPart::Accelerations => Some(&sheet.accelerations),
        _ if !has_forces(found, look.position) => None,
        _ => sheet.polygons.get(look.polygon.min(sheet.polygons.len().saturating_sub(1))),
    };
    let is_of_forces = !matches!(part, ViewPart::Velocities | ViewPart::Accelerations);
    match plan {
        // A mechanism at rest has plans of velocities, which are points.
        Some(plan) if is_of_forces && labelled(part, plan).is_empty() => {
            Shown::Nothing(text!("plans-no-force"))
        }
        Some(plan) => Shown::Plan(plan),
        None => Shown::Nothing(text!("forces-not-determined")),
    }
}

/// The chosen plan, beside it the same one of the position that is held; or the construction up to the chosen step.
pub fn figure(results: &Results, look: &Look<'_>, part: ViewPart) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let plans = found.plans.at(look.position);
    match shown(found, look, part, &plans) {
        Shown::Plan(plan) => {
            let mut panels = vec![panel_of_plan(part, plan)];
            let held = look.held.map(|position| (position, found.plans.at(position)));
            if let Some((position, plans)) = &held
                && let Shown::Plan(plan) = shown(found, look, part, plans)
            {
                panels.insert(0, panel_of_plan(part, plan));
                one_scale(panels.iter_mut());
                (panels[0].title, panels[1].title) = (results.place(*position), results.place(look.position));
            }
            let legend = keys(part, plan);
            Figure { title: plan.title.clone(), columns: panels.len(), panels, legend }
        }
        Shown::Construction(construction, last) => {
            let (method, step) = (construction.title.clone(), number(last + 1));
            let title = text!("plans-step", construction = method, step = step);
            let drawn = panel_of_steps(results, look, construction, last);
            drawn.map_or_else(Figure::default, |(panel, legend)| Figure {
                title,
                legend,
                ..Figure::of(panel)
            })
        }
        Shown::Nothing(_) => Figure::default(),
    }
}

/// Zhukovsky's lever of a position, from the first construction that has one; what its forces are, [`on_lever`] says.
pub fn lever(results: &Results, look: &Look<'_>) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let plans = found.plans.at(look.position);
    let Some(step) = last_of_lever(&plans) else { return Figure::default() };
    let mut drawn = figure(results, &Look { step, ..*look }, ViewPart::Construction);
    // What is zero has no arrow, and no name.
    let steps =
        chosen_step(&plans, step).map_or(&[][..], |(construction, last)| &construction.steps[..=last]);
    let is_zero = |text: &Text| {
        let mut own = steps.iter().filter(|step| step.name == *text).peekable();
        own.peek().is_some() && own.all(|step| step.unit == "N" && length([[0.0; 2], step.vector]) == 0.0)
    };
    let small = small_on_lever(&plans, step);
    let is_small = |item: &Item| match item {
        Item::Name { text, .. } => small.iter().any(|(own, _)| own == text),
        Item::Line { .. } | Item::Arrow { .. } => small.iter().any(|(_, ends)| item.points() == ends),
        _ => false,
    };
    for panel in &mut drawn.panels {
        panel.items.retain(|item| !matches!(item, Item::Name { text, .. } if is_zero(text)));
        panel.items.retain(|item| !is_small(item));
    }
    Figure { legend: too_small(&small.into_iter().map(|(own, _)| own).collect::<Vec<_>>()), ..drawn }
}

/// The forces that are specks in the drawing of the lever up to a step, each with its ends.
fn small_on_lever(plans: &Plans, step: usize) -> Vec<(Text, [Point; 2])> {
    let Some((drawn, last)) = chosen_step(plans, step) else { return Vec::new() };
    let (all, _) = construction_picture(drawn, true);
    let size = largest(all.iter().flat_map(|(_, ends)| *ends));
    let small = all.into_iter().filter(|(number, ends)| {
        let step = &drawn.steps[*number];
        let is_force = step.unit == "N" && !matches!(step.kind, VectorKind::Line | VectorKind::Point);
        // What is zero has no arrow at any scale.
        let is_zero = length([[0.0; 2], step.vector]) == 0.0;
        *number <= last && is_force && !is_zero && length(*ends) < SMALL * size
    });
    small.map(|(number, ends)| (drawn.steps[number].name.clone(), ends)).collect()
}

/// Says which vectors are left out of a drawing, because they would be specks in it; nothing where there are none.
pub(crate) fn too_small(names: &[Text]) -> Vec<Key> {
    /// Names in the first row of the legend, beside the words, and in the further ones.
    const IN_A_ROW: [usize; 2] = [5, 10];
    if names.is_empty() {
        return Vec::new();
    }
    let (first, further) = names.split_at(names.len().min(IN_A_ROW[0]));
    let mut rows = vec![text!("plans-too-small", names = list(first.iter().cloned()))];
    rows.extend(further.chunks(IN_A_ROW[1]).map(|row| list(row.iter().cloned())));
    let last = rows.len() - 1;
    let comma = |(row, text)| if row < last { joined("", [text, name(",")]) } else { text };
    let rows = rows.into_iter().enumerate().map(comma);
    rows.map(|text| Key { sample: Sample::None, text }).collect()
}

/// The number of the step that completes the first lever.
fn last_of_lever(plans: &Plans) -> Option<usize> {
    plans.constructions.iter().enumerate().find_map(|(index, (_, drawn))| {
        let last = drawn.steps.iter().rposition(|step| step.drawing == Drawing::Lever)?;
        Some(plans.steps_of(index).start + last)
    })
}

/// A force on Zhukovsky's lever.
#[derive(Debug, Clone, PartialEq)]
pub struct LeverForce {
    /// Its symbol in the drawing.
    pub symbol: Text,
    /// The load that it is, or of which it is a part.
    pub of: Text,
    /// Whether it is the balancing load.
    pub is_balancing: bool,
    /// Its size, N.
    pub size: f64,
    /// Its arm about the pole, and the unit of the lever.
    pub arm: (f64, &'static str),
}

/// The forces on the lever of a position that are not zero.
pub fn on_lever(results: &Results, position: usize) -> Vec<LeverForce> {
    let Some(found) = &results.found else { return Vec::new() };
    let plans = found.plans.at(position);
    let chosen = last_of_lever(&plans).and_then(|step| chosen_step(&plans, step));
    let Some((construction, last)) = chosen else { return Vec::new() };
    let image = construction.steps.iter().find(|step| step.kind == VectorKind::Absolute);
    let unit = image.map_or("m", |step| step.unit);
    // Drive and flywheel keep up the motion in the place of a balancing load.
    let state = results.moving(position, 0.0);
    let has_drive = state.is_some_and(|(_, state)| found.plans.calculation().drive_in(&state).is_some());
    let forces =
        construction.steps[..=last].iter().filter(|step| step.unit == "N" && step.drawing == Drawing::Lever);
    let force = |step: &ConstructionStep| {
        let size = length([[0.0; 2], step.vector]);
        let is_force = size > 0.0 && !matches!(step.kind, VectorKind::Line | VectorKind::Point);
        let is_balancing = step.kind == VectorKind::Balancing;
        let of = if is_balancing && has_drive { text!("lever-of-drive") } else { step.of.clone() };
        is_force.then(|| LeverForce {
            symbol: step.name.clone(),
            of,
            is_balancing,
            size,
            arm: (arm_of(step), unit),
        })
    };
    forces.filter_map(force).collect()
}

/// What the labels of a plan stand for, with the sizes.
fn keys(part: ViewPart, plan: &VectorPlan) -> Vec<Key> {
    let key = |(label, item): (String, &PlanVector)| {
        let size = measured(item.size, 5, item.unit.clone());
        let (ink, label, none) = (ink_of(part, item), name(label), Text::default());
        // A vector of the motion is called by its symbol alone.
        let names = match item.kind {
            VectorKind::Absolute => [&none, &item.symbol],
            _ if ink == Ink::Trace => [&none, &item.symbol],
            _ => [&label, &item.name],
        };
        let stroke = if ink == Ink::Trace { Stroke::Dotted } else { Stroke::Solid };
        plots::key(names, size, None, (stroke, ink))
    };
    plots::limited(labelled(part, plan).into_iter().map(key).collect())
}

/// Whether forces are determined in a position.
pub fn has_forces(found: &Found, position: usize) -> bool {
    found.balancing().is_some_and(|series| series.at(position).is_finite())
}

/// The vectors of a plan that are not only rounding, each with its label.
pub fn labelled(part: ViewPart, plan: &VectorPlan) -> Vec<(String, &PlanVector)> {
    let least = LEAST * plan.greatest();
    let drawn = plan.items.iter().filter(|item| item.size > least).enumerate();
    drawn.map(|(number, item)| (label(part, item, number), item)).collect()
}

pub(crate) fn panel_of_plan(part: ViewPart, plan: &VectorPlan) -> Panel {
    let shown: Vec<_> = labelled(part, plan).into_iter().map(|(label, item)| (name(label), item)).collect();
    panel_of(part, plan, &shown)
}

pub(crate) fn panel_of(part: ViewPart, plan: &VectorPlan, shown: &[(Text, &PlanVector)]) -> Panel {
    let size = largest(shown.iter().flat_map(|(_, item)| [item.start, item.end]));
    let is_longer = |item: &PlanVector, least: f64| length([item.start, item.end]) > least * size;
    let (symbol, pole) = match part {
        ViewPart::Velocities => ("v", Some(POLES[0])),
        ViewPart::Accelerations => ("a", Some(POLES[1])),
        _ => ("F", None),
    };
    // Components lie beneath the vectors on which they end.
    let mut ordered: Vec<_> = shown.iter().collect();
    ordered.sort_by_key(|(_, item)| pole.is_none() || ink_of(part, item) != Ink::Trace);
    let vectors = ordered.into_iter().map(|(label, item)| {
        let (ends, ink) = ([item.start, item.end], ink_of(part, item));
        let name = if ink == Ink::Trace { Text::default() } else { label.clone() };
        let arrow = Item::Arrow { from: ends[0], to: ends[1], stroke: Stroke::Dotted, ink };
        let is_component = pole.is_some() && ink == Ink::Trace && is_longer(item, SMALL);
        (if is_component { arrow } else { plots::arrow(ends, &name, ink) }, name)
    });
    let mut panel = plots::vectors(vectors.collect(), Scale::of(symbol, &plan.unit), pole);
    // The components of a plan of velocities or accelerations are named where they are long, or have room.
    let components = shown.iter().map(|(_, item)| item);
    let components = components.filter(|item| pole.is_some() && ink_of(part, item) == Ink::Trace);
    panel.items.extend(components.map(|item| Item::Name {
        at: [0, 1].map(|axis| 0.5 * (item.start[axis] + item.end[axis])),
        text: item.symbol.clone(),
        ink: Ink::Dim,
        needed: is_longer(item, NAMED),
    }));
    panel
}

/// The greater side of what these points need.
pub(crate) fn largest(points: impl Iterator<Item = Point>) -> f64 {
    Bounds::around(points).size().into_iter().fold(0.0, f64::max)
}

/// The label of a vector in the drawing and in the list: `R3`, or the point of an absolute velocity.
fn label(part: ViewPart, item: &PlanVector, number: usize) -> String {
    match (part, item.kind) {
        (ViewPart::Forces, VectorKind::Reaction) => format!("R{}", number + 1),
        (ViewPart::Forces, VectorKind::Inner) => "..".to_owned(),
        // A load has one number in all polygons and on the links.
        (ViewPart::Forces, VectorKind::Balancing) => item.symbol.to_string(),
        (ViewPart::Forces, _) if item.symbol != item.name => item.symbol.to_string(),
        (ViewPart::Forces, _) => format!("F{}", number + 1),
        (_, VectorKind::Absolute) => item.image.clone(),
        _ => "..".to_owned(),
    }
}

fn ink_of(part: ViewPart, item: &PlanVector) -> Ink {
    let absolute = part == ViewPart::Accelerations && item.kind == VectorKind::Absolute;
    if absolute { Ink::Acceleration } else { ink(item.kind) }
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
    let step = step.min(plans.step_count().checked_sub(1)?);
    plans.constructions.iter().enumerate().find_map(|(index, (_, construction))| {
        let steps = plans.steps_of(index);
        steps.contains(&step).then(|| (construction, step - steps.start))
    })
}

/// The drawing of the last step with the steps up to it, on the place that all its steps take: the mechanism under the steps in it
/// and the polygon laid off from its corner, or the lever; and what its vectors are, with the arms of those on the lever.
fn panel_of_steps(
    results: &Results,
    look: &Look<'_>,
    drawn: &Construction,
    last: usize,
) -> Option<(Panel, Vec<Key>)> {
    let step = drawn.steps.get(last)?;
    let on_lever = step.drawing == Drawing::Lever;
    let (all, newtons) = construction_picture(drawn, on_lever);
    let mut place = Bounds::around(all.iter().flat_map(|(_, ends)| *ends));
    let mut beneath = Vec::new();
    if !on_lever {
        // What lies far off, as a pole near infinity, would leave no room for the rest; of the mechanism the part is seen in which
        // the construction lies.
        let room = results.outline.bounds.widened(FAR);
        place = Bounds::around(all.iter().flat_map(|(_, ends)| *ends).filter(|at| room.holds(*at)))
            .widened(AROUND);
        let pose = results.pose(look.position, 0.0);
        let items = pose.map_or_else(Vec::new, |pose| mechanism::drawing(results, &[]).items(&pose));
        // The radii of an arc lead out of the picture.
        let is_radius = |item: &Item| matches!(item, Item::Line { ink: Ink::Trace, .. });
        let items = items.into_iter().filter(|item| !is_radius(item));
        beneath = items.flat_map(|item| item.within(&place)).collect();
    }
    let image = drawn.steps.iter().find(|step| step.kind == VectorKind::Absolute);
    let unit = image.map_or("m", |step| step.unit);
    let scale = if on_lever { Scale::of("v", unit) } else { Scale::of("l", "m") };
    let made: Vec<_> = all.into_iter().take_while(|(number, _)| *number <= last).collect();
    let arm_in = on_lever.then_some(unit);
    // Of very many entries the first ones are shown: the balancing load is among them.
    let mut steps: Vec<_> = made.iter().map(|(number, _)| &drawn.steps[*number]).collect();
    steps.sort_by_key(|step| step.kind != VectorKind::Balancing);
    let keys = steps.into_iter().filter_map(|step| key_of_step(step, arm_in));
    let legend = plots::limited(keys.collect());
    let vector = |(number, ends): (usize, [[f64; 2]; 2])| {
        let step = &drawn.steps[number];
        // A line is named while it is the last step; its ends have names. So is a vector too short to be seen.
        let short = || length(ends) < SHORT * place.size().into_iter().fold(0.0, f64::max);
        let is_named =
            number == last || step.kind == VectorKind::Point || step.kind != VectorKind::Line && !short();
        let name = if is_named { step.name.clone() } else { Text::default() };
        let ends = if on_lever { ends } else { place.cut(ends)? };
        let item = match step.kind {
            VectorKind::Point => Item::sign(ends[0], Sign::Dot, Ink::Title),
            VectorKind::Line => Item::line(ends, Stroke::Solid, Ink::Trace),
            kind => plots::arrow(ends, &name, ink(kind)),
        };
        Some((item, name))
    };
    let vectors = made.into_iter().filter_map(vector).collect();
    let mut panel = plots::vectors(vectors, scale, on_lever.then_some(POLES[0]));
    panel.items.splice(0..0, beneath);
    if let Frame::Plane { bounds, scales } = &mut panel.frame {
        *bounds = place;
        scales.extend((newtons > 0.0).then(|| Scale::vectors("F", "N", newtons)));
    }
    Some((panel, legend))
}

/// `F6 cutting  1500 N  h = 0.2 m/rad`, the last being the arm of a force about the pole of a lever in this unit; `None` of a line, a
/// point, and a force of zero.
fn key_of_step(step: &ConstructionStep, arm_in: Option<&'static str>) -> Option<Key> {
    let size = length([[0.0; 2], step.vector]);
    if matches!(step.kind, VectorKind::Line | VectorKind::Point) || size == 0.0 {
        return None;
    }
    let arm = arm_in.filter(|_| step.unit == "N");
    let arm = arm.map(|unit| joined(" = ", [name("h"), measured(arm_of(step), 5, unit)]));
    let size = measured(size, 5, step.unit);
    Some(plots::key([&step.name, &step.of], size, arm, (Stroke::Solid, ink(step.kind))))
}

/// The arm of a force about the origin, where it is not only rounding.
fn arm_of(step: &ConstructionStep) -> f64 {
    let arm = cross(step.start, step.vector).abs() / length([[0.0; 2], step.vector]);
    if arm <= LEAST * length([[0.0; 2], step.start]) { 0.0 } else { arm }
}

pub(crate) fn length([from, to]: [[f64; 2]; 2]) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1])
}
