//! The poses of one link at the samples of a branch, eight side by side as the lanes that calculated them.

use std::array;

use assur_group::Body;
use assur_number::{Lanes, Real};
use assur_structure::Structure;

/// Place and direction (x, y, c, s) of a link at successive samples.
#[derive(Debug, Clone, Default)]
pub(crate) struct Poses {
    blocks: Vec<[Lanes; 4]>,
    len: usize,
}

impl Poses {
    /// The pose at a sample; the derivatives are zero.
    pub(crate) fn get(&self, sample: usize) -> Option<Body<f64>> {
        let [x, y, c, s] = self.blocks.get(sample / Lanes::WIDTH).filter(|_| sample < self.len)?;
        let lane = sample % Lanes::WIDTH;
        Some(Body { x: x.0[lane], y: y.0[lane], c: c.0[lane], s: s.0[lane], ..Body::ground() })
    }

    pub(crate) fn last(&self) -> Option<Body<f64>> {
        self.get(self.len.checked_sub(1)?)
    }

    /// The poses at all samples in order.
    pub(crate) fn iter(&self) -> impl DoubleEndedIterator<Item = Body<f64>> + ExactSizeIterator {
        (0..self.len).map(|sample| self.get(sample).unwrap_or_else(Body::ground))
    }

    /// Sets place and direction of a link in lanes to those of a block of samples.
    pub(crate) fn load(&self, block: usize, body: &mut Body<Lanes>) {
        if let Some(&[x, y, c, s]) = self.blocks.get(block) {
            (body.x, body.y, body.c, body.s) = (x, y, c, s);
        }
    }

    /// Makes room for the poses of this number of samples.
    pub(crate) fn reserve(&mut self, samples: usize) {
        self.blocks.reserve_exact(samples.div_ceil(Lanes::WIDTH).saturating_sub(self.blocks.len()));
    }

    /// Adds the poses of a block of samples; only after whole blocks.
    pub(crate) fn push_block(&mut self, body: &Body<Lanes>) {
        self.blocks.push([body.x, body.y, body.c, body.s]);
        self.len += Lanes::WIDTH;
    }

    /// Adds the pose of one sample.
    pub(crate) fn push(&mut self, body: &Body<f64>) {
        let lane = self.len % Lanes::WIDTH;
        if lane == 0 {
            self.blocks.push([body.x, body.y, body.c, body.s].map(Lanes::from_f64));
        } else if let Some(block) = self.blocks.last_mut() {
            let numbers = [body.x, body.y, body.c, body.s];
            block.iter_mut().zip(numbers).for_each(|(lanes, number)| lanes.0[lane] = number);
        }
        self.len += 1;
    }

    /// Drops the samples from one on.
    pub(crate) fn truncate(&mut self, len: usize) {
        if len < self.len {
            self.blocks.truncate(len.div_ceil(Lanes::WIDTH));
            self.len = len;
        }
    }
}

/// A sample is interpolated between its neighbors only where these are within this of it, rad or parts of the scale.
const NEIGHBORS: f64 = 0.1;

/// Poses of the links of iterating groups at equally spaced coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Guesses {
    /// Coordinate of the first sample, rad or m.
    low: f64,
    /// Distance between neighboring samples, rad or m.
    step: f64,
    /// Whether the samples cover a whole period, so that the last one repeats the first.
    periodic: bool,
    /// Number of the last sample that all links have.
    last: usize,
    /// Most by which neighbors of a sample that is interpolated differ from it: x, y, c and s.
    most: [f64; 4],
    /// Each link with x, y, c and s at every sample.
    poses: Vec<(usize, Vec<[f64; 4]>)>,
}

/// Links of the groups whose solution is iterated from a starting pose.
pub fn iterated(structure: &Structure) -> Vec<usize> {
    let iterating = structure.groups.iter().filter(|group| group.plugin.iterates);
    iterating.flat_map(|group| group.frame.links.iter().copied()).collect()
}

impl Guesses {
    /// Poses from a first coordinate on, at distances `step`, in a mechanism of this scale; `None` where no link has any.
    pub(crate) fn new<'a, I: Iterator<Item = Body<f64>>>(
        (low, step, periodic): (f64, f64, bool),
        scale: f64,
        links: impl Iterator<Item = (&'a usize, I)>,
    ) -> Option<Self> {
        let numbers = |body: Body<f64>| [body.x, body.y, body.c, body.s];
        let poses = links.map(|(link, poses)| (*link, poses.map(numbers).collect::<Vec<_>>()));
        let poses: Vec<_> = poses.filter(|(_, poses)| !poses.is_empty()).collect();
        // A group may have been followed beyond where a later one ends the range.
        let last = poses.iter().map(|(_, poses)| poses.len() - 1).min()?;
        let most = [scale, scale, 1.0, 1.0].map(|unit| NEIGHBORS * unit);
        Some(Self { low, step, periodic, last, most, poses })
    }

    /// The sample closest to a coordinate, and how far the coordinate is past it, in steps.
    fn nearest(&self, coordinate: f64) -> (usize, f64) {
        let (place, last) = ((coordinate - self.low) / self.step, self.last as f64);
        let place = if self.periodic { place.rem_euclid(last) } else { place };
        let nearest = place.round().clamp(0.0, last);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the samples")]
        let sample = nearest as usize;
        (sample, place - nearest)
    }

    /// The coordinate of the sample closest to one.
    pub(crate) fn coordinate_near(&self, coordinate: f64) -> f64 {
        coordinate - self.nearest(coordinate).1 * self.step
    }

    /// The links with about their poses at a coordinate.
    pub(crate) fn at(&self, coordinate: f64) -> impl Iterator<Item = (usize, Body<f64>)> {
        let (sample, behind) = self.nearest(coordinate);
        let neighbors = match (sample, self.periodic) {
            (0, true) => [self.last.saturating_sub(1), 1.min(self.last)],
            (sample, true) if sample == self.last => [sample.saturating_sub(1), 1.min(self.last)],
            (sample, _) if sample > 0 && sample < self.last => [sample - 1, sample + 1],
            _ => [sample; 2],
        };
        self.poses.iter().map(move |(link, poses)| {
            let [before, here, after] = [neighbors[0], sample, neighbors[1]].map(|sample| &poses[sample]);
            let steps: [[f64; 2]; 4] = array::from_fn(|k| [here[k] - before[k], after[k] - here[k]]);
            let is_near = |(steps, most): (&[f64; 2], &f64)| steps.iter().all(|step| step.abs() <= *most);
            // The parabola through the three.
            let on_parabola = |k: usize| {
                let [back, forth] = steps[k];
                here[k] + 0.5 * behind * (back + forth + behind * (forth - back))
            };
            let are_near = steps.iter().zip(&self.most).all(is_near);
            let [x, y, c, s] = if are_near { array::from_fn(on_parabola) } else { *here };
            // Steps of Newton's method begin with a unit vector.
            let length = (c * c + s * s).sqrt();
            (*link, Body { x, y, c: c / length, s: s / length, ..Body::ground() })
        })
    }

    /// Sets the links to about their poses at a coordinate.
    pub(crate) fn put(&self, coordinate: f64, bodies: &mut [Body<f64>]) {
        self.at(coordinate).for_each(|(link, pose)| bodies[link] = pose);
    }
}
