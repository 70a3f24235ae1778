//! The linear system of a group: dense on the stack for up to 8 links, sparse beyond.

use assur_number::Real;

use crate::general::entries;
use crate::sparse::SparseLu;
use crate::{Body, GroupFrame};

/// The factored matrix J of a group, or its transpose.
pub(crate) trait Solver<T: Real>: Sized {
    /// A vector of unknowns or right-hand sides.
    type Vector: AsRef<[T]> + AsMut<[T]>;

    /// Factors J of a placed group.
    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self;

    fn zeros(frame: &GroupFrame) -> Self::Vector;

    /// The solution for a right-hand side.
    fn solve(&self, right: &Self::Vector) -> Self::Vector;

    /// Smallest over greatest pivot.
    fn health(&self) -> f64;

    /// Whether the determinant is positive.
    fn is_positive(&self) -> bool;
}

impl<T: Real, const N: usize> Solver<T> for Lu<T, N> {
    type Vector = [T; N];

    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self {
        let mut matrix = [[T::ZERO; N]; N];
        for (i, line) in matrix.iter_mut().enumerate().skip(3 * frame.links.len()) {
            line[i] = T::ONE;
        }
        entries(frame, bodies, |row, column, entry| {
            let (row, column) = if is_transposed { (column, row) } else { (row, column) };
            matrix[row][column] = entry;
        });
        Self::new(matrix)
    }

    fn zeros(_: &GroupFrame) -> [T; N] {
        [T::ZERO; N]
    }

    fn solve(&self, right: &[T; N]) -> [T; N] {
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
            for (&factor, &known) in self.factors[i][i + 1..].iter().zip(&x[i + 1..]) {
                sum -= factor * known;
            }
            x[i] = sum / self.factors[i][i];
        }
        x
    }

    fn health(&self) -> f64 {
        self.health
    }

    fn is_positive(&self) -> bool {
        self.is_positive
    }
}

impl<T: Real> Solver<T> for SparseLu<T> {
    type Vector = Vec<T>;

    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self {
        let mut rows = vec![Vec::new(); 3 * frame.links.len()];
        entries(frame, bodies, |row, column, entry| {
            let (row, column) = if is_transposed { (column, row) } else { (row, column) };
            rows[row].push((column, entry));
        });
        Self::new(rows)
    }

    fn zeros(frame: &GroupFrame) -> Vec<T> {
        vec![T::ZERO; 3 * frame.links.len()]
    }

    fn solve(&self, right: &Vec<T>) -> Vec<T> {
        self.solve(right)
    }

    fn health(&self) -> f64 {
        self.health
    }

    fn is_positive(&self) -> bool {
        self.is_positive
    }
}

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
            let (above, below) = matrix.split_at_mut(k + 1);
            let above = &above[k][k + 1..];
            for row in below {
                // Most entries are zero.
                if row[k].abs().greatest() == 0.0 {
                    continue;
                }
                let factor = row[k] / pivot;
                row[k] = factor;
                row[k + 1..].iter_mut().zip(above).for_each(|(entry, above)| *entry -= factor * *above);
            }
        }
        let health = if greatest > 0.0 && greatest.is_finite() { least / greatest } else { 0.0 };
        Self { factors: matrix, order, health, is_positive }
    }
}
