//! The polynomial that a step leaves behind: the motion at any instant inside the step.

use crate::{Curve, Node, State};

/// Number of coefficients: degree 7, the dense output of dop853.
pub const COEFFICIENTS: usize = 8;

/// Motion inside one step, over θ = (t - `time`)/`step` in [0, 1], nested as
/// r0 + θ (r1 + (1-θ) (r2 + θ (r3 + (1-θ) (r4 + ...)))) (Hairer, Norsett, Wanner I, II.6): the coefficients after
/// the fourth don't change the ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dense {
    /// Time at θ = 0, s.
    pub time: f64,
    /// Length of the step, s.
    pub step: f64,
    /// Coefficients of the coordinate.
    pub coordinate: [f64; COEFFICIENTS],
    /// Coefficients of the speed.
    pub speed: [f64; COEFFICIENTS],
}

/// The nested polynomial at `theta`.
#[inline]
fn nested(r: &[f64; COEFFICIENTS], theta: f64) -> f64 {
    let rest = 1.0 - theta;
    let upper = r[4] + theta * (r[5] + rest * (r[6] + theta * r[7]));
    r[0] + theta * (r[1] + rest * (r[2] + theta * (r[3] + rest * upper)))
}

impl Dense {
    /// Uniformly accelerated motion (D 3.12, 3.13).
    pub fn parabola(from: &Node, step: f64) -> Self {
        let State { time, coordinate, speed } = from.state;
        let half = 0.5 * from.acceleration * step * step;
        let mut dense = Self { time, step, coordinate: [0.0; COEFFICIENTS], speed: [0.0; COEFFICIENTS] };
        // w0 h θ + a h²/2 θ² = θ (w0 h + a h²/2) - θ (1-θ) a h²/2
        dense.coordinate[..3].copy_from_slice(&[coordinate, speed * step + half, -half]);
        dense.speed[..2].copy_from_slice(&[speed, from.acceleration * step]);
        dense
    }

    /// Cubic polynomials through both ends of a step of `step` seconds, in value and slope.
    pub fn cubic(from: &Node, to: &Node, step: f64) -> Self {
        let slopes = [
            [step * from.state.speed, step * to.state.speed],
            [step * from.acceleration, step * to.acceleration],
        ];
        Self::with_slopes(&from.state, &to.state, step, slopes)
    }

    /// Cubic polynomials with these ends; `slopes` of coordinate and speed by θ at the ends.
    pub fn with_slopes(from: &State, to: &State, step: f64, slopes: [[f64; 2]; 2]) -> Self {
        let coordinate = cubic([from.coordinate, to.coordinate], slopes[0]);
        Self { time: from.time, step, coordinate, speed: cubic([from.speed, to.speed], slopes[1]) }
    }

    /// Hermite polynomials through both ends: degree 5 for the coordinate (value, speed, acceleration), 3 for the speed.
    pub fn hermite(from: &Node, to: &Node) -> Self {
        let step = to.state.time - from.state.time;
        let mut dense = Self::cubic(from, to, step);
        let half = 0.5 * step * step;
        let r = &mut dense.coordinate;
        r[4] = half * from.acceleration + r[2] - r[3];
        r[5] = half * to.acceleration + r[2] + 2.0 * r[3] - r[4];
        dense
    }

    /// State at `theta`.
    #[inline]
    pub fn at(&self, theta: f64) -> State {
        State {
            time: self.time + theta * self.step,
            coordinate: nested(&self.coordinate, theta),
            speed: nested(&self.speed, theta),
        }
    }
}

impl Curve for Dense {
    fn at(&self, _: &State, time: f64) -> State {
        State { time, ..self.at(((time - self.time) / self.step).clamp(0.0, 1.0)) }
    }
}

/// The cubic with these values and slopes (by θ) at both ends: the first four coefficients.
fn cubic([from, to]: [f64; 2], slopes: [f64; 2]) -> [f64; COEFFICIENTS] {
    let rise = to - from;
    let second = slopes[0] - rise;
    [from, rise, second, rise - slopes[1] - second, 0.0, 0.0, 0.0, 0.0]
}

#[cfg(test)]
mod tests;
