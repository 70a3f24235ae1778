//! A speed that stays: rest, a jump of the moment with both sides driving back, or no moment at all.

use assur_integrator::{IntegrationError, Until};

use super::march::March;
use super::stretch::{Part, steady};

impl March<'_> {
    /// At this speed to the end.
    pub(super) fn keep_speed(&mut self) -> Result<(), IntegrationError> {
        let from = self.node.state;
        self.finished = true;
        self.node.acceleration = 0.0;
        let latest = self.request.latest();
        let end = match self.request.until {
            Until::Rest if from.speed == 0.0 => return Ok(()),
            _ if from.speed == 0.0 && latest == f64::INFINITY => {
                return Err(self.not_reached("rests there for good"));
            }
            Until::Rest => return Err(self.not_reached("keeps its speed")),
            Until::Coordinate(target) => {
                let dt = (target - from.coordinate) / from.speed;
                if dt >= 0.0 { from.time + dt } else { f64::INFINITY }
            }
            Until::Time(end) => end,
        };
        if end > latest {
            return Err(self.not_reached("the limit of time is over"));
        }
        if end == f64::INFINITY {
            return Err(self.not_reached("goes away from it at a speed that stays"));
        }
        self.parts.push(Part::Steady(from, end));
        self.node.state = steady(&from, end);
        if let Until::Coordinate(target) = self.request.until {
            self.node.state.coordinate = target;
        }
        Ok(())
    }
}
