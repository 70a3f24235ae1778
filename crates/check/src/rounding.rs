//! The rounding of a calculated function, measured at the place itself.
//!
//! Values at closely spaced arguments are differenced until nothing smooth is left (Hamming; Moré and Wild, "Estimating
//! computational noise", 2011): the fourth difference of a smooth function over a spacing of 1e-9 is far below rounding, and
//! that of independent errors of deviation s has the deviation s sqrt(70).

/// Values that one estimate takes.
pub(crate) const SAMPLES: usize = 8;

/// Spacing, in units of the coordinate.
pub(crate) const SPACING: f64 = 1e-9;

/// Deviation of the fourth difference of errors of deviation 1: sqrt(1 + 16 + 36 + 16 + 1).
const GAIN: f64 = 8.366_600_265_340_756;

/// Estimated deviation of the rounding of a function from its values at equally spaced arguments.
pub(crate) fn rounding_of(values: &[f64; SAMPLES]) -> f64 {
    let mut differences = *values;
    for order in 1..=4 {
        for i in 0..SAMPLES - order {
            differences[i] = differences[i + 1] - differences[i];
        }
    }
    let last = &differences[..SAMPLES - 4];
    // The greatest of a few, not their mean: an estimate that is too small would fail sound results.
    last.iter().fold(0.0_f64, |most, d| most.max(d.abs())) / GAIN
}
