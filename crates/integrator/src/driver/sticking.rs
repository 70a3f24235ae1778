//! Holding of a speed: rest under dry friction, or a jump of the moment over the speed that both sides drive back to.

use assur_number::search::try_bisect;

use super::Drive;
use crate::change::first_change_in;
use crate::piece_ahead::piece_ahead;
use crate::{Dense, EventKind, IntegrationError, Node, Piece, State, Stepper, Until, enter};

/// Number of parts of the remaining time that are searched for a release.
const STRIDES: f64 = 256.0;

/// First stride, s, where the remaining time is unlimited, and the growth factor of the following ones.
const FIRST_STRIDE: f64 = 1e-3;
const GROWTH: f64 = 1.5;

/// Distance from a jump at which the formulas before it hold, s or part of the time: more than the rounding by which an instant
/// may miss the jump.
const BESIDE: f64 = 1e-11;

impl<S: Stepper> Drive<'_, S> {
    /// Stays at the present speed until something releases the motion, or to the end.
    pub(super) fn stick(&mut self) -> Result<(), IntegrationError> {
        let at_rest = self.run.node.state.speed == 0.0;
        let ends = self.run.request.until == Until::Turn || !self.run.equation.dependence().moment_on_time;
        if at_rest && ends { self.run.coast_to_end() } else { self.wait() }
    }

    fn coast(&mut self, dt: f64) {
        self.run.coast_until(self.run.node.state.time + dt);
        self.scale.extend(&self.run.node.state);
    }

    /// The state if the motion sticks for `dt` more seconds.
    fn after(&self, dt: f64) -> State {
        let state = self.run.node.state;
        state.coasting_until(state.time + dt)
    }

    /// The piece into which the motion is released there, and its acceleration.
    fn release_after(&mut self, dt: f64) -> Result<Option<(Piece, f64)>, IntegrationError> {
        let state = self.after(dt);
        enter(&mut self.run.equation, &state, true)
    }

    /// The first change, other than one in time, between two instants in seconds from now.
    fn change_before(&self, held: f64, next: f64) -> Option<f64> {
        let step = next - held;
        if !(self.run.equation.dependence().moment_switches && step.is_finite()) {
            return None;
        }
        let coasting = Dense::parabola(&Node { state: self.after(held), acceleration: 0.0 }, step);
        let [_, after] = first_change_in(&self.run.equation, &coasting)?;
        Some(held + after * step).filter(|change| *change > held)
    }

    /// Looks ahead in strides, none of which passes a jump in time; if the motion is released within a stride, finds the
    /// instant.
    fn wait(&mut self) -> Result<(), IntegrationError> {
        let start = self.run.node.state.time;
        let left = self.run.request.latest() - start;
        let goal = self.time_to_goal();
        let mut stride = if left.is_finite() { left / STRIDES } else { FIRST_STRIDE };
        let mut held = 0.0;
        loop {
            self.run.equation.cost.steps += 1;
            if self.run.is_exhausted() {
                self.coast(held);
                return Err(self.too_many_steps());
            }
            let state = self.after(held);
            let [_, end] = piece_ahead(&mut self.run.equation, &state, 1.0)?.time;
            let next = (held + stride).min(left).min(goal).min(end - start);
            let next = self.change_before(held, next).unwrap_or(next);
            if (start + next).is_infinite() {
                // Nothing releases it within any representable time.
                return self.run.coast_to_end();
            }
            self.run.check_way(state.coordinate)?;
            // What holds before a jump may not hold after it, and the other way round.
            let before = next - BESIDE * (start + next).abs().max(1.0);
            for dt in [before, next] {
                if dt <= held {
                    continue;
                }
                if self.release_after(dt)?.is_some() {
                    return self.release_within(held, dt);
                }
                held = dt;
            }
            if next >= left {
                self.run.time_is_over()?;
                return self.run.coast_to_end();
            }
            if next >= goal {
                self.coast(goal);
                self.run.finished = true;
                return Ok(());
            }
            stride *= if left.is_finite() { 1.0 } else { GROWTH };
        }
    }

    /// Time in which the motion at constant speed reaches the requested coordinate, s.
    fn time_to_goal(&self) -> f64 {
        let Until::Coordinate(target) = self.run.request.until else { return f64::INFINITY };
        let time = (target - self.run.node.state.coordinate) / self.run.node.state.speed;
        if time > 0.0 { time } else { f64::INFINITY }
    }

    /// Releases the motion, which is held for `held` seconds and not for `dt`.
    fn release_within(&mut self, held: f64, dt: f64) -> Result<(), IntegrationError> {
        let [_, free] =
            try_bisect(held, dt, 0.0, |dt| self.release_after(dt).map(|released| released.is_none()))?;
        let released = self.release_after(free)?;
        self.coast(free);
        if let Some((piece, acceleration)) = released {
            self.run.event(EventKind::Release);
            (self.run.piece, self.run.node.acceleration) = (piece, acceleration);
            self.start_steps()?;
        }
        Ok(())
    }
}
