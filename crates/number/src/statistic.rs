//! Extremes, mean and mean square of a quantity, gathered value by value or eight at once.

use crate::{Lanes, Real};

/// Extremes that differ by less than this part of them are equal: a cycle often has two, and rounding must not decide between them.
const TIE: f64 = 1e-9;

/// An extreme value, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// Number of the position or sample; the first of those that are equal.
    pub number: usize,
}

/// What is known of a quantity over numbered positions or samples.
///
/// A value that is not a number is in the means only.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Statistic {
    count: usize,
    greatest: Most,
    /// Of the values with the opposite sign.
    least: Most,
    sum: Lanes,
    squares: Lanes,
}

/// The greatest value of each lane.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Most {
    value: Lanes,
    /// Number of the first value that is equal to it.
    number: [usize; Lanes::WIDTH],
    /// Up to this, values are equal to that one.
    equal: Lanes,
}

impl Default for Most {
    fn default() -> Self {
        let none = Lanes([f64::NEG_INFINITY; Lanes::WIDTH]);
        Self { value: none, number: [usize::MAX; Lanes::WIDTH], equal: none }
    }
}

impl Most {
    #[inline(always)]
    fn put(&mut self, lane: usize, number: usize, value: f64) {
        // Selections instead of branches make vector instructions.
        let (greater, leaves) = (value > self.value.0[lane], value > self.equal.0[lane]);
        self.value.0[lane] = if greater { value } else { self.value.0[lane] };
        self.number[lane] = if leaves { number } else { self.number[lane] };
        self.equal.0[lane] = if leaves { value + TIE * value.abs() } else { self.equal.0[lane] };
    }

    fn append(&mut self, next: &Self, lane: usize) {
        if next.value.0[lane] > self.equal.0[lane] {
            (self.number[lane], self.equal.0[lane]) = (next.number[lane], next.equal.0[lane]);
        }
        self.value.0[lane] = self.value.0[lane].max(next.value.0[lane]);
    }

    fn extreme(&self) -> Option<Extreme> {
        let value = self.value.greatest();
        let equal = self.number.iter().zip(self.equal.0).filter(|(_, up_to)| *up_to >= value);
        let number = equal.map(|(number, _)| *number).min().filter(|number| *number < usize::MAX)?;
        Some(Extreme { value, number })
    }
}

impl Statistic {
    /// Adds a value.
    #[inline]
    pub fn push(&mut self, number: usize, value: f64) {
        self.count += 1;
        self.put(0, number, value);
    }

    /// Adds the values of some lanes, whose numbers follow `first`.
    #[inline]
    pub fn add(&mut self, lanes: [bool; Lanes::WIDTH], first: usize, values: Lanes) {
        if lanes == [true; Lanes::WIDTH] {
            self.count += Lanes::WIDTH;
            (0..Lanes::WIDTH).for_each(|lane| self.put(lane, first + lane, values.0[lane]));
        } else {
            for lane in (0..Lanes::WIDTH).filter(|&lane| lanes[lane]) {
                self.count += 1;
                self.put(lane, first + lane, values.0[lane]);
            }
        }
    }

    /// Adds the values of another statistic, which come after these.
    pub fn append(&mut self, next: &Self) {
        self.count += next.count;
        for lane in 0..Lanes::WIDTH {
            self.greatest.append(&next.greatest, lane);
            self.least.append(&next.least, lane);
            self.sum.0[lane] += next.sum.0[lane];
            self.squares.0[lane] += next.squares.0[lane];
        }
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, number: usize, value: f64) {
        self.greatest.put(lane, number, value);
        self.least.put(lane, number, -value);
        self.sum.0[lane] += value;
        self.squares.0[lane] += value * value;
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The greatest value.
    pub fn greatest(&self) -> Option<Extreme> {
        self.greatest.extreme()
    }

    /// The least value.
    pub fn least(&self) -> Option<Extreme> {
        self.least.extreme().map(|least| Extreme { value: -least.value, ..least })
    }

    /// The value of greatest magnitude, with its sign.
    pub fn farthest(&self) -> Option<Extreme> {
        let (greatest, least) = (self.greatest()?, self.least()?);
        let [high, low] = [greatest, least].map(|extreme| extreme.value.abs());
        let is_tie = high.max(low) <= high.min(low) * (1.0 + TIE);
        let is_greatest = if is_tie { greatest.number <= least.number } else { high > low };
        Some(if is_greatest { greatest } else { least })
    }

    /// The mean.
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum.0.iter().sum::<f64>() / self.count as f64)
    }

    /// The root of the mean square.
    pub fn rms(&self) -> Option<f64> {
        (self.count > 0).then(|| (self.squares.0.iter().sum::<f64>() / self.count as f64).sqrt())
    }
}

impl FromIterator<(usize, f64)> for Statistic {
    fn from_iter<I: IntoIterator<Item = (usize, f64)>>(values: I) -> Self {
        let mut found = Self::default();
        values.into_iter().for_each(|(number, value)| found.push(number, value));
        found
    }
}
