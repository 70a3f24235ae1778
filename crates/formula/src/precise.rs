//! Formulas in about 32 digits, for what is proved by differences.

use std::f64::consts::LN_2;

use assur_number::{Dd, Real, elementary};

use crate::number::Scalar;
use crate::program::{Function, Sign};

/// ln 2 beyond its 16 digits.
const LN_2_REST: f64 = 2.319_046_813_846_3e-17;

/// Halvings of the argument of an exponential before its series, and terms of this.
const HALVINGS: i32 = 8;
const TERMS: u32 = 14;

/// The exponential by its series: exp(x) = 2^k exp(r / 2^n)^(2^n), r = x - k ln 2.
fn exponential(x: Dd) -> Dd {
    let k = (x.hi / LN_2).round();
    // Beyond the range of a number there is no precision to keep.
    if x.hi.is_nan() || x.hi.abs() > 700.0 {
        return Dd::from_f64(elementary::exp(x.hi));
    }
    let whole = Dd::from_f64(k);
    let rest = x - whole * Dd::from_f64(LN_2) - whole * Dd::from_f64(LN_2_REST);
    let small = rest * Dd::from_f64(0.5_f64.powi(HALVINGS));
    // exp - 1 keeps its digits while it is squared.
    let (mut sum, mut term) = (Dd::ZERO, Dd::ONE);
    for n in 1..=TERMS {
        term = term * small * Dd::ratio(1.0, f64::from(n));
        sum += term;
    }
    for _ in 0..HALVINGS {
        sum = sum.twice() + sum * sum;
    }
    (Dd::ONE + sum) * Dd::from_f64(elementary::exp2(k))
}

/// The logarithm by one step of Newton's method, which doubles the digits.
fn logarithm(x: Dd) -> Dd {
    let guess = Dd::from_f64(elementary::ln(x.hi));
    if guess.hi.is_finite() { guess + x * exponential(-guess) - Dd::ONE } else { guess }
}

/// A whole power by squaring.
fn whole_power(mut base: Dd, exponent: f64) -> Dd {
    let (mut left, mut product) = (exponent.abs(), Dd::ONE);
    while left >= 1.0 {
        if left % 2.0 >= 1.0 {
            product = product * base;
        }
        base = base * base;
        left = (0.5 * left).floor();
    }
    if exponent < 0.0 { Dd::ONE / product } else { product }
}

impl Scalar for Dd {
    fn power(self, exponent: Self) -> Self {
        let is_whole = exponent.lo == 0.0 && exponent.hi.fract() == 0.0 && exponent.hi.abs() < 1024.0;
        if is_whole { whole_power(self, exponent.hi) } else { exponential(exponent * logarithm(self)) }
    }
    fn call(self, function: Function) -> Self {
        let across = || (Self::ONE - self * self).sqrt();
        match function {
            Function::Sin => self.sin_cos().0,
            Function::Cos => self.sin_cos().1,
            Function::Tan => {
                let (s, c) = self.sin_cos();
                s / c
            }
            Function::Asin => self.angle(across()),
            Function::Acos => across().angle(self),
            Function::Atan => self.angle(Self::ONE),
            Function::Sqrt => self.sqrt(),
            Function::Exp => exponential(self),
            Function::Ln => logarithm(self),
        }
    }
    /// By one step of Newton's method.
    fn angle(self, x: Self) -> Self {
        let length = (x * x + self * self).sqrt();
        let guess = Self::from_f64(elementary::atan2(self.hi, x.hi));
        if !(length.hi > 0.0 && length.hi.is_finite()) {
            return guess;
        }
        let (s, c) = guess.sin_cos();
        guess + (self * c - x * s) / length
    }
    fn compared(self, other: Self) -> Option<Sign> {
        Sign::of((self - other).to_f64())
    }
}
