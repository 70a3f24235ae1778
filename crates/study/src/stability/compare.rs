//! Deviations between a computation and its reference in 32 digits.

use assur_group::{Body, Wrench};
use assur_number::{Dd, Real, greater};

/// The three orders of transfer functions, as rows name them.
pub(crate) const ORDERS: [&str; 3] = ["pf0", "pf1", "pf2"];

/// The numbers of a body that belong to an order, lengths in units of `scale`, angles and directions unchanged.
fn of_order<T: Real>(body: &Body<T>, order: usize, scale: f64) -> [T; 4] {
    let unit = T::from_f64(1.0 / scale);
    let [x, y, c, s, x1, y1, w1, x2, y2, w2] = body.numbers();
    match order {
        0 => [x * unit, y * unit, c, s],
        1 => [x1 * unit, y1 * unit, w1, T::ZERO],
        _ => [x2 * unit, y2 * unit, w2, T::ZERO],
    }
}

/// Largest deviation of some links, relative to the largest size of the order, but at least to `floor`: where a
/// derivative passes through zero its digits are lost, which is no error.
pub(crate) fn transfer(
    found: &[Body<f64>],
    reference: &[Body<Dd>],
    links: &[usize],
    order: usize,
    scale: f64,
    floor: f64,
) -> f64 {
    let (mut deviation, mut size) = (0.0, floor);
    for &link in links {
        let exact = of_order(&reference[link], order, scale);
        let mine = of_order(&found[link].map(Dd::from_f64), order, scale);
        for (exact, mine) in exact.into_iter().zip(mine) {
            size = f64::max(size, exact.to_f64().abs());
            deviation = greater(deviation, (mine - exact).to_f64().abs());
        }
    }
    deviation / size
}

/// Largest number of an order of some links, at least `floor`.
pub(crate) fn size(reference: &[Body<Dd>], links: &[usize], order: usize, scale: f64, floor: f64) -> f64 {
    let numbers = links.iter().flat_map(|&link| of_order(&reference[link], order, scale));
    numbers.fold(floor, |size, number| size.max(number.to_f64().abs()))
}

/// Largest deviation of reactions relative to the largest of them, moments in units of force times `scale`.
pub(crate) fn reactions(found: &[Wrench<f64>], reference: &[Wrench<Dd>], scale: f64) -> f64 {
    let (mut deviation, mut size) = (0.0, f64::MIN_POSITIVE);
    for (found, exact) in found.iter().zip(reference) {
        let pairs = [(found.fx, exact.fx, 1.0), (found.fy, exact.fy, 1.0), (found.m, exact.m, scale)];
        for (found, exact, unit) in pairs {
            size = f64::max(size, exact.to_f64().abs() / unit);
            deviation = greater(deviation, (Dd::from_f64(found) - exact).to_f64().abs() / unit);
        }
    }
    deviation / size
}
