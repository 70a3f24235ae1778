//! Interval arithmetic: bounds of a formula over a range of its variables.
//!
//! The bounds are not rounded outward: what is searched with them ends at a distance of many roundings.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur_number::elementary;

use crate::number::Number;
use crate::program::{Function, Kind, Sign};
use crate::slope::Signed;

/// All numbers between two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interval {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Interval {
    const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    pub(crate) fn between(a: f64, b: f64) -> Self {
        Self { low: a.min(b), high: a.max(b) }
    }

    /// Whether it contains zero, or nothing is known of it.
    pub(crate) fn may_be_zero(self) -> bool {
        !(self.low > 0.0 || self.high < 0.0)
    }

    fn hull(values: impl IntoIterator<Item = f64>) -> Self {
        let mut found = Self { low: f64::INFINITY, high: f64::NEG_INFINITY };
        for value in values {
            if value.is_nan() {
                return Self::WHOLE;
            }
            found = Self { low: found.low.min(value), high: found.high.max(value) };
        }
        found
    }

    /// The angles of the points of a rectangle.
    fn angle(self, x: Self) -> Self {
        // Away from the branch cut the extremes are at corners.
        if x.low > 0.0 || !self.may_be_zero() {
            let corners = [self.low, self.high]
                .into_iter()
                .flat_map(|y| [elementary::atan2(y, x.low), elementary::atan2(y, x.high)]);
            return Self::hull(corners);
        }
        Self { low: -PI, high: PI }
    }

    fn ends(self, function: impl Fn(f64) -> f64) -> Self {
        Self::hull([function(self.low), function(self.high)])
    }

    /// Whether it contains `offset` plus a whole multiple of `period`.
    fn meets(self, offset: f64, period: f64) -> bool {
        ((self.high - offset) / period).floor() >= ((self.low - offset) / period).ceil()
    }

    fn cosine(self) -> Self {
        let width = self.high - self.low;
        if width.is_nan() || width >= TAU {
            return Self { low: -1.0, high: 1.0 };
        }
        let ends = self.ends(elementary::cos);
        Self {
            low: if self.meets(PI, TAU) { -1.0 } else { ends.low },
            high: if self.meets(0.0, TAU) { 1.0 } else { ends.high },
        }
    }
}

impl Signed for Interval {
    /// The sign that all its numbers have.
    fn sign(self) -> Option<Sign> {
        Sign::of(self.low).filter(|sign| Sign::of(self.high) == Some(*sign))
    }
}

impl Number for Interval {
    fn of(value: f64) -> Self {
        Self { low: value, high: value }
    }

    fn negate(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    fn add(self, other: Self) -> Self {
        Self::hull([self.low + other.low, self.high + other.high])
    }

    fn multiply(self, other: Self) -> Self {
        Self::hull([self.low, self.high].into_iter().flat_map(|a| [a * other.low, a * other.high]))
    }

    fn divide(self, other: Self) -> Self {
        if other.may_be_zero() { Self::WHOLE } else { self.multiply(other.ends(f64::recip)) }
    }

    fn power(self, exponent: Self) -> Self {
        let whole = exponent.low.total_cmp(&exponent.high).is_eq() && exponent.low.fract() == 0.0;
        if !whole && self.low < 0.0 {
            return Self::WHOLE;
        }
        // Monotone in each variable on either side of zero; an even power has its extreme there.
        if self.may_be_zero() && self.low != 0.0 && exponent.low < 0.0 {
            return Self::WHOLE;
        }
        let ends = [self.low, self.high]
            .into_iter()
            .flat_map(|a| [elementary::powf(a, exponent.low), elementary::powf(a, exponent.high)]);
        let extreme = if self.may_be_zero() { Some(elementary::powf(0.0_f64, exponent.low)) } else { None };
        Self::hull(ends.chain(extreme))
    }

    fn call(self, function: Function) -> Self {
        match function {
            Function::Cos => self.cosine(),
            Function::Sin => self.add(Self::of(-FRAC_PI_2)).cosine(),
            Function::Tan if self.meets(FRAC_PI_2, PI) => Self::WHOLE,
            // Monotone; a bound outside the domain is NaN, which makes the whole line of it.
            _ => self.ends(|x| x.call(function)),
        }
    }

    fn switch(self, kind: Kind, other: Self) -> Self {
        match kind {
            Kind::Sign | Kind::Step => self.ends(|x| x.switch(kind, 0.0)),
            Kind::Angle => self.angle(other),
            Kind::Abs if self.may_be_zero() => Self { low: 0.0, high: self.high.max(-self.low) },
            Kind::Abs => self.ends(f64::abs),
            Kind::Min => Self { low: self.low.min(other.low), high: self.high.min(other.high) },
            Kind::Max => Self { low: self.low.max(other.low), high: self.high.max(other.high) },
        }
    }

    /// Not needed: arguments of switches are bounded by their own values, on no side.
    fn continued(self, _: Self, _: Self, _: Sign) -> Self {
        Self::WHOLE
    }
}
