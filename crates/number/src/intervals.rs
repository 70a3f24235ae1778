//! Intervals, eight side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Lanes, Real};

/// Eight intervals, each given by its middle and its radius.
///
/// A formula evaluated over intervals encloses, but for rounding, what it gives for all numbers in them. So it shows that
/// a quantity keeps away from a limit between two samples. Each operation takes its operands as independent, which makes the
/// result of a long formula wider than need be. A radius that is NaN says that nothing is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Intervals {
    /// The middles.
    pub middle: Lanes,
    /// Half of the widths.
    pub radius: Lanes,
}

impl Intervals {
    /// Lower ends.
    #[inline(always)]
    fn low(self) -> Lanes {
        self.middle - self.radius
    }
}

/// The lanes that exceed zero, NaN for the others: what is divided by them is then unknown.
#[inline(always)]
fn positive(lanes: Lanes) -> Lanes {
    Lanes::of(|lane| if lanes.0[lane] > 0.0 { lanes.0[lane] } else { f64::NAN })
}

impl Add for Intervals {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { middle: self.middle + other.middle, radius: self.radius + other.radius }
    }
}

impl Sub for Intervals {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { middle: self.middle - other.middle, radius: self.radius + other.radius }
    }
}

impl Mul for Intervals {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let own = self.radius * (other.middle.abs() + other.radius);
        Self { middle: self.middle * other.middle, radius: own + self.middle.abs() * other.radius }
    }
}

impl Div for Intervals {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let middle = self.middle / other.middle;
        let least = positive(other.middle.abs() - other.radius);
        Self { middle, radius: (self.radius + middle.abs() * other.radius) / least }
    }
}

impl Neg for Intervals {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { middle: -self.middle, ..self }
    }
}

crate::real::assigning!(Intervals);

impl Real for Intervals {
    const ZERO: Self = Self { middle: Lanes::ZERO, radius: Lanes::ZERO };
    const ONE: Self = Self { middle: Lanes::ONE, radius: Lanes::ZERO };
    const EPSILON: f64 = f64::EPSILON;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self { middle: Lanes::from_f64(value), radius: Lanes::ZERO }
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.middle.to_f64()
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let middle = self.middle.sqrt();
        // sqrt(a) - sqrt(b) = (a - b) / (sqrt(a) + sqrt(b)), greatest at the lower end.
        Self { middle, radius: self.radius / (middle + self.low().sqrt()) }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self { middle: self.middle.abs(), ..self }
    }
    #[inline(always)]
    fn least(self) -> f64 {
        self.low().least()
    }
    #[inline(always)]
    fn greatest(self) -> f64 {
        (self.middle + self.radius).greatest()
    }
    #[inline(always)]
    fn at_least(self, limit: f64) -> bool {
        self.low().at_least(limit)
    }
    #[inline(always)]
    fn exceeds(self, limit: f64) -> bool {
        self.low().exceeds(limit)
    }
    #[inline(always)]
    fn clamp_negative(self) -> Self {
        Self { middle: self.middle.clamp_negative(), ..self }
    }
    #[inline(always)]
    fn sign(self) -> Self {
        let known = |lane: usize| self.middle.0[lane].abs() > self.radius.0[lane];
        let radius = Lanes::of(|lane| if known(lane) { 0.0 } else { f64::NAN });
        Self { middle: self.middle.sign(), radius }
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.middle.sin_cos();
        (Self { middle: sine, ..self }, Self { middle: cosine, ..self })
    }
}
