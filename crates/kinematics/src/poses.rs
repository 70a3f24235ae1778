//! The poses of one link at the samples of a branch, eight side by side as the lanes that calculated them.

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

    /// The pose at the last sample.
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

/// Poses of the links of iterating groups at equally spaced coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Guesses {
    /// Coordinate of the first sample, rad or m.
    pub(crate) low: f64,
    /// Distance between neighboring samples, rad or m.
    pub(crate) step: f64,
    /// Whether the samples cover a whole period, so that the last one repeats the first.
    pub(crate) periodic: bool,
    /// Each link with its pose at every sample.
    pub(crate) poses: Vec<(usize, Vec<Body<f64>>)>,
}

/// Links of the groups whose solution is iterated from a starting pose.
pub fn iterated(structure: &Structure) -> Vec<usize> {
    let iterating = structure.groups.iter().filter(|group| group.plugin.iterates);
    iterating.flat_map(|group| group.frame.links.iter().copied()).collect()
}

impl Guesses {
    /// The links with their poses at the sample closest to a coordinate.
    pub(crate) fn at(&self, coordinate: f64) -> impl Iterator<Item = (usize, &Body<f64>)> {
        self.poses.iter().map(move |(link, poses)| {
            let last = (poses.len() - 1) as f64;
            let mut place = (coordinate - self.low) / self.step;
            if self.periodic {
                place = place.rem_euclid(last);
            }
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "clamped to the samples"
            )]
            let nearest = place.round().clamp(0.0, last) as usize;
            (*link, &poses[nearest])
        })
    }

    /// Sets the links to their poses at the sample closest to a coordinate.
    pub(crate) fn put(&self, coordinate: f64, bodies: &mut [Body<f64>]) {
        self.at(coordinate).for_each(|(link, pose)| bodies[link] = *pose);
    }
}
