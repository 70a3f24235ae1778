//! The one solution that a certificate proves, in small fixed memory and for any number: eight positions at once too.
//!
//! Forces of friction that have the same place and direction, as on both ends of a slide, have one unknown: the sum of their
//! magnitudes.

use assur_number::Real;

/// Most steps of Newton's method.
const STEPS: usize = 24;

/// Newton's method stops when the last relative step is below the first of these and the next one, extrapolated from the last two,
/// is below the second, which is rounding.
const SMALL: f64 = 1e-9;
const NOTHING: f64 = 1e-16;

/// Relative change below which a spectral radius has converged.
const STILL: f64 = 8.0 * f64::EPSILON;

/// Relative change that is rounding.
const ROUNDING: f64 = 0.25 * f64::EPSILON;

/// Number of products of the matrix with a vector of ones, for a bound of its spectral radius.
const POWERS: usize = 3;

/// Images of a vector by which a matrix may be seen to be a contraction.
const IMAGES: usize = 4;

/// Least slope of the characteristic polynomial at its greatest root, by the square of the root: below it others are too near.
pub(crate) const SLOPE: f64 = 1e-3;

/// Most squarings of the matrix for its spectral radius.
const SQUARINGS: usize = 14;

/// A row of a power of the matrix counts as this at least: one of zeros is no reason for a quotient of zeros.
const FLOOR: f64 = 1e-200;

/// An unknown: the magnitude of a vector, or of two numbers the sum of their magnitudes; each is affine in all unknowns.
#[derive(Debug, Clone, Copy)]
pub struct Sum<T, const N: usize> {
    /// Whether the components are those of one vector; else they are two numbers.
    pub is_vector: bool,
    /// The components without friction.
    pub constant: [T; 2],
    /// What each unknown of size 1 adds.
    pub slopes: [[T; 2]; N],
}

/// Equations for sums of magnitudes.
#[derive(Debug, Clone, Copy)]
pub struct Unique<T, const N: usize>(pub [Sum<T, N>; N]);

type Matrix<T, const N: usize> = [[T; N]; N];

impl<T: Real, const N: usize> Sum<T, N> {
    /// An unknown that is zero.
    pub const NONE: Self = Self { is_vector: false, constant: [T::ZERO; 2], slopes: [[T::ZERO; 2]; N] };

    #[inline(always)]
    fn size(&self, [x, y]: [T; 2]) -> T {
        if self.is_vector { (x * x + y * y).sqrt() } else { x.abs() + y.abs() }
    }
}

impl<T: Real, const N: usize> Unique<T, N> {
    /// The unknowns where there is certainly one solution, and the certificate, which may be left out where it is not asked for;
    /// `None` where a lane needs a more careful method.
    ///
    /// To be called within [`Real::evaluate`].
    #[inline(always)]
    pub fn solve(&self, is_certificate_wanted: bool) -> Option<(Option<T>, [T; N])> {
        let lengths = self.lengths();
        let certificate = if is_certificate_wanted || !is_contraction(&lengths) {
            let radius = certificate(&lengths)?;
            (T::ONE - radius).exceeds(0.0).then_some(Some(radius))?
        } else {
            None
        };
        self.solution().map(|z| (certificate, z))
    }

    /// The sums of lengths: where their spectral radius, the certificate, is below 1 there is exactly one solution.
    #[inline(always)]
    fn lengths(&self) -> Matrix<T, N> {
        let mut lengths = [[T::ZERO; N]; N];
        for (row, sum) in lengths.iter_mut().zip(&self.0) {
            for (length, slope) in row.iter_mut().zip(&sum.slopes) {
                *length = sum.size(*slope);
            }
        }
        lengths
    }

    /// The solution, where the certificate is below 1.
    #[inline(always)]
    fn solution(&self) -> Option<[T; N]> {
        // Forces of any size are divided by their sum first, so that no square of them leaves the range of numbers.
        let mut scale = T::from_f64(f64::MIN_POSITIVE);
        for sum in &self.0 {
            scale += sum.constant[0].abs() + sum.constant[1].abs();
        }
        let inverse = T::ONE / scale;
        let (mut constants, mut z) = ([[T::ZERO; 2]; N], [T::ZERO; N]);
        for (i, sum) in self.0.iter().enumerate() {
            constants[i] = [sum.constant[0] * inverse, sum.constant[1] * inverse];
            z[i] = sum.size(constants[i]);
        }
        if N == 1 && self.0[0].is_vector {
            z[0] = only(constants[0], self.0[0].slopes[0]) * scale;
            return z[0].at_least(0.0).then_some(z);
        }
        let (mut before, mut open) = (T::ONE, T::ONE);
        for _ in 0..STEPS {
            let change = self.change(&constants, &z);
            let (mut most, mut size) = (T::ZERO, T::ZERO);
            for (z, change) in z.iter_mut().zip(change) {
                *z += change * open;
                most += change.abs();
                size += z.abs();
            }
            // A lane that has converged keeps what it has. Changes fall as the squares of those before.
            let next = size * before * before * T::from_f64(NOTHING) - most * most * most;
            let done = (T::ONE + next.sign()) * (T::ONE + (size * T::from_f64(SMALL) - most).sign());
            open = open - open * done * T::from_f64(0.25);
            before = most;
            if open.greatest() <= 0.0 {
                let sound = z.iter().all(|z| z.at_least(0.0));
                for z in &mut z {
                    *z = *z * scale;
                }
                return sound.then_some(z);
            }
        }
        None
    }

    /// A step of Newton's method.
    #[inline(always)]
    fn change(&self, constants: &[[T; 2]; N], z: &[T; N]) -> [T; N] {
        let mut change = z.map(|z| -z);
        let mut matrix = [[T::ZERO; N]; N];
        for (i, sum) in self.0.iter().enumerate() {
            let mut at = constants[i];
            for (slope, z) in sum.slopes.iter().zip(z) {
                at[0] += slope[0] * *z;
                at[1] += slope[1] * *z;
            }
            let size = sum.size(at);
            change[i] += size;
            let unit = if sum.is_vector {
                let inverse = T::ONE / (size + T::from_f64(f64::MIN_POSITIVE));
                [at[0] * inverse, at[1] * inverse]
            } else {
                at.map(T::sign)
            };
            for (k, (entry, slope)) in matrix[i].iter_mut().zip(&sum.slopes).enumerate() {
                *entry = T::from_f64(f64::from(u8::from(i == k))) - (unit[0] * slope[0] + unit[1] * slope[1]);
            }
        }
        if N == 3 {
            return by_determinants(&matrix, &change);
        }
        eliminate(&mut matrix, &mut change);
        change
    }
}

/// Solves matrix x = right in place. Below a certificate of 1 the matrix of Newton's method needs no pivoting.
#[inline(always)]
fn eliminate<T: Real, const N: usize>(matrix: &mut Matrix<T, N>, right: &mut [T; N]) {
    let mut inverses = [T::ZERO; N];
    for k in 0..N {
        inverses[k] = T::ONE / matrix[k][k];
        let (above, below) = matrix.split_at_mut(k + 1);
        let (known, rest) = right.split_at_mut(k + 1);
        for (row, right) in below.iter_mut().zip(rest) {
            let factor = row[k] * inverses[k];
            row[k + 1..].iter_mut().zip(&above[k][k + 1..]).for_each(|(entry, own)| *entry -= factor * *own);
            *right -= factor * known[k];
        }
    }
    for k in (0..N).rev() {
        let known = (k + 1..N).fold(right[k], |rest, j| rest - matrix[k][j] * right[j]);
        right[k] = known * inverses[k];
    }
}

/// Solves matrix x = right with three rows: one division, on which nothing else waits.
#[inline(always)]
fn by_determinants<T: Real, const N: usize>(matrix: &Matrix<T, N>, right: &[T; N]) -> [T; N] {
    let mut sum = [T::ZERO; N];
    let mut determinant = T::ZERO;
    for i in 0..3 {
        let (one, other) = (&matrix[(i + 1) % 3], &matrix[(i + 2) % 3]);
        for j in 0..3 {
            let (k, l) = ((j + 1) % 3, (j + 2) % 3);
            let minor = one[k] * other[l] - one[l] * other[k];
            sum[j] += minor * right[i];
            if i == 0 {
                determinant += matrix[0][j] * minor;
            }
        }
    }
    let inverse = T::ONE / determinant;
    sum.map(|sum| sum * inverse)
}

/// Whether a positive vector shows that the spectral radius of a nonnegative matrix is below 1: its image is less in every
/// component (Collatz and Wielandt).
#[inline(always)]
fn is_contraction<T: Real, const N: usize>(matrix: &Matrix<T, N>) -> bool {
    let mut vector = [T::ONE; N];
    for _ in 0..IMAGES {
        let image = matrix.map(|row| row.iter().zip(&vector).fold(T::ZERO, |sum, (a, x)| sum + *a * *x));
        if vector.iter().zip(&image).all(|(x, y)| (*x - *y).exceeds(0.0)) {
            return true;
        }
        vector.iter_mut().zip(image).for_each(|(x, y)| *x += y);
    }
    false
}

/// The spectral radius of a nonnegative matrix; `None` where few steps do not find it in every lane.
#[inline(always)]
fn certificate<T: Real, const N: usize>(matrix: &Matrix<T, N>) -> Option<T> {
    match N {
        1 => Some(matrix[0][0]),
        3 => greatest_root(matrix).or_else(|| by_powers(matrix)),
        _ => by_powers(matrix),
    }
}

/// The magnitude of one vector, z = |a + w z|, where w is shorter than 1: (a w + s)/(1 - w w), or a a/(s - a w) where that cancels less.
#[inline(always)]
fn only<T: Real>([a, b]: [T; 2], [u, v]: [T; 2]) -> T {
    let (along, left, square) = (a * u + b * v, T::ONE - (u * u + v * v), a * a + b * b);
    let sum = along.abs() + (along * along + left * square).sqrt();
    let is_along = (T::ONE + along.sign()).half();
    is_along * (sum / left) + (T::ONE - is_along) * (square / (sum + T::from_f64(f64::MIN_POSITIVE)))
}

/// The spectral radius of a nonnegative matrix of three rows, the greatest root of its characteristic polynomial, by Newton's
/// method from above; `None` where in a lane other roots are too near.
#[inline(always)]
fn greatest_root<T: Real, const N: usize>(matrix: &Matrix<T, N>) -> Option<T> {
    let minor = |i: usize, j: usize| matrix[i][i] * matrix[j][j] - matrix[i][j] * matrix[j][i];
    let trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
    let minors = minor(0, 1) + minor(0, 2) + minor(1, 2);
    let across = |i: usize, j: usize| matrix[1][i] * matrix[2][j] - matrix[1][j] * matrix[2][i];
    let determinant = matrix[0][0] * across(1, 2) - matrix[0][1] * across(0, 2) + matrix[0][2] * across(0, 1);
    // Whatever the vector: the greatest quotient of its image and itself is not less (Collatz and Wielandt).
    let mut root = T::ZERO;
    let (mut vector, mut image) = ([T::ONE; N], [T::ONE; N]);
    for _ in 0..POWERS {
        vector = image;
        for (image, row) in image.iter_mut().zip(matrix) {
            *image = row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2];
        }
    }
    for (image, vector) in image.into_iter().zip(vector) {
        root = greater(root, over(image, vector));
    }
    let mut open = T::ONE;
    for _ in 0..STEPS {
        let value = ((root - trace) * root + minors) * root - determinant;
        let bend = root + root.twice() - trace;
        let slope = (bend - trace) * root + minors;
        let step = over(value, slope);
        root -= step * open;
        // The next step is as the square of this one.
        open = open.half() - open.half() * (slope * root * T::from_f64(ROUNDING) - step * step * bend).sign();
        if open.greatest() <= 0.0 {
            let apart = slope - root * root * T::from_f64(SLOPE);
            return apart.at_least(0.0).then_some(root);
        }
    }
    None
}

/// The spectral radius of a nonnegative matrix by its powers; `None` where it is not found in every lane.
#[inline(always)]
fn by_powers<T: Real, const N: usize>(matrix: &Matrix<T, N>) -> Option<T> {
    let norm = matrix.iter().fold(T::ZERO, |most, row| greater(most, total(row)));
    // With a part of the unit matrix no other eigenvalue has the size of the greatest; the vectors are the same.
    let mut power = *matrix;
    for (i, row) in power.iter_mut().enumerate() {
        row[i] += norm.half();
    }
    let (mut found, mut open, mut size) = (norm, T::ONE, norm);
    for _ in 0..SQUARINGS {
        let inverse = T::ONE / (size + T::from_f64(f64::MIN_POSITIVE));
        power.iter_mut().flatten().for_each(|entry| *entry = *entry * inverse);
        power = squared(&power);
        let sums = power.map(|row| total(&row) + T::from_f64(FLOOR));
        size = sums.into_iter().fold(T::ZERO, greater);
        let image = |i: usize| matrix[i].iter().zip(&sums).fold(T::ZERO, |sum, (a, x)| sum + *a * *x);
        let greatest = (0..N).fold(T::ZERO, |most, i| greater(most, image(i) / sums[i]));
        let apart = (found - greatest).abs();
        // A lane that has converged keeps what it has.
        found = found * (T::ONE - open) + greatest * open;
        open = open.half() - open.half() * (greatest * T::from_f64(STILL) - apart).sign();
        if open.greatest() <= 0.0 {
            return Some(found);
        }
    }
    // Unknowns of which none depends on itself in the end.
    let eighth = squared(&squared(&squared(matrix)));
    eighth.iter().flatten().all(|entry| entry.greatest() <= 0.0).then_some(T::ZERO)
}

#[inline(always)]
fn squared<T: Real, const N: usize>(matrix: &Matrix<T, N>) -> Matrix<T, N> {
    let entry = |i: usize, j: usize| (0..N).fold(T::ZERO, |sum, k| sum + matrix[i][k] * matrix[k][j]);
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

#[inline(always)]
fn total<T: Real>(row: &[T]) -> T {
    row.iter().fold(T::ZERO, |sum, entry| sum + *entry)
}

/// The greater of two numbers, lane by lane and but for rounding.
#[inline(always)]
fn greater<T: Real>(a: T, b: T) -> T {
    a + (b - a).clamp_negative()
}

/// A quotient by a number that is not negative; 0 where both are 0.
#[inline(always)]
fn over<T: Real>(part: T, whole: T) -> T {
    part / (whole + T::from_f64(f64::MIN_POSITIVE))
}
