//! The forces of pins and slides in eight positions.

use std::collections::HashMap;

use assur_force::{Joint, Reactions, joints};
use assur_group::plane::{dot, perp};
use assur_kinematics::{LanePosition, Linkage};
use assur_mechanism::{LinkId, PairId};
use assur_number::{Lanes, Real, elementary};

/// The pins and slides of a mechanism.
#[derive(Debug)]
pub(crate) struct Joints {
    all: Vec<Shown>,
    /// Those that results show, by their numbers.
    wanted: Vec<usize>,
}

/// A pin or slide.
#[derive(Debug)]
pub(crate) struct Shown {
    pub(crate) joint: Joint,
    /// Of a slide: the link of its guide, and the direction of the guide in the frame of that link.
    guide: Option<(LinkId, [Lanes; 2])>,
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
    pub(crate) fn new(linkage: &Linkage, wanted: &[PairId]) -> Self {
        let shown = |joint: Joint| {
            let guide = match joint.id {
                PairId::Pin(_) => None,
                PairId::Slide(slide) => {
                    let slide = &linkage.mechanism.slides[slide];
                    let (s, c) = elementary::sin_cos(slide.angle);
                    Some((slide.on, [c, s].map(Lanes::from_f64)))
                }
            };
            Shown { joint, guide }
        };
        let all: Vec<Shown> = joints(&linkage.mechanism, &linkage.structure).into_iter().map(shown).collect();
        let number: HashMap<PairId, usize> =
            all.iter().enumerate().map(|(number, shown)| (shown.joint.id, number)).collect();
        Self { wanted: wanted.iter().filter_map(|pair| number.get(pair).copied()).collect(), all }
    }

    /// One of those that results show, by its number among them.
    pub(crate) fn of(&self, wanted: usize) -> &Shown {
        &self.all[self.wanted[wanted]]
    }

    /// The greatest force of all, N.
    pub(crate) fn greatest(&self, reactions: &Reactions<Lanes>) -> [f64; Lanes::WIDTH] {
        let mut greatest = [0.0_f64; Lanes::WIDTH];
        for shown in &self.all {
            for [x, y] in (0..shown.joint.links.len()).map(|nth| shown.joint.force(nth, &reactions.pairs)) {
                for (lane, greatest) in greatest.iter_mut().enumerate() {
                    *greatest = greatest.max(elementary::hypot(x.0[lane], y.0[lane]));
                }
            }
        }
        greatest
    }
}

impl Shown {
    /// Of a slide: force on the sliding link across its guide, N.
    pub(crate) fn normal(&self, reactions: &Reactions<Lanes>, position: &LanePosition) -> Option<Lanes> {
        let (on, along) = self.guide?;
        Some(dot(perp(position.bodies[on].turned(along)), self.joint.force(0, &reactions.pairs)))
    }
}
