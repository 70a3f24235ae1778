//! A dense linear system: elimination with partial pivoting, in any number type.

use super::Pivots;
use crate::Real;

/// What a matrix is known by once it is factored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factored {
    /// Smallest pivot / greatest pivot, absolute values: 0 for a singular matrix.
    pub health: f64,
    /// Whether the determinant is positive (of the first lane).
    pub is_positive: bool,
}

/// Replaces a square matrix, given by its rows one after the other, by its LU factors; `order` becomes the order of the rows.
#[inline(always)]
pub fn factor<T: Real>(matrix: &mut [T], order: &mut [usize]) -> Factored {
    let n = order.len();
    order.iter_mut().enumerate().for_each(|(i, place)| *place = i);
    let mut is_positive = true;
    let mut pivots = Pivots::NONE;
    for k in 0..n {
        // All lanes share one order of pivots: the row whose smallest lane is the greatest.
        let size = |row: usize| matrix[row * n + k].abs().least();
        let best = (k + 1..n).fold(k, |best, row| if size(row) > size(best) { row } else { best });
        order.swap(k, best);
        let (above, below) = matrix.split_at_mut((k + 1) * n);
        let own = &mut above[k * n..];
        if best > k {
            own.swap_with_slice(&mut below[(best - k - 1) * n..(best - k) * n]);
        }
        let (pivot, own) = (own[k], &own[k + 1..]);
        is_positive ^= (best != k) != (pivot.to_f64() < 0.0);
        pivots.add(pivot);
        // Most entries are zero.
        for row in below.chunks_exact_mut(n).filter(|row| row[k].abs().greatest() != 0.0) {
            let factor = row[k] / pivot;
            row[k] = factor;
            row[k + 1..].iter_mut().zip(own).for_each(|(entry, own)| *entry -= factor * *own);
        }
    }
    Factored { health: pivots.ratio(), is_positive }
}

/// Solves for a right-hand side with the factors of [`factor`].
#[inline(always)]
pub fn substitute<T: Real>(factors: &[T], order: &[usize], right: &[T], x: &mut [T]) {
    let n = order.len();
    for i in 0..n {
        let known = factors[i * n..i * n + i].iter().zip(&*x);
        x[i] = known.fold(right[order[i]], |sum, (factor, x)| sum - *factor * *x);
    }
    for i in (0..n).rev() {
        let row = &factors[i * n..(i + 1) * n];
        let known = row[i + 1..].iter().zip(&x[i + 1..]);
        x[i] = known.fold(x[i], |sum, (factor, x)| sum - *factor * *x) / row[i];
    }
}

/// LU factors of an N x N matrix on the stack.
#[derive(Debug, Clone)]
pub struct Lu<T, const N: usize> {
    factors: [[T; N]; N],
    order: [usize; N],
    /// What the matrix is known by.
    pub factored: Factored,
}

impl<T: Real, const N: usize> Lu<T, N> {
    /// Factors a matrix given by its rows.
    pub fn new(mut factors: [[T; N]; N]) -> Self {
        let mut order = [0; N];
        let factored = factor(factors.as_flattened_mut(), &mut order);
        Self { factors, order, factored }
    }

    /// The solution for a right-hand side; not finite for a singular matrix.
    pub fn solve(&self, right: &[T; N]) -> [T; N] {
        let mut x = [T::ZERO; N];
        substitute(self.factors.as_flattened(), &self.order, right, &mut x);
        x
    }
}
