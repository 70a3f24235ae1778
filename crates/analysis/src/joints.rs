//! Reactions of pairs summed to what each pin and slide exerts on its links.

use std::collections::HashSet;

use assur_force::Reactions;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{LinkId, PairId};

/// A force below this part of the greatest of the position has no meaningful line of action.
const LEAST_FORCE: f64 = 1e-9;

/// The pins and slides of a mechanism, with the pairs of the groups that each consists of, and their reactions in one
/// position.
#[derive(Debug)]
pub(crate) struct Joints {
    /// All of them: pins in the order of the points, then slides.
    all: Vec<Joint>,
    /// Force on each end of each joint, N.
    forces: Vec<[f64; 2]>,
}

/// A pin or slide.
#[derive(Debug)]
struct Joint {
    /// Whether results show it.
    wanted: bool,
    /// The links that it joins; of a slide the sliding link first.
    ends: Vec<End>,
    /// The place of its first force in the list of all.
    first: usize,
    /// Of a slide: the guide.
    guide: Option<Guide>,
}

/// A link in a joint: the reactions of pairs that act on it, each with its sign.
#[derive(Debug)]
struct End {
    terms: Vec<(usize, f64)>,
}

#[derive(Debug)]
struct Guide {
    on: LinkId,
    /// Its direction in the frame of that link: cosine, sine.
    along: [f64; 2],
    /// Pairs whose moments act on the sliding link.
    pairs: Vec<usize>,
}

/// The reactions of one joint.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointForces<'a> {
    /// Force on each of its links, N.
    pub(crate) forces: &'a [[f64; 2]],
    /// Of a slide: moment on the sliding link about its point, N m, and its [offset](crate::results::Quantity::Offset).
    pub(crate) slide: Option<(f64, Option<f64>)>,
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
        let mechanism = &linkage.mechanism;
        let pins = mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin());
        let slides = (0..mechanism.slides.len()).map(PairId::Slide);
        let wanted: HashSet<PairId> = wanted.iter().copied().collect();
        let (mut all, mut first) = (Vec::new(), 0);
        for pair in pins.map(|(point, _)| PairId::Pin(point)).chain(slides) {
            let pairs = linkage.structure.pairs.iter().enumerate().filter(|(_, named)| named.source == pair);
            let terms = |link: LinkId| {
                let sign =
                    |a: LinkId, b: LinkId| f64::from(u8::from(link == a)) - f64::from(u8::from(link == b));
                let each = pairs.clone().map(|(index, named)| (index, sign(named.pair.a, named.pair.b)));
                End { terms: each.filter(|(_, sign)| *sign != 0.0).collect() }
            };
            let ends: Vec<End> = ends(linkage, pair).into_iter().map(terms).collect();
            let guide = match pair {
                PairId::Pin(_) => None,
                PairId::Slide(slide) => {
                    let slide = &mechanism.slides[slide];
                    let (s, c) = slide.angle.sin_cos();
                    Some(Guide {
                        on: slide.on,
                        along: [c, s],
                        pairs: pairs.map(|(index, _)| index).collect(),
                    })
                }
            };
            let joint = Joint { wanted: wanted.contains(&pair), first, guide, ends };
            first += joint.ends.len();
            all.push(joint);
        }
        Self { all, forces: vec![[0.0; 2]; first] }
    }

    /// Sums the reactions of a position.
    pub(crate) fn sum(&mut self, reactions: &Reactions) {
        let mut forces = self.forces.iter_mut();
        for end in self.all.iter().flat_map(|joint| &joint.ends) {
            let Some(force) = forces.next() else { return };
            *force = [0.0; 2];
            for (pair, sign) in &end.terms {
                force[0] += sign * reactions.pairs[*pair].fx;
                force[1] += sign * reactions.pairs[*pair].fy;
            }
        }
    }

    /// The joints that results show with their reactions in a position, which [`sum`](Self::sum) has summed.
    pub(crate) fn wanted<'a>(
        &'a self,
        reactions: &'a Reactions,
        position: &'a Position,
    ) -> impl Iterator<Item = JointForces<'a>> {
        let greatest = self.forces.iter().map(|force| force[0].hypot(force[1])).fold(0.0, f64::max);
        self.all.iter().filter(|joint| joint.wanted).map(move |joint| {
            let forces = &self.forces[joint.first..joint.first + joint.ends.len()];
            let slide = joint.guide.as_ref().map(|guide| {
                let moment = guide.pairs.iter().fold(0.0, |sum, pair| sum + reactions.pairs[*pair].m);
                let along = position.bodies[guide.on].turned(guide.along);
                let normal = along[0] * forces[0][1] - along[1] * forces[0][0];
                (moment, (normal.abs() > LEAST_FORCE * greatest).then(|| moment / normal))
            });
            JointForces { forces, slide }
        })
    }
}
