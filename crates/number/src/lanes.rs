//! Several numbers side by side.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::Real;

/// Eight numbers that are put through a formula together: a plain array that the compiler turns into vector
/// instructions (one register of AVX-512, two of AVX).
///
/// Every lane gets the bits that `f64` gets by the same formula.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; Lanes::WIDTH]);

impl Lanes {
    /// Number of lanes.
    pub const WIDTH: usize = 8;

    /// The numbers that a function gives for each lane.
    #[inline(always)]
    pub fn of(lane: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(lane))
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::of(|lane| f(self.0[lane]))
    }

    #[inline(always)]
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
        impl $trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::of(|lane| self.0[lane] $op other.0[lane])
            }
        }
    };
}
lanewise!(Add, add, +);
lanewise!(Sub, sub, -);
lanewise!(Mul, mul, *);
lanewise!(Div, div, /);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Lanes {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Real for Lanes {
    const ZERO: Self = Self([0.0; Self::WIDTH]);
    const ONE: Self = Self([1.0; Self::WIDTH]);
    const EPSILON: f64 = f64::EPSILON;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self([value; Self::WIDTH])
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.0[0]
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
    #[inline(always)]
    fn least(self) -> f64 {
        self.fold(|a, b| a < b)
    }
    #[inline(always)]
    fn greatest(self) -> f64 {
        self.fold(|a, b| a > b)
    }
    #[inline(always)]
    fn clamp_negative(self) -> Self {
        self.map(|a| if a < 0.0 { 0.0 } else { a })
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        (self.map(f64::sin), self.map(f64::cos))
    }
}
