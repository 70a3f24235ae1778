//! The regime by running in time with dop853 until it settles: a method of its own, and the judge of the others.

use std::hint::black_box;

use assur_integrator::{Request, State, find};

use super::{Cycle, MOST_CYCLES, NEVER_SETTLES, verdict};
use crate::chart::entry::{Contestant, Verdict};
use crate::chart::motion::Task;
use crate::chart::{Options, Reference};

const METHOD: &str = "dop853";

/// Tolerance of the steps of the judge.
const TIGHT: f64 = 1e-14;

/// Two independent answers that judge each other's methods.
pub(super) struct Judges {
    /// Speed at the start of the cycle by dop853.
    pub(super) in_time: f64,
    /// The same by shooting.
    pub(super) shooting: f64,
    pub(super) reference: Reference,
}

impl Judges {
    pub(super) fn find(cycle: &Cycle<'_>) -> Self {
        let task = cycle.task(1);
        let shooting = task.request.initial.speed;
        let multiplier = cycle.regime.multiplier;
        let once = turn(&task, shooting, TIGHT);
        let (in_time, how) = match once {
            Ok(end) if multiplier < NEVER_SETTLES => (
                fixed_point(&task, shooting, end.0, multiplier),
                "speed at the start of the cycle: the fixed point of one cycle by dop853 at tolerance 1e-14, for all methods \
                 on collocation panels; shooting, for dop853; own error by their difference",
            ),
            Ok(end) => (
                end.0,
                "speed at the end of the found cycle, run in time by dop853 at tolerance 1e-14 (it must equal that at the start)",
            ),
            Err(_) => (shooting, "shooting itself: dop853 fails on the cycle"),
        };
        // Speeds are known to a few roundings at best.
        let error = ((in_time - shooting) / shooting).abs().max(1e-15);
        let free = multiplier >= NEVER_SETTLES;
        let reference = Reference { how: how.to_owned(), error: if free { TIGHT } else { error } };
        Self { in_time, shooting, reference }
    }
}

/// Newton's method on "the speed after a cycle is that before", with the known multiplier.
fn fixed_point(task: &Task<'_>, start: f64, end: f64, multiplier: f64) -> f64 {
    let mut speed = start + (end - start) / (1.0 - multiplier);
    for _ in 0..2 {
        if let Ok((end, _)) = turn(task, speed, TIGHT) {
            speed += (end - speed) / (1.0 - multiplier);
        }
    }
    speed
}

/// One cycle from a speed: the speed at its end, and evaluations.
fn turn(task: &Task<'_>, speed: f64, tolerance: f64) -> Result<(f64, usize), String> {
    let plugin = find(METHOD).map_err(|error| error.to_string())?;
    let initial = State { speed, ..task.request.initial };
    let request = Request { initial, tolerance, samples: 1, ..task.request };
    let found = plugin.solve(&mut task.motion.clone(), &request);
    let found = found.map_err(|error| error.to_string())?;
    Ok((found.end.speed, found.statistics.evaluations))
}

/// Cycle after cycle from the mean speed, the steps as exact as the regime is wanted.
pub(super) struct InTime<'a> {
    pub(super) cycle: &'a Cycle<'a>,
    pub(super) tolerance: f64,
    pub(super) truth: f64,
    pub(super) options: Options,
}

impl InTime<'_> {
    fn solve(&self) -> Result<(f64, usize), String> {
        let task = self.cycle.task(1);
        let (mut speed, mut count) = (self.cycle.request.mean_speed, 0);
        for _ in 0..MOST_CYCLES {
            let (end, evaluations) = turn(&task, speed, self.tolerance)?;
            count += evaluations;
            let done = ((end - speed) / speed).abs() <= self.tolerance;
            speed = end;
            if done {
                return Ok((speed, count));
            }
            if count > 10 * self.options.max_steps {
                return Err(format!("not settled after {count} evaluations"));
            }
        }
        Err(format!("not settled after {MOST_CYCLES} cycles"))
    }
}

impl Contestant for InTime<'_> {
    fn run(&mut self) {
        let _ = black_box(self.solve());
    }

    fn judge(&mut self) -> Verdict {
        verdict(self.solve(), self.truth)
    }
}
