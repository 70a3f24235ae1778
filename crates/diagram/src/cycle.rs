//! A reaction over the cycle: its polar diagram, its greatest value and root mean square.

use assur_mechanism::{LinkId, Named, PairId};
use serde::Serialize;

use crate::plan::length;

/// Size of one reaction over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReactionExtreme {
    /// Pin or slide.
    pub joint: Named<PairId>,
    /// The link that it acts on.
    pub on: Named<LinkId>,
    /// Greatest modulus, N.
    pub greatest: f64,
    /// Number of the position where it occurs; the first one of equals.
    pub index: usize,
    /// Coordinate there, rad or m.
    pub coordinate: f64,
    /// Root mean square of the modulus over the coordinate, N.
    pub rms: f64,
}

/// Polar diagram of a reaction: the ends of its vectors from one origin.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Hodograph {
    /// Pin or slide.
    pub joint: Named<PairId>,
    /// The link that it acts on.
    pub on: Named<LinkId>,
    /// Coordinates of the positions, rad or m.
    pub coordinates: Vec<f64>,
    /// The force in each position, N.
    pub points: Vec<[f64; 2]>,
    /// Whether the last point joins the first: the positions make a whole cycle.
    pub closed: bool,
}

/// Relative difference below which moduli count as equal.
const TIE: f64 = 1e-9;

/// The size of one reaction as its positions are added, in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sizes {
    /// Moduli that are greater than all before them and near the greatest: size, position, coordinate.
    records: Vec<(f64, usize, f64)>,
    count: usize,
    sum_of_squares: f64,
    /// Integral of the square over the coordinate, by trapezoids.
    integral: f64,
    first: f64,
    /// Coordinate and square of the last position.
    last: [f64; 2],
}

impl Sizes {
    /// Adds the force in a position of this number and coordinate.
    pub fn add(&mut self, index: usize, coordinate: f64, force: [f64; 2]) {
        let size = length(force);
        let square = size * size;
        let greatest = self.greatest();
        if self.count == 0 || size > greatest {
            self.records.retain(|record| record.0 >= size * (1.0 - TIE));
            self.records.push((size, index, coordinate));
        }
        if self.count == 0 {
            self.first = coordinate;
        } else {
            self.integral += 0.5 * (self.last[1] + square) * (coordinate - self.last[0]);
        }
        self.sum_of_squares += square;
        self.last = [coordinate, square];
        self.count += 1;
    }

    /// The greatest modulus, N.
    pub fn greatest(&self) -> f64 {
        self.records.last().map_or(0.0, |record| record.0)
    }

    /// Greatest modulus, the first position that has it, and root mean square; `None` without positions. `closed`:
    /// whether the positions make a whole cycle.
    ///
    /// Over a whole cycle of equal steps the mean of the squares is the arithmetic one; over a range it is by
    /// trapezoids.
    pub fn extreme(&self, joint: Named<PairId>, on: Named<LinkId>, closed: bool) -> Option<ReactionExtreme> {
        // A cycle often has two equal maxima; rounding must not decide between them.
        let (_, index, coordinate) = *self.records.first()?;
        let range = self.last[0] - self.first;
        let mean = if closed || range == 0.0 {
            self.sum_of_squares / self.count as f64
        } else {
            self.integral / range
        };
        Some(ReactionExtreme { joint, on, greatest: self.greatest(), index, coordinate, rms: mean.sqrt() })
    }
}
