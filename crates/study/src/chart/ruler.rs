//! Deviations from a reference in extended precision, relative to the sizes of the quantities.

use assur_group::Body;
use assur_number::{Dd, Real, greater};

/// For each number of a body, the quantity to which it belongs: position, direction, PF1 and PF2 of the origin, PF1 and
/// PF2 of the angle.
const QUANTITY: [usize; 10] = [0, 0, 1, 1, 2, 2, 3, 4, 4, 5];

/// A quantity below this part of its natural size counts as zero.
const NOTHING: f64 = 1e-12;

/// Sizes of the quantities of all links over the work.
#[derive(Debug, Clone)]
pub(crate) struct Ruler {
    sizes: [f64; 6],
}

impl Ruler {
    /// From the reference: the largest value of each quantity, or its natural size (PF1 of a link, its square) where it is
    /// zero throughout, as PF2 of a parallelogram's rockers; lengths are measured by a length typical of the mechanism.
    pub(crate) fn new<'a>(positions: impl Iterator<Item = &'a [Body<Dd>]>, scale: f64) -> Self {
        let mut sizes: [f64; 6] = [scale, 1.0, 0.0, 0.0, 0.0, 0.0];
        for body in positions.flatten() {
            let all = body.numbers();
            for (value, quantity) in all.into_iter().zip(QUANTITY).skip(4) {
                sizes[quantity] = sizes[quantity].max(value.to_f64().abs());
            }
        }
        let [_, _, first, turn, _, _] = sizes;
        let natural = [scale, 1.0, scale * turn, 1.0, (first * turn).max(scale * turn * turn), turn * turn];
        for (size, natural) in sizes.iter_mut().zip(natural) {
            // A quantity that is zero everywhere has only the size of its rounding.
            if *size <= NOTHING * natural {
                *size = natural;
            }
            if *size == 0.0 {
                *size = 1.0;
            }
        }
        Self { sizes }
    }

    /// Largest relative deviation of one position; NaN if a number is NaN.
    pub(crate) fn deviation<T: Real>(&self, reference: &[Body<Dd>], found: &[Body<T>]) -> f64 {
        let mut worst = 0.0;
        for (right, found) in reference.iter().zip(found) {
            for ((a, b), quantity) in right.numbers().into_iter().zip(found.numbers()).zip(QUANTITY) {
                worst = greater(worst, difference(b, a).abs() / self.sizes[quantity]);
            }
        }
        worst
    }
}

/// A number less its reference, with all digits of both.
pub(crate) fn difference<T: Real>(found: T, reference: Dd) -> f64 {
    let high = found.to_f64();
    let low = (found - T::from_f64(high)).to_f64();
    (Dd::from_f64(high) - reference + Dd::from_f64(low)).to_f64()
}
