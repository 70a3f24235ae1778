//! Pair reactions summed to the reactions of each pin and slide of the scene.

use assur_group::{Pair, Wrench};
use assur_mechanism::{LinkId, Mechanism, PairId};
use assur_number::Real;
use assur_structure::Structure;

/// A pin or slide, and the pairs of the structure of which it consists.
///
/// A multiple joint is several pairs; the force of the pin on a link is the sum over the pairs of that link.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// The pin or slide.
    pub id: PairId,
    /// The links that it joins, in the order of the scene; of a slide, the sliding link first.
    pub links: Vec<LinkId>,
    /// For each of the links, its pairs: index, and 1 where the link is body `a` of the pair, else -1.
    pub pairs: Vec<Vec<(usize, f64)>>,
    /// Where its marks begin in [`Reactions::open`](crate::Reactions::open).
    marks: usize,
}

/// The reactions of one pin or slide.
#[derive(Debug, Clone, PartialEq)]
pub struct JointReaction {
    /// The pin or slide.
    pub joint: PairId,
    /// Force on each link that it joins, N, in the order of the scene; of a slide, the sliding link first. They sum to zero.
    pub forces: Vec<(LinkId, [f64; 2])>,
    /// Of a slide: moment on the sliding link about its point, N m; the force acts at that point.
    pub moment: Option<f64>,
    /// Of a pin: moment of its friction on each link that it joins, N m; zero without friction.
    pub turning: Vec<f64>,
}

/// All pins in the order of the points, then all slides.
pub fn joints(mechanism: &Mechanism, structure: &Structure) -> Vec<Joint> {
    let mut of_point = vec![usize::MAX; mechanism.points.len()];
    let mut joints = Vec::with_capacity(mechanism.points.len() + mechanism.slides.len());
    for (id, point) in mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin()) {
        of_point[id] = joints.len();
        joints.push(Joint::new(PairId::Pin(id), point.places.iter().map(|place| place.link).collect()));
    }
    let pins = joints.len();
    let slides = mechanism.slides.iter().enumerate();
    joints.extend(slides.map(|(id, slide)| Joint::new(PairId::Slide(id), vec![slide.link, slide.on])));
    let mut marks = 0;
    for joint in &mut joints {
        joint.marks = marks;
        marks += joint.count_of_marks();
    }
    for (index, named) in structure.pairs.iter().enumerate() {
        let joint = match named.source {
            PairId::Pin(point) => of_point[point],
            PairId::Slide(slide) => pins + slide,
        };
        if let Some(joint) = joints.get_mut(joint) {
            joint.add(index, &named.pair);
        }
    }
    joints
}

impl Joint {
    fn new(id: PairId, links: Vec<LinkId>) -> Self {
        let pairs = vec![Vec::new(); links.len()];
        Self { id, links, pairs, marks: 0 }
    }

    fn count_of_marks(&self) -> usize {
        self.links.len() + usize::from(matches!(self.id, PairId::Slide(_)))
    }

    /// Its marks among those of all [reactions](crate::Reactions::open): by link, then for the moment of a slide; none where all
    /// reactions are determined.
    pub fn open<'a, T>(&self, all: &'a [T]) -> &'a [T] {
        all.get(self.marks..self.marks + self.count_of_marks()).unwrap_or_default()
    }

    fn add(&mut self, index: usize, pair: &Pair) {
        for (link, pairs) in self.links.iter().zip(&mut self.pairs) {
            if pair.joins(*link) {
                pairs.push((index, if pair.a == *link { 1.0 } else { -1.0 }));
            }
        }
    }

    /// Force on the link of this number among [`links`](Self::links), N, from the reactions in all pairs.
    #[inline]
    pub fn force<T: Real>(&self, nth: usize, reactions: &[Wrench<T>]) -> [T; 2] {
        let mut sum = [T::ZERO; 2];
        for &(pair, sign) in &self.pairs[nth] {
            let sign = T::from_f64(sign);
            sum[0] += sign * reactions[pair].fx;
            sum[1] += sign * reactions[pair].fy;
        }
        sum
    }

    /// Of a slide: moment on the sliding link about its point, N m, where the force acts; `None` for a pin.
    #[inline]
    pub fn moment<T: Real>(&self, reactions: &[Wrench<T>]) -> Option<T> {
        let slides = matches!(self.id, PairId::Slide(_));
        slides.then(|| self.pairs[0].iter().fold(T::ZERO, |sum, (pair, _)| sum + reactions[*pair].m))
    }

    /// The reactions of the joint from those in all pairs.
    pub fn reaction(&self, reactions: &[Wrench<f64>]) -> JointReaction {
        let forces = self.links.iter().enumerate().map(|(nth, link)| (*link, self.force(nth, reactions)));
        let turning = (0..self.links.len()).map(|nth| {
            let own = self.pairs[nth].iter();
            own.fold(0.0, |sum, (pair, sign)| sum + sign * reactions[*pair].m)
        });
        let turning = if matches!(self.id, PairId::Pin(_)) { turning.collect() } else { Vec::new() };
        JointReaction { joint: self.id, forces: forces.collect(), moment: self.moment(reactions), turning }
    }
}
