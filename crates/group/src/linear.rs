//! A small dense linear system on the stack.

use assur_number::Real;

/// LU factors of an N x N matrix with partial pivoting, in any number type.
#[derive(Debug, Clone)]
pub(crate) struct Lu<T, const N: usize> {
    factors: [[T; N]; N],
    order: [usize; N],
    /// Smallest pivot / greatest pivot, absolute values: 0 for a singular matrix.
    pub(crate) health: f64,
    /// Whether the determinant is positive (of the first lane).
    pub(crate) is_positive: bool,
}

impl<T: Real, const N: usize> Lu<T, N> {
    pub(crate) fn new(mut matrix: [[T; N]; N]) -> Self {
        let mut order = [0; N];
        for (i, place) in order.iter_mut().enumerate() {
            *place = i;
        }
        let mut is_positive = true;
        let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
        for k in 0..N {
            // All lanes share one order of pivots: the row whose smallest lane is the greatest.
            let strength = |row: &[T; N]| row[k].abs().least();
            let mut best = k;
            for i in k + 1..N {
                if strength(&matrix[i]) > strength(&matrix[best]) {
                    best = i;
                }
            }
            matrix.swap(k, best);
            order.swap(k, best);
            let pivot = matrix[k][k];
            is_positive ^= (best != k) != (pivot.to_f64() < 0.0);
            least = least.min(pivot.abs().least());
            greatest = greatest.max(pivot.abs().greatest());
            for i in k + 1..N {
                let factor = matrix[i][k] / pivot;
                matrix[i][k] = factor;
                let above = matrix[k];
                for (entry, above) in matrix[i].iter_mut().zip(above).skip(k + 1) {
                    *entry -= factor * above;
                }
            }
        }
        let health = if greatest > 0.0 && greatest.is_finite() { least / greatest } else { 0.0 };
        Self { factors: matrix, order, health, is_positive }
    }

    pub(crate) fn solve(&self, right: &[T; N]) -> [T; N] {
        let mut x = [T::ZERO; N];
        for i in 0..N {
            let mut sum = right[self.order[i]];
            for (j, &known) in x.iter().enumerate().take(i) {
                sum -= self.factors[i][j] * known;
            }
            x[i] = sum;
        }
        for i in (0..N).rev() {
            let mut sum = x[i];
            for (&factor, &known) in self.factors[i].iter().zip(&x).skip(i + 1) {
                sum -= factor * known;
            }
            x[i] = sum / self.factors[i][i];
        }
        x
    }
}
