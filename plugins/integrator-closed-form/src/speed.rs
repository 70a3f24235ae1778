//! J constant and M(w) (D's case 2): t = J ∫ dw/M(w) and q = q0 + J ∫ w dw/M(w), by panels of the speed.
//!
//! The acceleration e = M/J is fitted over a panel; time and displacement are integrals of polynomials and need no
//! further evaluation. Where the moment vanishes at a speed, 1/e has a pole. It is divided out, so the asymptotic
//! approach to that speed is one logarithm, in one panel.

use assur_integrator::{
    EquationOfMotion, EventKind, IntegrationError, MotionError, Request, Run, State, Trajectory, Until,
};
use assur_number::elementary;
use assur_words::{number, text};

use crate::QUADRATURE;
use panel::{Passage, SpeedPanel};

mod panel;

/// Least tolerance: the rounding errors of a fit.
const ROUNDINGS: f64 = 3e-14;

/// Panels and trials in one smooth piece after which its moment counts as too rough for polynomials.
const MOST_TRIALS: usize = 400;

/// The solution in progress.
pub(crate) struct March<'a> {
    run: Run<'a, Passage>,
    /// Largest speed and displacement since the start.
    fastest: f64,
    travel: f64,
    /// Length of the next panel, without sign; whether it was lengthened to include a speed at which the moment
    /// vanishes.
    length: f64,
    lengthened: bool,
    /// The last trial was shortened.
    rejected: bool,
    /// Why the last trial could not be fitted at all.
    failure: Option<MotionError>,
    /// Last panel that passed in this piece; 0 if there is none.
    before: f64,
    trials: usize,
}

/// Solves the equation in panels of the speed.
pub(crate) fn run(
    motion: &mut dyn EquationOfMotion,
    request: &Request,
) -> Result<Trajectory, IntegrationError> {
    let mut march = March {
        run: Run::new(motion, request),
        fastest: request.initial.speed.abs(),
        travel: 0.0,
        length: 0.0,
        lengthened: false,
        rejected: false,
        failure: None,
        before: 0.0,
        trials: 0,
    };
    let moving = march.run.begin()?;
    march.go_on(moving)?;
    while !march.run.finished {
        if march.run.is_exhausted() {
            let step = march.length / march.run.node.acceleration.abs().max(f64::MIN_POSITIVE);
            return Err(march.run.too_many_steps(step, None));
        }
        march.run.check_way(march.run.node.state.coordinate)?;
        march.advance()?;
    }
    march.run.conclude()
}

impl March<'_> {
    /// Continues in a new piece, or at a speed that is held: the moment depends on nothing else, so it is held for
    /// good.
    fn go_on(&mut self, moving: bool) -> Result<(), IntegrationError> {
        if !moving {
            return self.run.coast_to_end();
        }
        self.length = self.first_length();
        (self.lengthened, self.before, self.trials) = (false, 0.0, 0);
        Ok(())
    }

    /// No panel was short enough: the equation has no value there, or no polynomial fits it.
    fn given_up(&mut self) -> IntegrationError {
        if let Some(source) = self.failure.take() {
            return self.run.failed(source);
        }
        let State { time, speed, .. } = self.run.node.state;
        IntegrationError::Unsupported {
            integrator: QUADRATURE.name,
            reason: text!(
                "integrator-quadrature-too-fine",
                speed = number(format_args!("{speed:e}")),
                time = number(format_args!("{time:e}"))
            ),
        }
    }

    /// The change of the speed to the end at constant moment.
    fn first_length(&self) -> f64 {
        let (state, acceleration) = (self.run.node.state, self.run.node.acceleration);
        let (w, e) = (state.speed.abs(), acceleration.abs());
        let length = match self.run.request.until {
            Until::Time(end) => e * (end - state.time),
            Until::Coordinate(end) => {
                let way = end - state.coordinate;
                let slows = acceleration * state.speed < 0.0;
                let twice = 2.0 * e * way.abs();
                let square = if slows { w * w - twice } else { w * w + twice };
                // A motion that stops before the end, or turns to reach it, loses its whole speed first.
                let stops = slows && (square <= 0.0 || way * state.speed < 0.0);
                if stops { w } else { twice / (w + square.sqrt()) }
            }
            Until::Turn | Until::Rest if acceleration * state.speed < 0.0 => w,
            Until::Turn | Until::Rest => w.max(e),
        };
        length.min(e * (self.run.request.latest() - state.time))
    }

    /// Sign of the acceleration.
    fn direction(&self) -> f64 {
        self.run.node.acceleration.signum()
    }

    /// The speed ahead that no panel passes: the bound of the piece, or zero.
    fn bound(&self) -> f64 {
        let (direction, speed) = (self.direction(), self.run.node.state.speed);
        let bound = self.run.piece.speed[usize::from(direction > 0.0)];
        let zero_ahead = speed * direction < 0.0;
        if zero_ahead && bound * direction > 0.0 { 0.0 } else { bound }
    }

    fn advance(&mut self) -> Result<(), IntegrationError> {
        let node = self.run.node;
        let least = 4.0 * f64::EPSILON * node.state.speed.abs();
        if node.acceleration == 0.0 || self.first_length() <= least {
            return self.run.coast_to_end();
        }
        let room = (self.bound() - node.state.speed).abs();
        if room == 0.0 {
            return self.meet_bound(node.state);
        }
        let at_bound = self.length * 1.05 >= room && !self.lengthened;
        let length = if at_bound { room } else { self.length };
        self.trials += 1;
        if self.trials > MOST_TRIALS || length <= least.max(f64::MIN_POSITIVE) {
            return Err(self.given_up());
        }
        let along = self.direction() * length;
        match SpeedPanel::fit(&mut self.run.equation, &node, along) {
            Ok(panel) => {
                self.failure = None;
                self.judge(&panel, length, room)
            }
            Err(source) => {
                self.failure = Some(source);
                self.shorten(length * 0.5);
                Ok(())
            }
        }
    }

    /// Advances through a panel, or prepares another trial.
    fn judge(&mut self, panel: &SpeedPanel, length: f64, room: f64) -> Result<(), IntegrationError> {
        let error = self.error(panel);
        let factor = factor(error);
        if error <= 1.0 {
            self.plan(panel, length, factor);
            return self.pass(panel, room);
        }
        if let Some(whole) = panel.length_to_pole().filter(|_| !self.lengthened) {
            self.run.equation.cost.rejected += 1;
            self.lengthened = true;
            self.length = whole.min(2.0 * room);
            return Ok(());
        }
        // A failed panel after one that passed contained a pole, rather than being far too long.
        let least = if self.before > 0.0 { 0.4 } else { 0.1 };
        self.shorten(length * factor.clamp(least, 0.7));
        Ok(())
    }

    /// The panel after one that passed.
    fn plan(&mut self, panel: &SpeedPanel, length: f64, factor: f64) {
        self.run.equation.cost.steps += 1;
        // Towards a speed at which the moment vanishes panels shrink as they did before.
        let shrinking = if self.before > 0.0 { (length / self.before).min(1.0) } else { 1.0 };
        let most = if self.rejected { 1.0 } else { 4.0 };
        let grown = length * (factor * shrinking).clamp(0.1, most);
        let to_pole = panel.length_to_pole().map(|whole| whole - length).filter(|rest| *rest > 0.0);
        self.length = to_pole.map_or(grown, |rest| rest.min(grown));
        (self.before, self.lengthened, self.rejected) = (length, false, false);
    }

    fn shorten(&mut self, length: f64) {
        self.run.equation.cost.rejected += 1;
        self.rejected = true;
        self.length = length;
    }

    /// Error of a panel divided by the allowed one: relative to the largest speed and the largest displacement.
    fn error(&self, panel: &SpeedPanel) -> f64 {
        let tolerance = (0.25 * self.run.request.tolerance).max(ROUNDINGS);
        let [speed, way] = panel.error;
        let fastest = self.fastest.max(panel.last_speed().abs());
        // Errors grow while the motion leaves an unstable speed.
        let own = panel.length().abs().max(64.0 * f64::EPSILON / tolerance * fastest);
        let grows = panel.last.abs() > self.run.node.acceleration.abs();
        let size = if grows { own.min(fastest) } else { fastest };
        let travel = self.travel.max(panel.whole_way().abs());
        let error = (speed / (tolerance * size)).max(way / (tolerance * travel));
        if speed.is_finite() && way.is_finite() { error } else { f64::INFINITY }
    }

    /// Advances to the end of a segment.
    fn go_to(&mut self, state: State) {
        self.run.node.state = state;
        self.fastest = self.fastest.max(state.speed.abs());
        self.travel = self.travel.max((state.coordinate - self.run.request.initial.coordinate).abs());
    }

    /// Advances through a panel to its end, or to an earlier limit; the bound of the speed is `room` ahead.
    fn pass(&mut self, panel: &SpeedPanel, room: f64) -> Result<(), IntegrationError> {
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
            Ending::SpeedPanel => {
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
    fn speed_ahead(&mut self, panel: &SpeedPanel, room: f64) -> Result<(f64, Ending), IntegrationError> {
        if panel.length().abs() < room {
            let end = if panel.pole.is_some() { f64::INFINITY } else { 1.0 };
            return Ok((end, Ending::SpeedPanel));
        }
        let speed = self.bound();
        if panel.pole.is_none() {
            return Ok((panel.parameter(speed, 0.0), Ending::Speed));
        }
        let at_bound = State { speed, ..self.run.node.state };
        let left = self.run.equation.acceleration(&at_bound).map_err(|source| self.run.failed(source))?;
        Ok((panel.parameter(speed, left), Ending::Speed))
    }

    fn settles(&self, panel: &SpeedPanel) -> IntegrationError {
        let at_rest = panel.pole.is_some_and(|pole| pole.speed == 0.0);
        self.run.not_reached(if at_rest {
            text!("integrator-creeps")
        } else {
            text!("integrator-quadrature-settles")
        })
    }

    /// At a bound of the piece, or at zero speed.
    fn meet_bound(&mut self, state: State) -> Result<(), IntegrationError> {
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

/// Factor of the length that makes the error of a fit the allowed one.
fn factor(error: f64) -> f64 {
    0.85 * elementary::powf(1.0 / error.max(1e-30), 1.0 / 12.0)
}

/// What ends the motion through a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Ending {
    SpeedPanel,
    /// The speed ahead that no panel passes.
    Speed,
    /// A coordinate, and whether it is the requested end.
    Coordinate(f64, bool),
    Time(f64),
}

#[cfg(test)]
mod tests;
