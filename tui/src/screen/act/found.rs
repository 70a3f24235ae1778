//! Commands of the views that show what the analysis found.

use super::round;
use crate::screen::found::Found;
use crate::screen::state::{Pane, PlanKind, State, View};
use crate::screen::theme::Role;

fn found(state: &State) -> Option<&Found> {
    state.study.as_ref()?.found.as_deref()
}

/// The next or previous reaction.
pub(crate) fn reaction(state: &mut State, by: isize) {
    let count = found(state).map_or(0, |found| found.reactions.len());
    state.chosen.reaction = round(state.chosen.reaction, by, count);
}

/// The next or previous quantity of the motion.
pub(crate) fn motion(state: &mut State, by: isize) {
    let count = found(state).map_or(0, |found| found.motion.len());
    state.chosen.motion = round(state.chosen.motion, by, count);
}

/// The next or previous check.
pub(crate) fn check(state: &mut State, by: isize) {
    let count = found(state).map_or(0, |found| found.checks.len());
    state.chosen.check = round(state.chosen.check, by, count);
}

/// Goes to the position of the chosen check's largest residual.
pub(crate) fn worst(state: &mut State) {
    let at = found(state).and_then(|found| found.checks.get(state.chosen.check)?.at);
    match at {
        Some(at) => state.go_to(at),
        None => state.say(Role::Plain, state.texts.no_worst),
    }
}

/// The next part of the view.
pub(crate) fn pane(state: &mut State) {
    state.pane = match state.pane {
        Pane::Table if state.view == View::Forces => Pane::Causes,
        Pane::Table | Pane::Causes => Pane::Curves,
        Pane::Curves => Pane::Hodograph,
        Pane::Hodograph => Pane::Table,
    };
}

/// Reactions by cause, or the table of all again.
pub(crate) fn causes(state: &mut State) {
    state.pane = if state.pane == Pane::Causes { Pane::Table } else { Pane::Causes };
}

/// The next registered force analyzer that can treat the open scene.
fn next_analyzer(state: &State) -> Option<String> {
    let study = state.study.as_ref()?;
    let fit: Vec<&str> = assur_force::applicable(&study.linkage)
        .into_iter()
        .filter(|plugin| plugin.gives_reactions)
        .map(|plugin| plugin.name)
        .collect();
    let now = study.found.as_ref().map_or("", |found| &found.analyzer);
    let index = fit.iter().position(|name| *name == now).unwrap_or(0);
    fit.get((index + 1) % fit.len().max(1)).map(|name| (*name).to_owned())
}

/// Calculates again with the next force analyzer.
pub(crate) fn analyzer(state: &mut State) {
    state.analyzer = next_analyzer(state);
    if let Some(study) = &mut state.study {
        study.other = None;
    }
    state.analyze(false);
}

/// Shows the difference to the next force analyzer, or stops that.
pub(crate) fn difference(state: &mut State) {
    if let Some(study) = &mut state.study
        && study.other.take().is_some()
    {
        return;
    }
    let now = state.analyzer.clone();
    state.analyzer = next_analyzer(state);
    state.analyze(true);
    state.analyzer = now;
}

/// The next or previous polygon, or step of the construction.
pub(crate) fn step(state: &mut State, by: isize) {
    let Some(plans) = found(state).map(|found| found.plans.at(state.position)) else { return };
    let count = |read: fn(&assur_diagram::Sheet) -> usize| plans.sheet.as_ref().map_or(0, read);
    let chosen = &mut state.chosen;
    match state.plan {
        PlanKind::Construction => {
            chosen.step = round(chosen.step, by, crate::screen::view::plans::step_count(&plans));
        }
        PlanKind::Forces => chosen.polygon = round(chosen.polygon, by, count(|sheet| sheet.polygons.len())),
        PlanKind::Velocity => {
            chosen.vector = round(chosen.vector, by, count(|sheet| sheet.velocities.items.len()));
        }
        PlanKind::Acceleration => {
            chosen.vector = round(chosen.vector, by, count(|sheet| sheet.accelerations.items.len()));
        }
    }
}

/// The next kind of plan.
pub(crate) fn plan(state: &mut State) {
    state.plan = match state.plan {
        PlanKind::Forces => PlanKind::Velocity,
        PlanKind::Velocity => PlanKind::Acceleration,
        PlanKind::Acceleration => PlanKind::Construction,
        PlanKind::Construction => PlanKind::Forces,
    };
}
