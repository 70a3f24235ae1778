//! Which groups carry loads, and which reactions are zero because no load reaches a group.

use assur_mechanism::{Balance, GROUND, LinkId, Mechanism};
use assur_structure::Structure;

/// By link: whether a load acts on it, or (`heavy`) its mass counts.
///
/// A load whose value happens to be zero is a load: the plan considers what the scene defines, not numbers.
fn loaded(mechanism: &Mechanism, heavy: impl Fn(LinkId) -> bool) -> Vec<bool> {
    let mut loaded: Vec<bool> = (0..mechanism.links.len()).map(|id| id != GROUND && heavy(id)).collect();
    let forces = mechanism.forces.iter().map(|force| force.at.link);
    let moments = mechanism.moments.iter().map(|moment| moment.link);
    let contacts = mechanism.contacts.iter().map(|contact| contact.center.link);
    // Between points of one link the two forces of a spring cancel.
    let springs = mechanism.springs.iter().filter(|spring| spring.ends[0].link != spring.ends[1].link);
    let springs = springs.flat_map(|spring| spring.ends.map(|end| end.link));
    for link in forces.chain(moments).chain(contacts).chain(springs) {
        loaded[link] = true;
    }
    loaded
}

/// Whether a link has a weight.
fn weight(mechanism: &Mechanism, link: LinkId) -> bool {
    mechanism.links[link].mass > 0.0 && mechanism.gravity.is_some_and(|gravity| gravity != [0.0, 0.0])
}

/// Links whose mass or loads enter J or Q.
pub(crate) fn reduced_links(mechanism: &Mechanism) -> Vec<LinkId> {
    let loaded = loaded(mechanism, |link| is_heavy(mechanism, link));
    (1..mechanism.links.len()).filter(|link| loaded[*link]).collect()
}

/// Whether a link has mass or moment of inertia.
pub(crate) fn is_heavy(mechanism: &Mechanism, link: LinkId) -> bool {
    mechanism.links[link].mass > 0.0 || mechanism.links[link].inertia > 0.0
}

/// By group: whether its reactions can differ from zero. The groups are visited from the last to the first: one carries
/// a load if its links have one of their own, or if a later group that carries one is attached to them.
pub(crate) fn groups(mechanism: &Mechanism, structure: &Structure) -> Vec<bool> {
    let moves = mechanism.motion.is_some();
    let mut links = loaded(mechanism, |link| weight(mechanism, link) || moves && is_heavy(mechanism, link));
    match mechanism.balance {
        Some(Balance::Moment(link)) => links[link] = true,
        Some(Balance::Force { at, .. }) => links[at.link] = true,
        None => {}
    }
    let mut carrying = vec![false; structure.groups.len()];
    for (index, group) in structure.groups.iter().enumerate().rev() {
        let frame = &group.frame;
        carrying[index] = frame.links.iter().any(|link| links[*link]);
        if carrying[index] {
            let ends = frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
            ends.for_each(|link| links[link] = true);
        }
    }
    carrying
}

/// Whether a load that is always against the motion acts outside the input link: PF1 together with PF2 shows whether
/// its point is at rest.
pub(crate) fn opposed(mechanism: &Mechanism) -> bool {
    let far = |link: LinkId| link != GROUND && link != mechanism.input.link;
    let against = |direction| matches!(direction, assur_mechanism::Direction::AgainstMotion);
    let brakes = mechanism.moments.iter().any(|moment| moment.brake.is_some() && far(moment.link));
    brakes || mechanism.forces.iter().any(|force| against(force.direction) && far(force.at.link))
}

/// Whether a link of a group has mass.
pub(crate) fn heavy_groups(mechanism: &Mechanism, structure: &Structure) -> bool {
    (1..mechanism.links.len()).any(|link| is_heavy(mechanism, link) && group_of(structure, link).is_some())
}

/// The group of a link; none for the ground and the input link.
pub(crate) fn group_of(structure: &Structure, link: LinkId) -> Option<usize> {
    structure.groups.iter().position(|group| group.frame.links.contains(&link))
}
