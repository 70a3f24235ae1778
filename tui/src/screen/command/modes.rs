//! Commands on the modes of a group: one after the other is shown in the first position, and one is taken.

use std::sync::Arc;

use assur_kinematics::Modes;
use assur_mechanism::Point;
use assur_words::{ordinal, text};

use super::draft;
use crate::screen::state::{Assembled, Role, Scene, State, round};

/// Greatest distance at which a mode is still identified with the nearest one of the changed mechanism, rad or parts of the scale.
const VANISHED: f64 = 0.5;

/// Shows the next (1) or previous (-1) mode of the chosen group, in the first position.
pub(super) fn show(state: &mut State, by: isize) {
    state.follow();
    let group = state.chosen.group;
    let Some(modes) = state.scene.as_ref().and_then(|scene| scene.modes(group, 0)) else {
        return state.say(Role::Plain, text!("say-no-modes"));
    };
    state.go_to(0);
    let shown = state.mode_of(group).unwrap_or(modes.present);
    state.chosen.mode = Some([group, round(shown, by, modes.all.len())]);
}

pub(super) fn are_several(state: &State) -> bool {
    let modes = state.scene.as_ref().and_then(|scene| scene.modes(state.chosen.group, 0));
    modes.is_some_and(|modes| modes.all.len() > 1)
}

/// Takes the mode that is shown: its places are written under `[assembly]`, as a changed value is.
pub(super) fn take(state: &mut State) {
    let group = state.chosen.group;
    let Some((index, scene)) = state.mode_of(group).zip(state.scene.as_ref()) else {
        return state.say(Role::Plain, text!("say-no-mode-shown"));
    };
    let Some(points) = points(scene, group, index).filter(|points| !points.is_empty()) else {
        return state.say(Role::Bad, text!("say-mode-without-points"));
    };
    let way = scene.modes(group, 0).map_or(index, |modes| modes.number(index));
    let differs = draft::assemble(state, &points);
    let (role, id) =
        if differs { (Role::Good, "say-mode-taken") } else { (Role::Plain, "say-mode-is-taken") };
    state.say(role, text!(id, mode = ordinal(way)));
    state.chosen.mode = None;
}

/// After a change: the mode that each group had is taken where it still exists; otherwise that is said.
pub(super) fn keep(state: &mut State, coordinate: f64, before: &[Option<Arc<Modes>>]) {
    let Some(scene) = &state.scene else { return };
    if scene.pose(0, 0.0).is_none_or(|pose| pose.coordinate.to_bits() != coordinate.to_bits()) {
        return;
    }
    let structure = &scene.linkage.structure;
    for (group, before) in before.iter().enumerate().take(structure.groups.len()) {
        let Some((before, modes)) = before.as_ref().zip(scene.modes(group, 0)) else { continue };
        let limit = if modes.all.len() < before.all.len() { VANISHED } else { f64::INFINITY };
        let Some(index) = before.present_after(&modes, limit, structure.scale) else {
            let name = structure.group_name(&scene.linkage.mechanism, group);
            let way = ordinal(modes.number(modes.present));
            return state.say(Role::Bad, text!("say-mode-vanished", group = name, mode = way));
        };
        if index != modes.present {
            let points = points(scene, group, index).unwrap_or_default();
            return draft::assemble_too(state, &points);
        }
    }
}

pub(super) fn all(scene: &Scene) -> Vec<Option<Arc<Modes>>> {
    (0..scene.linkage.structure.groups.len()).map(|group| scene.modes(group, 0)).collect()
}

/// The points that tell a mode: the inner pins of the group, or all its points where it has none, and those that have a place in
/// `[assembly]` already.
fn points(scene: &Scene, group: usize, index: usize) -> Option<Vec<Assembled>> {
    let linkage = &scene.linkage;
    let (mechanism, frame) = (&linkage.mechanism, &linkage.structure.groups[group].frame);
    let modes = scene.modes(group, 0)?;
    let mode = modes.all.get(index)?;
    let is_own = |point: &Point| point.places.iter().all(|place| frame.column(place.link).is_some());
    let has_pins = mechanism.points.iter().any(|point| point.is_pin() && is_own(point));
    let is_told = |(id, point): &(usize, &Point)| {
        let stands = mechanism.assembly.iter().any(|(told, _)| told == id);
        is_own(point) && (point.is_pin() || !has_pins || stands)
    };
    let told = mechanism.points.iter().enumerate().filter(is_told).filter_map(|(_, point)| {
        let of = point.places.first()?;
        let place = mode.bodies[frame.column(of.link)?].point(of.at);
        Some(Assembled { name: point.name.to_string(), place })
    });
    Some(told.collect())
}
