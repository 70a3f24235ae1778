//! Control of the global error of a motion, which the control of the local error of each step can't ensure: local
//! errors may grow, and the motion of a stiff or unstable equation may follow a wrong branch at a loose tolerance.

use crate::{EquationOfMotion, IntegrationError, IntegratorPlugin, Knob, Request, Trajectory};

/// Each run is compared with one at this fraction of its tolerance.
const FINER: f64 = 0.1;

/// Estimated errors of up to this many tolerances are accepted; the true error is then at most ten tolerances.
const ACCEPTED: f64 = 3.0;

/// Refinements after which the motion counts as too sensitive for its tolerance.
const MOST_REFINEMENTS: usize = 6;

/// Most steps of a finer run: this multiple of the steps of the run before (a method of order 5 needs 1.6), and a
/// constant.
const MOST_GROWTH: usize = 6;
const FEW_STEPS: usize = 1000;

/// Tolerance below which only rounding errors remain.
const LEAST_TOLERANCE: f64 = 1e-15;

/// Solves the equation to the tolerance for the motion as a whole: with finer and finer steps, until a still finer run
/// gives the same motion. The estimated error is in [`SolutionCost::error`](crate::SolutionCost::error).
pub(crate) fn solve(
    plugin: &IntegratorPlugin,
    motion: &mut dyn EquationOfMotion,
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
    /// Largest difference between the samples of two solutions of one request: speeds relative to the largest speed,
    /// coordinates to the largest displacement, times to the duration.
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
