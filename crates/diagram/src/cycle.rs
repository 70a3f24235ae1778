//! A reaction over the cycle: its polar diagram, its greatest value and root mean square.

use assur_mechanism::{LinkId, Named, PairId};
use assur_number::{Extreme, Statistic};
use serde::Serialize;

use crate::plan::length;

/// Size of one reaction over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReactionExtreme {
    /// Pin or slide.
    pub joint: Named<PairId>,
    /// The link that it acts on.
    pub on: Named<LinkId>,
    /// Greatest magnitude, N.
    pub greatest: f64,
    /// Number of the position where it occurs; the first one of equals.
    pub index: usize,
    /// Coordinate there, rad or m.
    pub coordinate: f64,
    /// Root mean square of the magnitude over the coordinate, N.
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

/// The size of one reaction as its positions are added, in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sizes {
    modulus: Statistic,
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
        if self.modulus.is_empty() {
            self.first = coordinate;
        } else {
            self.integral += 0.5 * (self.last[1] + square) * (coordinate - self.last[0]);
        }
        self.last = [coordinate, square];
        self.modulus.push(index, size);
    }

    /// The greatest magnitude, N.
    pub fn greatest(&self) -> f64 {
        self.modulus.greatest().map_or(0.0, |greatest| greatest.value)
    }

    /// Greatest magnitude, the first position that has it, and root mean square; `None` without positions. `input`: the coordinate of
    /// a position by its number, and whether the positions make a whole cycle.
    ///
    /// Over a whole cycle of equal steps the mean of the squares is the arithmetic one; over a range it is by
    /// trapezoids.
    pub fn extreme(
        &self,
        joint: Named<PairId>,
        on: Named<LinkId>,
        (coordinate, closed): (impl Fn(usize) -> f64, bool),
    ) -> Option<ReactionExtreme> {
        let Extreme { value: greatest, number: index } = self.modulus.greatest()?;
        let range = self.last[0] - self.first;
        let rms = if closed || range == 0.0 { self.modulus.rms()? } else { (self.integral / range).sqrt() };
        Some(ReactionExtreme { joint, on, greatest, index, coordinate: coordinate(index), rms })
    }
}
