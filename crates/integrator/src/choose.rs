//! Which method solves an equation, and which methods follow if it fails: ranked by what the methods declare. And control of the
//! global error of a motion, which the control of the local error of each step can't ensure: local errors may grow, and the motion of
//! a stiff or unstable equation may follow a wrong branch at a loose tolerance.

use assur_words::{Describe, Text, joined, name, number, text};

use crate::error::SUSPICIOUS;
use crate::{
    Dependence, EquationOfMotion, IntegrationError, IntegratorPlugin, Knob, Request, Trajectory, find,
    integrators,
};

/// The name that leaves the choice of the method to the program.
pub const AUTO: &str = "auto";

/// A method for an equation, and the reason for it.
#[derive(Debug, Clone)]
pub struct RankedMethod {
    /// The method.
    pub integrator: &'static IntegratorPlugin,
    /// The reason for it, for a person.
    pub reason: Text,
}

/// The methods for an equation in the order in which they are tried.
#[derive(Debug, Clone)]
pub struct Choice {
    /// The method to take.
    pub first: RankedMethod,
    /// The methods that follow if one finds during the motion that it does not suit the equation.
    pub others: Vec<RankedMethod>,
    /// The method to continue with if an explicit one finds the equation stiff.
    pub stiff: Option<&'static IntegratorPlugin>,
}

/// A trajectory with the method that found it.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The motion.
    pub trajectory: Trajectory,
    /// The method.
    pub integrator: &'static IntegratorPlugin,
    /// The reason for the method, for a person.
    pub reason: Text,
}

/// Solves an equation by the method of that name, or by the methods that [`AUTO`] stands for.
pub fn solve(
    name: &str,
    motion: &mut dyn EquationOfMotion,
    request: &Request,
) -> Result<Solution, IntegrationError> {
    let mut found = choose(name, &motion.dependence(), request.tolerance)?.solve(motion, request)?;
    if found.integrator.knob == Knob::Step {
        found.trajectory.statistics.error = error_of_steps(&found, motion, request);
    }
    Ok(found)
}

/// The deviation of a motion by fixed steps from that by the method that [`AUTO`] stands for; `None` where that fails, or
/// has fixed steps as well.
fn error_of_steps(found: &Solution, motion: &mut dyn EquationOfMotion, request: &Request) -> Option<f64> {
    let adaptive = choose(AUTO, &motion.dependence(), request.tolerance).ok()?.solve(motion, request).ok()?;
    (adaptive.integrator.knob != Knob::Step).then(|| adaptive.trajectory.deviation(&found.trajectory))
}

/// The method of that name; for [`AUTO`] all that suit the equation, the cheapest first.
///
/// Stiffness can't be seen from what an equation depends on: an explicit method reports it when it meets it.
///
/// # Errors
///
/// [`IntegrationError::Registry`] where no method has that name, [`IntegrationError::Unsupported`] where it does not support the
/// equation, [`IntegrationError::NoMethod`] where none can.
pub fn choose(name: &str, dependence: &Dependence, tolerance: f64) -> Result<Choice, IntegrationError> {
    if name == AUTO {
        return ranked(&integrators()?, *dependence, tolerance);
    }
    let integrator = find(name)?;
    integrator.supports(dependence)?;
    let first = RankedMethod { integrator, reason: text!("integrator-by-name") };
    Ok(Choice { first, others: Vec::new(), stiff: None })
}

fn ranked(
    registry: &[&'static IntegratorPlugin],
    dependence: Dependence,
    tolerance: f64,
) -> Result<Choice, IntegrationError> {
    let suits = |plugin: &&'static IntegratorPlugin| {
        let suitability = (plugin.suitability)(&dependence, tolerance).ok()?;
        Some((*plugin, suitability))
    };
    let mut methods: Vec<_> = registry.iter().filter_map(suits).collect();
    // Within a class of cost the higher order; the registry is sorted by name, and the sort keeps that.
    methods.sort_by_key(|(plugin, suitability)| (suitability.cost, std::cmp::Reverse(plugin.order)));
    let mut candidates = methods.iter().map(|(integrator, suitability)| {
        let reason = text!(
            "integrator-choice",
            case = number(dependence.case()),
            equation = dependence.describe(),
            reason = &suitability.reason
        );
        RankedMethod { integrator, reason }
    });
    let first = candidates.next().ok_or(IntegrationError::NoMethod(dependence))?;
    let stiff = methods.iter().map(|(plugin, _)| *plugin).find(|plugin| plugin.stiff);
    Ok(Choice { first, others: candidates.collect(), stiff })
}

impl Choice {
    /// Solves the equation by the first method that suits it, keeping the tolerance for the motion as a whole.
    pub fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Solution, IntegrationError> {
        let mut refusals = Vec::new();
        let mut rest = self.others.iter();
        let mut candidate = &self.first;
        loop {
            let RankedMethod { integrator, reason } = candidate;
            match (to_tolerance(integrator, motion, request), self.stiff) {
                (Ok(trajectory), _) => {
                    let reasons = std::iter::once(reason.clone()).chain(refusals);
                    return Ok(Solution { trajectory, integrator, reason: joined("; ", reasons) });
                }
                (Err(error @ IntegrationError::Unsupported { .. }), _) => {
                    candidate = rest.next().ok_or_else(|| error.clone())?;
                    if let IntegrationError::Unsupported { reason, .. } = error {
                        refusals.push(text!(
                            "integrator-tried-before",
                            method = name(integrator.name),
                            why = reason
                        ));
                    }
                }
                (Err(IntegrationError::TooManySteps { stiffness: Some(product), .. }), Some(stiff))
                    if product > SUSPICIOUS =>
                {
                    let reason = text!("integrator-stiff", product = number(format_args!("{product:.2}")));
                    let trajectory = to_tolerance(stiff, motion, request)?;
                    return Ok(Solution { trajectory, integrator: stiff, reason });
                }
                (Err(error), _) => return Err(error),
            }
        }
    }

    /// Where an explicit method is tried first: the method that follows if the equation turns out to be stiff.
    pub fn if_stiff(&self) -> Option<&'static IntegratorPlugin> {
        let first = self.first.integrator;
        self.stiff.filter(|_| first.order > 0 && !first.stiff)
    }
}

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
fn to_tolerance(
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

#[cfg(test)]
mod tests;
