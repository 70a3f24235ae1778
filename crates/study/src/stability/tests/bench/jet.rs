//! A number with its first two derivatives with respect to the input coordinate, in 32 digits.

use std::ops::{Add, Div, Mul, Neg, Sub};

use assur_number::{Dd, Real};

/// f, f', f''.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet(pub(crate) [Dd; 3]);

impl Jet {
    pub(crate) fn constant(value: f64) -> Self {
        Self([Dd::from_f64(value), Dd::ZERO, Dd::ZERO])
    }

    /// Sine and cosine of `part` times the coordinate, plus an angle.
    pub(crate) fn sin_cos(q: Dd, part: f64, angle: Dd) -> [Self; 2] {
        let k = Dd::from_f64(part);
        let (s, c) = (q * k + angle).sin_cos();
        [Self([s, c * k, -(s * k * k)]), Self([c, -(s * k), -(c * k * k)])]
    }

    pub(crate) fn sqrt(self) -> Self {
        let [f, f1, f2] = self.0;
        let root = f.sqrt();
        let first = f1.half() / root;
        Self([root, first, (f2.half() - first * first) / root])
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self([0, 1, 2].map(|k| self.0[k] - other.0[k]))
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ([a, a1, a2], [b, b1, b2]) = (self.0, other.0);
        Self([a * b, a1 * b + a * b1, a2 * b + (a1 * b1).twice() + a * b2])
    }
}

impl Div for Jet {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let ([a, a1, a2], [b, b1, b2]) = (self.0, other.0);
        let q = a / b;
        let q1 = (a1 - q * b1) / b;
        Self([q, q1, (a2 - (q1 * b1).twice() - q * b2) / b])
    }
}
