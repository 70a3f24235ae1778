//! The operations that a formula may use on a number.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A real number, or several side by side.
///
/// There is no comparison: a formula that has to decide uses the [`least`](Self::least) or
/// [`greatest`](Self::greatest) lane, and so decides for all lanes at once.
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
    fn least(self) -> f64;
    /// The greatest lane; NaN if a lane is NaN.
    fn greatest(self) -> f64;
    /// The greater of this number and zero, lane by lane.
    #[must_use]
    fn clamp_negative(self) -> Self;
    /// Sine and cosine of an angle, rad.
    fn sin_cos(self) -> (Self, Self);

    /// Half of this number.
    #[must_use]
    fn half(self) -> Self {
        self * Self::from_f64(0.5)
    }

    /// Twice this number.
    #[must_use]
    fn twice(self) -> Self {
        self + self
    }
}

macro_rules! primitive {
    ($float:ident) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            #[expect(clippy::allow_attributes, reason = "one macro serves both widths")]
            #[allow(clippy::cast_lossless, trivial_numeric_casts, reason = "one macro serves both widths")]
            const EPSILON: f64 = $float::EPSILON as f64;

            #[inline]
            #[expect(clippy::allow_attributes, reason = "one macro serves both widths")]
            #[allow(clippy::cast_possible_truncation, reason = "f32 is asked for to see what it loses")]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline]
            #[expect(clippy::allow_attributes, reason = "one macro serves both widths")]
            #[allow(clippy::cast_lossless, reason = "one macro serves both widths")]
            fn to_f64(self) -> f64 {
                self as f64
            }
            #[inline]
            fn sqrt(self) -> Self {
                $float::sqrt(self)
            }
            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }
            #[inline]
            fn least(self) -> f64 {
                self.to_f64()
            }
            #[inline]
            fn greatest(self) -> f64 {
                self.to_f64()
            }
            #[inline]
            fn clamp_negative(self) -> Self {
                if self < 0.0 { 0.0 } else { self }
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $float::sin_cos(self)
            }
        }
    };
}

primitive!(f32);
primitive!(f64);
