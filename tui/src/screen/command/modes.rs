//! Commands on the modes of a group: one after the other is shown in the first position, and one is taken.

use assur_group::{Body, Mode};
use assur_kinematics::Modes;
use assur_mechanism::Point;
use assur_words::{number, text};

use super::whatif;
use crate::screen::state::{Assembled, Role, Scene, State, round};

/// A mode that is farther than this from the nearest one of the changed mechanism has vanished, rad or parts of the scale.
const VANISHED: f64 = 0.5;

/// Shows the next (1) or previous (-1) mode of the chosen group, in the first position.
pub(super) fn show(state: &mut State, by: isize) {
    let group = state.chosen.group;
    let Some(modes) = state.scene.as_ref().and_then(|scene| scene.first_modes(group)) else {
        return state.say(Role::Plain, text!("say-no-modes"));
    };
    state.go_to(0);
    let shown = state.mode_of(group).unwrap_or(modes.present);
    state.chosen.mode = Some([group, round(shown, by, modes.all.len())]);
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
    let way = scene.first_modes(group).map_or(index, |modes| modes.number(index));
    if whatif::assemble(state, &points) {
        state.say(Role::Good, text!("say-mode-taken", mode = number(way)));
    } else {
        state.say(Role::Plain, text!("say-mode-is-taken", mode = number(way)));
    }
    state.chosen.mode = None;
}

/// After a change: the mode that each group had is taken where it still exists; otherwise that is said.
pub(super) fn keep(state: &mut State, coordinate: f64, before: &[Option<Modes>]) {
    let Some(scene) = &state.scene else { return };
    let first = scene.poses.first().and_then(Option::as_ref);
    if first.is_none_or(|pose| pose.coordinate.to_bits() != coordinate.to_bits()) {
        return;
    }
    let structure = &scene.linkage.structure;
    for (group, before) in before.iter().enumerate().take(structure.groups.len()) {
        let Some((before, modes)) = before.as_ref().zip(scene.first_modes(group)) else { continue };
        let is_fewer = modes.all.len() < before.all.len();
        let partner = partner(before.present, &before.all, &modes.all, structure.scale);
        let Some((index, _)) = partner.filter(|(_, distance)| !is_fewer || *distance <= VANISHED) else {
            let name = structure.group_name(&scene.linkage.mechanism, group);
            let way = number(modes.number(modes.present));
            return state.say(Role::Bad, text!("say-mode-vanished", group = name, mode = way));
        };
        if index != modes.present {
            let points = points(scene, group, index).unwrap_or_default();
            return whatif::assemble_too(state, &points);
        }
    }
}

/// What a mode has become, with the distance, rad or parts of the scale: of all modes of one way before and after, the nearest two
/// belong together, then the nearest of the others. `None` where all that are left belong to others.
fn partner(present: usize, before: &[Mode<f64>], after: &[Mode<f64>], scale: f64) -> Option<(usize, f64)> {
    let distance = |(a, b): (&Body<f64>, &Body<f64>)| {
        ((a.x - b.x).hypot(a.y - b.y) / scale).max((a.c - b.c).hypot(a.s - b.s))
    };
    let apart = |old: usize, new: usize| {
        before[old].bodies.iter().zip(&after[new].bodies).map(distance).fold(0.0, f64::max)
    };
    let pairs = (0..before.len()).flat_map(|old| (0..after.len()).map(move |new| (old, new)));
    let pairs = pairs.filter(|(old, new)| before[*old].way == after[*new].way);
    let mut pairs: Vec<_> = pairs.map(|(old, new)| (old, new, apart(old, new))).collect();
    pairs.sort_by(|a, b| a.2.total_cmp(&b.2));
    while let Some(&(old, new, distance)) = pairs.first() {
        if old == present {
            return Some((new, distance));
        }
        pairs.retain(|pair| pair.0 != old && pair.1 != new);
    }
    None
}

/// The modes of each group in the first position.
pub(super) fn all(scene: &Scene) -> Vec<Option<Modes>> {
    (0..scene.linkage.structure.groups.len()).map(|group| scene.first_modes(group)).collect()
}

/// The points that tell a mode: the inner pins of the group, or all its points where it has none, and those that have a place in
/// `[assembly]` already.
fn points(scene: &Scene, group: usize, index: usize) -> Option<Vec<Assembled>> {
    let linkage = &scene.linkage;
    let (mechanism, frame) = (&linkage.mechanism, &linkage.structure.groups[group].frame);
    let first = scene.poses.first()?.as_ref()?;
    let modes = scene.first_modes(group)?;
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
        Some(Assembled { name: point.name.to_string(), present: first.bodies[of.link].point(of.at), place })
    });
    Some(told.collect())
}

#[cfg(test)]
mod tests {
    use super::{Body, Mode, partner};

    #[test]
    fn a_mode_whose_place_only_others_take_has_vanished() {
        let modes = |angles: &[f64]| -> Vec<Mode<f64>> {
            let body = |angle: &f64| Body { c: angle.cos(), s: angle.sin(), ..Body::ground() };
            angles.iter().map(|angle| Mode { bodies: vec![body(angle)], way: 0, health: 1.0 }).collect()
        };
        // The first two meet and vanish; the third one, not far away, has moved a little.
        let (before, after) = (modes(&[0.0, 0.1, 0.4]), modes(&[0.42]));
        let found = [0, 1, 2].map(|present| partner(present, &before, &after, 1.0).map(|(index, _)| index));
        assert_eq!(found, [None, None, Some(0)]);
        // All of them go on.
        let after = modes(&[-0.02, 0.15, 0.42]);
        let found = [0, 1, 2].map(|present| partner(present, &before, &after, 1.0).map(|(index, _)| index));
        assert_eq!(found, [Some(0), Some(1), Some(2)]);
    }
}
