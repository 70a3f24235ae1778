use assur_words::Language;

use super::evaluate::recomputes;
use super::{compiled, forces_agree, worked};

pub(crate) fn scene(name: &str) -> assur_mechanism::Mechanism {
    assur_scene::read(name, assur_fixtures::scene(name)).unwrap()
}

#[test]
fn every_line_of_every_scene_recomputes() {
    let (mut lines, mut general) = (0, Vec::new());
    for (name, _) in assur_fixtures::SCENES {
        let (linkage, loads) = compiled(scene(name));
        // The working of a position is not written over time.
        if linkage.kind().is_time() {
            continue;
        }
        let count = linkage.mechanism.input.positions;
        for index in [0, 1, 3, count / 4, count / 2, count - 1].into_iter().filter(|index| *index < count) {
            let mut position = linkage.position();
            if linkage.solve_index(index, assur_group::Order::Second, &mut position).is_err() {
                continue;
            }
            let working = worked(&linkage, loads.as_ref(), index);
            lines += recomputes(&format!("{name}, position {index}"), &working.text(Language::english()));
            general.extend(working.general.iter().map(|group| (*name, index, *group)));
        }
    }
    assert!(lines > 3000, "{lines} lines");
    // All groups of class II without a driven pair have equations of their own; only the parallelograms with their links in one line need the linear system.
    general.retain(|(name, index, _)| !(name.starts_with("n-four-bar") && *index == 6));
    let is_higher =
        |name: &str| ["triad", "contour", "six-links", "boom", "scissor-lift", "leg"].contains(&name);
    assert!(general.iter().any(|(name, ..)| is_higher(name)));
    general.retain(|(name, ..)| !is_higher(name));
    assert!(general.is_empty(), "{general:?}");
}

#[test]
fn forces_of_the_scenes_are_those_of_newton_and_euler() {
    for name in ["slider-crank", "shaper", "guide-shaper", "conveyor", "press", "stephenson3", "r-rtr-rrt"] {
        let (linkage, loads) = compiled(scene(name));
        let Some(loads) = loads else { continue };
        for index in 0..linkage.mechanism.input.positions.min(12) {
            let working = worked(&linkage, Some(&loads), index);
            forces_agree(name, &linkage, &loads, index, &working);
        }
    }
}
