//! Control of the step size: the norm of an error, and the proportional-integral controller.

use assur_number::elementary;

use crate::{CountedEquation, FixedStep, Node, Request, State, Until};

/// Constants of the controller of step sizes (Gustafsson; Hairer, Wanner II, IV.2):
/// factor = safety · error^-`proportional` · `error_before`^`integral`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Control {
    /// Exponent of the present error.
    pub proportional: f64,
    /// Exponent of the error of the step before: damps the alternation of too long and too short steps. 0: plain
    /// control.
    pub integral: f64,
    /// Safety factor: the part of the computed step that is tried.
    pub safety: f64,
    /// Least factor between steps.
    pub shrink: f64,
    /// Greatest factor between steps.
    pub grow: f64,
    /// Order of the error estimate, for the first step.
    pub order: f64,
}

impl Control {
    /// Factor to the next step after an accepted one.
    #[inline]
    pub fn after_accepted(&self, error: f64, error_before: f64) -> f64 {
        let error = error.max(1e-10);
        let factor = self.safety
            * elementary::powf(error, -self.proportional)
            * elementary::powf(error_before, self.integral);
        factor.clamp(self.shrink, self.grow)
    }

    /// Factor to the next trial after a rejected one: by the present error alone.
    #[inline]
    pub fn after_rejected(&self, error: f64) -> f64 {
        if !error.is_finite() {
            return self.shrink;
        }
        (self.safety * elementary::powf(error, -1.0 / self.order)).clamp(self.shrink, 0.9)
    }
}

/// The scale of errors: the tolerance times the largest speed and the largest displacement since the start, because the
/// motion as a whole must be right, not a passage through zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Requested relative accuracy.
    pub tolerance: f64,
    origin: f64,
    travel: f64,
    speed: f64,
}

impl Scale {
    /// Starts at `state`.
    pub fn new(tolerance: f64, state: &State) -> Self {
        Self { tolerance, origin: state.coordinate, travel: 0.0, speed: state.speed.abs() }
    }

    /// Updates the largest displacement and speed.
    #[inline]
    pub fn extend(&mut self, state: &State) {
        self.travel = self.travel.max((state.coordinate - self.origin).abs());
        self.speed = self.speed.max(state.speed.abs());
    }

    /// Largest speed since the start, rad/s (m/s).
    pub fn fastest(&self) -> f64 {
        self.speed
    }

    /// Allowed errors of coordinate and speed at the end of a step.
    #[inline]
    pub fn allowed(&self, end: &State) -> [f64; 2] {
        /// Unit roundings of the coordinate that no step can avoid.
        const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
        let travel = self.travel.max((end.coordinate - self.origin).abs());
        let speed = self.speed.max(end.speed.abs());
        [
            (self.tolerance * travel).max(ROUNDINGS * end.coordinate.abs()).max(f64::MIN_POSITIVE),
            (self.tolerance.max(ROUNDINGS) * speed).max(f64::MIN_POSITIVE),
        ]
    }

    /// Root mean square of the errors over what is allowed.
    #[inline]
    pub fn norm(&self, end: &State, coordinate: f64, speed: f64) -> f64 {
        let [q, w] = self.allowed(end);
        let (q, w) = (coordinate / q, speed / w);
        (0.5 * (q * q + w * w)).sqrt()
    }
}

/// Number of steps of a motion at a fixed step, where the request gives no step.
const FIXED_STEPS: f64 = 1000.0;

/// Time in which uniformly accelerated motion covers about `distance`.
fn time_for(distance: f64, node: &Node) -> f64 {
    let (w, a) = (node.state.speed.abs(), node.acceleration.abs());
    // w x + a x²/2 = d, without cancellation.
    2.0 * distance / (w + (w * w + 2.0 * a * distance).sqrt())
}

/// The fixed step: the requested one, else a thousandth of the duration; for an end by coordinate or rest, of the
/// duration of uniformly accelerated motion.
pub(crate) fn fixed_step(request: &Request, node: &Node) -> f64 {
    match request.fixed_step {
        Some(FixedStep::Time(step)) => return step,
        Some(FixedStep::Coordinate(way)) => return time_for(way, node),
        None => {}
    }
    let start = node.state.time;
    let duration = match request.until {
        Until::Time(end) => end - start,
        Until::Coordinate(target) => time_for((target - node.state.coordinate).abs(), node),
        Until::Turn | Until::Rest if node.state.speed == 0.0 => time_for(1.0, node),
        Until::Turn | Until::Rest => (node.state.speed / node.acceleration).abs(),
    };
    let duration = duration.min(request.time_limit - start);
    if duration.is_finite() { duration / FIXED_STEPS } else { time_for(1.0, node) / FIXED_STEPS }
}

/// First step of an adaptive method whose error estimate has that order: chosen from the change of the acceleration
/// along a short trial step, for a local error near the tolerance.
pub(crate) fn first_step(
    equation: &mut CountedEquation<'_>,
    node: &Node,
    tolerance: f64,
    order: f64,
    longest: f64,
) -> f64 {
    /// Displacement over which a mechanism changes little, rad (m).
    const SHORT: f64 = 0.02;
    let trial = time_for(SHORT, node).min(0.1 * longest);
    let there = node.advanced(trial);
    let there = equation.acceleration(&there);
    // The trial state has no position: a short step then.
    let Ok(there) = there else { return 1e-3 * trial };
    let change = (there - node.acceleration).abs() / trial;
    let size = node.acceleration.abs().max(there.abs()).max(node.state.speed.abs() / trial * 0.1);
    let time = (size / change).min(50.0 * trial);
    let time = if time.is_finite() { time } else { 50.0 * trial };
    (2.0 * time * elementary::powf(tolerance, 1.0 / order)).min(longest)
}

#[cfg(test)]
mod tests;
