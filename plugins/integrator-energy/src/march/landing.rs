//! Where a march ends, turns or rests.

use assur_integrator::{Event, EventKind, IntegrationError, State, Stretch, Until};

use super::March;
use crate::record::Part;

impl March<'_> {
    pub(super) fn rest(&mut self) -> Result<(), IntegrationError> {
        self.acceleration = 0.0;
        self.finished = true;
        self.events.push(Event { state: self.state, kind: EventKind::Rest });
        match self.request.until {
            Until::Rest => Ok(()),
            Until::Time(end) => {
                self.parts.push(Part::rest(self.state, end));
                self.state.time = end;
                Ok(())
            }
            Until::Coordinate(_) => Err(self.not_reached("rests there for good")),
        }
    }

    pub(super) fn end_in_time(&mut self, part: Part, latest: f64) -> Result<(), IntegrationError> {
        self.state = part.at(latest);
        self.parts.push(part);
        if !matches!(self.request.until, Until::Time(_)) {
            return Err(self.not_reached("the limit of time is over"));
        }
        self.finished = true;
        self.final_acceleration()
    }

    pub(super) fn final_acceleration(&mut self) -> Result<(), IntegrationError> {
        let State { time, coordinate, speed } = self.state;
        let acceleration = self.equation.acceleration(time, coordinate, speed);
        self.acceleration = acceleration.map_err(|source| self.failed(source))?;
        Ok(())
    }

    pub(super) fn reach(&mut self, wall: f64, is_goal: bool) -> Result<(), IntegrationError> {
        self.state.coordinate = wall;
        if is_goal {
            self.finished = true;
            return self.final_acceleration();
        }
        self.events.push(Event { state: self.state, kind: EventKind::Coordinate });
        self.enter()
    }

    /// At a turning point: the end, a reversal, or rest.
    pub(super) fn turn(&mut self) -> Result<(), IntegrationError> {
        let before = self.parts.last().map_or(0.0, Part::direction);
        self.state.speed = 0.0;
        self.energy = 0.0;
        if self.request.until == Until::Rest {
            self.finished = true;
            return self.final_acceleration();
        }
        let state = self.state;
        self.enter()?;
        if self.acceleration * before < 0.0 {
            self.events.push(Event { state, kind: EventKind::Reversal });
        }
        Ok(())
    }
}
