//! The construction of a force analyzer as plans.

use assur_force::{Construction, ConstructionStep, Drawing, VectorKind};
use assur_group::plane::{minus, plus, scaled};

use assur_words::text;

use crate::plan::{PlanVector, VectorPlan, length, round_scale};

/// One plan for each drawing of the construction: mechanism (m), polygon (N), lever (m/rad).
///
/// Forces in a drawing of lengths are scaled: the greatest is half as long as the drawing is wide. Their
/// [`size`](PlanVector::size) stays in N. The residual of the polygon is its closure error.
pub fn construction_plans(construction: &Construction) -> Vec<VectorPlan> {
    let drawings = [Drawing::Mechanism, Drawing::Polygon, Drawing::Lever];
    drawings.into_iter().filter_map(|drawing| construction_plan(construction, drawing)).collect()
}

/// One drawing of a construction; `None` if the construction has no step in it.
fn construction_plan(construction: &Construction, drawing: Drawing) -> Option<VectorPlan> {
    let steps: Vec<&ConstructionStep> =
        construction.steps.iter().filter(|step| step.drawing == drawing).collect();
    let first = steps.first()?;
    let (title, unit) = match drawing {
        Drawing::Mechanism => ("plan-construction-mechanism", "m"),
        Drawing::Polygon => ("plan-construction-polygon", "N"),
        Drawing::Lever => ("plan-construction-lever", if is_force(first) { "m/rad" } else { first.unit }),
    };
    let mut plan = VectorPlan::new(text!(title, method = construction.title.clone()), unit);
    let per_newton = if unit == "N" { 1.0 } else { drawn_per_newton(&steps) };
    for step in &steps {
        if step.kind == VectorKind::Point {
            plan.point(step.name.clone(), step.start);
            continue;
        }
        let factor = if is_force(step) { per_newton } else { 1.0 };
        plan.items.push(PlanVector {
            name: step.name.clone(),
            symbol: step.name.clone(),
            image: String::new(),
            kind: step.kind,
            start: plus(step.start, scaled(per_newton, step.after)),
            end: plus(plus(step.start, scaled(per_newton, step.after)), scaled(factor, step.vector)),
            size: length(step.vector),
            unit: step.unit.to_owned(),
            note: step.note.clone(),
        });
    }
    let open = if drawing == Drawing::Polygon { open(&steps) } else { 0.0 };
    Some(plan.finish(open))
}

/// A step by its number, with its start and its end.
pub type StepInPicture = (usize, [[f64; 2]; 2]);

/// The steps of a construction as they lie in one picture: those of the lever, or those in the mechanism with the force polygon laid
/// off from its corner to the same scale of forces (L fig. 1). The second value is that scale, newtons for a unit of the picture, which
/// is round; 0 without forces.
pub fn construction_picture(construction: &Construction, lever: bool) -> (Vec<StepInPicture>, f64) {
    let numbered = construction.steps.iter().enumerate();
    let steps: Vec<(usize, &ConstructionStep)> =
        numbered.filter(|(_, step)| (step.drawing == Drawing::Lever) == lever).collect();
    // Rounded up, the greatest force is up to 0.7 as long as the drawing is wide.
    let per_newton = drawn_per_newton(&steps.iter().map(|(_, step)| *step).collect::<Vec<_>>());
    let newtons = round_scale(0.7 / per_newton);
    let scale = if newtons > 0.0 { newtons.recip() } else { 0.0 };
    let ends = |step: &ConstructionStep| {
        let start = match step.drawing {
            Drawing::Polygon => plus(construction.corner, scaled(scale, step.start)),
            _ => plus(step.start, scaled(scale, step.after)),
        };
        [start, plus(start, scaled(if is_force(step) { scale } else { 1.0 }, step.vector))]
    };
    (steps.into_iter().map(|(number, step)| (number, ends(step))).collect(), newtons)
}

fn is_force(step: &ConstructionStep) -> bool {
    step.unit == "N"
}

/// Length in the drawing for 1 N.
fn drawn_per_newton(steps: &[&ConstructionStep]) -> f64 {
    let in_lengths = || steps.iter().filter(|step| step.drawing != Drawing::Polygon);
    let places = || in_lengths().flat_map(|step| [Some(step.start), end_of_line(step)]).flatten();
    let Some(first) = places().next() else { return 0.0 };
    let width = places().map(|place| length(minus(place, first))).fold(0.0, f64::max);
    let forces = steps.iter().filter(|step| is_force(step)).map(|step| length(step.vector));
    let greatest = forces.fold(0.0, f64::max);
    if greatest > 0.0 { 0.5 * width / greatest } else { 0.0 }
}

fn end_of_line(step: &ConstructionStep) -> Option<[f64; 2]> {
    (!is_force(step)).then(|| plus(step.start, step.vector))
}

/// Closure error of the sides up to the closing one, and of the reactions that replace it.
fn open(steps: &[&ConstructionStep]) -> f64 {
    let sum = |wanted: &dyn Fn(VectorKind) -> bool| {
        let sides = steps.iter().filter(|step| wanted(step.kind));
        length(sides.fold([0.0; 2], |sum, side| plus(sum, side.vector)))
    };
    sum(&|kind| kind != VectorKind::Reaction).max(sum(&|kind| kind != VectorKind::Closing))
}
