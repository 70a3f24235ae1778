//! The solution of least norm of fewer equations than unknowns.
//!
//! The unknowns are forces in N: moments are divided by the size of the mechanism. Of A x = b, with Aᵀ = Q R, the solution of least
//! norm is Q R⁻ᵀ b; what lies outside of the columns of Q is open.

use nalgebra::{DMatrix, DVector};

use crate::elimination::Row;

/// An unknown (or a sum of some) is open if more than this part of it, squared, lies outside of what the equations say: rounding
/// leaves some 1e-15.
const OPEN: f64 = 1e-12;

/// The solution of least norm.
#[derive(Debug)]
pub(crate) struct LeastNorm {
    pub(crate) solution: Vec<f64>,
    /// Ratio of least to greatest pivot.
    pub(crate) health: f64,
    /// Orthonormal directions that the equations determine, in columns.
    determined: DMatrix<f64>,
}

/// Solves equations in this number of unknowns; the right side of each stands after the last unknown.
pub(crate) fn solve(rows: &[Row], unknowns: usize) -> LeastNorm {
    let (mut transposed, mut right) = (DMatrix::zeros(unknowns, rows.len()), DVector::zeros(rows.len()));
    for (row, entries) in rows.iter().enumerate() {
        for &(unknown, factor) in entries {
            if unknown == unknowns {
                right[row] += factor;
            } else {
                transposed[(unknown, row)] += factor;
            }
        }
    }
    let decomposed = transposed.clone().qr();
    let (q, r) = (decomposed.q(), decomposed.r());
    let pivots = r.diagonal().abs();
    let health = pivots.min() / pivots.max();
    let by = |right: &DVector<f64>| r.tr_solve_upper_triangular(right).map(|parts| &q * parts);
    let mut x = by(&right).unwrap_or_else(|| DVector::from_element(unknowns, f64::NAN));
    // What rounding left is solved once more.
    let rest = &right - transposed.tr_mul(&x);
    if let Some(more) = by(&rest) {
        x += more;
    }
    LeastNorm { solution: x.iter().copied().collect(), health, determined: q }
}

impl LeastNorm {
    /// Whether the sum of some unknowns is open.
    pub(crate) fn is_open(&self, unknowns: &[usize]) -> bool {
        let parts = self.determined.column_iter().map(|column| {
            let sum: f64 = unknowns.iter().map(|unknown| column[*unknown]).sum();
            sum * sum
        });
        let all = unknowns.len() as f64;
        all - parts.sum::<f64>() > OPEN * all
    }
}
