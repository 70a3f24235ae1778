//! Commands of the point that is moved over the drawing.

use assur_words::text;
use ratatui::layout::Rect;

use crate::screen::state::{Probe, Role, State, round};
use crate::screen::view::mechanism;

/// Steps by which a key moves the point, as part of the greater side of the drawing.
const STEP: f64 = 0.01;

/// Sets a point on the first coupler, or removes it.
pub(super) fn toggle(state: &mut State) {
    let Some(scene) = &state.scene else { return };
    state.draft.open = false;
    state.probe = match state.probe {
        Some(_) => None,
        None => Some(Probe::of(scene, Probe::first_link(scene))),
    };
}

pub(super) fn shift(state: &mut State, axis: usize, sense: f64) {
    let part = state.part_way();
    let (Some(scene), Some(probe)) = (&state.scene, &mut state.probe) else { return };
    let Some(pose) = scene.pose(state.position, part) else {
        return state.say(Role::Bad, text!("say-no-pose"));
    };
    let [width, height] = scene.outline.bounds.size();
    let mut place = pose.bodies[probe.link].point(probe.at);
    place[axis] += sense * STEP * width.max(height) / state.zoom.factor;
    probe.put(&pose, place);
}

pub(super) fn link(state: &mut State) {
    let (Some(scene), Some(probe)) = (&state.scene, &mut state.probe) else { return };
    let moving = scene.linkage.mechanism.links.len() - 1;
    *probe = Probe::of(scene, 1 + round(probe.link - 1, 1, moving));
}

/// Moves the point to a cell of the screen; returns whether there is a drawing.
pub(super) fn click(state: &mut State, area: Rect, cell: [u16; 2]) -> bool {
    let (place, part) = (mechanism::place_at(state, area, cell), state.part_way());
    let (Some(scene), Some(probe)) = (&state.scene, &mut state.probe) else { return false };
    let (Some(place), Some(pose)) = (place, scene.pose(state.position, part)) else { return false };
    probe.put(&pose, place);
    true
}
