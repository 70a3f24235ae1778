//! Panel after panel along the speed, through pieces, to the end.

use assur_integrator::{
    Entered, Equation, Event, EventKind, IntegrationError, Motion, MotionError, Node, Piece, Request, Sample,
    State, Statistics, Trajectory, Until, enter, samples,
};

use crate::QUADRATURE;

use super::panel::Panel;
use super::stretch::Part;

/// Least tolerance: the roundings of a fit.
const ROUNDINGS: f64 = 3e-14;

/// Panels and trials in one smooth piece after which its moment counts as too rough for polynomials.
const MOST_TRIALS: usize = 400;

/// The motion so far.
#[derive(Debug)]
pub(crate) struct March<'a> {
    pub(super) equation: Equation<'a>,
    pub(super) request: &'a Request,
    pub(super) node: Node,
    pub(super) piece: Piece,
    pub(super) parts: Vec<Part>,
    pub(super) events: Vec<Event>,
    pub(super) finished: bool,
    statistics: Statistics,
    /// Largest speed and way so far.
    fastest: f64,
    travel: f64,
    /// Next panel, without sign; whether it was lengthened to hold a speed at which the moment vanishes.
    length: f64,
    lengthened: bool,
    /// The last trial was shortened.
    rejected: bool,
    /// Why the last trial could not even be fitted.
    failure: Option<MotionError>,
    /// Last panel that passed in this piece; 0 if there is none.
    before: f64,
    /// Trials in this piece.
    trials: usize,
}

impl<'a> March<'a> {
    pub(crate) fn new(motion: &'a mut dyn Motion, request: &'a Request) -> Self {
        Self {
            equation: Equation::new(motion),
            request,
            node: Node { state: request.initial, acceleration: 0.0 },
            piece: Piece::UNBOUNDED,
            parts: Vec::with_capacity(16),
            events: Vec::new(),
            finished: false,
            statistics: Statistics::default(),
            fastest: request.initial.speed.abs(),
            travel: 0.0,
            length: 0.0,
            lengthened: false,
            rejected: false,
            failure: None,
            before: 0.0,
            trials: 0,
        }
    }

    pub(crate) fn run(mut self) -> Result<Trajectory, IntegrationError> {
        self.enter(false)?;
        let first = self.sample_here();
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
        Ok(Trajectory { samples, events: self.events, statistics: self.statistics, end: self.node.state })
    }

    fn sample_here(&self) -> Sample {
        let State { time, coordinate, speed } = self.node.state;
        Sample { time, coordinate, speed, acceleration: self.node.acceleration }
    }

    pub(super) fn failed(&self, source: MotionError) -> IntegrationError {
        IntegrationError::Equation { at: self.node.state, source }
    }

    pub(super) fn not_reached(&self, why: &'static str) -> IntegrationError {
        IntegrationError::not_reached(self.request, self.node.state, why)
    }

    fn too_many(&self) -> IntegrationError {
        let steps = self.statistics.steps + self.statistics.rejected;
        let step = self.length / self.node.acceleration.abs().max(f64::MIN_POSITIVE);
        IntegrationError::TooManySteps { at: self.node.state, steps, step, stiffness: None }
    }

    /// No panel was short enough: the equation fails there, or no polynomial follows it.
    fn given_up(&mut self) -> IntegrationError {
        if let Some(source) = self.failure.take() {
            return self.failed(source);
        }
        let State { time, speed, .. } = self.node.state;
        IntegrationError::Unsupported {
            integrator: QUADRATURE.name,
            reason: format!(
                "no polynomial in the speed follows the moment near w = {speed:e} (t = {time:e} s) to this tolerance; a method \
                 in steps of time does"
            ),
        }
    }

    /// Enters the piece ahead, or keeps the speed.
    pub(super) fn enter(&mut self, at_speed_bound: bool) -> Result<(), IntegrationError> {
        match enter(&mut self.equation, &self.node.state, at_speed_bound)? {
            Entered::Moving(piece, acceleration) => {
                self.piece = piece;
                self.node.acceleration = acceleration;
                self.length = self.first_length();
                (self.lengthened, self.before, self.trials) = (false, 0.0, 0);
                Ok(())
            }
            Entered::Held => {
                let state = self.node.state;
                let kind = if state.speed == 0.0 { EventKind::Rest } else { EventKind::Held };
                self.events.push(Event { state, kind });
                self.keep_speed()
            }
        }
    }

    /// The change of the speed to the end, if the moment stayed.
    fn first_length(&self) -> f64 {
        let Node { state, acceleration } = self.node;
        let (w, e) = (state.speed.abs(), acceleration.abs());
        let length = match self.request.until {
            Until::Time(end) => e * (end - state.time),
            Until::Coordinate(_) | Until::Rest if acceleration * state.speed < 0.0 => w,
            Until::Coordinate(end) => {
                let twice = 2.0 * e * (end - state.coordinate).abs();
                twice / (w + (w * w + twice).sqrt())
            }
            Until::Rest => w.max(e),
        };
        length.min(e * (self.request.latest() - state.time))
    }

    /// Sign of the acceleration.
    pub(super) fn direction(&self) -> f64 {
        self.node.acceleration.signum()
    }

    /// The speed ahead that no panel passes: the bound of the piece, or zero.
    pub(super) fn wall(&self) -> f64 {
        let (direction, speed) = (self.direction(), self.node.state.speed);
        let wall = self.piece.speed[usize::from(direction > 0.0)];
        let zero_ahead = speed * direction < 0.0;
        if zero_ahead && wall * direction > 0.0 { 0.0 } else { wall }
    }

    fn advance(&mut self) -> Result<(), IntegrationError> {
        let Node { state, acceleration } = self.node;
        let least = 4.0 * f64::EPSILON * state.speed.abs();
        if acceleration == 0.0 || self.first_length() <= least {
            return self.keep_speed();
        }
        let room = (self.wall() - state.speed).abs();
        if room == 0.0 {
            return self.land_on_wall(state);
        }
        let at_wall = self.length * 1.05 >= room && !self.lengthened;
        let length = if at_wall { room } else { self.length };
        self.trials += 1;
        if self.trials > MOST_TRIALS || length <= least.max(f64::MIN_POSITIVE) {
            return Err(self.given_up());
        }
        let along = self.direction() * length;
        match Panel::fit(&mut self.equation, &self.node, along) {
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

    /// Goes through a panel, or plans another trial.
    fn judge(&mut self, panel: &Panel, length: f64, room: f64) -> Result<(), IntegrationError> {
        let error = self.error(panel);
        let factor = factor(error);
        if error <= 1.0 {
            self.plan(panel, length, factor);
            return self.pass(panel, room);
        }
        if let Some(whole) = panel.length_to_pole().filter(|_| !self.lengthened) {
            self.statistics.rejected += 1;
            self.lengthened = true;
            self.length = whole.min(2.0 * room);
            return Ok(());
        }
        // After a panel that passed, one that failed held a pole rather than far too much.
        let least = if self.before > 0.0 { 0.4 } else { 0.1 };
        self.shorten(length * factor.clamp(least, 0.7));
        Ok(())
    }

    /// The panel after one that passed.
    fn plan(&mut self, panel: &Panel, length: f64, factor: f64) {
        self.statistics.steps += 1;
        // Towards a speed at which the moment vanishes panels shrink as they did before.
        let shrinking = if self.before > 0.0 { (length / self.before).min(1.0) } else { 1.0 };
        let most = if self.rejected { 1.0 } else { 4.0 };
        let grown = length * (factor * shrinking).clamp(0.1, most);
        let to_pole = panel.length_to_pole().map(|whole| whole - length).filter(|rest| *rest > 0.0);
        self.length = to_pole.map_or(grown, |rest| rest.min(grown));
        (self.before, self.lengthened, self.rejected) = (length, false, false);
    }

    fn shorten(&mut self, length: f64) {
        self.statistics.rejected += 1;
        self.rejected = true;
        self.length = length;
    }

    /// Error of a panel over what is allowed: parts of the largest speed and of the largest way so far.
    fn error(&self, panel: &Panel) -> f64 {
        let tolerance = (0.25 * self.request.tolerance).max(ROUNDINGS);
        let [speed, way] = panel.error;
        let fastest = self.fastest.max(panel.last_speed().abs());
        // What is lost while the motion leaves a speed that repels grows with it.
        let own = panel.length().abs().max(64.0 * f64::EPSILON / tolerance * fastest);
        let size = if panel.last.abs() > self.node.acceleration.abs() { own.min(fastest) } else { fastest };
        let travel = self.travel.max(panel.whole_way().abs());
        let error = (speed / (tolerance * size)).max(way / (tolerance * travel));
        if speed.is_finite() && way.is_finite() { error } else { f64::INFINITY }
    }

    /// Goes on to the end of a stretch.
    pub(super) fn go_to(&mut self, state: State) {
        self.node.state = state;
        self.fastest = self.fastest.max(state.speed.abs());
        self.travel = self.travel.max((state.coordinate - self.request.initial.coordinate).abs());
    }
}

/// Factor of the length that brings the error of a fit to what is allowed.
fn factor(error: f64) -> f64 {
    0.85 * (1.0 / error.max(1e-30)).powf(1.0 / 12.0)
}
