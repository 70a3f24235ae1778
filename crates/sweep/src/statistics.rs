//! What is known of a quantity over the positions.

use assur_number::{Lanes, Real};

/// The lanes that hold a position in which the quantity is known.
pub(crate) type Valid = [bool; Lanes::WIDTH];

/// Extremes, mean and mean square of a quantity over the positions, gathered in lanes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Statistics {
    count: usize,
    least: Lanes,
    /// Number of the first position with the least value of its lane.
    at_least: Lanes,
    greatest: Lanes,
    at_greatest: Lanes,
    sum: Lanes,
    squares: Lanes,
}

impl Statistics {
    /// Of no positions.
    pub(crate) const NONE: Self = Self {
        count: 0,
        least: Lanes([f64::INFINITY; Lanes::WIDTH]),
        at_least: Lanes([f64::INFINITY; Lanes::WIDTH]),
        greatest: Lanes([f64::NEG_INFINITY; Lanes::WIDTH]),
        at_greatest: Lanes([f64::INFINITY; Lanes::WIDTH]),
        sum: Lanes([0.0; Lanes::WIDTH]),
        squares: Lanes([0.0; Lanes::WIDTH]),
    };

    /// Adds the values in the positions of these numbers.
    #[inline]
    pub(crate) fn add(&mut self, valid: Valid, positions: Lanes, values: Lanes) {
        if valid == [true; Lanes::WIDTH] {
            self.count += Lanes::WIDTH;
            for lane in 0..Lanes::WIDTH {
                self.put(lane, positions.0[lane], values.0[lane]);
            }
        } else {
            let known = (0..Lanes::WIDTH).filter(|&lane| valid[lane]);
            known.for_each(|lane| self.add_one(lane, positions.0[lane], values.0[lane]));
        }
    }

    /// Adds the value in one position.
    #[inline]
    pub(crate) fn add_one(&mut self, lane: usize, position: f64, value: f64) {
        self.count += 1;
        self.put(lane, position, value);
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, position: f64, value: f64) {
        // A value that is not a number is in the sums. Selections instead of branches make vector instructions.
        let (less, greater) = (value < self.least.0[lane], value > self.greatest.0[lane]);
        self.least.0[lane] = if less { value } else { self.least.0[lane] };
        self.at_least.0[lane] = if less { position } else { self.at_least.0[lane] };
        self.greatest.0[lane] = if greater { value } else { self.greatest.0[lane] };
        self.at_greatest.0[lane] = if greater { position } else { self.at_greatest.0[lane] };
        self.sum.0[lane] += value;
        self.squares.0[lane] += value * value;
    }

    /// Whether there is a value.
    pub(crate) fn is_known(&self) -> bool {
        self.count > 0
    }

    /// The least value.
    pub(crate) fn least(&self) -> f64 {
        self.least.least()
    }

    /// The greatest value.
    pub(crate) fn greatest(&self) -> f64 {
        self.greatest.greatest()
    }

    /// Number of the first position with the least value.
    pub(crate) fn at_least(&self) -> f64 {
        first(&self.least, &self.at_least, self.least())
    }

    /// Number of the first position with the greatest value.
    pub(crate) fn at_greatest(&self) -> f64 {
        first(&self.greatest, &self.at_greatest, self.greatest())
    }

    /// The mean.
    pub(crate) fn mean(&self) -> f64 {
        self.sum.0.iter().sum::<f64>() / self.count as f64
    }

    /// The root of the mean square.
    pub(crate) fn rms(&self) -> f64 {
        (self.squares.0.iter().sum::<f64>() / self.count as f64).sqrt()
    }

    /// Greatest less least value.
    pub(crate) fn range(&self) -> f64 {
        self.greatest() - self.least()
    }
}

/// The first position among those of the lanes with a value.
fn first(values: &Lanes, positions: &Lanes, value: f64) -> f64 {
    let lanes = values.0.iter().zip(positions.0).filter(|(of, _)| of.total_cmp(&value).is_eq());
    lanes.map(|(_, position)| position).fold(f64::INFINITY, f64::min)
}
