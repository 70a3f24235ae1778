//! Several numbers side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

use pulp::Arch;

use crate::{Curve, Real, sine};

/// Eight numbers that are put through a formula together: a plain array that the compiler turns into vector
/// instructions (one register of AVX-512, two of AVX).
///
/// Every lane gets the bits that `f64` gets by the same formula.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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

    #[cold]
    #[inline(never)]
    fn sin_cos_one_by_one(self) -> (Self, Self) {
        let both = self.0.map(Real::sin_cos);
        (Self(both.map(|(sine, _)| sine)), Self(both.map(|(_, cosine)| cosine)))
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::of(|lane| f(self.0[lane]))
    }

    #[inline(always)]
    fn fold(self, better: impl Fn(f64, f64) -> bool) -> f64 {
        // A NaN is better than any number: it must not be hidden.
        let choose = |a: f64, b: f64| if a.is_nan() || better(a, b) { a } else { b };
        self.0.into_iter().fold(self.0[0], choose)
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

crate::real::assigning!(Lanes);

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
    fn along<const N: usize>(self, curve: &impl Curve<N>) -> [Self; N] {
        let mut all = [Self::ZERO; N];
        for (lane, own) in self.0.into_iter().enumerate() {
            all.iter_mut().zip(curve.at(own)).for_each(|(all, own)| all.0[lane] = own);
        }
        all
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
    #[expect(clippy::needless_bitwise_bool, reason = "no branch in the inner loop")]
    #[inline(always)]
    fn at_least(self, limit: f64) -> bool {
        self.0.iter().fold(true, |all, lane| all & (*lane >= limit))
    }
    #[expect(clippy::needless_bitwise_bool, reason = "no branch in the inner loop")]
    #[inline(always)]
    fn exceeds(self, limit: f64) -> bool {
        self.0.iter().fold(true, |all, lane| all & (*lane > limit))
    }
    #[inline(always)]
    fn clamp_negative(self) -> Self {
        self.map(|a| if a < 0.0 { 0.0 } else { a })
    }
    #[inline(always)]
    fn sign(self) -> Self {
        self.map(Real::sign)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine, mut all_right) = (self, self, true);
        for lane in 0..Self::WIDTH {
            let ([s, c], is_right) = sine::quick(self.0[lane]);
            (sine.0[lane], cosine.0[lane]) = (s, c);
            all_right &= is_right;
        }
        if all_right { (sine, cosine) } else { self.sin_cos_one_by_one() }
    }
    #[inline(always)]
    fn evaluate<V>(formula: impl FnOnce() -> V) -> V {
        Arch::new().dispatch(formula)
    }
}
