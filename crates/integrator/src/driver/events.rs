//! On the edge of a piece: the end of the motion, or the next piece.

use super::Drive;
use crate::event_location::Side;
use crate::{EventKind, IntegrationError, State, Stepper};

/// Events without progress of time after which the pieces are contradictory.
const MAX_STALLS: usize = 50;

impl<S: Stepper> Drive<'_, S> {
    /// A step aimed at a bound that ended a little before it: the rest is uniformly accelerated.
    pub(super) fn meet_if_at(&mut self, side: Side, h: f64) -> Result<(), IntegrationError> {
        /// Part of the step: the error of the parabola is its cube.
        const NEAR: f64 = 1e-5;
        let node = self.run.node;
        match self.bounds.time_to(side, &node).filter(|dt| *dt <= NEAR * h) {
            Some(dt) => self.meet(side, node.advanced(dt)),
            None if self.bounds.snap(side, node.state) == node.state => self.meet(side, node.state),
            None => Ok(()),
        }
    }

    /// At a bound of time: the end, or the next piece.
    pub(super) fn meet_time(&mut self) -> Result<(), IntegrationError> {
        if self.run.node.state.time >= self.run.request.latest() {
            self.run.finished = true;
            return self.run.time_is_over();
        }
        self.run.event(EventKind::Time);
        self.enter_next(false)
    }

    /// At a bound of coordinate or speed: the end, or the next piece.
    pub(super) fn meet(&mut self, side: Side, state: State) -> Result<(), IntegrationError> {
        let state = self.bounds.snap(side, state);
        let before = self.run.node.state;
        let stalled = state.time <= before.time;
        self.stalls = if stalled { self.stalls + 1 } else { 0 };
        if self.stalls > MAX_STALLS {
            return Err(IntegrationError::EmptyPiece { at: state });
        }
        self.run.statistics.steps += usize::from(!stalled);
        self.scale.extend(&state);
        self.run.node.state = state;
        if self.bounds.is_goal(side) {
            return self.run.finish();
        }
        let in_speed = matches!(side, Side::SpeedLow | Side::SpeedHigh);
        if !in_speed {
            self.run.event(EventKind::Coordinate);
        } else if state.speed != 0.0 {
            self.run.event(EventKind::Speed);
        }
        self.enter_next(in_speed)?;
        if in_speed && state.speed == 0.0 && self.run.node.acceleration * before.speed < 0.0 {
            self.run.event_at(state, EventKind::Reversal);
        }
        Ok(())
    }

    fn enter_next(&mut self, at_speed_bound: bool) -> Result<(), IntegrationError> {
        if self.run.enter_next(at_speed_bound)? {
            self.update_bounds();
            return Ok(());
        }
        self.stick()
    }
}
