//! On the edge of a piece: the end of the motion, or the next piece.

use super::Drive;
use crate::crossing::Side;
use crate::{Entered, Event, EventKind, IntegrationError, State, Stepper, Until, enter, stops_at_once};

/// Landings without progress of time after which the pieces are contradictory.
const MAX_STALLS: usize = 50;

impl<S: Stepper> Drive<'_, S> {
    /// A step aimed at a wall that ended a little before it: the rest is uniformly accelerated.
    pub(super) fn land_if_at(&mut self, side: Side, h: f64) -> Result<(), IntegrationError> {
        /// Part of the step: the error of the parabola is its cube.
        const NEAR: f64 = 1e-5;
        match self.walls.time_to(side, &self.node).filter(|dt| *dt <= NEAR * h) {
            Some(dt) => self.land(side, self.node.advanced(dt)),
            None if self.is_on(side) => self.land(side, self.node.state),
            None => Ok(()),
        }
    }

    pub(super) fn is_on(&self, side: Side) -> bool {
        self.walls.snap(side, self.node.state) == self.node.state
    }

    pub(super) fn land_in_time(&mut self) -> Result<(), IntegrationError> {
        let state = self.node.state;
        if state.time >= self.request.latest() {
            return match self.request.until {
                Until::Time(_) => {
                    self.finished = true;
                    Ok(())
                }
                _ => Err(self.not_reached("the limit of time is over")),
            };
        }
        self.events.push(Event { state, kind: EventKind::Time });
        self.enter_next(false)
    }

    /// On a wall: the end, or the next piece.
    pub(super) fn land(&mut self, side: Side, state: State) -> Result<(), IntegrationError> {
        let state = self.walls.snap(side, state);
        let stalled = state.time <= self.node.state.time;
        self.stalls = if stalled { self.stalls + 1 } else { 0 };
        if self.stalls > MAX_STALLS {
            return Err(IntegrationError::EmptyPiece { at: state });
        }
        self.statistics.steps += usize::from(!stalled);
        self.scale.extend(&state);
        let before = self.node.state.speed;
        self.node.state = state;
        if self.walls.is_goal(side) {
            self.finished = true;
            let at = state;
            self.node.acceleration = self
                .equation
                .acceleration(at.time, at.coordinate, at.speed)
                .map_err(|source| IntegrationError::Equation { at, source })?;
            return Ok(());
        }
        let in_speed = matches!(side, Side::SpeedLow | Side::SpeedHigh);
        if !in_speed {
            self.events.push(Event { state, kind: EventKind::Coordinate });
        } else if state.speed != 0.0 {
            self.events.push(Event { state, kind: EventKind::Speed });
        }
        self.enter_next(in_speed)?;
        if in_speed && state.speed == 0.0 && self.node.acceleration * before < 0.0 {
            self.events.push(Event { state, kind: EventKind::Reversal });
        }
        Ok(())
    }

    pub(super) fn enter_next(&mut self, at_speed_bound: bool) -> Result<(), IntegrationError> {
        match enter(&mut self.equation, &self.node.state, at_speed_bound)? {
            Entered::Moving(_, acceleration) if stops_at_once(&self.node.state, acceleration) => {
                self.node.state.speed = 0.0;
                self.enter_next(true)
            }
            Entered::Moving(piece, acceleration) => {
                self.go_on(piece, acceleration);
                Ok(())
            }
            Entered::Held => self.hold(),
        }
    }
}
