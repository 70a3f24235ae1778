//! Numbers with a bound of their rounding: a running error analysis (N. Higham, Accuracy and Stability of Numerical Algorithms,
//! section 3.3).

use std::f64::consts::{PI, TAU};

use assur_number::elementary;

use crate::number::{Number, turn};
use crate::program::{Function, Kind, Sign};
use crate::slope::Signed;

/// Rounding of one operation, as part of its result: functions of the standard library are good to a unit in the last
/// place.
const UNIT: f64 = f64::EPSILON;

/// A variable that misses a place by less than this part of its size, or of 1, counts as there; loads take the side ahead of a
/// switch within such a distance.
const NEAR: f64 = 1e-11;

/// A number and a bound of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rounded {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

impl Rounded {
    /// A variable whose rounding is `relative` to its size.
    pub(crate) fn variable(value: f64, relative: f64) -> Self {
        Self { value, error: relative * value.abs() }
    }

    /// A variable somewhere near its value.
    pub(crate) fn near(value: f64) -> Self {
        Self { value, error: NEAR * value.abs().max(1.0) }
    }

    /// A result with the error that it has from its arguments, and its own.
    fn result(value: f64, inherited: f64) -> Self {
        let error = inherited + UNIT * value.abs();
        Self { value, error: if error.is_nan() { f64::INFINITY } else { error } }
    }

    /// A monotone function: the error shows at the ends, as far as they lie in its domain.
    fn monotone(self, [low, high]: [f64; 2], function: impl Fn(f64) -> f64) -> Self {
        let Self { mut value, error } = self;
        // An argument may miss the domain by its error.
        if value < low && value + error >= low {
            value = low;
        } else if value > high && value - error <= high {
            value = high;
        }
        let result = function(value);
        let off = |end: f64| (function(end.clamp(low, high)) - result).abs();
        let inherited = if error == 0.0 { 0.0 } else { off(self.value - error).max(off(self.value + error)) };
        Self::result(result, inherited)
    }

    fn tangent(self) -> Self {
        let value = elementary::tan(self.value);
        let slope = 1.0 + value * value;
        // Within half of the distance to the pole the slope grows to four times at most.
        let near = slope.sqrt() * self.error < 0.5;
        Self::result(value, if near { 4.0 * slope * self.error } else { f64::INFINITY })
    }

    fn wave(self, value: f64, slope: f64) -> Self {
        let Self { error, .. } = self;
        Self::result(value, (slope.abs() * error + 0.5 * error * error).min(2.0))
    }

    /// The angle of a point; `self` is its ordinate.
    fn angle(self, x: Self) -> Self {
        let value = elementary::atan2(self.value, x.value);
        if self.error == 0.0 && x.error == 0.0 {
            return Self::result(value, 0.0);
        }
        let (far, off) = (elementary::hypot(self.value, x.value), elementary::hypot(self.error, x.error));
        let cut = x.value < 0.0 && self.value.abs() <= self.error;
        Self::result(value, if cut || off >= far { TAU } else { elementary::asin(off / far) })
    }
}

impl Signed for Rounded {
    /// Where the error leaves one; zero is certain without an error only.
    fn sign(self) -> Option<Sign> {
        let Self { value, error } = self;
        if value.abs() > error || (value == 0.0 && error == 0.0) { Sign::of(value) } else { None }
    }
}

impl Number for Rounded {
    fn of(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    fn negate(self) -> Self {
        Self { value: -self.value, ..self }
    }

    fn add(self, other: Self) -> Self {
        Self::result(self.value + other.value, self.error + other.error)
    }

    fn multiply(self, other: Self) -> Self {
        let [a, b] = [self, other];
        // A factor that is zero for certain makes zero.
        let part = |size: f64, error: f64| if error == 0.0 { 0.0 } else { size.abs() * error };
        let inherited = part(a.value, b.error) + part(b.value, a.error) + part(a.error, b.error);
        Self::result(a.value * b.value, inherited)
    }

    fn divide(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = other.value.abs() - other.error;
        let inherited = if self.error == 0.0 && other.error == 0.0 {
            0.0
        } else if least > 0.0 {
            (self.error + value.abs() * other.error) / least
        } else {
            f64::INFINITY
        };
        Self::result(value, inherited)
    }

    fn power(self, exponent: Self) -> Self {
        let whole = exponent.error == 0.0 && exponent.value.fract() == 0.0;
        // A base that is zero up to its error has no sign; only whole powers of others that are negative exist.
        let zero = self.value.abs() <= self.error;
        let base = if !whole && zero && self.value < 0.0 { 0.0 } else { self.value };
        let value = elementary::powf(base, exponent.value);
        if self.error == 0.0 && exponent.error == 0.0 {
            return Self::result(value, 0.0);
        }
        let bases = [self.value - self.error, self.value + self.error]
            .map(|base| if whole { base } else { base.max(0.0) });
        let exponents = [exponent.value - exponent.error, exponent.value + exponent.error];
        let corners =
            bases.into_iter().flat_map(|base| exponents.map(|exponent| elementary::powf(base, exponent)));
        let extreme = zero.then(|| elementary::powf(0.0_f64, exponent.value));
        let inherited = corners.chain(extreme).map(|corner| (corner - value).abs());
        // Not max(): it would drop what is not a number.
        Self::result(
            value,
            inherited.fold(0.0, |most, off| if off > most || off.is_nan() { off } else { most }),
        )
    }

    fn call(self, function: Function) -> Self {
        let of = |x: f64| x.call(function);
        let (anywhere, unit) = ([f64::NEG_INFINITY, f64::INFINITY], [-1.0, 1.0]);
        match function {
            Function::Sin => self.wave(of(self.value), elementary::cos(self.value)),
            Function::Cos => self.wave(of(self.value), elementary::sin(self.value)),
            Function::Tan => self.tangent(),
            Function::Asin | Function::Acos => self.monotone(unit, of),
            Function::Sqrt | Function::Ln => self.monotone([0.0, f64::INFINITY], of),
            Function::Atan | Function::Exp => self.monotone(anywhere, of),
        }
    }

    fn switch(self, kind: Kind, other: Self) -> Self {
        let value = self.value.switch(kind, other.value);
        match kind {
            Kind::Sign | Kind::Step => Self { value, error: if self.sign().is_some() { 0.0 } else { 2.0 } },
            Kind::Abs => Self { value, ..self },
            Kind::Angle => self.angle(other),
            Kind::Min | Kind::Max => {
                let apart = (self.value - other.value).abs() > self.error + other.error;
                let chosen = if value.total_cmp(&self.value).is_eq() { self } else { other };
                let error = if apart { chosen.error } else { self.error.max(other.error) };
                Self { value, error }
            }
        }
    }

    fn continued(self, _: Self, x: Self, side: Sign) -> Self {
        // Beyond the cut by its rounding only, the angle is known as well as on it.
        let turn = turn(self.value, x.value, side);
        Self { value: self.value + turn, error: self.error.min(2.0 * PI) }
    }
}
