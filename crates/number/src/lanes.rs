//! Several numbers side by side.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::Real;

/// `N` numbers that are put through a formula together; plain arrays that the compiler turns into vector
/// instructions.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    #[inline]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self.0;
        for (a, b) in out.iter_mut().zip(other.0) {
            *a = f(*a, b);
        }
        Self(out)
    }

    #[inline]
    fn fold(self, better: impl Fn(f64, f64) -> bool) -> f64 {
        // The result must be NaN if a lane is NaN, which a comparison would hide. Without branches, because this is
        // in the inner loop.
        let mut hidden = false;
        for a in self.0 {
            hidden |= a.is_nan();
        }
        let best = self.0.into_iter().reduce(|a, b| if better(a, b) { a } else { b }).unwrap_or(0.0);
        if hidden { f64::NAN } else { best }
    }
}

macro_rules! lanewise {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $op b)
            }
        }
    };
}
lanewise!(Add, add, +);
lanewise!(Sub, sub, -);
lanewise!(Mul, mul, *);
lanewise!(Div, div, /);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const N: usize> AddAssign for Lanes<N> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize> SubAssign for Lanes<N> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const N: usize> Real for Lanes<N> {
    const ZERO: Self = Self([0.0; N]);
    const ONE: Self = Self([1.0; N]);
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn from_f64(value: f64) -> Self {
        Self([value; N])
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.0[0]
    }
    #[inline]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }
    #[inline]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    #[inline]
    fn least(self) -> f64 {
        self.fold(|a, b| a < b)
    }
    #[inline]
    fn greatest(self) -> f64 {
        self.fold(|a, b| a > b)
    }
    #[inline]
    fn clamp_negative(self) -> Self {
        self.map(|a| if a < 0.0 { 0.0 } else { a })
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        (self.map(f64::sin), self.map(f64::cos))
    }
}
