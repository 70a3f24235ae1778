//! Small dense matrices: a linear system, and the spectral radius of a nonnegative matrix.

use assur_number::{Real, elementary};

/// Number of squarings: the norm of a power 2^50 of a matrix is its spectral radius to that power but for a factor whose root
/// is 1 to rounding.
const SQUARINGS: i32 = 50;

/// Number of squarings after which a power may have converged.
const ENOUGH: i32 = 5;

/// Number of images of a vector by which the spectral radius is set off from 1 before it is calculated.
const IMAGES: usize = 16;

/// Whether the spectral radius of a nonnegative square matrix, given by its rows one after the other, is below 1: it lies between the
/// least and the greatest quotient of a positive vector and its image (Collatz and Wielandt). `None` where these don't tell.
pub(crate) fn is_contraction(matrix: &[f64], n: usize) -> Option<bool> {
    let [mut vector, mut next] = [vec![1.0; n], vec![1.0; n]];
    for _ in 0..IMAGES {
        let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
        for ((row, own), next) in matrix.chunks_exact(n.max(1)).zip(&vector).zip(&mut next) {
            let image: f64 = row.iter().zip(&vector).map(|(entry, x)| entry * x).sum();
            let quotient = image / own;
            if quotient.is_nan() {
                return None;
            }
            (least, greatest) = (least.min(quotient), greatest.max(quotient));
            // With a part of the vector before, none of the quotients oscillates.
            *next = own + image;
        }
        if greatest < 1.0 || least >= 1.0 {
            return Some(greatest < 1.0);
        }
        std::mem::swap(&mut vector, &mut next);
    }
    None
}

/// The spectral radius where a power of the matrix has converged: between the least and the greatest quotient of a positive
/// vector and its image (Collatz and Wielandt), where these agree.
fn by_vector(matrix: &[Vec<f64>], power: &[Vec<f64>]) -> Option<f64> {
    let vector: Vec<f64> = power.iter().map(|row| row.iter().sum()).collect();
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    for (row, own) in matrix.iter().zip(&vector) {
        let image: f64 = row.iter().zip(&vector).map(|(entry, x)| entry * x).sum();
        let quotient = image / own;
        if !quotient.is_finite() {
            return None;
        }
        (least, greatest) = (least.min(quotient), greatest.max(quotient));
    }
    (greatest - least <= 4.0 * f64::EPSILON * greatest).then(|| f64::midpoint(least, greatest))
}

/// The spectral radius of a nonnegative square matrix, given by rows: the limit of the roots of norms of its powers
/// (Gelfand), each power the square of the one before.
///
/// Needs neither irreducibility nor a single greatest eigenvalue. Infinite or NaN where an entry is.
pub fn spectral_radius(matrix: &[Vec<f64>]) -> f64 {
    f64::evaluate(
        #[inline(always)]
        || by_squaring(matrix),
    )
}

#[inline(always)]
fn by_squaring(matrix: &[Vec<f64>]) -> f64 {
    let n = matrix.len();
    let mut power = matrix.to_vec();
    // The logarithm of the factor that was taken out of the power, divided by the exponent of the power.
    let mut logarithm = 0.0;
    let mut share = 1.0;
    for squaring in 0..SQUARINGS {
        if squaring >= ENOUGH
            && let Some(radius) = by_vector(matrix, &power)
        {
            return radius;
        }
        let greatest =
            power.iter().flatten().fold(0.0_f64, |most, x| if x.is_nan() { f64::NAN } else { most.max(*x) });
        if !greatest.is_finite() {
            return greatest;
        }
        if greatest == 0.0 {
            return 0.0;
        }
        logarithm += share * elementary::ln(greatest);
        power.iter_mut().flatten().for_each(|x| *x /= greatest);
        let mut square = vec![vec![0.0; n]; n];
        for (sums, row) in square.iter_mut().zip(&power) {
            for (entry, others) in row.iter().zip(&power) {
                sums.iter_mut().zip(others).for_each(|(sum, other)| *sum += entry * other);
            }
        }
        power = square;
        share *= 0.5;
    }
    elementary::exp(logarithm)
}

/// Below this ratio of least to greatest pivot a matrix is singular: rounding alone gives as much.
pub(crate) const SINGULAR: f64 = 1e-14;

/// Solves `matrix x = right` in place by elimination with partial pivoting: the matrix is given by rows, one after the other, and so
/// are several right sides. `None` where it is singular.
#[inline(always)]
pub(crate) fn solve(matrix: &mut [f64], rights: &mut [f64], n: usize) -> Option<()> {
    if n == 0 {
        return Some(());
    }
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    for k in 0..n {
        let size = |row: usize| matrix[row * n + k].abs();
        let best = (k..n).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        let (above, below) = matrix.split_at_mut((k + 1) * n);
        let own = &mut above[k * n..];
        if best > k {
            own.swap_with_slice(&mut below[(best - k - 1) * n..(best - k) * n]);
        }
        rights.chunks_exact_mut(n).for_each(|right| right.swap(k, best));
        let pivot = own[k];
        least = least.min(pivot.abs());
        greatest = greatest.max(pivot.abs());
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        for (i, row) in below.chunks_exact_mut(n).enumerate() {
            let factor = row[k] / pivot;
            if factor == 0.0 {
                continue;
            }
            row[k..].iter_mut().zip(&own[k..]).for_each(|(entry, own)| *entry -= factor * own);
            for right in rights.chunks_exact_mut(n) {
                right[k + 1 + i] -= factor * right[k];
            }
        }
    }
    if least < SINGULAR * greatest {
        return None;
    }
    for right in rights.chunks_exact_mut(n) {
        for k in (0..n).rev() {
            let row = &matrix[k * n..(k + 1) * n];
            let known: f64 = row[k + 1..].iter().zip(&right[k + 1..]).map(|(entry, x)| entry * x).sum();
            right[k] = (right[k] - known) / row[k];
        }
    }
    Some(())
}
