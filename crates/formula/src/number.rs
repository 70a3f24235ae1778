//! What a formula is evaluated with: numbers, or intervals of them.

use std::f64::consts::TAU;

use assur_number::{Real, elementary};

use crate::program::{Function, Kind, Sign};

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

/// The turn by which an angle is continued beyond the negative half of the axis.
pub(crate) fn turn(angle: f64, x: f64, side: Sign) -> f64 {
    match side {
        Sign::Positive if x < 0.0 && angle < 0.0 => TAU,
        Sign::Negative if x < 0.0 && angle > 0.0 => -TAU,
        _ => 0.0,
    }
}

/// A number of some precision, with the functions that not every [`Real`] has.
pub(crate) trait Scalar: Real {
    /// This number raised to a power.
    fn power(self, exponent: Self) -> Self;
    /// The value of a smooth function.
    fn call(self, function: Function) -> Self;
    /// The angle of a point; this is its ordinate.
    fn angle(self, x: Self) -> Self;
    /// The sign of this number less another one; `None` where one of them is not a number.
    fn compared(self, other: Self) -> Option<Sign>;
}

impl<T: Scalar> Number for T {
    fn of(value: f64) -> Self {
        Self::from_f64(value)
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
        Scalar::power(self, exponent)
    }
    fn call(self, function: Function) -> Self {
        Scalar::call(self, function)
    }
    fn switch(self, kind: Kind, other: Self) -> Self {
        // What is not a number stays so.
        let not_a_number = Self::from_f64(f64::NAN);
        match kind {
            Kind::Angle => self.angle(other),
            Kind::Abs => Real::abs(self),
            Kind::Min | Kind::Max => match self.compared(other) {
                None => not_a_number,
                Some(Sign::Positive) if kind == Kind::Min => other,
                Some(Sign::Negative) if kind == Kind::Max => other,
                Some(_) => self,
            },
            Kind::Sign | Kind::Step => {
                Sign::of(self.to_f64()).map_or(not_a_number, |side| self.on_side(kind, other, side))
            }
        }
    }
    fn continued(self, _: Self, x: Self, side: Sign) -> Self {
        self + Self::from_f64(turn(self.to_f64(), x.to_f64(), side))
    }
}

impl Scalar for f64 {
    fn power(self, exponent: Self) -> Self {
        elementary::powf(self, exponent)
    }
    fn call(self, function: Function) -> Self {
        match function {
            Function::Sin => elementary::sin(self),
            Function::Cos => elementary::cos(self),
            Function::Tan => elementary::tan(self),
            Function::Asin => elementary::asin(self),
            Function::Acos => elementary::acos(self),
            Function::Atan => elementary::atan(self),
            Function::Sqrt => self.sqrt(),
            Function::Exp => elementary::exp(self),
            Function::Ln => elementary::ln(self),
        }
    }
    fn angle(self, x: Self) -> Self {
        elementary::atan2(self, x)
    }
    fn compared(self, other: Self) -> Option<Sign> {
        // Not by the difference, which of two infinite numbers is none.
        self.partial_cmp(&other).map(Sign::from)
    }
}
