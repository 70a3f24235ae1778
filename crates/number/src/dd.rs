//! Double-double: an unevaluated sum of two f64, about 32 digits.
//!
//! Sums and products use the error-free transformations of Dekker (1971) and Knuth; the error of a product is found
//! by a fused multiply-add. Used for reference results, not for speed.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Curve, Real};

/// `hi + lo` with |lo| at most half a unit in the last place of `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dd {
    /// The leading part.
    pub hi: f64,
    /// The remainder.
    pub lo: f64,
}

/// pi/2 in three parts, enough to reduce an angle of some thousand turns.
const HALF_PI: [f64; 3] =
    [std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

/// a + b exactly (Knuth).
pub(crate) fn two_sum(a: f64, b: f64) -> Dd {
    let hi = a + b;
    let part = hi - a;
    Dd { hi, lo: (a - (hi - part)) + (b - part) }
}

/// a + b exactly, |a| >= |b| (Dekker).
pub(crate) fn quick_two_sum(a: f64, b: f64) -> Dd {
    let hi = a + b;
    Dd { hi, lo: b - (hi - a) }
}

/// a b exactly without a fused multiply-add, which takes long where the machine has none (Dekker); for |a|, |b| below 1e290.
pub(crate) fn split_product(a: f64, b: f64) -> Dd {
    /// 2^27 + 1 (Veltkamp): the product with it, less itself, leaves the upper half of the digits.
    const SPLITTER: f64 = 134_217_729.0;
    let halves = |x: f64| {
        let wide = SPLITTER * x;
        let upper = wide - (wide - x);
        [upper, x - upper]
    };
    let ([a1, a2], [b1, b2], hi) = (halves(a), halves(b), a * b);
    Dd { hi, lo: ((a1 * b1 - hi) + a1 * b2 + a2 * b1) + a2 * b2 }
}

impl Dd {
    /// A quotient of two f64, to the full precision.
    pub fn ratio(a: f64, b: f64) -> Self {
        Self::from_f64(a) / Self::from_f64(b)
    }

    /// sin and cos for |x| <= pi/4 by their series, the argument halved four times first.
    fn small_sin_cos(self) -> (Self, Self) {
        let x = self * Self::from_f64(1.0 / 16.0);
        let (mut sine, mut versine) = (Self::ZERO, Self::ZERO);
        let mut term = x;
        let mut n = 1.0;
        // 12 pairs of terms: (pi/64)^25 / 25! is far below 1e-33.
        for _ in 0..12 {
            sine += term;
            term = term * x * Self::ratio(1.0, n + 1.0);
            versine += term;
            term = -(term * x * Self::ratio(1.0, n + 2.0));
            n += 2.0;
        }
        // versine = 1 - cos keeps its digits while doubling: v(2x) = 2 sin², sin(2x) = 2 sin (1 - v).
        for _ in 0..4 {
            let doubled = (sine * sine).twice();
            sine = (sine * (Self::ONE - versine)).twice();
            versine = doubled;
        }
        (sine, Self::ONE - versine)
    }
}

impl Add for Dd {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let s = two_sum(self.hi, other.hi);
        let t = two_sum(self.lo, other.lo);
        let s = quick_two_sum(s.hi, s.lo + t.hi);
        quick_two_sum(s.hi, s.lo + t.lo)
    }
}

impl Sub for Dd {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + (-other)
    }
}

impl Mul for Dd {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // The product of the leading parts and its rounding, exactly.
        let hi = self.hi * other.hi;
        let lo = self.hi.mul_add(other.hi, -hi);
        quick_two_sum(hi, lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for Dd {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let q1 = self.hi / other.hi;
        let rest = self - other * Self::from_f64(q1);
        let q2 = rest.hi / other.hi;
        let rest = rest - other * Self::from_f64(q2);
        let q3 = rest.hi / other.hi;
        quick_two_sum(q1, q2) + Self::from_f64(q3)
    }
}

impl Neg for Dd {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

crate::real::assigning!(Dd);

impl Real for Dd {
    const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;

    fn from_f64(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
    fn to_f64(self) -> f64 {
        self.hi + self.lo
    }
    fn along<const N: usize>(self, curve: &impl Curve<N>) -> [Self; N] {
        curve.precise(self)
    }
    fn sqrt(self) -> Self {
        let root = self.hi.sqrt();
        // sqrt(0) has no Newton step; a negative number stays NaN.
        if root == 0.0 || root.is_nan() {
            return Self::from_f64(root);
        }
        let guess = Self::from_f64(root);
        let rest = self - guess * guess;
        guess + rest * Self::ratio(0.5, root)
    }
    fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }
    fn sin_cos(self) -> (Self, Self) {
        let turns = (self.hi / HALF_PI[0]).round();
        let n = Self::from_f64(turns);
        let mut rest = self;
        for part in HALF_PI {
            rest -= n * Self::from_f64(part);
        }
        let (s, c) = rest.small_sin_cos();
        match turns.rem_euclid(4.0) {
            quarter if quarter < 0.5 => (s, c),
            quarter if quarter < 1.5 => (c, -s),
            quarter if quarter < 2.5 => (-s, -c),
            _ => (-c, s),
        }
    }
}
