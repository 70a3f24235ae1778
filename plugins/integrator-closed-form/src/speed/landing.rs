//! How the motion through a panel ends.

use assur_integrator::{Event, EventKind, IntegrationError, State, Until};

use super::march::March;
use super::panel::Panel;
use super::stretch::Part;

/// What ends the motion through a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stop {
    /// The panel itself.
    Panel,
    /// The speed ahead that no panel passes.
    Wall,
    /// A coordinate, and whether it is the end asked for.
    Coordinate(f64, bool),
    /// A time.
    Time(f64),
}

impl March<'_> {
    /// Goes through a panel to its end, or to what comes before; the wall lies `room` ahead.
    pub(super) fn pass(&mut self, panel: &Panel, room: f64) -> Result<(), IntegrationError> {
        let from = self.node.state;
        let (mut end, mut stop) = self.speed_ahead(panel, room)?;
        let first = panel.first();
        if let Some((place, is_goal)) = self.place_ahead() {
            let way = place - from.coordinate;
            let whole = if end.is_finite() { panel.at(end).way } else { panel.whole_way() };
            let beyond = (whole - way) * way;
            if beyond > 0.0 || (beyond == 0.0 && end.is_finite()) {
                (end, stop) = (panel.at_way(way, [first, end]), Stop::Coordinate(place, is_goal));
            }
        }
        let latest = self.request.latest().min(self.piece.time[1]);
        if end == f64::INFINITY || from.time + panel.at(end).time >= latest {
            if latest == f64::INFINITY {
                return Err(self.settled(panel));
            }
            (end, stop) = (panel.at_time(latest - from.time, [first, end]), Stop::Time(latest));
        }
        let place = panel.at(end);
        let time = if let Stop::Time(time) = stop { time } else { from.time + place.time };
        let to = State { time, coordinate: from.coordinate + place.way, speed: place.speed };
        self.parts.push(Part::Moving { panel: Box::new(*panel), from, ends: [first, end], end: time });
        match stop {
            Stop::Panel => {
                self.go_to(to);
                self.node.acceleration = panel.last;
                Ok(())
            }
            Stop::Wall => self.land_on_wall(to),
            Stop::Coordinate(coordinate, is_goal) => self.land_on_place(State { coordinate, ..to }, is_goal),
            Stop::Time(_) => self.land_in_time(to),
        }
    }

    /// The parameter at the end of the panel or at the wall in it; infinite where the moment vanishes before.
    fn speed_ahead(&mut self, panel: &Panel, room: f64) -> Result<(f64, Stop), IntegrationError> {
        let ahead = panel.length().abs();
        if ahead < room {
            let end = if panel.pole().is_some() { f64::INFINITY } else { 1.0 };
            return Ok((end, Stop::Panel));
        }
        if panel.pole().is_none() {
            return Ok((panel.parameter(self.wall(), 0.0), Stop::Wall));
        }
        let (State { time, coordinate, .. }, wall) = (self.node.state, self.wall());
        let left =
            self.equation.acceleration(time, coordinate, wall).map_err(|source| self.failed(source))?;
        Ok((panel.parameter(wall, left), Stop::Wall))
    }

    /// The coordinate ahead at which the motion ends, or the piece does.
    fn place_ahead(&self) -> Option<(f64, bool)> {
        let State { coordinate, speed, .. } = self.node.state;
        let sense = if speed == 0.0 { self.direction() } else { speed.signum() };
        let wall = self.piece.coordinate[usize::from(sense > 0.0)];
        let ahead = |place: f64| (place - coordinate) * sense > 0.0;
        match self.request.until {
            Until::Coordinate(target) if ahead(target) && (target - wall) * sense <= 0.0 => {
                Some((target, true))
            }
            _ => Some((wall, false)).filter(|_| wall.is_finite() && ahead(wall)),
        }
    }

    fn settled(&self, panel: &Panel) -> IntegrationError {
        let at_rest = panel.pole().is_some_and(|pole| pole.speed == 0.0);
        self.not_reached(if at_rest {
            "creeps to rest without end"
        } else {
            "settles at a speed, which it approaches without end"
        })
    }

    /// On a bound of the piece, or at zero speed.
    pub(super) fn land_on_wall(&mut self, state: State) -> Result<(), IntegrationError> {
        let speed = self.wall();
        let before = self.direction();
        self.go_to(State { speed, ..state });
        if speed == 0.0 && self.request.until == Until::Rest {
            return self.finish();
        }
        let state = self.node.state;
        if speed != 0.0 {
            self.events.push(Event { state, kind: EventKind::Speed });
        }
        self.enter(true)?;
        if speed == 0.0 && self.node.acceleration * before > 0.0 && !self.finished {
            self.events.push(Event { state, kind: EventKind::Reversal });
        }
        Ok(())
    }

    fn land_on_place(&mut self, state: State, is_goal: bool) -> Result<(), IntegrationError> {
        self.go_to(state);
        if is_goal {
            return self.finish();
        }
        self.events.push(Event { state, kind: EventKind::Coordinate });
        self.enter(false)
    }

    fn land_in_time(&mut self, state: State) -> Result<(), IntegrationError> {
        self.go_to(state);
        if state.time < self.request.latest() {
            self.events.push(Event { state, kind: EventKind::Time });
            return self.enter(false);
        }
        match self.request.until {
            Until::Time(_) => self.finish(),
            _ => Err(self.not_reached("the limit of time is over")),
        }
    }

    /// Ends here, with the acceleration of the present piece.
    fn finish(&mut self) -> Result<(), IntegrationError> {
        let State { time, coordinate, speed } = self.node.state;
        let found = self.equation.acceleration(time, coordinate, speed);
        self.node.acceleration = found.map_err(|source| self.failed(source))?;
        self.finished = true;
        Ok(())
    }
}
