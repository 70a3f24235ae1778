//! The requested results, and the groups on which they depend.

use assur_group::Order;
use assur_mechanism::{Balance, GROUND, LinkId, Mechanism, Output, PairId, Place};
use assur_structure::Structure;
use assur_words::{Text, text};

use crate::plan::{Plan, Wanted};

/// The results that an output names, or all, without repetition and in the order of the scene.
pub(crate) fn wanted(mechanism: &Mechanism, structure: &Structure, output: Option<&Output>) -> Wanted {
    let named =
        |ids: fn(&Output) -> &Vec<usize>, id: &usize| output.is_none_or(|output| ids(output).contains(id));
    let points = (0..mechanism.points.len()).filter(|id| named(|output| &output.points, id));
    let pins = (0..mechanism.points.len()).filter(|id| mechanism.points[*id].is_pin());
    let slides = 0..mechanism.slides.len();
    let is_wanted = |pair: &PairId| output.is_none_or(|output| output.reactions.contains(pair));
    Wanted {
        links: (1..mechanism.links.len()).filter(|id| named(|output| &output.links, id)).collect(),
        points: points.map(|id| (id, earliest(mechanism, structure, id))).collect(),
        slides: slides.clone().filter(|id| named(|output| &output.slides, id)).collect(),
        reactions: pins.map(PairId::Pin).chain(slides.map(PairId::Slide)).filter(is_wanted).collect(),
    }
}

/// The groups on which the requested results and the loads depend.
///
/// A method that treats the mechanism as one system needs all of them.
pub(crate) fn groups(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Vec<bool> {
    // Passive parts may be attached to any of them.
    if plan.forces && !plan.by_groups || !structure.passive.is_empty() {
        return vec![true; structure.groups.len()];
    }
    let mut links = shown(mechanism, &plan.wanted);
    if plan.reduction {
        // Those whose mass or loads enter J or Q.
        let loaded = loaded(mechanism, |link| mechanism.links[link].is_heavy());
        links.extend((1..mechanism.links.len()).filter(|link| loaded[*link]));
    }
    if plan.forces {
        let carrying = structure.groups.iter().zip(&plan.groups_carrying).filter(|(_, carrying)| **carrying);
        links.extend(carrying.flat_map(|(group, _)| &group.frame.links));
    }
    behind(structure, links)
}

/// The links whose motion is requested.
fn shown(mechanism: &Mechanism, wanted: &Wanted) -> Vec<LinkId> {
    let slides = wanted.slides.iter().map(|&slide| &mechanism.slides[slide]);
    let points = wanted.points.iter().map(|(_, place)| place.link);
    wanted
        .links
        .iter()
        .copied()
        .chain(points)
        .chain(slides.flat_map(|slide| [slide.link, slide.on]))
        .collect()
}

/// The groups of these links, and the groups on which these depend.
fn behind(structure: &Structure, mut links: Vec<LinkId>) -> Vec<bool> {
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

/// The link in which a point is evaluated: the one that is known first (ground, input link, then the groups in their
/// order).
fn earliest(mechanism: &Mechanism, structure: &Structure, point: usize) -> Place {
    let rank = |place: &&Place| match group_of(structure, place.link) {
        None if place.link == GROUND => 0,
        None if structure.is_passive(place.link) => usize::MAX,
        None => 1,
        Some(group) => group + 2,
    };
    let places = &mechanism.points[point].places;
    // A point always has a place; for one without, the ground's origin is used.
    places.iter().min_by_key(rank).copied().unwrap_or(Place { link: GROUND, at: [0.0; 2] })
}

/// The order for a plan whose stages are decided, with its reason in words.
pub(crate) fn order(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> (Order, Vec<Text>) {
    let shows = !plan.wanted.has_no_motion();
    let second = [
        (shows, text!("analysis-order-shown")),
        (plan.velocities, text!("analysis-order-accelerations")),
        (plan.reduction && !plan.inertia_constant, text!("analysis-order-inertia")),
        (plan.inertia_loads && heavy_groups(mechanism, structure), text!("analysis-order-masses")),
        ((plan.reduction || plan.forces) && opposed(mechanism), text!("analysis-order-rest")),
    ];
    let first = [
        (plan.reduction, text!("analysis-order-power")),
        (plan.forces && plan.groups_carrying.contains(&true), text!("analysis-order-forces")),
        (plan.forces && !plan.by_groups, text!("analysis-order-forces")),
    ];
    let reasons = |list: &[(bool, Text)]| -> Vec<Text> {
        list.iter().filter(|&(needs, _why)| *needs).map(|(_needs, why)| why.clone()).collect()
    };
    match (reasons(&second), reasons(&first)) {
        (why, _) if !why.is_empty() => (Order::Second, why),
        (_, mut why) if !why.is_empty() => {
            why.dedup();
            (Order::First, why)
        }
        _ => (Order::Place, Vec::new()),
    }
}

/// By link: whether a load acts on it, or (`heavy`) its mass counts.
///
/// A load whose value happens to be zero is a load: the plan considers what the scene defines, not numbers.
fn loaded(mechanism: &Mechanism, heavy: impl Fn(LinkId) -> bool) -> Vec<bool> {
    let mut loaded: Vec<bool> = (0..mechanism.links.len()).map(|id| id != GROUND && heavy(id)).collect();
    for link in mechanism.loads.iter().flat_map(|load| load.kind.links()) {
        loaded[link] = true;
    }
    loaded
}

/// By group: whether its reactions can differ from zero. The groups are visited from the last to the first: one carries
/// a load if its links have one of their own, or if a later group that carries one is attached to them.
pub(crate) fn groups_carrying(mechanism: &Mechanism, structure: &Structure) -> Vec<bool> {
    let moves = mechanism.motion.is_some();
    let falls = mechanism.gravity.is_some_and(|gravity| gravity != [0.0, 0.0]);
    let mut links = loaded(mechanism, |link| {
        let link = &mechanism.links[link];
        falls && link.mass > 0.0 || moves && link.is_heavy()
    });
    match mechanism.balance {
        Some(Balance::Moment(link)) => links[link] = true,
        Some(Balance::Force { at, .. }) => links[at.link] = true,
        None => {}
    }
    loop {
        let mut carrying = vec![!structure.passive.is_empty(); structure.groups.len()];
        for (index, group) in structure.groups.iter().enumerate().rev() {
            let frame = &group.frame;
            carrying[index] |= frame.links.iter().any(|link| links[*link]);
            if carrying[index] {
                let ends = frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
                ends.for_each(|link| links[link] = true);
            }
        }
        if !carry_by_friction(mechanism, &mut links) {
            return carrying;
        }
    }
}

/// Marks the links that friction may load in a joint of three and more links, since another one of them is loaded; whether there
/// are new ones.
fn carry_by_friction(mechanism: &Mechanism, links: &mut [bool]) -> bool {
    let mut more = false;
    for friction in &mechanism.frictions {
        let PairId::Pin(point) = friction.pair else { continue };
        let places = &mechanism.points[point].places;
        if places.len() > 2 && places.iter().any(|place| place.link != GROUND && links[place.link]) {
            for place in places {
                more |= !std::mem::replace(&mut links[place.link], true);
            }
        }
    }
    more
}

/// Whether a load that is always against the motion acts outside the input link: PF1 together with PF2 shows whether
/// its point is at rest.
pub(crate) fn opposed(mechanism: &Mechanism) -> bool {
    let far = |link: LinkId| link != GROUND && Some(link) != mechanism.input.crank();
    mechanism.loads.iter().any(|load| load.kind.is_against_motion() && load.kind.links().any(far))
}

/// Whether a link of a group has mass.
pub(crate) fn heavy_groups(mechanism: &Mechanism, structure: &Structure) -> bool {
    let follows = |link: LinkId| group_of(structure, link).is_some() || structure.is_passive(link);
    mechanism.heavy_links().any(follows)
}

/// The group of a link; none for the ground and the input link.
pub(crate) fn group_of(structure: &Structure, link: LinkId) -> Option<usize> {
    structure.groups.iter().position(|group| group.frame.links.contains(&link))
}
