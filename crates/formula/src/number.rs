//! What a formula is evaluated with: numbers, or intervals of them.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use crate::program::{Function, Kind};

/// A number or an interval of numbers.
pub(crate) trait Number: Copy {
    fn of(value: f64) -> Self;
    fn negate(self) -> Self;
    fn add(self, other: Self) -> Self;
    fn multiply(self, other: Self) -> Self;
    fn divide(self, other: Self) -> Self;
    fn power(self, exponent: Self) -> Self;
    fn call(self, function: Function) -> Self;
    /// The value of a function with a switch; `other` is the second argument of `min`, `max` and `atan2`.
    fn switch(self, kind: Kind, other: Self) -> Self;

    /// The value of a function with a switch on a given side of it, continued smoothly beyond the switch.
    #[inline]
    fn on_side(self, kind: Kind, other: Self, side: Sign) -> Self {
        match (kind, side) {
            (Kind::Sign | Kind::Step, Sign::Positive) | (Kind::Step, Sign::Zero) => Self::of(1.0),
            (Kind::Sign, Sign::Zero) | (Kind::Step, Sign::Negative) => Self::of(0.0),
            (Kind::Sign, Sign::Negative) => Self::of(-1.0),
            (Kind::Abs | Kind::Max, Sign::Positive) | (Kind::Min, Sign::Negative) => self,
            (Kind::Abs, Sign::Negative) => self.negate(),
            (Kind::Max, Sign::Negative) | (Kind::Min, Sign::Positive) => other,
            (Kind::Abs | Kind::Min | Kind::Max, Sign::Zero) => self.switch(kind, other),
            (Kind::Angle, side) => self.switch(kind, other).continued(self, other, side),
        }
    }

    /// This angle of the point with the ordinate `y` and the abscissa `x`, a turn away where the point has passed the
    /// negative half of the axis from this side.
    fn continued(self, y: Self, x: Self, side: Sign) -> Self;
}

/// The sign of a number that may be zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Zero.
    Zero,
    /// Greater than zero.
    Positive,
}

impl Sign {
    /// The sign of a number; `None` of what is not one.
    pub fn of(value: f64) -> Option<Self> {
        Some(match value.partial_cmp(&0.0)? {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        })
    }
}

/// The turn by which an angle is continued beyond the negative half of the axis.
pub(crate) fn turn(angle: f64, x: f64, side: Sign) -> f64 {
    match side {
        Sign::Positive if x < 0.0 && angle < 0.0 => TAU,
        Sign::Negative if x < 0.0 && angle > 0.0 => -TAU,
        _ => 0.0,
    }
}

impl Number for f64 {
    fn of(value: f64) -> Self {
        value
    }
    fn negate(self) -> Self {
        -self
    }
    fn add(self, other: Self) -> Self {
        self + other
    }
    fn multiply(self, other: Self) -> Self {
        self * other
    }
    fn divide(self, other: Self) -> Self {
        self / other
    }
    fn power(self, exponent: Self) -> Self {
        self.powf(exponent)
    }
    fn call(self, function: Function) -> Self {
        match function {
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
            Function::Tan => self.tan(),
            Function::Asin => self.asin(),
            Function::Acos => self.acos(),
            Function::Atan => self.atan(),
            Function::Sqrt => self.sqrt(),
            Function::Exp => self.exp(),
            Function::Ln => self.ln(),
        }
    }
    fn switch(self, kind: Kind, other: Self) -> Self {
        match kind {
            Kind::Angle => self.atan2(other),
            Kind::Abs => self.abs(),
            // What is not a number stays so.
            Kind::Min | Kind::Max if self.is_nan() || other.is_nan() => Self::NAN,
            Kind::Min => self.min(other),
            Kind::Max => self.max(other),
            Kind::Sign | Kind::Step => {
                Sign::of(self).map_or(Self::NAN, |side| self.on_side(kind, other, side))
            }
        }
    }
    fn continued(self, _: Self, x: Self, side: Sign) -> Self {
        self + turn(self, x, side)
    }
}
