//! The rounding error of a calculated function, measured near the position itself.
//!
//! Values at closely spaced arguments are differenced until only rounding remains (Hamming; Moré and Wild, "Estimating
//! computational noise", 2011): the fourth difference of a smooth function over a spacing of 1e-9 is far below
//! rounding, and that of independent errors with standard deviation s has the standard deviation s sqrt(70).

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
