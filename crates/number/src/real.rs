//! The operations that a formula may use on a number.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use pulp::Arch;

use crate::{Dd, sine};

/// `+=` and `-=` of a number by its sum and difference.
macro_rules! assigning {
    ($number:ty) => {
        impl std::ops::AddAssign for $number {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl std::ops::SubAssign for $number {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
    };
}
pub(crate) use assigning;

/// Numbers that depend on one number.
pub trait Curve<const N: usize> {
    /// In 16 digits.
    fn at(&self, x: f64) -> [f64; N];
    /// In about 32 digits.
    fn precise(&self, x: Dd) -> [Dd; N];
}

/// A real number, or several side by side.
///
/// There is no comparison of two numbers: a formula that has to decide asks whether all lanes are on one side of a limit.
pub trait Real:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// Distance from 1 to the next number of this kind.
    const EPSILON: f64;

    /// This number in every lane.
    fn from_f64(value: f64) -> Self;
    /// The first lane, rounded.
    fn to_f64(self) -> f64;
    /// Square root; NaN for a negative number.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// The smallest lane; NaN if a lane is NaN.
    #[inline(always)]
    fn least(self) -> f64 {
        self.to_f64()
    }
    /// The greatest lane; NaN if a lane is NaN.
    #[inline(always)]
    fn greatest(self) -> f64 {
        self.to_f64()
    }
    /// Whether every lane is at least `limit`; no, if a lane is NaN.
    #[inline(always)]
    fn at_least(self, limit: f64) -> bool {
        self.least() >= limit
    }
    /// Whether every lane exceeds `limit`; no, if a lane is NaN.
    #[inline(always)]
    fn exceeds(self, limit: f64) -> bool {
        self.least() > limit
    }
    /// The greater of this number and zero, lane by lane.
    #[must_use]
    #[inline(always)]
    fn clamp_negative(self) -> Self {
        if self.to_f64() < 0.0 { Self::ZERO } else { self }
    }
    /// -1 for a negative number, else 1, lane by lane.
    #[must_use]
    #[inline(always)]
    fn sign(self) -> Self {
        if self.to_f64() < 0.0 { -Self::ONE } else { Self::ONE }
    }
    /// Sine and cosine of an angle, rad.
    fn sin_cos(self) -> (Self, Self);

    /// The numbers of a curve at this one, lane by lane.
    #[must_use]
    fn along<const N: usize>(self, curve: &impl Curve<N>) -> [Self; N] {
        curve.at(self.to_f64()).map(Self::from_f64)
    }

    /// Evaluates a formula with the widest instructions that the machine has for this kind of number. The closure must be
    /// `#[inline(always)]`, and so must be what it calls: the instructions of the caller reach only as far as code is inlined.
    #[inline(always)]
    fn evaluate<V>(formula: impl FnOnce() -> V) -> V {
        formula()
    }

    /// Half of this number.
    #[must_use]
    #[inline(always)]
    fn half(self) -> Self {
        self * Self::from_f64(0.5)
    }

    /// Twice this number.
    #[must_use]
    #[inline(always)]
    fn twice(self) -> Self {
        self + self
    }
}

macro_rules! primitive {
    ($float:ident, $sin_cos:path) => {
        #[expect(clippy::allow_attributes, reason = "one macro serves both widths")]
        #[allow(
            clippy::cast_lossless,
            clippy::cast_possible_truncation,
            trivial_numeric_casts,
            reason = "one macro serves both widths, and f32 is asked for to see what it loses"
        )]
        impl Real for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: f64 = $float::EPSILON as f64;

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self as f64
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $float::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            #[inline(always)]
            fn evaluate<V>(formula: impl FnOnce() -> V) -> V {
                Arch::new().dispatch(formula)
            }
        }
    };
}

primitive!(f32, f32::sin_cos);
primitive!(f64, sin_cos);

#[inline(always)]
fn sin_cos(angle: f64) -> (f64, f64) {
    let (found, is_right) = sine::quick(angle);
    let [sine, cosine] = if is_right { found } else { sine::precise(angle) };
    (sine, cosine)
}
