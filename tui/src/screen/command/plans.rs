//! Commands of the view of plans.

use crate::screen::state::{PlanKind, State, following, round};

/// The next or previous polygon, vector, or step of the construction.
pub(super) fn step(state: &mut State, by: isize) {
    let Some(plans) = state.found().map(|found| found.plans.at(state.position)) else { return };
    let count = |count: fn(&assur_diagram::Sheet) -> usize| plans.sheet.as_ref().map_or(0, count);
    let chosen = &mut state.chosen;
    let (chosen, count) = match state.plan {
        PlanKind::Construction => (&mut chosen.step, plans.step_count()),
        PlanKind::Forces => (&mut chosen.polygon, count(|sheet| sheet.polygons.len())),
        PlanKind::Velocity => (&mut chosen.vector, count(|sheet| sheet.velocities.items.len())),
        PlanKind::Acceleration => (&mut chosen.vector, count(|sheet| sheet.accelerations.items.len())),
    };
    *chosen = round(*chosen, by, count);
}

/// The next kind of plan.
pub(super) fn next(state: &mut State) {
    let all = [PlanKind::Forces, PlanKind::Velocity, PlanKind::Acceleration, PlanKind::Construction];
    state.plan = following(&all, state.plan);
}
