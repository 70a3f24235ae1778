//! Search for a minimum that ends where there is no value.

/// The least value between `low` and `high` and where it is, by golden section; `None` as soon as there is no value.
pub(super) fn least_of(
    low: f64,
    high: f64,
    steps: usize,
    mut value: impl FnMut(f64) -> Option<f64>,
) -> Option<(f64, f64)> {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    let (mut x, mut y) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut fx, mut fy) = (value(x)?, value(y)?);
    for _ in 0..steps {
        if fx <= fy {
            (b, y, fy) = (y, x, fx);
            x = b - ratio * (b - a);
            fx = value(x)?;
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + ratio * (b - a);
            fy = value(y)?;
        }
    }
    Some(if fx <= fy { (x, fx) } else { (y, fy) })
}
