//! The one solution that a certificate proves, in small fixed memory and for any number: eight positions at once too.
//!
//! Forces of friction that have the same place and direction, as on both ends of a slide, have one unknown: the sum of their
//! moduli, `s_r = sum over the vectors j of r of |a_j + sum of W_jq s_q|`.

use assur_number::{Formula, Real};

/// Most unknowns, most vectors, and how many normal forces a caller may have eliminated from them.
pub const MOST: [usize; 3] = [6, 10, 3];

/// Most steps of the iteration and of Newton's method together.
const STEPS: usize = 24;

/// Steps of the iteration before Newton's method.
const BEFORE: usize = 2;

/// Relative change below which a spectral radius has converged.
const STILL: f64 = 8.0 * f64::EPSILON;

/// Relative change in a step of Newton's method after which nothing but rounding is left.
const SMALL: f64 = 1e-12;

/// Most squarings of the matrix for its spectral radius.
const SQUARINGS: usize = 14;

/// A row of a power of the matrix counts as this at least: one of zeros is no reason for a quotient of zeros.
const FLOOR: f64 = 1e-200;

/// A vector whose modulus counts for an unknown.
#[derive(Debug, Clone, Copy)]
pub struct Vector<T> {
    /// The unknown of which the modulus is a part.
    pub unknown: usize,
    /// The vector without friction; of one component the second is zero.
    pub constant: [T; 2],
    /// What each unknown of size 1 adds.
    pub slopes: [[T; 2]; MOST[0]],
}

/// Equations for sums of moduli.
#[derive(Debug, Clone, Copy)]
pub struct Unique<T> {
    count: usize,
    used: usize,
    vectors: [Vector<T>; MOST[1]],
}

impl<T: Real> Unique<T> {
    /// Equations for a number of unknowns, at most [`MOST`]; vectors are added.
    pub fn new(count: usize) -> Self {
        let empty = Vector { unknown: 0, constant: [T::ZERO; 2], slopes: [[T::ZERO; 2]; MOST[0]] };
        Self { count: count.min(MOST[0]), used: 0, vectors: [empty; MOST[1]] }
    }

    /// Adds a vector; one more than [`MOST`] is left out.
    pub fn push(&mut self, vector: Vector<T>) {
        if let Some(place) = self.vectors.get_mut(self.used) {
            *place = vector;
            self.used += 1;
        }
    }

    #[inline(always)]
    fn vectors(&self) -> &[Vector<T>] {
        &self.vectors[..self.used]
    }

    /// The certificate, and the unknowns where it proves one solution; `None` where a lane needs a more careful method.
    pub fn solve(&self) -> Option<(T, [T; MOST[0]])> {
        T::evaluate(Both(self))
    }

    /// The spectral radius of the sums of lengths: below 1 there is exactly one solution. `None` where few squarings of the
    /// matrix do not find it in every lane.
    #[inline(always)]
    fn certificate(&self) -> Option<T> {
        let n = self.count;
        let mut matrix = [[T::ZERO; MOST[0]]; MOST[0]];
        for vector in self.vectors() {
            for (sum, slope) in matrix[vector.unknown].iter_mut().zip(&vector.slopes[..n]) {
                *sum += length(*slope);
            }
        }
        if n == 1 {
            return Some(matrix[0][0]);
        }
        let norm = matrix[..n].iter().fold(T::ZERO, |most, row| greater(most, total(&row[..n])));
        // With a part of the unit matrix no other eigenvalue has the size of the greatest; the vectors are the same.
        let mut power = matrix;
        for (i, row) in power[..n].iter_mut().enumerate() {
            row[i] += norm.half();
        }
        let (mut found, mut open, mut size) = (norm, T::ONE, norm);
        for _ in 0..SQUARINGS {
            power[..n].iter_mut().flat_map(|row| &mut row[..n]).for_each(|entry| *entry = over(*entry, size));
            power = squared(&power, n);
            let sums: [T; MOST[0]] = std::array::from_fn(|i| total(&power[i][..n]) + T::from_f64(FLOOR));
            size = sums[..n].iter().fold(T::ZERO, |most, sum| greater(most, *sum));
            let greatest =
                (0..n).fold(T::ZERO, |most, i| greater(most, product(&matrix[i], &sums, n) / sums[i]));
            let apart = (found - greatest).abs() - greatest * T::from_f64(STILL);
            // A lane that has converged keeps what it has.
            found = found * (T::ONE - open) + greatest * open;
            open = open * positive(apart);
            if open.greatest() <= 0.0 {
                return Some(found);
            }
        }
        // Unknowns of which none depends on itself in the end.
        let eighth = squared(&squared(&squared(&matrix, n), n), n);
        eighth.iter().flatten().all(|entry| entry.greatest() <= 0.0).then_some(T::ZERO)
    }

    /// The solution, where the certificate is below 1.
    #[inline(always)]
    fn solution(&self) -> Option<[T; MOST[0]]> {
        let n = self.count;
        // Forces of any size are divided by their sum first, so that no square of them leaves the range of numbers.
        let of = |vector: &Vector<T>| vector.constant[0].abs() + vector.constant[1].abs();
        let scale = self.vectors().iter().fold(T::ZERO, |sum, vector| sum + of(vector));
        let mut scaled = *self;
        for vector in &mut scaled.vectors[..self.used] {
            vector.constant = vector.constant.map(|part| over(part, scale));
        }
        let (mut z, mut open) = ([T::ZERO; MOST[0]], T::ONE);
        for step in 0..STEPS {
            let change = scaled.change(&z, step >= BEFORE);
            let (mut most, mut size) = (T::ZERO, T::ZERO);
            for k in 0..n {
                z[k] += change[k] * open;
                (most, size) = (greater(most, change[k].abs()), greater(size, z[k].abs()));
            }
            // A lane that has converged keeps what it has.
            open = open * positive(most - size * T::from_f64(SMALL));
            if open.greatest() <= 0.0 {
                let sound = z[..n].iter().all(|z| z.at_least(0.0));
                return sound.then(|| z.map(|z| z * scale));
            }
        }
        None
    }

    /// A step of the iteration, or of Newton's method.
    #[inline(always)]
    fn change(&self, z: &[T; MOST[0]], newton: bool) -> [T; MOST[0]] {
        let n = self.count;
        let mut change = z.map(|z| -z);
        let mut matrix = [[T::ZERO; MOST[0]]; MOST[0]];
        for vector in self.vectors() {
            let mut at = vector.constant;
            for (slope, z) in vector.slopes[..n].iter().zip(z) {
                at[0] += slope[0] * *z;
                at[1] += slope[1] * *z;
            }
            let size = length(at);
            change[vector.unknown] += size;
            let unit = at.map(|part| over(part, size));
            for (entry, slope) in matrix[vector.unknown].iter_mut().zip(&vector.slopes[..n]) {
                *entry += unit[0] * slope[0] + unit[1] * slope[1];
            }
        }
        if newton {
            eliminate(&mut matrix, &mut change, n);
        }
        change
    }
}

/// The certificate and the solution, as a formula for the widest instructions.
struct Both<'a, T>(&'a Unique<T>);

impl<T: Real> Formula for Both<'_, T> {
    type Value = Option<(T, [T; MOST[0]])>;

    #[inline(always)]
    fn evaluate(self) -> Self::Value {
        let radius = self.0.certificate()?;
        let proved = (T::ONE - radius).exceeds(0.0);
        proved.then(|| self.0.solution())?.map(|z| (radius, z))
    }
}

/// Solves (1 - matrix) x = right in place. Below a certificate of 1 the matrix on the left needs no pivoting.
#[inline(always)]
fn eliminate<T: Real>(matrix: &mut [[T; MOST[0]]; MOST[0]], right: &mut [T; MOST[0]], n: usize) {
    for (i, row) in matrix[..n].iter_mut().enumerate() {
        row[..n].iter_mut().for_each(|entry| *entry = -*entry);
        row[i] += T::ONE;
    }
    for k in 0..n {
        let (own, known) = (matrix[k], right[k]);
        for (row, right) in matrix[..n].iter_mut().zip(&mut right[..n]).skip(k + 1) {
            let factor = row[k] / own[k];
            for (entry, own) in row[..n].iter_mut().zip(&own).skip(k + 1) {
                *entry -= factor * *own;
            }
            *right -= factor * known;
        }
    }
    for k in (0..n).rev() {
        let row = &matrix[k];
        let known = row[..n].iter().zip(&right[..n]).skip(k + 1).fold(T::ZERO, |sum, (a, x)| sum + *a * *x);
        right[k] = (right[k] - known) / row[k];
    }
}

#[inline(always)]
fn squared<T: Real>(matrix: &[[T; MOST[0]]; MOST[0]], n: usize) -> [[T; MOST[0]]; MOST[0]] {
    let mut square = [[T::ZERO; MOST[0]]; MOST[0]];
    for (square, row) in square[..n].iter_mut().zip(matrix) {
        for (factor, other) in row[..n].iter().zip(matrix) {
            for (sum, entry) in square[..n].iter_mut().zip(other) {
                *sum += *factor * *entry;
            }
        }
    }
    square
}

#[inline(always)]
fn total<T: Real>(row: &[T]) -> T {
    row.iter().fold(T::ZERO, |sum, entry| sum + *entry)
}

#[inline(always)]
fn product<T: Real>(row: &[T; MOST[0]], vector: &[T; MOST[0]], n: usize) -> T {
    row[..n].iter().zip(vector).fold(T::ZERO, |sum, (a, b)| sum + *a * *b)
}

#[inline(always)]
fn length<T: Real>([x, y]: [T; 2]) -> T {
    (x * x + y * y).sqrt()
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

/// 1 where a number is positive, else 0; NaN where it is none.
#[inline(always)]
fn positive<T: Real>(number: T) -> T {
    let size = number.clamp_negative();
    over(size, size)
}
