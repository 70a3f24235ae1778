//! Numerical differentiation with an error estimate (Richardson's extrapolation, Ridders' choice of its order).

/// Halvings of the step at most.
pub(crate) const LEVELS: usize = 9;

/// A derivative and how far it may be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Estimate {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// Extrapolates central differences (step, difference quotient), each step half of the one before.
///
/// `noise`: deviation of the rounding of the function. The error of an entry is its distance from both entries that it was made
/// of, plus the rounding that its smallest step magnifies: of two values, 2 noise / 2h, and by at most
/// (4/3)(16/15)... < 1.5 through the extrapolation. The entry of least error is taken. Large steps can agree on a wrong value
/// when they all step over something narrow; so the row of the smallest step must agree too, or the error grows to the
/// disagreement.
pub(crate) fn extrapolated(quotients: &[(f64, f64)], noise: f64) -> Estimate {
    let none = Estimate { value: f64::NAN, error: f64::INFINITY };
    let (mut best, mut last) = (none, none);
    let mut before: Vec<f64> = Vec::with_capacity(LEVELS);
    for (step, quotient) in quotients {
        let mut row = Vec::with_capacity(LEVELS);
        row.push(*quotient);
        last = none;
        let mut power = 1.0;
        for (j, coarse) in before.iter().enumerate() {
            power *= 4.0;
            let fine = row[j];
            let value = fine + (fine - coarse) / (power - 1.0);
            let apart = (value - fine).abs().max((value - coarse).abs());
            let error = apart + 1.5 * noise / step;
            if error < last.error {
                last = Estimate { value, error };
            }
            row.push(value);
        }
        if last.error < best.error {
            best = last;
        }
        before = row;
    }
    // What rounding can put between the two is no disagreement.
    let least = quotients.last().map_or(f64::NAN, |(step, _)| *step);
    let disagreement = (best.value - last.value).abs() - 3.0 * noise / least;
    Estimate { error: best.error.max(disagreement), ..best }
}
