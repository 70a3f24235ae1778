//! What a formula is evaluated with: numbers, or intervals of them.

use crate::program::{Function, Kind};

/// A number or an interval of numbers.
pub(crate) trait Number: Copy {
    fn of(value: f64) -> Self;
    fn negate(self) -> Self;
    fn add(self, other: Self) -> Self;
    fn multiply(self, other: Self) -> Self;
    fn divide(self, other: Self) -> Self;
    fn power(self, exponent: Self) -> Self;
    fn atan2(self, x: Self) -> Self;
    fn call(self, function: Function) -> Self;
    /// The value of a function with a switch; `other` is the second argument of `min` and `max`.
    fn switch(self, kind: Kind, other: Self) -> Self;
}

/// The value of a function with a switch on a given side of it: whether its argument (of `min` and `max` the difference of
/// both) is not negative.
pub(crate) fn on_side(kind: Kind, one: f64, other: f64, not_negative: bool) -> f64 {
    match (kind, not_negative) {
        (Kind::Sign | Kind::Step, true) => 1.0,
        (Kind::Sign, false) => -1.0,
        (Kind::Step, false) => 0.0,
        (Kind::Abs | Kind::Max, true) | (Kind::Min, false) => one,
        (Kind::Abs, false) => -one,
        (Kind::Max, false) | (Kind::Min, true) => other,
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
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
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
            Kind::Sign if self == 0.0 => 0.0,
            Kind::Sign | Kind::Step | Kind::Abs => on_side(kind, self, other, self >= 0.0),
            Kind::Min | Kind::Max => on_side(kind, self, other, self >= other),
        }
    }
}
