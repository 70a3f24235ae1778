//! Numbers as a reader wants them: six significant digits, no `-0`.

pub use assur_words::{digits, trimmed};

#[cfg(test)]
mod tests;

/// Relative tolerance with which a number counts as a step.
const SAME: f64 = 1e-9;

/// The smallest `s` times a power of ten that is at least `least`, with `s` one of `steps`, which rise from 1.
pub(crate) fn round_up(least: f64, steps: &[f64]) -> f64 {
    if !(least.is_finite() && least > 0.0) {
        return 1.0;
    }
    let power = 10.0_f64.powf(least.log10().floor());
    let found = steps.iter().map(|times| times * power).find(|step| *step >= least * (1.0 - SAME));
    found.unwrap_or(10.0 * power)
}

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
pub(crate) fn round_length(most: f64) -> f64 {
    if !(most.is_finite() && most > 0.0) {
        return 1.0;
    }
    let power = 10.0_f64.powf(most.log10().floor());
    let times = [5.0, 2.0, 1.0].into_iter().find(|times| times * power <= most);
    times.unwrap_or(1.0) * power
}

/// A number with six significant digits.
pub fn number(value: f64) -> String {
    digits(value, 6)
}

/// A number of at most four significant digits without trailing zeros: for axes and scales.
pub fn plain(value: f64) -> String {
    trimmed(value, 4)
}

/// A multiple of a step with the digits that the step has; very large and very small ones with an exponent.
pub(crate) fn stepped(value: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, reason = "an exponent of f64")]
    let exponent = |number: f64| number.abs().log10().floor() as i32;
    if value == 0.0 || !(value.is_finite() && step.is_finite()) || step <= 0.0 {
        return plain(value);
    }
    // Places behind the point: of 0.25 two, of 25 none, of 100 minus two.
    let first = -exponent(step * (1.0 + SAME));
    let of_step = step * 10.0_f64.powi(first);
    let places = first + i32::from((of_step - of_step.round()).abs() > SAME);
    let exponent = exponent(value * (1.0 + SAME));
    let count = |number: i32| usize::try_from(number).unwrap_or(0);
    match exponent {
        -4..=6 => format!("{value:.*}", count(places)),
        _ => format!("{value:.*e}", count(exponent + places)),
    }
}
