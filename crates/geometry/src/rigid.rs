//! Links that do not move against each other: the rigid parts of a mechanism.

use assur_group::{Body, GroupFrame, Pair, plane::minus};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{GROUND, LinkId, PairId};
use assur_number::elementary;

use crate::course::Cycle;

/// Rounding units of the terms of a relative velocity: of four products and their sums, in each of two bodies.
const UNITS: f64 = 16.0;

/// The rigid parts of a mechanism.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct RigidParts {
    /// For each link the first link of its part.
    first: Vec<LinkId>,
}

impl RigidParts {
    /// The rigid parts that follow from the structure: a group can't move against a part to which all its outer pairs lead.
    pub(crate) fn of_structure(linkage: &Linkage) -> Self {
        let mut parts = Self { first: (0..linkage.mechanism.links.len()).collect() };
        let groups = &linkage.structure.groups;
        let outer: Vec<_> = groups.iter().map(|group| outer_links(linkage, &group.frame)).collect();
        // A part that grows by a group may hold another one.
        for _ in groups {
            // A drive moves the links of its group.
            let undriven = groups.iter().zip(&outer).filter(|(group, _)| group.frame.driven.is_empty());
            for (group, outer) in undriven {
                let Some((first, others)) = outer.split_first() else { continue };
                let holds =
                    |one: LinkId| others.iter().all(|pair| pair.iter().any(|&link| parts.joins(one, link)));
                if let Some(part) = first.iter().copied().find(|&one| holds(one)) {
                    group.frame.links.iter().for_each(|&link| parts.unite(part, link));
                }
            }
        }
        parts
    }

    /// The rigid parts that follow from the structure, and from the dimensions: two couplers of one parallelogram don't move
    /// against each other; their relative PF1 is rounding over the whole cycle.
    pub(crate) fn of(cycle: &Cycle<'_>) -> Self {
        let mut parts = Self::of_structure(cycle.linkage);
        let factors: Vec<_> = cycle.samples.iter().map(|position| factors(cycle.linkage, position)).collect();
        for link in 1..parts.first.len() {
            for other in 0..link {
                let heads = parts.first[link] == link && parts.first[other] == other;
                let still = || {
                    let mut all = cycle.samples.iter().zip(&factors);
                    all.all(|(position, factors)| rests(cycle.linkage, position, factors, [link, other]))
                };
                if heads && still() {
                    parts.unite(other, link);
                }
            }
        }
        parts
    }

    /// Whether two links never move against each other.
    pub(crate) fn joins(&self, one: LinkId, other: LinkId) -> bool {
        self.first[one] == self.first[other]
    }

    fn unite(&mut self, one: LinkId, other: LinkId) {
        let [one, other] = [self.first[one], self.first[other]];
        let [head, tail] = [one.min(other), one.max(other)];
        self.first.iter_mut().filter(|first| **first == tail).for_each(|first| *first = head);
    }
}

/// For each outer pair of a group, the links outside it to which the pair leads: a pin may join several.
fn outer_links(linkage: &Linkage, frame: &GroupFrame) -> Vec<Vec<LinkId>> {
    let outside = |link: &LinkId| frame.column(*link).is_none();
    let links = |pair: &Pair| match linkage.structure.pairs[pair.id].source {
        PairId::Pin(point) => {
            let places = &linkage.mechanism.points[point].places;
            places.iter().map(|place| place.link).filter(outside).collect()
        }
        PairId::Slide(_) => [pair.a, pair.b].into_iter().filter(outside).collect(),
    };
    frame.outer.iter().map(links).collect()
}

/// By how much the PF1 of each link multiplies rounding. A group divides what comes from its outer links by its
/// determinant: once in its places, and again in its PF1, whose equations are made of these places.
fn factors(linkage: &Linkage, position: &Position) -> Vec<f64> {
    let mut all = vec![[1.0_f64; 2]; position.bodies.len()];
    all[GROUND] = [0.0; 2];
    for (group, health) in linkage.structure.groups.iter().zip(&position.health) {
        let bodies = group.frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
        let outer = bodies.filter(|&body| group.frame.column(body).is_none()).map(|body| all[body]);
        let [place, pf1] = outer.fold([0.0; 2], |most, one| [0, 1].map(|i| f64::max(most[i], one[i])));
        let health = health.abs().min(1.0);
        let place = (1.0 + place) / health;
        let found = [place, (1.0 + place + pf1) / health];
        group.frame.links.iter().for_each(|&link| all[link] = found);
    }
    all.into_iter().map(|[_, pf1]| pf1).collect()
}

/// Whether the relative PF1 of two links is rounding in a position.
fn rests(linkage: &Linkage, position: &Position, factors: &[f64], [one, other]: [LinkId; 2]) -> bool {
    let scale = linkage.structure.scale;
    let bodies = &position.bodies;
    let size = |body: &Body<f64>| modulus([body.x1, body.y1]) + scale * body.w1.abs();
    let motion = bodies.iter().take(linkage.structure.links).map(size).fold(0.0, f64::max);
    let [a, b] = [&bodies[one], &bodies[other]];
    let arm = minus([a.x, a.y], [b.x, b.y]);
    let slip = modulus(minus([a.x1, a.y1], b.first(arm)));
    let terms = motion + b.w1.abs() * modulus(arm);
    slip + scale * (a.w1 - b.w1).abs() <= UNITS * f64::EPSILON * terms * (factors[one] + factors[other])
}

/// The length of a vector.
pub(crate) fn modulus(v: [f64; 2]) -> f64 {
    elementary::hypot(v[0], v[1])
}
