//! Motions that are hard to integrate, each by every registered integrator, against closed forms.

mod case;
mod jumps;
mod starts;
mod stiff;
mod stops;

use assur_check::Finding;
use assur_integrator::{FixedStep, IntegrationError, IntegratorPlugin, Request, Trajectory, integrators};
use assur_words::{Describe, Text, name};

pub(crate) use case::Case;
pub(super) use case::LAW;
use case::Wanted;

use crate::stability::row::{Comparison, FEW_DIGITS};

/// Tolerance of methods that have one.
const TOLERANCE: f64 = 1e-10;

/// Steps of methods of a fixed step over the motion.
const STEPS: f64 = 1000.0;

/// Most steps of such a method.
const MOST_FIXED: usize = 20_000;

/// Roundings of a step, in eps.
const ROUNDINGS: f64 = 16.0;

/// Every case by every integrator; many turns up to so many.
pub(crate) fn rows(most_turns: f64) -> Vec<Comparison> {
    let Ok(plugins) = integrators() else { return Vec::new() };
    let cases = [starts::cases(), stops::cases(), stiff::cases(most_turns), jumps::cases()];
    let cases = cases.iter().flatten();
    cases.flat_map(|case| plugins.iter().filter_map(|plugin| case.row(plugin))).collect()
}

impl Case {
    fn row(&self, plugin: &IntegratorPlugin) -> Option<Comparison> {
        let mut motion = (self.motion)();
        let duration = self.duration;
        let request = Request {
            tolerance: TOLERANCE,
            fixed_step: Some(FixedStep::Time(self.step())),
            samples: 4,
            max_steps: if plugin.order == 1 || plugin.order == 4 { MOST_FIXED } else { self.max_steps },
            time_limit: 1e3 * duration,
            ..Request::new(self.initial, self.until)
        };
        if let Err(why) = (plugin.suitability)(&motion.dependence(), TOLERANCE) {
            let mut row = self.subject(plugin.name, f64::NAN).judged_or(Err(why), true);
            row.finding.bound = 0.0;
            // Once a walk is enough.
            return self.is_first.then_some(row);
        }
        let found = plugin.solve(&mut *motion, &request);
        let steps = match &found {
            Ok(found) => found.statistics.steps + found.statistics.rejected,
            Err(_) => self.max_steps.min(1000),
        };
        let bound = self.bound(plugin, steps);
        let (outcome, may_refuse) = self.judge(found);
        let lost = bound > FEW_DIGITS;
        Some(self.subject(plugin.name, bound).judged_or(outcome, may_refuse || lost))
    }

    /// Of methods of a fixed step, s.
    fn step(&self) -> f64 {
        self.duration / (STEPS * self.repeats)
    }

    /// What each step may lose, added up and passed on.
    fn bound(&self, plugin: &IntegratorPlugin, steps: usize) -> f64 {
        let rounding = ROUNDINGS * f64::EPSILON * (steps.max(1) as f64) * self.rounding;
        let step = self.rate * self.step();
        let method = match plugin.order {
            // The coefficients of a local error of a step, 1/2 and 1/120, are below 1.
            1 => step * self.rate * self.duration,
            4 => step.powi(4) * self.rate * self.duration,
            0 if plugin.name == "closed-form" => 0.0,
            _ => steps as f64 * TOLERANCE,
        };
        method * self.growth + rounding
    }

    fn subject(&self, method: &str, bound: f64) -> Comparison {
        Comparison {
            method: name(method.to_owned()),
            quantity: self.wanted.quantity(),
            distance: self.distance,
            health: self.distance.min(1.0),
            finding: Finding::within(name(self.place.to_owned()), bound),
        }
    }

    fn judge(&self, found: Result<Trajectory, IntegrationError>) -> (Result<f64, Text>, bool) {
        match (&self.wanted, found) {
            (Wanted::End(_) | Wanted::Stop { refused: false, .. }, Ok(found)) => {
                (Ok(self.wanted.apart(&found.end, &found.events)), false)
            }
            (Wanted::Stop { refused: true, .. }, Err(IntegrationError::NotReached { at, .. })) => {
                (Ok(self.wanted.apart(&at, &[])), false)
            }
            (Wanted::Stop { refused: true, .. }, Ok(_)) => (Ok(f64::INFINITY), false),
            (_, Err(why)) => {
                let by_stiffness = matches!(
                    why,
                    IntegrationError::Unstable { .. }
                        | IntegrationError::TooManySteps { .. }
                        | IntegrationError::StepTooSmall { .. }
                );
                (Err(why.describe()), self.explicit_may_refuse && by_stiffness)
            }
        }
    }
}
