//! How the motion through a panel ends.

use assur_integrator::{EventKind, IntegrationError, State, Until};
use assur_words::text;

use super::march::March;
use super::panel::{Panel, Passage};

/// What ends the motion through a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Ending {
    /// The end of the panel.
    Panel,
    /// The speed ahead that no panel passes.
    Speed,
    /// A coordinate, and whether it is the requested end.
    Coordinate(f64, bool),
    /// A time.
    Time(f64),
}

impl March<'_> {
    /// Advances through a panel to its end, or to an earlier limit; the bound of the speed is `room` ahead.
    pub(super) fn pass(&mut self, panel: &Panel, room: f64) -> Result<(), IntegrationError> {
        let from = self.run.node.state;
        let (mut end, mut ending) = self.speed_ahead(panel, room)?;
        let first = panel.first();
        let sense = if from.speed == 0.0 { self.direction() } else { from.speed.signum() };
        let (place, is_goal) = self.run.coordinate_ahead(sense);
        let way = place - from.coordinate;
        if place.is_finite() && way * sense > 0.0 {
            let whole = if end.is_finite() { panel.at(end).way } else { panel.whole_way() };
            let beyond = (whole - way) * way;
            if beyond > 0.0 || (beyond == 0.0 && end.is_finite()) {
                (end, ending) = (panel.at_way(way, [first, end]), Ending::Coordinate(place, is_goal));
            }
        }
        let latest = self.run.request.latest().min(self.run.piece.time[1]);
        if end == f64::INFINITY || from.time + panel.at(end).time >= latest {
            if latest == f64::INFINITY {
                return Err(self.settles(panel));
            }
            (end, ending) = (panel.at_time(latest - from.time, [first, end]), Ending::Time(latest));
        }
        let place = panel.at(end);
        let time = if let Ending::Time(time) = ending { time } else { from.time + place.time };
        let to = State { time, coordinate: from.coordinate + place.way, speed: place.speed };
        self.run.record(Passage { panel: Box::new(*panel), ends: [first, end] }, time);
        match ending {
            Ending::Panel => {
                self.go_to(to);
                self.run.node.acceleration = panel.last;
                Ok(())
            }
            Ending::Speed => self.meet_bound(to),
            Ending::Coordinate(coordinate, is_goal) => {
                self.go_to(State { coordinate, ..to });
                if is_goal { self.run.finish() } else { self.enter_next(EventKind::Coordinate) }
            }
            Ending::Time(_) => {
                self.go_to(to);
                if time < self.run.request.latest() {
                    return self.enter_next(EventKind::Time);
                }
                self.run.time_is_over()?;
                self.run.finish()
            }
        }
    }

    /// The parameter at the end of the panel or at the bound in it; infinite where the moment vanishes before.
    fn speed_ahead(&mut self, panel: &Panel, room: f64) -> Result<(f64, Ending), IntegrationError> {
        if panel.length().abs() < room {
            let end = if panel.pole().is_some() { f64::INFINITY } else { 1.0 };
            return Ok((end, Ending::Panel));
        }
        let speed = self.bound();
        if panel.pole().is_none() {
            return Ok((panel.parameter(speed, 0.0), Ending::Speed));
        }
        let at_bound = State { speed, ..self.run.node.state };
        let left = self.run.equation.acceleration(&at_bound).map_err(|source| self.run.failed(source))?;
        Ok((panel.parameter(speed, left), Ending::Speed))
    }

    fn settles(&self, panel: &Panel) -> IntegrationError {
        let at_rest = panel.pole().is_some_and(|pole| pole.speed == 0.0);
        self.run.not_reached(if at_rest {
            text!("integrator-creeps")
        } else {
            text!("integrator-quadrature-settles")
        })
    }

    /// At a bound of the piece, or at zero speed.
    pub(super) fn meet_bound(&mut self, state: State) -> Result<(), IntegrationError> {
        let speed = self.bound();
        let before = self.direction();
        self.go_to(State { speed, ..state });
        if speed == 0.0 && self.run.request.until == Until::Turn {
            return self.run.finish();
        }
        if speed != 0.0 {
            self.run.event(EventKind::Speed);
        }
        let state = self.run.node.state;
        let moving = self.run.enter(true)?;
        self.go_on(moving)?;
        if speed == 0.0 && self.run.node.acceleration * before > 0.0 && moving {
            self.run.reversal(state, -before)?;
        }
        Ok(())
    }

    fn enter_next(&mut self, event: EventKind) -> Result<(), IntegrationError> {
        self.run.event(event);
        let moving = self.run.enter(false)?;
        self.go_on(moving)
    }
}
