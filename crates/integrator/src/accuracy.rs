//! Control of the error of a whole motion, which the control of each step can't promise: what a step loses may grow, and
//! the motion of a stiff or unstable equation may follow a wrong branch at a loose tolerance.

use crate::{IntegrationError, IntegratorPlugin, Knob, Motion, Request, Trajectory};

/// Each run is compared with one to this part of its tolerance.
const FINER: f64 = 0.1;

/// Estimated errors up to so many tolerances are accepted: the true one is at most ten.
const ACCEPTED: f64 = 3.0;

/// Refinements after which the motion counts as too sensitive for its tolerance.
const MOST_REFINEMENTS: usize = 6;

/// Most steps of a finer run: so many times those of the run before (a method of order 5 needs 1.6 times), and some.
const MOST_GROWTH: usize = 6;
const FEW_STEPS: usize = 1000;

/// Tolerance below which nothing but roundings is left to refine.
const LEAST_TOLERANCE: f64 = 1e-15;

/// Solves the equation so that the motion as a whole keeps the tolerance: with finer and finer steps, until a still finer run
/// gives the same motion. What the result may be off is its [`Statistics::error`](crate::Statistics::error).
///
/// # Errors
///
/// [`IntegrationError`] of the first run. Where a finer one fails, the result is that of the run before.
pub(crate) fn solve(
    plugin: &IntegratorPlugin,
    motion: &mut dyn Motion,
    request: &Request,
) -> Result<Trajectory, IntegrationError> {
    let mut found = plugin.solve(motion, request)?;
    if plugin.knob != Knob::Tolerance || plugin.order == 0 {
        return Ok(found);
    }
    let mut tolerance = request.tolerance;
    for _ in 0..MOST_REFINEMENTS {
        tolerance *= FINER;
        if tolerance < LEAST_TOLERANCE {
            break;
        }
        let steps = found.statistics.steps + found.statistics.rejected;
        let max_steps = request.max_steps.min(MOST_GROWTH * steps + FEW_STEPS);
        let finer = plugin.solve(motion, &Request { tolerance, max_steps, ..*request });
        let Ok(mut finer) = finer else { break };
        let error = found.deviation(&finer);
        found.statistics.error = Some(error);
        if error <= ACCEPTED * request.tolerance {
            break;
        }
        finer.statistics.error = Some(error);
        found = finer;
    }
    Ok(found)
}

impl Trajectory {
    /// Largest difference between the samples of two solutions of the same request: of the speeds as a part of the largest
    /// speed, of the coordinates as a part of the travel, of the times as a part of the duration.
    pub fn deviation(&self, other: &Self) -> f64 {
        let Some((first, last)) = self.samples.first().zip(self.samples.last()) else { return 0.0 };
        let duration = last.time - first.time;
        let (mut fastest, mut travel) = (f64::MIN_POSITIVE, f64::MIN_POSITIVE);
        for sample in &self.samples {
            fastest = fastest.max(sample.speed.abs());
            travel = travel.max((sample.coordinate - first.coordinate).abs());
        }
        let pairs = self.samples.iter().zip(&other.samples);
        pairs.fold(0.0, |worst, (a, b)| {
            let speed = (a.speed - b.speed).abs() / fastest;
            let way = (a.coordinate - b.coordinate).abs() / travel;
            let time = (a.time - b.time).abs() / duration.max(f64::MIN_POSITIVE);
            worst.max(speed).max(way).max(time)
        })
    }
}
