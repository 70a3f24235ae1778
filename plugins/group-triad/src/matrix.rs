//! Systems of three equations.

use assur_number::Real;

/// A matrix of three rows.
pub(crate) type Matrix<T> = [[T; 3]; 3];

/// The adjugate of a matrix and its reciprocal determinant: they solve for the matrix and for its transpose.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Inverse<T> {
    adjugate: Matrix<T>,
    reciprocal: T,
}

impl<T: Real> Inverse<T> {
    #[inline(always)]
    pub(crate) fn of(m: &Matrix<T>) -> Self {
        let minor = |i: usize, k: usize| {
            let ([i1, i2], [k1, k2]) = ([(i + 1) % 3, (i + 2) % 3], [(k + 1) % 3, (k + 2) % 3]);
            m[i1][k1] * m[i2][k2] - m[i1][k2] * m[i2][k1]
        };
        let adjugate = [
            [minor(0, 0), minor(1, 0), minor(2, 0)],
            [minor(0, 1), minor(1, 1), minor(2, 1)],
            [minor(0, 2), minor(1, 2), minor(2, 2)],
        ];
        let determinant = m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
        Self { adjugate, reciprocal: T::ONE / determinant }
    }

    #[inline(always)]
    pub(crate) fn determinant(m: &Matrix<T>) -> T {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
            + m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    }

    /// The solution x of M x = right.
    #[inline(always)]
    pub(crate) fn solve(&self, right: [T; 3]) -> [T; 3] {
        let a = &self.adjugate;
        [0, 1, 2].map(|i| (a[i][0] * right[0] + a[i][1] * right[1] + a[i][2] * right[2]) * self.reciprocal)
    }

    /// The solution x of Mᵀ x = right.
    #[inline(always)]
    pub(crate) fn solve_transposed(&self, right: [T; 3]) -> [T; 3] {
        let a = &self.adjugate;
        [0, 1, 2].map(|i| (a[0][i] * right[0] + a[1][i] * right[1] + a[2][i] * right[2]) * self.reciprocal)
    }
}
