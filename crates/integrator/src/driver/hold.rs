//! A speed that stays: rest under dry friction, or a jump of the moment over speed with both sides driving back.

use super::Drive;
use crate::{Dense, Entered, Event, EventKind, IntegrationError, Piece, State, Stepper, Until, enter};

/// Halvings that find the instant of release to rounding.
const HALVINGS: usize = 60;

impl<S: Stepper> Drive<'_, S> {
    /// Stays at the present speed until something releases the motion, or to the end.
    pub(super) fn hold(&mut self) -> Result<(), IntegrationError> {
        let state = self.node.state;
        self.node.acceleration = 0.0;
        let at_rest = state.speed == 0.0;
        self.events.push(Event { state, kind: if at_rest { EventKind::Rest } else { EventKind::Held } });
        if at_rest && self.request.until == Until::Rest {
            self.finished = true;
            return Ok(());
        }
        if at_rest && !self.equation.depends_on_time() {
            return match self.request.until {
                Until::Time(end) => self.stay_until(end),
                _ => Err(self.not_reached("rests there for good")),
            };
        }
        self.wait()
    }

    /// The motion held for `dt`.
    fn held(&self, dt: f64) -> State {
        let state = self.node.state;
        State { time: state.time + dt, coordinate: state.coordinate + state.speed * dt, ..state }
    }

    fn stay_until(&mut self, end: f64) -> Result<(), IntegrationError> {
        let dt = end - self.node.state.time;
        self.stay(dt)?;
        self.node.state.time = end;
        self.finished = true;
        Ok(())
    }

    fn stay(&mut self, dt: f64) -> Result<(), IntegrationError> {
        let dense = Dense::steady(&self.node.state, dt);
        let next = self.held(dt);
        self.recorder.step(&mut self.equation, &dense, next.time, true)?;
        self.node.state = next;
        self.scale.extend(&next);
        Ok(())
    }

    fn released(&mut self, dt: f64) -> Result<Option<(Piece, f64)>, IntegrationError> {
        let state = self.held(dt);
        match enter(&mut self.equation, &state, true)? {
            Entered::Moving(piece, acceleration) => Ok(Some((piece, acceleration))),
            Entered::Held => Ok(None),
        }
    }

    /// Looks ahead in growing strides; where the motion is released within one, halves it to the instant.
    fn wait(&mut self) -> Result<(), IntegrationError> {
        let latest = self.request.latest();
        let mut stride = if latest.is_finite() { (latest - self.node.state.time) / 256.0 } else { 1e-3 };
        loop {
            self.statistics.steps += 1;
            if self.statistics.steps + self.statistics.rejected >= self.request.max_steps {
                return Err(self.too_many());
            }
            let left = latest - self.node.state.time;
            let dt = stride.min(left).min(self.time_to_goal());
            if self.released(dt)?.is_some() {
                return self.release_within(dt);
            }
            if dt >= left {
                return match self.request.until {
                    Until::Time(end) => self.stay_until(end),
                    _ => Err(self.not_reached("is held until the limit of time")),
                };
            }
            let at_goal = dt >= self.time_to_goal();
            self.stay(dt)?;
            if at_goal {
                self.finished = true;
                return Ok(());
            }
            stride *= if latest.is_finite() { 1.0 } else { 1.5 };
        }
    }

    /// Time in which the held speed reaches the coordinate asked for.
    fn time_to_goal(&self) -> f64 {
        let Until::Coordinate(target) = self.request.until else { return f64::INFINITY };
        let time = (target - self.node.state.coordinate) / self.node.state.speed;
        if time > 0.0 { time } else { f64::INFINITY }
    }

    fn release_within(&mut self, dt: f64) -> Result<(), IntegrationError> {
        let (mut held, mut free) = (0.0, dt);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (held + free);
            if middle <= held || middle >= free {
                break;
            }
            if self.released(middle)?.is_some() {
                free = middle;
            } else {
                held = middle;
            }
        }
        let released = self.released(free)?;
        self.stay(free)?;
        let Some((piece, acceleration)) = released else { return Ok(()) };
        self.events.push(Event { state: self.node.state, kind: EventKind::Release });
        self.go_on(piece, acceleration);
        self.step = self.initial_step();
        Ok(())
    }
}
