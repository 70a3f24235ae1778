//! The first step, and the fixed step where the user gives none.

use crate::{Equation, FixedStep, Node, Request, Until};

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
pub(crate) fn fixed(request: &Request, node: &Node) -> f64 {
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
pub(crate) fn adaptive(
    equation: &mut Equation<'_>,
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
    (2.0 * time * tolerance.powf(1.0 / order)).min(longest)
}
