//! What is asked for, and which groups it depends on.

use assur_mechanism::{GROUND, InputPair, LinkId, Mechanism, PairId, Place};
use assur_structure::Structure;

use crate::Wanted;

/// What `[output]` names, or everything, without repetition and in the order of the scene.
pub(crate) fn wanted(mechanism: &Mechanism, structure: &Structure) -> Wanted {
    let Some(output) = &mechanism.output else { return everything(mechanism, structure) };
    Wanted {
        links: (1..mechanism.links.len()).filter(|id| output.links.contains(id)).collect(),
        points: (0..mechanism.points.len())
            .filter(|id| output.points.contains(id))
            .map(|id| (id, earliest(mechanism, structure, id)))
            .collect(),
        slides: (0..mechanism.slides.len()).filter(|id| output.slides.contains(id)).collect(),
        reactions: pairs(mechanism).into_iter().filter(|pair| output.reactions.contains(pair)).collect(),
    }
}

fn everything(mechanism: &Mechanism, structure: &Structure) -> Wanted {
    Wanted {
        links: (1..mechanism.links.len()).collect(),
        points: (0..mechanism.points.len()).map(|id| (id, earliest(mechanism, structure, id))).collect(),
        slides: (0..mechanism.slides.len()).collect(),
        reactions: pairs(mechanism),
    }
}

/// Pins, then slides.
fn pairs(mechanism: &Mechanism) -> Vec<PairId> {
    let pins = mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin());
    let slides = (0..mechanism.slides.len()).map(PairId::Slide);
    pins.map(|(id, _)| PairId::Pin(id)).chain(slides).collect()
}

/// The groups that places and derivatives of what is told depend on.
pub(crate) fn groups(mechanism: &Mechanism, structure: &Structure, wanted: &Wanted) -> Vec<bool> {
    let mut links: Vec<LinkId> = wanted.links.clone();
    links.extend(wanted.points.iter().map(|(_, place)| place.link));
    for &slide in &wanted.slides {
        links.extend([mechanism.slides[slide].link, mechanism.slides[slide].on]);
    }
    let mut needed = vec![false; structure.groups.len()];
    while let Some(link) = links.pop() {
        let Some(group) = group_of(structure, link) else { continue };
        if !needed[group] {
            needed[group] = true;
            let frame = &structure.groups[group].frame;
            links.extend(frame.outer.iter().flat_map(|pair| [pair.a, pair.b]));
        }
    }
    needed
}

/// Where a point is read: in the link that is known first (ground, input link, then the groups in their order).
fn earliest(mechanism: &Mechanism, structure: &Structure, point: usize) -> Place {
    let rank = |place: &&Place| match group_of(structure, place.link) {
        None if place.link == GROUND => 0,
        None => 1,
        Some(group) => group + 2,
    };
    let places = &mechanism.points[point].places;
    // A point always has a place; the ground's origin stands in for one that has none.
    places.iter().min_by_key(rank).copied().unwrap_or(Place { link: GROUND, at: [0.0; 2] })
}

fn group_of(structure: &Structure, link: LinkId) -> Option<usize> {
    structure.groups.iter().position(|group| group.frame.links.contains(&link))
}

/// The name of the input's pair, for reasons.
pub(crate) fn coordinate_words(mechanism: &Mechanism) -> String {
    let link = &mechanism.links[mechanism.input.link].name;
    match mechanism.input.pair {
        InputPair::Pin(_) => format!("the angle of `{link}`"),
        InputPair::Slide(_) => format!("the displacement of `{link}`"),
    }
}
