//! The effect of rounding on the numbers of a position: the chain is solved with every datum perturbed by a small part
//! of its size, and the deviation of each number, in parts of the perturbation, is its true amplification.
//!
//! A backward-stable calculation gives the exact result for data that are perturbed by a few rounding units. Its error
//! is then (rounding units) x (amplification), whatever the mechanism, and near a singular position it grows as it
//! must: the amplification is a property of the equations, not a power of the determinant. The calculated numbers do
//! not enter, so an error in them can't widen its own limit.
//!
//! The data of a group are the places of its pairs in its links, and the motion of the bodies that carry it, which have
//! the rounding of their own solution.

use assur_group::{Body, Pair, PairGeometry};
use assur_kinematics::Linkage;
use assur_number::Real;
use assur_structure::Structure;

/// Perturbations in random directions; the greatest effect counts.
pub(crate) const TRIALS: u64 = 4;

/// Perturbs data by a small part of their size, up or down at random.
#[derive(Debug)]
pub(crate) struct Perturbation {
    /// Distance of the farthest pair from the origin of each link, m: the scale for the rounding of places.
    reach: Vec<f64>,
    part: f64,
    state: u64,
}

impl Perturbation {
    pub(crate) fn new(linkage: &Linkage, part: f64) -> Self {
        let mut reach = vec![0.0_f64; linkage.structure.links];
        for named in &linkage.structure.pairs {
            for (link, at) in named.pair.places() {
                reach[link] = reach[link].max(at[0].hypot(at[1]));
            }
        }
        Self { reach, part, state: 0 }
    }

    pub(crate) fn begin(&mut self, trial: u64) {
        self.state = trial + 1;
    }

    /// Plus or minus the part, by the next bit of a linear congruential generator (Knuth's MMIX).
    fn next(&mut self) -> f64 {
        self.state =
            self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if self.state >> 63 == 0 { self.part } else { -self.part }
    }

    /// The structure with perturbed lengths and angles of all groups and passive links.
    pub(crate) fn lengths(&mut self, structure: &Structure) -> Structure {
        let mut perturbed = structure.clone();
        let groups = perturbed.groups.iter_mut().map(|group| &mut group.frame);
        for frame in groups.chain(perturbed.passive.iter_mut().map(|passive| &mut passive.frame)) {
            for pair in frame.inner.iter_mut().chain(&mut frame.outer) {
                self.pair(pair);
            }
        }
        perturbed
    }

    fn pair(&mut self, pair: &mut Pair) {
        let (points, angles) = match &mut pair.geometry {
            PairGeometry::Pin { at_a, at_b } => ([at_a, at_b], None),
            PairGeometry::Slide { point, through, angle, tilt } => ([point, through], Some([angle, tilt])),
        };
        for number in points.into_iter().flatten() {
            *number += self.next() * number.abs();
        }
        for angle in angles.into_iter().flatten() {
            // Cosine and sine are each rounded, which turns the direction by this angle.
            *angle += self.next() * angle.abs().min(1.0);
        }
    }

    /// The time, in which the terms of the laws over it are rounded: a law is off as at a time that is.
    pub(crate) fn time<T: Real>(&mut self, time: T) -> T {
        time + T::from_f64(self.next() * time.to_f64().abs())
    }

    /// The ground is at rest exactly, but its pins and guides are data.
    pub(crate) fn ground<T: Real>(&mut self, body: &mut Body<T>) {
        self.place(body, 0);
    }

    /// Perturbs each number of a link by a part of the size of the terms of which it was computed.
    pub(crate) fn link<T: Real>(&mut self, body: &mut Body<T>, link: usize) {
        self.place(body, link);
        let reach = self.reach[link];
        let [x1, y1, w1, x2, y2, w2] =
            [body.x1, body.y1, body.w1, body.x2, body.y2, body.w2].map(|number| number.to_f64().abs());
        let (first, turn) = (x1 + y1 + w1 * reach, w2 + w1 * w1);
        let second = x2 + y2 + turn * reach;
        for (number, size) in [
            (&mut body.x1, first),
            (&mut body.y1, first),
            (&mut body.w1, w1),
            (&mut body.x2, second),
            (&mut body.y2, second),
            (&mut body.w2, turn),
        ] {
            *number += T::from_f64(self.next() * size);
        }
    }

    fn place<T: Real>(&mut self, body: &mut Body<T>, link: usize) {
        let size = body.x.to_f64().abs() + body.y.to_f64().abs() + self.reach[link];
        body.x += T::from_f64(self.next() * size);
        body.y += T::from_f64(self.next() * size);
        let turn = T::from_f64(self.next());
        (body.c, body.s) = (body.c - turn * body.s, body.s + turn * body.c);
    }
}
