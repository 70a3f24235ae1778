//! Trigonometric polynomials of degree 3 and their real zeros.
//!
//! The zeros are isolated by exclusion: on an arc of half-width h about m, Taylor's formula with the bound
//! `Σ k³ |z_k|` of the third derivative shows that the function has no zero, that it is monotone, or that it is convex or
//! concave. In the first case the arc holds no zero, in the second one or none by the signs at its ends, in the third two,
//! one or none by its extreme value too. Other arcs are halved. So no zero is missed, and the number is certain up to
//! the rounding of the coefficients, whose bound says where two zeros can't be told from none.

use std::{convert::Infallible, f64::consts::TAU};

use assur_number::{Real, elementary, search::try_newton_root};

/// Number of samples: more than the 7 coefficients need, so that their rounding is averaged.
pub(crate) const SAMPLES: usize = 16;

/// Most zeros, counted with what rounding may repeat at the ends of arcs.
const MOST: usize = 12;

/// Rounding of a value in units of the last place of the greatest of its terms.
const ROUNDING: f64 = 8.0;

/// Arcs of a smaller half-width than this are not halved: the function and its first two derivatives vanish there.
const LEAST_ARC: f64 = 1e-7;

/// `a0 + Σ (a_k cos kφ + b_k sin kφ)`, k = 1, 2, 3.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trig<T> {
    mean: T,
    parts: [[T; 2]; 3],
    /// Bound of the function: the mean and the sizes of the parts.
    size: f64,
    /// Bound of its third derivative, Σ k³ times the size of the parts.
    third: f64,
}

/// The directions of the samples, at the angles 2π k / 16.
pub(crate) fn sampled<T: Real>() -> [[T; 2]; SAMPLES] {
    // cos(π/8) and sin(π/8) from square roots, in the precision of the number.
    let half = T::ONE.half();
    let c45 = half.sqrt();
    let (c, s) = ((half + c45.half()).sqrt(), (half - c45.half()).sqrt());
    let (o, l) = (T::ZERO, T::ONE);
    let first = [[l, o], [c, s], [c45, c45], [s, c]];
    std::array::from_fn(|k| {
        let [x, y] = first[k % 4];
        [[x, y], [-y, x], [-x, -y], [y, -x]][k / 4]
    })
}

impl<T: Real> Trig<T> {
    /// The polynomial through samples at the directions of [`sampled`].
    pub(crate) fn through(values: &[T; SAMPLES], directions: &[[T; 2]; SAMPLES]) -> Self {
        let share = T::from_f64(1.0 / SAMPLES as f64);
        let sum = |k: usize, part: usize| {
            (0..SAMPLES).fold(T::ZERO, |sum, j| sum + values[j] * directions[(k * j) % SAMPLES][part]) * share
        };
        let parts = [1, 2, 3].map(|k| [sum(k, 0).twice(), sum(k, 1).twice()]);
        let mean = sum(0, 0);
        let sizes = parts.map(|[a, b]: [T; 2]| elementary::hypot(a.to_f64(), b.to_f64()));
        let [one, two, three] = sizes;
        let size = mean.abs().to_f64() + one + two + three;
        Self { mean, parts, size, third: one + 8.0 * two + 27.0 * three }
    }

    /// Value and first two derivatives at a direction.
    fn at(&self, d: [T; 2]) -> [T; 3] {
        let [c, s] = d;
        let c2 = [c * c - s * s, (c * s).twice()];
        let c3 = [c2[0] * c - c2[1] * s, c2[0] * s + c2[1] * c];
        let mut out = [self.mean, T::ZERO, T::ZERO];
        for (k, ([c, s], [a, b])) in [d, c2, c3].into_iter().zip(self.parts).enumerate() {
            let n = T::from_f64(k as f64 + 1.0);
            let value = a * c + b * s;
            out[0] += value;
            out[1] += n * (b * c - a * s);
            out[2] -= n * n * value;
        }
        out
    }

    fn at_angle(&self, angle: f64) -> [T; 3] {
        let (s, c) = T::from_f64(angle).sin_cos();
        self.at([c, s])
    }

    fn value(&self, angle: f64) -> f64 {
        self.at_angle(angle)[0].to_f64()
    }

    /// The directions (cos, sin) of all real zeros, some perhaps twice, where the samples are sums of terms of at most this size; `None` where the polynomial is zero but for
    /// rounding: every angle is one.
    pub(crate) fn zeros(&self, size: f64) -> Option<Vec<[T; 2]>> {
        let slack = ROUNDING * T::EPSILON * size.max(self.size);
        if self.size.is_nan() || self.size <= slack {
            return None;
        }
        let mut zeros = Vec::new();
        for k in 0..SAMPLES {
            self.search(&mut zeros, [k, k + 1].map(|k| TAU * k as f64 / SAMPLES as f64), slack);
        }
        zeros.truncate(MOST);
        Some(zeros)
    }

    /// Adds the zeros between two angles.
    fn search(&self, zeros: &mut Vec<[T; 2]>, [low, high]: [f64; 2], slack: f64) {
        let (middle, h) = (0.5 * (low + high), 0.5 * (high - low));
        let [f, f1, f2] = self.at_angle(middle).map(Real::to_f64);
        let third = self.third;
        if zeros.len() >= MOST || f.abs() > h * (f1.abs() + h * (0.5 * f2.abs() + h * third / 6.0)) + slack {
            return;
        }
        if f1.abs() > h * (f2.abs() + 0.5 * h * third) {
            self.cross(zeros, [low, high], slack);
        } else if f2.abs() > h * third {
            self.around(zeros, [low, high], slack);
        } else if h < LEAST_ARC {
            zeros.push(self.direction(middle));
        } else {
            self.search(zeros, [low, middle], slack);
            self.search(zeros, [middle, high], slack);
        }
    }

    /// Adds the zeros between two angles where the second derivative keeps its sign.
    fn around(&self, zeros: &mut Vec<[T; 2]>, [low, high]: [f64; 2], slack: f64) {
        let slope = |angle: f64| self.at_angle(angle)[1].to_f64();
        if (slope(low) > 0.0) == (slope(high) > 0.0) {
            return self.cross(zeros, [low, high], slack);
        }
        let extreme = self.root([low, high], 1);
        let [value, _, bend] = self.at_angle(extreme).map(Real::to_f64);
        if value.abs() <= slack {
            // Two zeros that can't be told from one or none: they are no farther apart than this.
            let apart = (2.0 * (value.abs() + slack) / bend.abs()).sqrt();
            zeros.push(self.direction(extreme - apart));
            zeros.push(self.direction(extreme + apart));
            return;
        }
        self.cross(zeros, [low, extreme], slack);
        self.cross(zeros, [extreme, high], slack);
    }

    /// Adds the zero between two angles where the polynomial is monotone, if there is one; one at an end is found from both
    /// sides.
    fn cross(&self, zeros: &mut Vec<[T; 2]>, [low, high]: [f64; 2], slack: f64) {
        let [below, above] = [self.value(low), self.value(high)];
        if below.abs() <= slack {
            zeros.push(self.direction(low));
        } else if above.abs() <= slack {
            zeros.push(self.direction(high));
        } else if (below > 0.0) != (above > 0.0) {
            zeros.push(self.direction(self.root([low, high], 0)));
        }
    }

    /// The zero of the function (0) or of its derivative (1) between two angles where it has opposite signs.
    fn root(&self, [low, high]: [f64; 2], order: usize) -> f64 {
        let both = |angle: f64| {
            let all = self.at_angle(angle).map(Real::to_f64);
            Ok::<_, Infallible>((all[order], all[order + 1]))
        };
        let Ok(found) = try_newton_root(low, high, both);
        found
    }

    /// A direction, moved onto the zero in the precision of the number where that is regular.
    fn direction(&self, angle: f64) -> [T; 2] {
        let (s, c) = T::from_f64(angle).sin_cos();
        let mut d = [c, s];
        if T::EPSILON < f64::EPSILON {
            for _ in 0..2 {
                let [f, f1, _] = self.at(d);
                let step = -(f / f1);
                if step.abs().at_least(1e-12) || step.to_f64().is_nan() {
                    break;
                }
                let turned = [d[0] - d[1] * step, d[1] + d[0] * step];
                let length = (turned[0] * turned[0] + turned[1] * turned[1]).sqrt();
                d = turned.map(|part| part / length);
            }
        }
        d
    }
}
