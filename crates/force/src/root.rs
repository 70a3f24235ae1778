//! A bracketed root of a function whose derivative is known.

/// Newton's method never needs as many; bisection alone from any bracket needs about these.
const MOST_STEPS: usize = 120;

/// The root of `f` (value, derivative) between `a` and `b`, where `f` has opposite signs: Newton's method, kept in the
/// bracket by bisection, to rounding.
///
/// # Errors
///
/// Those of `f`.
pub(crate) fn root<E>(
    mut f: impl FnMut(f64) -> Result<(f64, f64), E>,
    mut a: f64,
    mut b: f64,
) -> Result<f64, E> {
    let rising = f(b)?.0 > 0.0;
    let mut x = f64::midpoint(a, b);
    for _ in 0..MOST_STEPS {
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
        let next = if newton > a.min(b) && newton < a.max(b) { newton } else { f64::midpoint(a, b) };
        if (next - x).abs() <= f64::EPSILON * x.abs().max((b - a).abs()) {
            return Ok(next);
        }
        x = next;
    }
    Ok(x)
}
