//! All numbers of a position that have derivatives, and their differences around it.

use assur_kinematics::{Linkage, Position};
use assur_number::{Real, greater};

use crate::{elements::Element, kinetics};

/// Levels that an extrapolation needs.
const LEAST_LEVELS: usize = 4;

/// PF0, PF1 and PF2 of all elements (two components each), then J and J'.
#[derive(Debug, Clone)]
pub(crate) struct Numbers<T>(pub(crate) Vec<T>);

impl<T: Real> Numbers<T> {
    /// From the motions of the elements and the reduced inertia.
    pub(crate) fn new(motions: impl Iterator<Item = [[T; 2]; 3]>, inertia: [T; 2]) -> Self {
        Self(motions.flatten().flatten().chain(inertia).collect())
    }

    /// A component of the transfer function of this order of an element.
    pub(crate) fn motion(&self, element: usize, order: usize, component: usize) -> T {
        self.0[6 * element + 2 * order + component]
    }

    /// J for order 0, J' for order 1.
    pub(crate) fn inertia(&self, order: usize) -> T {
        self.0[self.0.len() - 2 + order]
    }

    /// Each number, transformed by a function.
    pub(crate) fn map<U>(&self, number: impl Fn(T) -> U) -> Numbers<U> {
        Numbers(self.0.iter().map(|value| number(*value)).collect())
    }

    /// The difference of each number from that of another place.
    pub(crate) fn off(&self, other: &Self) -> Numbers<f64> {
        Numbers(self.0.iter().zip(&other.0).map(|(a, b)| (*a - *b).to_f64().abs()).collect())
    }

    /// Central differences between these numbers and those at the greater coordinate.
    pub(crate) fn quotient(&self, high: &Self, step: f64) -> Quotient {
        let slopes = self.0.iter().zip(&high.0).map(|(low, high)| (*high - *low).to_f64() / (2.0 * step));
        Quotient { step, slopes: Numbers(slopes.collect()) }
    }
}

impl Numbers<f64> {
    /// For each number the greater of both.
    pub(crate) fn raise(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(mine, other)| *mine = greater(*mine, *other));
    }

    pub(crate) fn scaled(&self, by: f64) -> Self {
        self.map(|number| by * number)
    }
}

/// Central differences of all numbers over one step.
#[derive(Debug, Clone)]
pub(crate) struct Quotient {
    pub(crate) step: f64,
    pub(crate) slopes: Numbers<f64>,
}

/// Differences with steps that are halved from `step` down to `least`, until there are `levels` consecutive ones; `None`
/// where too few of them exist.
pub(crate) fn quotients(
    [mut step, least]: [f64; 2],
    levels: usize,
    mut over: impl FnMut(f64) -> Option<Quotient>,
) -> Option<Vec<Quotient>> {
    let mut found = Vec::with_capacity(levels);
    while found.len() < levels && step > least {
        match over(step) {
            Some(quotient) => found.push(quotient),
            None => found.clear(),
        }
        step *= 0.5;
    }
    (found.len() >= LEAST_LEVELS).then_some(found)
}

/// The numbers of the program; angles are counted from those of `reference`.
pub(crate) fn numbers(
    linkage: &Linkage,
    all: &[Element],
    position: &Position,
    reference: &Position,
) -> Numbers<f64> {
    let motions = all.iter().map(|element| element.motion(linkage, position, reference));
    Numbers::new(motions, kinetics::reduced(&linkage.mechanism, position.coordinate, &position.bodies))
}

/// Safety factor of error estimates, which are right within a small factor only: a deviation from a few samples, an
/// extrapolation from its neighbors.
pub(crate) const SAFETY: f64 = 8.0;

/// Halvings of the step at most.
pub(crate) const LEVELS: usize = 9;

/// A derivative and its estimated error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Estimate {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// Extrapolates central differences (step, difference quotient), each step half of the one before.
///
/// `rounding`: standard deviation of the rounding of the function. The error of an entry is its distance from both
/// entries from which it was computed, plus the rounding that its smallest step magnifies: for two values, 2 rounding /
/// 2h, times at most (4/3)(16/15)... < 1.5 for the extrapolation. Of each row the entry of least error counts, and of
/// all rows the best one.
///
/// The least of many estimates tends to be too small: two entries agree by chance, or large steps agree on a wrong
/// value because they all step over something narrow. So the best row must agree with its better neighbor and with the
/// row of the smallest step; otherwise the error is raised to the disagreement.
pub(crate) fn extrapolated(quotients: &[(f64, f64)], rounding: f64) -> Estimate {
    let mut rows = [Estimate { value: f64::NAN, error: f64::INFINITY }; LEVELS];
    let rows = best_of_rows(quotients, rounding, &mut rows);
    let Some(best) = (0..rows.len()).min_by(|&i, &k| rows[i].error.total_cmp(&rows[k].error)) else {
        return Estimate { value: f64::NAN, error: f64::INFINITY };
    };
    let found = rows[best];
    let apart = |other: &Estimate| (found.value - other.value).abs();
    let around = [best.checked_sub(1), Some(best + 1)].map(|i| rows.get(i?));
    let neighbor = around.into_iter().flatten().min_by(|a, b| a.error.total_cmp(&b.error)).map_or(0.0, apart);
    // A difference from the last row that rounding explains is no disagreement.
    let least = quotients.last().map_or(f64::NAN, |(step, _)| *step);
    let last = rows.last().map_or(0.0, apart) - 3.0 * rounding / least;
    Estimate { error: found.error.max(neighbor).max(last), ..found }
}

/// The entry of least error in each row of the extrapolation except the first, which has no entry to compare with.
fn best_of_rows<'a>(
    quotients: &[(f64, f64)],
    rounding: f64,
    rows: &'a mut [Estimate; LEVELS],
) -> &'a [Estimate] {
    // Row by row in place: what stands in `row[j]` is the entry of the row before until it is replaced.
    let mut row = [0.0; LEVELS];
    for (i, (step, quotient)) in quotients.iter().enumerate().take(LEVELS) {
        let mut coarse = std::mem::replace(&mut row[0], *quotient);
        let mut power = 1.0;
        for j in 0..i {
            power *= 4.0;
            let fine = row[j];
            let value = fine + (fine - coarse) / (power - 1.0);
            let apart = (value - fine).abs().max((value - coarse).abs());
            let error = apart + 1.5 * rounding / step;
            if j == 0 || error < rows[i - 1].error {
                rows[i - 1] = Estimate { value, error };
            }
            coarse = std::mem::replace(&mut row[j + 1], value);
        }
    }
    &rows[..quotients.len().saturating_sub(1).min(LEVELS)]
}

/// Number of values for one estimate.
pub(crate) const SAMPLES: usize = 8;

/// Spacing, in units of the coordinate.
pub(crate) const SPACING: f64 = 1e-9;

/// Standard deviation of the fourth difference of errors with standard deviation 1: sqrt(1 + 16 + 36 + 16 + 1).
const GAIN: f64 = 8.366_600_265_340_756;

/// Estimated standard deviation of the rounding of a function from its values at equally spaced arguments.
pub(crate) fn rounding_of(values: &[f64; SAMPLES]) -> f64 {
    let mut differences = *values;
    for order in 1..=4 {
        for i in 0..SAMPLES - order {
            differences[i] = differences[i + 1] - differences[i];
        }
    }
    let last = &differences[..SAMPLES - 4];
    // The greatest of a few, not their mean: an estimate that is too small would reject correct results.
    last.iter().fold(0.0_f64, |most, d| most.max(d.abs())) / GAIN
}
