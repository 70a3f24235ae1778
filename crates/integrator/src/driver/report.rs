//! The end of a drive: statistics, and errors with the place reached.

use super::Drive;
use crate::{IntegrationError, MotionError, Pace, Stepper, Trajectory};

/// Steps from which on the report looks for stiffness.
const MANY_STEPS: usize = 1000;

impl<S: Stepper> Drive<'_, S> {
    pub(super) fn conclude(mut self) -> Result<Trajectory, IntegrationError> {
        let samples = self.recorder.finish(&mut self.equation, &self.node)?;
        if self.statistics.steps > MANY_STEPS {
            self.statistics.stiffness = self.stiffness();
        }
        self.statistics.evaluations = self.equation.evaluations();
        self.statistics.jacobians = self.equation.jacobians();
        self.statistics.pieces = self.equation.pieces();
        Ok(Trajectory { samples, events: self.events, statistics: self.statistics, end: self.node.state })
    }

    /// Step times eigenvalue, here.
    fn stiffness(&mut self) -> Option<f64> {
        if S::IMPLICIT || !self.step.is_finite() {
            return None;
        }
        Some(self.equation.eigenvalue(&self.node.state).ok()? * self.step)
    }

    /// At a fixed step no error estimate would notice an unstable step.
    pub(super) fn check_stability(&mut self) -> Result<(), IntegrationError> {
        if self.pace != Pace::Fixed {
            return Ok(());
        }
        let at = self.node.state;
        let eigenvalue = self.equation.eigenvalue(&at).map_err(|source| self.failed(source))?;
        let (step, product, allowed) = (self.step, self.step * eigenvalue, S::STABLE);
        if product > allowed {
            return Err(IntegrationError::Unstable { at, step, product, allowed });
        }
        Ok(())
    }

    pub(super) fn too_many(&mut self) -> IntegrationError {
        IntegrationError::TooManySteps {
            at: self.node.state,
            steps: self.statistics.steps + self.statistics.rejected,
            step: self.step,
            stiffness: self.stiffness(),
        }
    }

    pub(super) fn failed(&self, source: MotionError) -> IntegrationError {
        IntegrationError::Equation { at: self.node.state, source }
    }

    pub(super) fn not_reached(&self, why: &'static str) -> IntegrationError {
        IntegrationError::not_reached(self.request, self.node.state, why)
    }
}
