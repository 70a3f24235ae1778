//! Forces that depend linearly on unknowns.

use nalgebra::{DMatrix, DVector};

/// Part of the greatest singular value below which counterweights on several links replace each other; the smallest of
/// them are then taken.
const DEPENDENT: f64 = 1e-10;

/// A force as a linear function of the unknowns: `force + columns u`, columns two by two as x and y.
pub(crate) struct Row {
    pub(crate) force: [f64; 2],
    /// What each unknown adds, along x and along y.
    pub(crate) columns: Vec<[f64; 2]>,
}

impl Row {
    pub(crate) fn at(&self, unknowns: &DVector<f64>) -> [f64; 2] {
        let each = self.columns.iter().zip(unknowns.iter());
        each.fold(self.force, |sum, (column, u)| [sum[0] + column[0] * u, sum[1] + column[1] * u])
    }
}

/// The least solution of a linear system, in the sense of least squares where it has none.
pub(crate) fn solve(matrix: DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let unknowns = matrix.ncols();
    let decomposed = matrix.svd(true, true);
    let least = DEPENDENT * decomposed.singular_values.max();
    decomposed.solve(right, least).unwrap_or_else(|_| DVector::zeros(unknowns))
}
