//! Numerical differentiation with an error estimate (Richardson's extrapolation, Ridders' choice of its order).

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
