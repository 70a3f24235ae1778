//! The linear system of a group: dense on the stack for up to 8 links, sparse beyond.

use assur_number::Real;

use crate::general::entries;
use crate::linear::Lu;
use crate::sparse::SparseLu;
use crate::{Body, GroupFrame};

/// The factored matrix J of a group, or its transpose.
pub(crate) trait Solver<T: Real>: Sized {
    /// A vector of unknowns or right-hand sides.
    type Vector: AsRef<[T]> + AsMut<[T]>;

    /// Factors J of a placed group.
    fn factor(frame: &GroupFrame, bodies: &[Body<T>], is_transposed: bool) -> Self;

    /// A vector of zeros.
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
        self.solve(right)
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
