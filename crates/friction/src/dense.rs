//! A small dense linear system.

/// Below this ratio of least to greatest pivot a matrix is singular: rounding alone gives as much.
pub(crate) const SINGULAR: f64 = 1e-14;

/// Solves `matrix x = right` for several right sides (each a row of `rights`) by elimination with partial pivoting; the
/// matrix is given by rows. `None` where it is singular.
pub(crate) fn solve(mut matrix: Vec<Vec<f64>>, mut rights: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    for k in 0..n {
        let best = (k..n).max_by(|&a, &b| matrix[a][k].abs().total_cmp(&matrix[b][k].abs()))?;
        matrix.swap(k, best);
        for right in &mut rights {
            right.swap(k, best);
        }
        let pivot = matrix[k][k];
        least = least.min(pivot.abs());
        greatest = greatest.max(pivot.abs());
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        let (above, below) = matrix.split_at_mut(k + 1);
        let own = &above[k];
        for (i, row) in below.iter_mut().enumerate() {
            let factor = row[k] / pivot;
            if factor == 0.0 {
                continue;
            }
            row.iter_mut().zip(own).skip(k).for_each(|(entry, own)| *entry -= factor * own);
            for right in &mut rights {
                right[k + 1 + i] -= factor * right[k];
            }
        }
    }
    if least < SINGULAR * greatest {
        return None;
    }
    for right in &mut rights {
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| matrix[k][j] * right[j]).sum();
            right[k] = (right[k] - known) / matrix[k][k];
        }
    }
    Some(rights)
}
