//! Three linear equations.

/// A matrix of three rows.
pub(crate) type Matrix = [[f64; 3]; 3];

/// The inverse, or none for a singular matrix. By cofactors: the matrix is small and Newton's method forgives roundings.
pub(crate) fn inverse(m: &Matrix) -> Option<Matrix> {
    let cofactor = |i: usize, j: usize| {
        let (r, s) = ((i + 1) % 3, (i + 2) % 3);
        let (u, v) = ((j + 1) % 3, (j + 2) % 3);
        m[r][u] * m[s][v] - m[r][v] * m[s][u]
    };
    let determinant = (0..3).map(|j| m[0][j] * cofactor(0, j)).sum::<f64>();
    if determinant == 0.0 || !determinant.is_finite() {
        return None;
    }
    let row = |i: usize| std::array::from_fn(|j| cofactor(j, i) / determinant);
    Some([row(0), row(1), row(2)])
}

/// Matrix times vector.
pub(crate) fn times(m: &Matrix, v: &[f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Matrix times matrix.
pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| std::array::from_fn(|j| row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j]))
}
