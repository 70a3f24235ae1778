//! The derivative of a formula by a variable: forward differentiation along with the value (A. Griewank, A. Walther, Evaluating
//! Derivatives, section 3.1).

use crate::number::{Number, Scalar};
use crate::program::{Function, Kind, Sign};

/// A number whose sign can be determined, so that a constant is known to be one.
pub(crate) trait Signed: Number {
    /// Its sign; `None` of what is not a number.
    fn sign(self) -> Option<Sign>;

    /// Whether it is zero and nothing else.
    fn is_zero(self) -> bool {
        self.sign() == Some(Sign::Zero)
    }
}

impl<T: Scalar> Signed for T {
    fn sign(self) -> Option<Sign> {
        Sign::of(self.to_f64())
    }
}

impl<T: Scalar> Signed for Dual<T> {
    fn sign(self) -> Option<Sign> {
        Signed::sign(self.value)
    }

    fn is_zero(self) -> bool {
        Signed::is_zero(self.value) && Signed::is_zero(self.slope)
    }
}

/// A number with its derivative with respect to one variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual<N> {
    pub(crate) value: N,
    pub(crate) slope: N,
}

impl<N: Signed> Dual<N> {
    /// The chain rule: a function's value, and its derivative with respect to its argument.
    fn through(self, value: N, derivative: N) -> Self {
        // What does not vary has no slope, even where the function has a pole.
        let slope = if self.slope.is_zero() { self.slope } else { derivative.multiply(self.slope) };
        Self { value, slope }
    }
}

impl<N: Signed> Number for Dual<N> {
    fn of(value: f64) -> Self {
        Self { value: N::of(value), slope: N::of(0.0) }
    }

    fn negate(self) -> Self {
        Self { value: self.value.negate(), slope: self.slope.negate() }
    }

    fn add(self, other: Self) -> Self {
        Self { value: self.value.add(other.value), slope: self.slope.add(other.slope) }
    }

    fn multiply(self, other: Self) -> Self {
        let slope = self.slope.multiply(other.value).add(self.value.multiply(other.slope));
        Self { value: self.value.multiply(other.value), slope }
    }

    fn divide(self, other: Self) -> Self {
        let value = self.value.divide(other.value);
        let slope = self.slope.add(value.multiply(other.slope).negate()).divide(other.value);
        Self { value, slope }
    }

    fn power(self, exponent: Self) -> Self {
        let value = self.value.power(exponent.value);
        if exponent.value.is_zero() && exponent.slope.is_zero() {
            // 1, of a base of zero too, where the rule would give 0 times 1/0.
            return Self { value, slope: N::of(0.0) };
        }
        let less = exponent.value.add(N::of(-1.0));
        let by_base = self.through(value, exponent.value.multiply(self.value.power(less)));
        let logarithm = || value.multiply(self.value.call(Function::Ln));
        let slope = if exponent.slope.is_zero() {
            by_base.slope
        } else {
            by_base.slope.add(logarithm().multiply(exponent.slope))
        };
        Self { value, slope }
    }

    fn call(self, function: Function) -> Self {
        let (x, one) = (self.value, N::of(1.0));
        let value = x.call(function);
        let derivative = match function {
            Function::Sin => x.call(Function::Cos),
            Function::Cos => x.call(Function::Sin).negate(),
            Function::Tan => one.add(value.multiply(value)),
            Function::Asin | Function::Acos => {
                let steep = one.divide(one.add(x.multiply(x).negate()).call(Function::Sqrt));
                if function == Function::Asin { steep } else { steep.negate() }
            }
            Function::Atan => one.divide(one.add(x.multiply(x))),
            Function::Sqrt => one.divide(value.add(value)),
            Function::Exp => value,
            Function::Ln => one.divide(x),
        };
        self.through(value, derivative)
    }

    fn switch(self, kind: Kind, other: Self) -> Self {
        let value = self.value.switch(kind, other.value);
        let apart = self.value.add(other.value.negate()).sign();
        let chosen = match (kind, apart) {
            (Kind::Min, Some(Sign::Positive)) | (Kind::Max, Some(Sign::Negative)) => other,
            _ => self,
        };
        let slope = match kind {
            Kind::Sign | Kind::Step => N::of(0.0),
            Kind::Abs if self.value.sign() == Some(Sign::Negative) => self.slope.negate(),
            Kind::Abs | Kind::Min | Kind::Max => chosen.slope,
            Kind::Angle => {
                let (y, x) = (self, other);
                let turning = y.slope.multiply(x.value).add(x.slope.multiply(y.value).negate());
                turning.divide(x.value.multiply(x.value).add(y.value.multiply(y.value)))
            }
        };
        Self { value, slope }
    }

    fn continued(self, y: Self, x: Self, side: Sign) -> Self {
        Self { value: self.value.continued(y.value, x.value, side), ..self }
    }
}
