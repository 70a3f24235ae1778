//! Commands of the view of plans.

use crate::screen::state::{Part, State, View, round};

/// Keeps the plan of this position beside that of the position that is shown, or removes it.
pub(super) fn beside(state: &mut State) {
    state.held = if state.held.is_some() { None } else { Some(state.position) };
}

/// The next or previous polygon, vector, or step of the construction.
pub(super) fn step(state: &mut State, by: isize) {
    let Some(plans) = state.found().map(|found| found.plans.at(state.position)) else { return };
    let count = |count: fn(&assur_diagram::Sheet) -> usize| plans.sheet.as_ref().map_or(0, count);
    let part = state.part(View::Plans);
    let chosen = &mut state.chosen;
    let (chosen, count) = match part {
        Part::Construction => (&mut chosen.step, plans.step_count()),
        Part::Velocities => (&mut chosen.vector, count(|sheet| sheet.velocities.items.len())),
        Part::Accelerations => (&mut chosen.vector, count(|sheet| sheet.accelerations.items.len())),
        _ => (&mut chosen.polygon, count(|sheet| sheet.polygons.len())),
    };
    *chosen = round(*chosen, by, count);
}
