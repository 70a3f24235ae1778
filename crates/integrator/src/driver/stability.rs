//! Steps against the largest eigenvalue of the equation: unstable steps, and stiffness.

use super::Drive;
use crate::{IntegrationError, Pace, Stepper};

/// Number of steps after which the report looks for stiffness.
const MANY_STEPS: usize = 1000;

/// At a fixed step, stability is checked once in so many steps.
const PERIOD: usize = 64;

impl<S: Stepper> Drive<'_, S> {
    /// Step times eigenvalue, here.
    fn stiffness(&mut self) -> Option<f64> {
        if S::IMPLICIT || !self.step.is_finite() {
            return None;
        }
        Some(self.run.equation.eigenvalue(&self.run.node.state).ok()? * self.step)
    }

    /// Step times eigenvalue at the end of a long run.
    pub(super) fn reported_stiffness(&mut self) -> Option<f64> {
        if self.run.statistics.steps > MANY_STEPS { self.stiffness() } else { None }
    }

    pub(super) fn too_many_steps(&mut self) -> IntegrationError {
        let stiffness = self.stiffness();
        self.run.too_many_steps(self.step, stiffness)
    }

    pub(super) fn check_stability_at_times(&mut self) -> Result<(), IntegrationError> {
        if self.run.statistics.steps.is_multiple_of(PERIOD) { self.check_stability() } else { Ok(()) }
    }

    /// At a fixed step no error estimate would notice an unstable step.
    pub(super) fn check_stability(&mut self) -> Result<(), IntegrationError> {
        if self.pace != Pace::Fixed {
            return Ok(());
        }
        let at = self.run.node.state;
        let eigenvalue = self.run.equation.eigenvalue(&at).map_err(|source| self.run.failed(source))?;
        let (step, product, allowed) = (self.step, self.step * eigenvalue, S::STABLE);
        if product > allowed {
            return Err(IntegrationError::Unstable { at, step, product, allowed });
        }
        Ok(())
    }
}
