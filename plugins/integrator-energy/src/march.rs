//! Panel after panel along the coordinate, through pieces and turning points, to the end.

use assur_integrator::chebyshev::{INSIDE, WITH_ENDS};
use assur_integrator::{
    Entered, Equation, Event, IntegrationError, Motion, MotionError, Piece, Request, State, Statistics,
    Trajectory, Until, enter, samples, stops_at_once,
};

use crate::clock::{Clock, Rests};
use crate::panel::{Panel, Values, factor};
use crate::record::Part;

mod landing;

/// A turning point nearer than this part of the panel to its start has the panel fitted anew, as short as that.
const TOO_NEAR: f64 = 0.2;

/// The kinetic energy may grow so much over a panel: of a start that is slower the speed would be lost in the roundings of
/// the work, and the time, in which 1/w is nearly singular there, with it. What is lost is eps times its root.
const RISE: f64 = 1e6;

/// First panel, rad (m), where nothing else limits it.
const FIRST_PANEL: f64 = 0.5;

/// Least tolerance of the time: the roundings of a fit.
const CLOCK_ROUNDING: f64 = 1e-13;

pub(crate) struct March<'a> {
    pub(crate) equation: Equation<'a>,
    pub(crate) request: &'a Request,
    pub(crate) state: State,
    pub(crate) acceleration: f64,
    pub(crate) parts: Vec<Part>,
    piece: Piece,
    /// Kinetic energy here, and the largest so far.
    energy: f64,
    largest: f64,
    /// Next panel, without sign, rad (m).
    length: f64,
    known: Option<Values>,
    events: Vec<Event>,
    statistics: Statistics,
    finished: bool,
}

impl<'a> March<'a> {
    pub(crate) fn new(motion: &'a mut dyn Motion, request: &'a Request) -> Self {
        Self {
            equation: Equation::new(motion),
            request,
            state: request.initial,
            acceleration: 0.0,
            parts: Vec::with_capacity(64),
            piece: Piece::UNBOUNDED,
            energy: 0.0,
            largest: 0.0,
            length: FIRST_PANEL,
            known: None,
            events: Vec::new(),
            statistics: Statistics::default(),
            finished: false,
        }
    }

    pub(crate) fn run(mut self) -> Result<Trajectory, IntegrationError> {
        self.enter_first()?;
        let first = self.sample_here();
        let (inertia, _) = self.equation.work(&self.state).map_err(|source| self.failed(source))?;
        self.energy = 0.5 * inertia * self.state.speed * self.state.speed;
        self.largest = self.energy;
        while !self.finished {
            if self.statistics.steps + self.statistics.rejected >= self.request.max_steps {
                return Err(self.too_many());
            }
            self.advance()?;
        }
        let ends = [first, self.sample_here()];
        let samples = samples(&mut self.equation, self.request, &self.parts, ends)?;
        self.statistics.evaluations = self.equation.evaluations();
        self.statistics.pieces = self.equation.pieces();
        Ok(Trajectory { samples, events: self.events, statistics: self.statistics, end: self.state })
    }

    /// Tolerance of a fit: half of what is asked, since speed and time add up, and no finer than roundings allow.
    fn tolerance(&self) -> f64 {
        (0.5 * self.request.tolerance).max(1e-14)
    }

    fn failed(&self, source: MotionError) -> IntegrationError {
        IntegrationError::Equation { at: self.state, source }
    }

    fn too_many(&self) -> IntegrationError {
        let steps = self.statistics.steps + self.statistics.rejected;
        let step = self.length / self.state.speed.abs().max(f64::MIN_POSITIVE);
        IntegrationError::TooManySteps { at: self.state, steps, step, stiffness: None }
    }

    /// Enters the first piece, with any speed however small; or rests.
    fn enter_first(&mut self) -> Result<(), IntegrationError> {
        match enter(&mut self.equation, &self.state, false)? {
            Entered::Moving(piece, acceleration) => {
                (self.piece, self.acceleration) = (piece, acceleration);
                Ok(())
            }
            Entered::Held => self.rest(),
        }
    }

    /// Enters the piece ahead, or rests.
    fn enter(&mut self) -> Result<(), IntegrationError> {
        self.known = None;
        match enter(&mut self.equation, &self.state, false)? {
            Entered::Moving(_, acceleration) if stops_at_once(&self.state, acceleration) => {
                (self.state.speed, self.energy) = (0.0, 0.0);
                self.enter()
            }
            Entered::Moving(piece, acceleration) => {
                (self.piece, self.acceleration) = (piece, acceleration);
                Ok(())
            }
            Entered::Held => self.rest(),
        }
    }

    fn not_reached(&self, why: &'static str) -> IntegrationError {
        IntegrationError::not_reached(self.request, self.state, why)
    }

    fn direction(&self) -> f64 {
        if self.state.speed == 0.0 { self.acceleration.signum() } else { self.state.speed.signum() }
    }

    /// The wall ahead, and whether it is the end.
    fn wall(&self) -> (f64, bool) {
        let direction = self.direction();
        let wall = self.piece.coordinate[usize::from(direction > 0.0)];
        match self.request.until {
            Until::Coordinate(target)
                if (target - self.state.coordinate) * direction > 0.0
                    && (target - wall) * direction <= 0.0 =>
            {
                (target, true)
            }
            _ => (wall, false),
        }
    }

    /// Length of the next panel, and whether it ends at the wall.
    fn plan(&self, wall: f64) -> (f64, bool) {
        let room = (wall - self.state.coordinate).abs();
        let left = self.request.latest() - self.state.time;
        let mut length = self.length;
        if left.is_finite() {
            let push = (self.acceleration * self.direction()).max(0.0);
            let reach = left * (self.state.speed.abs() + 0.5 * left * push);
            length = length.min(1.1 * reach).max(1e-6 * self.length);
        }
        if length * 1.05 >= room { (room, true) } else { (length, false) }
    }

    fn advance(&mut self) -> Result<(), IntegrationError> {
        let (wall, is_goal) = self.wall();
        let (length, at_wall) = self.plan(wall);
        let direction = self.direction();
        let from = State { speed: direction * self.state.speed.abs().max(f64::MIN_POSITIVE), ..self.state };
        let energies = (self.energy, self.largest);
        let fitted =
            Panel::fit(&mut self.equation, &WITH_ENDS, &from, direction * length, self.known, energies);
        let panel = match fitted {
            Ok(panel) => panel,
            Err(source) => return self.shorten(length, 0.5, Some(source)),
        };
        if panel.error > self.tolerance() {
            return self.shorten(length, factor(self.tolerance(), panel.error).clamp(0.1, 0.7), None);
        }
        let rise = panel.most_energy() / self.energy.max(f64::MIN_POSITIVE);
        match panel.turning() {
            None if self.energy > 0.0 && rise > RISE => self.shorten_start(length, RISE / rise),
            Some(x) if 0.5 * (x + 1.0) < TOO_NEAR => {
                let nearer = 0.75 * (x + 1.0);
                if length * nearer < self.least() {
                    (self.state.speed, self.energy) = (0.0, 0.0);
                    return self.enter();
                }
                self.shorten(length, nearer, None)
            }
            turning => {
                let grown = length * factor(self.tolerance(), panel.error).clamp(0.3, 3.0);
                self.length = if at_wall { self.length.max(grown) } else { grown };
                self.pass(&panel, turning, at_wall.then_some((wall, is_goal)))
            }
        }
    }

    /// Length that the roundings of the coordinate swallow.
    fn least(&self) -> f64 {
        16.0 * f64::EPSILON * self.state.coordinate.abs().max(1e-12)
    }

    /// A panel over which the energy grows too much from a slow start; the start is one from rest where the way that its speed
    /// stands for is swallowed by roundings.
    fn shorten_start(&mut self, length: f64, by: f64) -> Result<(), IntegrationError> {
        if length * by > self.least() {
            return self.shorten(length, by, None);
        }
        (self.state.speed, self.energy) = (0.0, 0.0);
        self.enter()
    }

    fn shorten(&mut self, length: f64, by: f64, source: Option<MotionError>) -> Result<(), IntegrationError> {
        self.statistics.rejected += 1;
        self.length = length * by;
        if self.length > self.least() {
            return Ok(());
        }
        let step = self.length / self.state.speed.abs().max(f64::MIN_POSITIVE);
        Err(match source {
            Some(source) => self.failed(source),
            None => IntegrationError::StepTooSmall { at: self.state, step },
        })
    }

    /// Goes through a fitted panel to its end, to the turning point in it, or to the end of time.
    fn pass(
        &mut self,
        panel: &Panel,
        turning: Option<f64>,
        wall: Option<(f64, bool)>,
    ) -> Result<(), IntegrationError> {
        let latest = self.request.latest();
        let until = turning.unwrap_or(1.0);
        let rests = Rests { at_start: self.energy <= 0.0, at_end: turning.is_some() };
        let begin = self.state.time;
        let tolerance = self.tolerance().max(CLOCK_ROUNDING);
        let clock = Clock::measure(panel, &INSIDE, (until, rests), (begin, latest), tolerance);
        let clock = clock.map_err(|_| self.not_reached("creeps into an equilibrium without end"))?;
        self.statistics.steps += 1;
        self.largest = self.largest.max(panel.most_energy());
        let end = clock.end();
        let part = Part::moving(panel, clock, begin, end);
        if end >= latest {
            return self.end_in_time(part, latest);
        }
        self.energy = panel.energy(until);
        let speed = panel.speed(until, self.energy);
        self.state = State { time: end, coordinate: panel.coordinate(until), speed };
        self.known = Some(panel.last);
        self.parts.push(part);
        if turning.is_some() {
            return self.turn();
        }
        let (inertia, moment) = panel.last;
        self.acceleration = moment / inertia;
        match wall {
            Some((wall, is_goal)) => self.reach(wall, is_goal),
            None => Ok(()),
        }
    }
}
