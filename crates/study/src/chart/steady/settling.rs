//! The regime by steps in time until the speed settles: a method in its own right, and the reference of the others.

use assur_integrator::{Cost, EquationOfMotion, IntegratorPlugin, Knob, Request, State, integrators};
use assur_words::{Describe, Text, name, number, text};

use super::{Cycle, MOST_CYCLES, NEVER_SETTLES};
use crate::chart::motion::Task;
use crate::chart::{ChartOptions, Reference};

const TIGHT: f64 = 1e-14;

/// The registered integrator that steps in time and suits an equation best at a tight tolerance.
pub(super) fn stepping(task: &Task<'_>) -> Option<&'static IntegratorPlugin> {
    let dependence = task.motion.dependence();
    let suits = |plugin: &&IntegratorPlugin| {
        let suitability = (plugin.suitability)(&dependence, TIGHT);
        plugin.knob == Knob::Tolerance && suitability.is_ok_and(|found| found.cost == Cost::Steps)
    };
    integrators().ok()?.into_iter().find(suits)
}

/// Two independent results, each the reference of the other's methods.
pub(super) struct Judges {
    pub(super) method: Option<&'static IntegratorPlugin>,
    /// Speed at the start of the cycle by that method.
    pub(super) in_time: f64,
    /// Speed at the start of the cycle by shooting.
    pub(super) shooting: f64,
    pub(super) reference: Reference,
}

impl Judges {
    pub(super) fn find(cycle: &Cycle<'_>) -> Self {
        let task = cycle.task(1);
        let shooting = task.request.initial.speed;
        let multiplier = cycle.regime.multiplier;
        let method = stepping(&task);
        let after_one = |speed| method.and_then(|method| Some(turn(method, &task, speed, TIGHT).ok()?.0));
        let by = |id| {
            let method = name(method.map_or("", |method| method.name));
            text!(id, method, tolerance = number(format_args!("{TIGHT:e}")))
        };
        let (in_time, how) = match after_one(shooting) {
            Some(end) if multiplier < NEVER_SETTLES => {
                // Newton's method for "the speed after a cycle equals that before", with the known multiplier.
                let next = |speed: f64, end: f64| speed + (end - speed) / (1.0 - multiplier);
                let mut speed = next(shooting, end);
                for _ in 0..2 {
                    speed = after_one(speed).map_or(speed, |end| next(speed, end));
                }
                (speed, by("chart-reference-fixed-point"))
            }
            Some(end) => (end, by("chart-reference-end")),
            None if method.is_none() => (shooting, text!("chart-reference-alone")),
            None => (shooting, by("chart-reference-shooting")),
        };
        // Speeds are known to a few rounding errors at best.
        let error = ((in_time - shooting) / shooting).abs().max(1e-15);
        let free = multiplier >= NEVER_SETTLES;
        let reference = Reference { how, error: if free { TIGHT } else { error } };
        Self { method, in_time, shooting, reference }
    }
}

/// One cycle from a speed: the speed at its end, and evaluations.
fn turn(
    method: &IntegratorPlugin,
    task: &Task<'_>,
    speed: f64,
    tolerance: f64,
) -> Result<(f64, usize), Text> {
    let initial = State { speed, ..task.request.initial };
    let request = Request { initial, tolerance, samples: 1, ..task.request };
    let found = method.solve(&mut task.motion.clone(), &request);
    let found = found.map_err(|error| error.describe())?;
    Ok((found.end.speed, found.statistics.evaluations))
}

/// Cycle after cycle from the mean speed, the tolerance of the steps being that of the regime.
pub(super) struct InTime<'a> {
    pub(super) cycle: &'a Cycle<'a>,
    pub(super) method: &'static IntegratorPlugin,
    pub(super) tolerance: f64,
    pub(super) options: ChartOptions,
}

impl InTime<'_> {
    /// Speed at the start of a cycle, and evaluations.
    pub(super) fn solve(&self) -> Result<(f64, usize), Text> {
        let task = self.cycle.task(1);
        let (mut speed, mut count) = (self.cycle.request.mean_speed, 0);
        for _ in 0..MOST_CYCLES {
            let (end, evaluations) = turn(self.method, &task, speed, self.tolerance)?;
            count += evaluations;
            let done = ((end - speed) / speed).abs() <= self.tolerance;
            speed = end;
            if done {
                return Ok((speed, count));
            }
            if count > 10 * self.options.max_steps {
                return Err(text!("chart-not-settled-evaluations", count = number(count)));
            }
        }
        Err(text!("chart-not-settled-cycles", count = number(MOST_CYCLES)))
    }
}
