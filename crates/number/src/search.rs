//! Searches along one real variable: for the change of a condition, for a root, for a minimum.
//!
//! Each search keeps an interval that contains the solution, and ends at the given width or when no number is left
//! between the ends. For a function that can fail there are the forms with `try_`; the first error ends the search.

use std::convert::Infallible;

/// Bisection needs at most about 1100 steps between any two finite numbers, and rarely more than 60.
const MOST_BISECTIONS: usize = 1100;

/// Steps after which false position, which converges fast or hardly at all, gives way to bisection.
const MOST_SECANTS: usize = 40;

/// Maximum number of steps of a root finder that converges faster than bisection.
const MOST_ROOT_STEPS: usize = 120;

/// Bisection of a condition that holds at `holding` and not at `failing`; either may be the smaller one.
///
/// Returns the two arguments, in this order, when they are at most `width` apart or neighboring numbers; `width` may
/// be 0.
pub fn bisect(holding: f64, failing: f64, width: f64, mut holds: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(ends) = try_bisect(holding, failing, width, |x| Ok::<_, Infallible>(holds(x)));
    ends
}

/// Bisection of a condition that can fail; see [`bisect`].
///
/// # Errors
///
/// The first error of `holds`.
pub fn try_bisect<E>(
    mut holding: f64,
    mut failing: f64,
    width: f64,
    mut holds: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    for _ in 0..MOST_BISECTIONS {
        let middle = f64::midpoint(holding, failing);
        if !is_between(middle, holding, failing) || (failing - holding).abs() <= width {
            break;
        }
        if holds(middle)? {
            holding = middle;
        } else {
            failing = middle;
        }
    }
    Ok([holding, failing])
}

/// Root of a continuous function between `positive` (where it is not negative) and `negative` (where it is), to an
/// interval of `width`, by false position with the Illinois correction.
///
/// Returns an exact root if one is met, otherwise the end at which the function is negative.
pub fn root(mut positive: f64, mut negative: f64, width: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut above, mut below) = (f(positive), f(negative));
    let mut last_was_above = None;
    for step in 0..MOST_ROOT_STEPS {
        if (negative - positive).abs() <= width {
            break;
        }
        let secant = (positive * below - negative * above) / (below - above);
        let x = if step < MOST_SECANTS && is_between(secant, positive, negative) {
            secant
        } else {
            f64::midpoint(positive, negative)
        };
        let value = f(x);
        if value == 0.0 {
            return x;
        }
        // The value at an end that is kept a second time is halved, which makes the other end move as well.
        if value > 0.0 {
            (positive, above) = (x, value);
            below *= if last_was_above == Some(true) { 0.5 } else { 1.0 };
        } else {
            (negative, below) = (x, value);
            above *= if last_was_above == Some(false) { 0.5 } else { 1.0 };
        }
        last_was_above = Some(value > 0.0);
    }
    negative
}

/// Root between `a` and `b` of a function with opposite signs there, or 0 in `b`, from its value and derivative: Newton's method, kept
/// within the bracket by bisection, to rounding. With a derivative of 0 it bisects.
pub fn try_newton_root<E>(
    mut a: f64,
    mut b: f64,
    mut f: impl FnMut(f64) -> Result<(f64, f64), E>,
) -> Result<f64, E> {
    let at_end = f(b)?.0;
    if at_end == 0.0 {
        return Ok(b);
    }
    let rising = at_end > 0.0;
    let mut x = f64::midpoint(a, b);
    for _ in 0..MOST_ROOT_STEPS {
        let (value, slope) = f(x)?;
        if value == 0.0 {
            return Ok(x);
        }
        if (value > 0.0) == rising {
            b = x;
        } else {
            a = x;
        }
        let newton = x - value / slope;
        let next = if is_between(newton, a, b) { newton } else { f64::midpoint(a, b) };
        if (next - x).abs() <= f64::EPSILON * x.abs().max((b - a).abs()) {
            return Ok(next);
        }
        x = next;
    }
    Ok(x)
}

/// Minimum of a function with one minimum between `low` and `high`, by `sections` golden sections: argument and
/// value.
///
/// Each section reduces the interval to 0.618 of its width. The argument of a smooth minimum is accurate only to
/// about the square root of the rounding of the values.
pub fn least(low: f64, high: f64, sections: usize, mut f: impl FnMut(f64) -> f64) -> (f64, f64) {
    let Ok(found) = try_least(low, high, sections, |x| Ok::<_, Infallible>(f(x)));
    found
}

/// Minimum, by golden sections, of a function that can fail; see [`least`].
pub fn try_least<E>(
    low: f64,
    high: f64,
    sections: usize,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    let (mut x, mut y) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut fx, mut fy) = (f(x)?, f(y)?);
    for _ in 0..sections {
        if fx <= fy {
            (b, y, fy) = (y, x, fx);
            x = b - ratio * (b - a);
            fx = f(x)?;
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + ratio * (b - a);
            fy = f(y)?;
        }
    }
    Ok(if fx <= fy { (x, fx) } else { (y, fy) })
}

/// Whether `x` is strictly between two ends, in either order.
fn is_between(x: f64, a: f64, b: f64) -> bool {
    x > a.min(b) && x < a.max(b)
}
