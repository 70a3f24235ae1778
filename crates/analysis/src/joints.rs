//! The forces of pins and slides in eight positions.

use std::collections::HashSet;

use assur_force::{Joint, Reactions, joints};
use assur_group::plane::{dot, perp};
use assur_kinematics::{LanePosition, Linkage};
use assur_mechanism::{LinkId, PairId};
use assur_number::{Lanes, Real, elementary};

use crate::results::Mask;

/// A force below this part of the greatest of the position has no meaningful line of action.
const LEAST_FORCE: f64 = 1e-9;

/// The pins and slides of a mechanism, and their forces in eight positions.
#[derive(Debug)]
pub(crate) struct Joints {
    all: Vec<Shown>,
    /// Force on each link of each joint, N.
    forces: Vec<[Lanes; 2]>,
}

/// A pin or slide.
#[derive(Debug)]
struct Shown {
    joint: Joint,
    /// Whether results show it.
    wanted: bool,
    /// Of a slide: the link of its guide, and the direction of the guide in the frame of that link.
    guide: Option<(LinkId, [Lanes; 2])>,
}

/// The reactions of one joint.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointForces<'a> {
    /// Force on each of its links, N.
    pub(crate) forces: &'a [[Lanes; 2]],
    /// Of a slide: moment on the sliding link about its point, N m; its [offset](crate::results::Quantity::Offset), m, and
    /// the lanes that have one.
    pub(crate) slide: Option<(Lanes, Lanes, Mask)>,
    /// By link, then for the moment of a slide: 1 where it is not determined; empty where all are.
    pub(crate) open: &'a [Lanes],
}

/// The links that a pin or slide joins, in the order of the results.
pub(crate) fn ends(linkage: &Linkage, pair: PairId) -> Vec<LinkId> {
    let mechanism = &linkage.mechanism;
    match pair {
        PairId::Pin(point) => mechanism.points[point].places.iter().map(|place| place.link).collect(),
        PairId::Slide(slide) => vec![mechanism.slides[slide].link, mechanism.slides[slide].on],
    }
}

impl Joints {
    pub(crate) fn of(linkage: &Linkage, wanted: &[PairId]) -> Self {
        let wanted: HashSet<PairId> = wanted.iter().copied().collect();
        let shown = |joint: Joint| {
            let guide = match joint.id {
                PairId::Pin(_) => None,
                PairId::Slide(slide) => {
                    let slide = &linkage.mechanism.slides[slide];
                    let (s, c) = elementary::sin_cos(slide.angle);
                    Some((slide.on, [c, s].map(Lanes::from_f64)))
                }
            };
            Shown { wanted: wanted.contains(&joint.id), joint, guide }
        };
        let all = joints(&linkage.mechanism, &linkage.structure).into_iter().map(shown);
        Self { all: all.collect(), forces: Vec::new() }
    }

    /// Sums the reactions of the pairs.
    pub(crate) fn sum(&mut self, reactions: &Reactions<Lanes>) {
        self.forces.clear();
        let Self { all, forces } = self;
        let each = all.iter().map(|shown| &shown.joint);
        forces.extend(
            each.flat_map(|joint| (0..joint.links.len()).map(|nth| joint.force(nth, &reactions.pairs))),
        );
    }

    /// The joints that results show with their reactions, which [`sum`](Self::sum) has summed.
    pub(crate) fn wanted<'a>(
        &'a self,
        reactions: &'a Reactions<Lanes>,
        position: &'a LanePosition,
    ) -> impl Iterator<Item = JointForces<'a>> {
        let mut greatest = [0.0_f64; Lanes::WIDTH];
        for [x, y] in &self.forces {
            for (lane, greatest) in greatest.iter_mut().enumerate() {
                *greatest = greatest.max(elementary::hypot(x.0[lane], y.0[lane]));
            }
        }
        let mut rest = &self.forces[..];
        let each = self.all.iter().map(move |shown| {
            let (forces, after) = rest.split_at(shown.joint.links.len().min(rest.len()));
            rest = after;
            (shown, forces)
        });
        each.filter(|(shown, _)| shown.wanted).map(move |(shown, forces)| {
            let slide = shown.joint.moment(&reactions.pairs).zip(shown.guide).map(|(moment, (on, along))| {
                let normal = dot(perp(position.bodies[on].turned(along)), forces[0]);
                let has = std::array::from_fn(|lane| normal.0[lane].abs() > LEAST_FORCE * greatest[lane]);
                (moment, moment / normal, has)
            });
            JointForces { forces, slide, open: shown.joint.open(&reactions.open) }
        })
    }
}
