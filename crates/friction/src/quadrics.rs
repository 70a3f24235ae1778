//! Common points of one, two or three quadrics `z_j² = |c_j + sum of V_jk z_k|²` with z >= 0.
//!
//! Two and three: the null space of the Macaulay matrix of their degree of regularity has one dimension for each common point
//! (2, 4, 8 by Bézout), and multiplication by a linear form acts on it as a matrix whose eigenvalues are the values of the form
//! there (Stetter 2004, section 2). Coordinates are turned first, so that no point is at infinity.

use assur_number::elementary;
use assur_number::elimination::{factor, substitute};
use nalgebra::{DMatrix, DVector};

#[derive(Debug, Clone)]
pub(crate) struct Quadric {
    pub(crate) constant: [f64; 2],
    pub(crate) slopes: Vec<[f64; 2]>,
}

/// A polynomial: its coefficients by exponents.
type Polynomial = Vec<(Vec<u8>, f64)>;

/// A singular value that is this small, as part of the greatest, is zero.
const RANK: f64 = 1e-11;

/// An imaginary part that is this small, as part of the greatest eigenvalue, may be that of two roots that nearly coincide.
const IMAGINARY: f64 = 1e-4;

/// Points near all real roots without negative magnitudes (some may be near none), and whether no root can be missing.
pub(crate) fn roots(quadrics: &[Quadric]) -> (Vec<Vec<f64>>, bool) {
    match quadrics {
        [] => (vec![Vec::new()], true),
        [one] => (quadratic(one), true),
        _ => several(quadrics),
    }
}

/// The roots of one equation: (1 - |v|²) z² - 2 c v z - |c|² = 0.
fn quadratic(quadric: &Quadric) -> Vec<Vec<f64>> {
    let (c, v) = (quadric.constant, quadric.slopes[0]);
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let speed = dot(v, v).sqrt();
    let (square, half, constant) = ((1.0 - speed) * (1.0 + speed), dot(c, v), dot(c, c));
    // half² + square constant, without the difference of large numbers.
    let turn = c[0] * v[1] - c[1] * v[0];
    let discriminant = constant - turn * turn;
    if constant == 0.0 {
        return vec![vec![0.0]];
    }
    if discriminant < 0.0 {
        // Rounding may hide two roots that coincide.
        let near = if -discriminant <= 1e-14 * constant { -constant / half } else { -1.0 };
        return if near >= 0.0 { vec![vec![near]] } else { Vec::new() };
    }
    let root = discriminant.sqrt();
    let sum = half + if half < 0.0 { -root } else { root };
    let both = [sum / square, -constant / sum];
    both.into_iter().filter(|z| z.is_finite() && *z >= 0.0).map(|z| vec![z]).collect()
}

/// Exponents of all monomials of up to this degree, by degree.
fn monomials(variables: usize, degree: u8) -> Vec<Vec<u8>> {
    let mut all = vec![vec![0; variables]];
    let mut last = all.clone();
    for _ in 0..degree {
        let mut next: Vec<Vec<u8>> = Vec::new();
        for exponents in &last {
            for i in 0..variables {
                let mut raised = exponents.clone();
                raised[i] += 1;
                if !next.contains(&raised) {
                    next.push(raised);
                }
            }
        }
        all.extend(next.iter().cloned());
        last = next;
    }
    all
}

/// An orthogonal matrix whose entries have nothing to do with any mechanism: a product of plane rotations.
fn turned(n: usize) -> DMatrix<f64> {
    let mut matrix: DMatrix<f64> = DMatrix::identity(n, n);
    let mut angle = 0.7_f64;
    for i in 0..n {
        for j in 0..i {
            angle = (angle * 1.618_033_988_749_895 + 0.377).rem_euclid(std::f64::consts::TAU);
            let (s, c) = elementary::sin_cos(angle);
            let mut rotation: DMatrix<f64> = DMatrix::identity(n, n);
            (rotation[(i, i)], rotation[(j, j)], rotation[(i, j)], rotation[(j, i)]) = (c, c, s, -s);
            matrix *= rotation;
        }
    }
    matrix
}

/// A quadric in turned coordinates y (`x = O y`, `x_0` belongs to the constant, `y_0 = 1`), scaled to size 1.
fn polynomial(quadric: &Quadric, own: usize, scale: f64, turn: &DMatrix<f64>) -> Polynomial {
    let n = quadric.slopes.len() + 1;
    let row = |component: usize| {
        let of = |k: usize| {
            if k == 0 { quadric.constant[component] / scale } else { quadric.slopes[k - 1][component] }
        };
        DVector::from_fn(n, |k, _| of(k))
    };
    let (x, y) = (row(0), row(1));
    let unit = DVector::from_fn(n, |k, _| f64::from(u8::from(k == own + 1)));
    let form = &unit * unit.transpose() - &x * x.transpose() - &y * y.transpose();
    let form = turn.transpose() * form * turn;
    let size = form.amax();
    let mut terms = Vec::new();
    for i in 0..n {
        for j in 0..=i {
            let mut exponents = vec![0_u8; n - 1];
            for index in [i, j].into_iter().filter(|index| *index > 0) {
                exponents[index - 1] += 1;
            }
            let twice = if i == j { 1.0 } else { 2.0 };
            terms.push((exponents, twice * form[(i, j)] / size));
        }
    }
    terms
}

/// Two or three equations.
fn several(quadrics: &[Quadric]) -> (Vec<Vec<f64>>, bool) {
    let q = quadrics.len();
    let scale =
        quadrics.iter().map(|one| elementary::hypot(one.constant[0], one.constant[1])).fold(0.0, f64::max);
    if scale == 0.0 {
        return (vec![vec![0.0; q]], true);
    }
    let turn = turned(q + 1);
    let polynomials: Vec<Polynomial> =
        quadrics.iter().enumerate().map(|(own, one)| polynomial(one, own, scale, &turn)).collect();
    let degree = u8::try_from(q + 1).unwrap_or(u8::MAX);
    let monomials_of = monomials(q, degree);
    let Some((null, complete)) = null_space(&polynomials, &monomials_of, degree, 1 << q) else {
        return (Vec::new(), false);
    };
    let Some((points, simple)) = common_points(&null, &monomials_of, degree) else {
        return (Vec::new(), false);
    };
    let mut roots = Vec::new();
    for point in points {
        // Back from turned homogeneous coordinates.
        let x = &turn * &point;
        if x[0].abs() <= 1e-12 * x.amax() {
            continue;
        }
        let z: Vec<f64> = (1..=q).map(|k| scale * x[k] / x[0]).collect();
        let size = z.iter().fold(0.0_f64, |most, z| most.max(z.abs()));
        if z.iter().all(|z| *z >= -1e-3 * size) {
            roots.push(z.into_iter().map(|z| z.max(0.0)).collect());
        }
    }
    (roots, complete && simple)
}

/// The null space of the Macaulay matrix, of this many dimensions, and whether it has no more.
fn null_space(
    polynomials: &[Polynomial],
    all: &[Vec<u8>],
    degree: u8,
    dimensions: usize,
) -> Option<(DMatrix<f64>, bool)> {
    let n = all.len();
    let at = |exponents: &[u8]| all.iter().position(|known| known == exponents);
    let factors: Vec<&Vec<u8>> = all.iter().filter(|one| one.iter().sum::<u8>() + 2 <= degree).collect();
    let rows = polynomials.len() * factors.len();
    // Rows of zeros make it as high as wide, so that the decomposition gives the null space too.
    let mut matrix: DMatrix<f64> = DMatrix::zeros(rows.max(n), n);
    for (i, polynomial) in polynomials.iter().enumerate() {
        for (j, factor) in factors.iter().enumerate() {
            for (exponents, value) in polynomial {
                let product: Vec<u8> = exponents.iter().zip(*factor).map(|(a, b)| a + b).collect();
                matrix[(i * factors.len() + j, at(&product)?)] += value;
            }
        }
    }
    let svd = nalgebra::SVD::new(matrix, false, true);
    let directions = svd.v_t?;
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| svd.singular_values[*a].total_cmp(&svd.singular_values[*b]));
    let greatest = svd.singular_values.max();
    let next = svd.singular_values[*order.get(dimensions)?];
    let null = DMatrix::from_fn(n, dimensions, |i, k| directions[(order[k], i)]);
    Some((null, next > RANK * greatest))
}

/// The common points, as turned homogeneous coordinates, from the null space; and whether the basis was well conditioned.
fn common_points(null: &DMatrix<f64>, all: &[Vec<u8>], degree: u8) -> Option<(Vec<DVector<f64>>, bool)> {
    let (d, variables) = (null.ncols(), all[0].len());
    let lower: Vec<usize> = (0..all.len()).filter(|i| all[*i].iter().sum::<u8>() < degree).collect();
    let basis = independent_rows(null, &lower, d)?;
    let chosen = DMatrix::from_fn(d, d, |i, k| null[(basis[i], k)]);
    let condition = chosen.clone().svd(false, false).singular_values;
    let simple = condition.min() > 1e-9 * condition.max();
    let inverse = chosen.try_inverse()?;
    // All monomials as combinations of those of the basis.
    let expand = null * &inverse;
    let weight = |i: usize| [0.577, -0.811, 0.352][i % 3];
    let mut product: DMatrix<f64> = DMatrix::zeros(d, d);
    for (row, &at) in basis.iter().enumerate() {
        for variable in 0..variables {
            let mut raised = all[at].clone();
            raised[variable] += 1;
            let raised = all.iter().position(|known| *known == raised)?;
            for k in 0..d {
                product[(row, k)] += weight(variable) * expand[(raised, k)];
            }
        }
    }
    let eigenvalues = product.complex_eigenvalues();
    let greatest =
        eigenvalues.iter().fold(0.0_f64, |most, value| most.max(elementary::hypot(value.re, value.im)));
    let mut points = Vec::new();
    for value in eigenvalues.iter().filter(|value| value.im.abs() <= IMAGINARY * greatest) {
        for vector in near_eigenvectors(&product, value.re, greatest) {
            let monomials = &expand * vector;
            points.push(DVector::from_fn(variables + 1, |i, _| monomials[i]));
        }
    }
    Some((points, simple))
}

/// Rows of a matrix that are as independent as pivoting finds them.
fn independent_rows(matrix: &DMatrix<f64>, among: &[usize], count: usize) -> Option<Vec<usize>> {
    let mut rows: Vec<(usize, DVector<f64>)> =
        among.iter().map(|&i| (i, matrix.row(i).transpose())).collect();
    let mut chosen = Vec::with_capacity(count);
    for _ in 0..count {
        let best = (0..rows.len()).max_by(|&a, &b| rows[a].1.norm().total_cmp(&rows[b].1.norm()))?;
        let (index, vector) = rows.swap_remove(best);
        let size = vector.norm();
        if size == 0.0 {
            return None;
        }
        let unit = vector / size;
        for (_, other) in &mut rows {
            let along = unit.dot(other);
            *other -= along * &unit;
        }
        chosen.push(index);
    }
    Some(chosen)
}

/// Eigenvectors near an eigenvalue by inverse iteration, from two different starts, since two eigenvalues may nearly coincide.
fn near_eigenvectors(matrix: &DMatrix<f64>, value: f64, greatest: f64) -> Vec<DVector<f64>> {
    let n = matrix.nrows();
    let shifted = matrix - DMatrix::identity(n, n) * (value + 1e-11 * greatest);
    // Stored by columns.
    let (mut factors, mut order) = (shifted.transpose(), vec![0; n]);
    factor(factors.as_mut_slice(), &mut order);
    let starts = [[0.9, 0.31], [-0.53, 0.77]];
    let of = |[a, b]: [f64; 2]| {
        let mut vector = DVector::from_fn(n, |i, _| a + b * elementary::sin(1.3 * i as f64 + a));
        for _ in 0..4 {
            let right = vector.clone();
            substitute(factors.as_slice(), &order, right.as_slice(), vector.as_mut_slice());
            let size = vector.norm();
            if !(size.is_finite() && size > 0.0) {
                return None;
            }
            vector /= size;
        }
        Some(vector)
    };
    starts.into_iter().filter_map(of).collect()
}
