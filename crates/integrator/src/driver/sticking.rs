//! Holding of a speed: rest under dry friction, or a jump of the moment over the speed that both sides drive back to.

use assur_number::search::try_bisect;

use super::Drive;
use crate::{EventKind, IntegrationError, Piece, Stepper, Until, enter};

/// Number of parts of the remaining time that are searched for a release.
const STRIDES: f64 = 256.0;

/// First stride, s, where the remaining time is unlimited, and the growth factor of the following ones.
const FIRST_STRIDE: f64 = 1e-3;
const GROWTH: f64 = 1.5;

impl<S: Stepper> Drive<'_, S> {
    /// Stays at the present speed until something releases the motion, or to the end.
    pub(super) fn stick(&mut self) -> Result<(), IntegrationError> {
        let at_rest = self.run.node.state.speed == 0.0;
        let rest_wanted = matches!(self.run.request.until, Until::Turn | Until::Rest);
        if at_rest && (rest_wanted || !self.run.equation.depends_on_time()) {
            return self.run.coast_to_end();
        }
        self.wait()
    }

    fn coast(&mut self, dt: f64) {
        self.run.coast_until(self.run.node.state.time + dt);
        self.scale.extend(&self.run.node.state);
    }

    /// The piece into which the motion is released if it sticks for `dt` more seconds, and its acceleration.
    fn release_after(&mut self, dt: f64) -> Result<Option<(Piece, f64)>, IntegrationError> {
        let state = self.run.node.state;
        enter(&mut self.run.equation, &state.coasting_until(state.time + dt), true)
    }

    /// Looks ahead in strides; if the motion is released within a stride, finds the instant.
    fn wait(&mut self) -> Result<(), IntegrationError> {
        let latest = self.run.request.latest();
        let limited = latest.is_finite();
        let mut stride = if limited { (latest - self.run.node.state.time) / STRIDES } else { FIRST_STRIDE };
        loop {
            self.run.statistics.steps += 1;
            if self.run.is_exhausted() {
                return Err(self.too_many_steps());
            }
            let left = latest - self.run.node.state.time;
            let dt = stride.min(left).min(self.time_to_goal());
            if (self.run.node.state.time + dt).is_infinite() {
                // Nothing releases it within any representable time.
                return self.run.coast_to_end();
            }
            if self.release_after(dt)?.is_some() {
                return self.release_within(dt);
            }
            let at_goal = dt >= self.time_to_goal();
            if dt >= left {
                self.run.time_is_over()?;
                return self.run.coast_to_end();
            }
            self.coast(dt);
            if at_goal {
                self.run.finished = true;
                return Ok(());
            }
            stride *= if limited { 1.0 } else { GROWTH };
        }
    }

    /// Time in which the motion at constant speed reaches the requested coordinate, s.
    fn time_to_goal(&self) -> f64 {
        let Until::Coordinate(target) = self.run.request.until else { return f64::INFINITY };
        let time = (target - self.run.node.state.coordinate) / self.run.node.state.speed;
        if time > 0.0 { time } else { f64::INFINITY }
    }

    fn release_within(&mut self, dt: f64) -> Result<(), IntegrationError> {
        let [_, free] =
            try_bisect(0.0, dt, 0.0, |dt| self.release_after(dt).map(|released| released.is_none()))?;
        let released = self.release_after(free)?;
        self.coast(free);
        if let Some((piece, acceleration)) = released {
            self.run.event(EventKind::Release);
            (self.run.piece, self.run.node.acceleration) = (piece, acceleration);
            self.start_steps();
        }
        Ok(())
    }
}
