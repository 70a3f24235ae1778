//! A solution in progress: what every method keeps from piece to piece, up to the end, as segments that follow each other in time;
//! and the equally spaced samples of it.

use assur_number::ROUNDING;
use assur_words::{Text, text};

use crate::piece_ahead::acceleration;
use crate::{
    CountedEquation, EquationOfMotion, Event, EventKind, IntegrationError, MotionError, Node, Piece, Request,
    Sample, State, Trajectory, Until, enter,
};

/// The reason where the speed only decays, so that the requested end is never reached.
pub(crate) const CREEPS: Text = text!("integrator-creeps");

/// Most events of a motion, which are all kept.
const MOST_EVENTS: usize = 1_000_000;

/// The motion so far. `C` is how the method describes the motion inside a segment.
pub struct Run<'a, C> {
    /// The equation of motion.
    pub equation: CountedEquation<'a>,
    /// What is requested.
    pub request: &'a Request,
    /// Present state, with its acceleration by the formulas of the present piece.
    pub node: Node,
    /// Present smooth piece.
    pub piece: Piece,
    /// The requested end is reached.
    pub finished: bool,
    first: Node,
    segments: Vec<Segment<C>>,
    events: Vec<Event>,
    /// Coordinates of the last turning points, backward and forward.
    turned_at: [Option<f64>; 2],
    /// Index of the next sample, where the end is a time.
    next_sample: usize,
}

impl<'a, C: Curve> Run<'a, C> {
    /// At the initial state, before any piece is entered.
    pub fn new(motion: &'a mut dyn EquationOfMotion, request: &'a Request) -> Self {
        let node = Node { state: request.initial, acceleration: 0.0 };
        Self {
            equation: CountedEquation::new(motion),
            request,
            node,
            piece: Piece::UNBOUNDED,
            finished: false,
            first: node,
            segments: Vec::with_capacity(64),
            events: Vec::new(),
            turned_at: [None; 2],
            next_sample: 1,
        }
    }

    /// Enters the first piece. `false`: the speed is held, see [`Run::enter`].
    pub fn begin(&mut self) -> Result<bool, IntegrationError> {
        let moving = self.enter(false)?;
        self.first = self.node;
        Ok(moving)
    }

    /// Enters the piece ahead; `at_speed_bound` if the speed is on a bound of the previous piece.
    ///
    /// `false`: the motion sticks at its speed, each side of which drives it back; the acceleration is zero then.
    pub fn enter(&mut self, at_speed_bound: bool) -> Result<bool, IntegrationError> {
        if self.events.len() > MOST_EVENTS {
            return Err(self.not_reached(text!("integrator-many-events")));
        }
        let entered = enter(&mut self.equation, &self.node.state, at_speed_bound)?;
        if let Some((piece, acceleration)) = entered {
            self.piece = piece;
            self.node.acceleration = acceleration;
        } else {
            self.node.acceleration = 0.0;
            self.event(if self.node.state.speed == 0.0 { EventKind::Rest } else { EventKind::Held });
        }
        Ok(entered.is_some())
    }

    /// Enters the piece after a bound of the present one, like [`Run::enter`], but a motion that would stop again
    /// within the rounding of its coordinate stops here: between two pieces that drive it back and forth it comes to
    /// rest after infinitely many turning points in a finite time.
    pub fn enter_next(&mut self, at_speed_bound: bool) -> Result<bool, IntegrationError> {
        /// Roundings of the coordinate.
        const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
        let moving = self.enter(at_speed_bound)?;
        let Node { state: State { coordinate, speed, .. }, acceleration } = self.node;
        let stopping = 0.5 * speed * speed / acceleration.abs();
        if moving && speed * acceleration < 0.0 && stopping < ROUNDINGS * coordinate.abs().max(1e-3) {
            self.node.state.speed = 0.0;
            return self.enter(true);
        }
        Ok(moving)
    }

    /// Something happened at the present state.
    pub fn event(&mut self, kind: EventKind) {
        self.event_at(self.node.state, kind);
    }

    /// Something happened at a state.
    pub fn event_at(&mut self, state: State, kind: EventKind) {
        self.events.push(Event { kind, state });
    }

    /// Whether there may be a sample in a step to `time`, s, which itself belongs to the next step. Where the end is
    /// not a time, the sampling instants are not known yet.
    pub fn wants(&self, time: f64) -> bool {
        let (next, count) = (self.next_sample, self.request.samples);
        next < count
            && match self.request.until {
                Until::Time(end) => instant(self.first.state.time, end, next, count) < time,
                Until::Coordinate(_) | Until::Turn | Until::Rest => true,
            }
    }

    /// The speed changes its sign at a state; `before` has the sign of the speed before.
    ///
    /// # Errors
    ///
    /// [`IntegrationError::NotReached`] where the motion oscillates between two turning points, and does not end in
    /// time.
    pub fn reversal(&mut self, state: State, before: f64) -> Result<(), IntegrationError> {
        self.event_at(state, EventKind::Reversal);
        let side = usize::from(before > 0.0);
        let last = self.turned_at[side].replace(state.coordinate);
        let endless = matches!(self.request.until, Until::Coordinate(_) | Until::Rest);
        let (Some(last), Some(other)) = (last, self.turned_at[1 - side]) else { return Ok(()) };
        let swing = (state.coordinate - other).abs();
        let same = (state.coordinate - last).abs() <= ROUNDING.max(self.request.tolerance) * swing;
        if endless && same && !self.equation.dependence().moment_on_time {
            // An oscillation smaller than the errors of the motion doesn't count.
            let way = (state.coordinate - self.request.initial.coordinate).abs();
            let creeps = swing <= self.request.tolerance * way;
            let why = if creeps { CREEPS } else { text!("integrator-swings") };
            return Err(self.not_reached(why));
        }
        Ok(())
    }

    /// An error where a coordinate that is reached has grown so large that few of its digits are significant, and the motion does not
    /// end in time.
    pub fn check_way(&self, coordinate: f64) -> Result<(), IntegrationError> {
        /// Coordinate, rad (m).
        const FURTHEST: f64 = 1e12;
        let endless = !matches!(self.request.until, Until::Time(_));
        if endless && coordinate.abs() > FURTHEST {
            Err(self.not_reached(text!("integrator-endless")))
        } else {
            Ok(())
        }
    }

    /// Stores the motion from the present state to the time `end`, s, for its samples.
    pub fn record(&mut self, curve: C, end: f64) {
        self.push(Some(curve), end);
    }

    fn push(&mut self, curve: Option<C>, end: f64) {
        if self.wants(end) {
            self.segments.push(Segment { from: self.node.state, end, curve });
        }
        while matches!(self.request.until, Until::Time(_)) && self.wants(end) {
            self.next_sample += 1;
        }
    }

    /// Keeps the present speed up to the time `end`, s.
    pub fn coast_until(&mut self, end: f64) {
        self.push(None, end);
        self.node = Node { state: self.node.state.coasting_until(end), acceleration: 0.0 };
    }

    /// Keeps the present speed to the end, since nothing will change it.
    ///
    /// # Errors
    ///
    /// [`IntegrationError::NotReached`] if the end is not reached at that speed.
    pub fn coast_to_end(&mut self) -> Result<(), IntegrationError> {
        let State { time, coordinate, speed } = self.node.state;
        self.finished = true;
        self.node.acceleration = 0.0;
        let end = match self.request.until {
            Until::Time(end) => end,
            Until::Turn | Until::Rest if speed == 0.0 => return Ok(()),
            Until::Turn | Until::Rest => return Err(self.not_reached(text!("integrator-keeps-speed"))),
            Until::Coordinate(_) if speed == 0.0 => return Err(self.not_reached(text!("integrator-rests"))),
            Until::Coordinate(target) => time + (target - coordinate) / speed,
        };
        if end < time {
            return Err(self.not_reached(text!("integrator-moves-away")));
        }
        if end > self.request.latest() {
            return Err(self.not_reached(text!("integrator-time-is-over")));
        }
        self.coast_until(end);
        if let Until::Coordinate(target) = self.request.until {
            self.node.state.coordinate = target;
        }
        Ok(())
    }

    /// The coordinate ahead in that direction at which the motion ends (then `true`), or else the piece ends; may be
    /// infinite.
    pub fn coordinate_ahead(&self, direction: f64) -> (f64, bool) {
        let bound = self.piece.coordinate[usize::from(direction > 0.0)];
        match self.request.until {
            Until::Coordinate(target)
                if (target - self.node.state.coordinate) * direction > 0.0
                    && (target - bound) * direction <= 0.0 =>
            {
                (target, true)
            }
            _ => (bound, false),
        }
    }

    /// Ends here, with the acceleration by the formulas of the present piece.
    pub fn finish(&mut self) -> Result<(), IntegrationError> {
        self.node.acceleration = acceleration(&mut self.equation, &self.node.state)?;
        self.finished = true;
        Ok(())
    }

    /// The time limit is reached: an error unless the requested end is a time.
    pub fn time_is_over(&self) -> Result<(), IntegrationError> {
        match self.request.until {
            Until::Time(_) => Ok(()),
            _ => Err(self.not_reached(text!("integrator-time-is-over"))),
        }
    }

    /// All allowed steps are used.
    pub fn is_exhausted(&self) -> bool {
        self.equation.cost.steps + self.equation.cost.rejected >= self.request.max_steps
    }

    /// The error of a run that [is exhausted](Self::is_exhausted): with its last step, s, and for an explicit method with step
    /// times eigenvalue.
    pub fn too_many_steps(&self, step: f64, stiffness: Option<f64>) -> IntegrationError {
        let steps = self.equation.cost.steps + self.equation.cost.rejected;
        IntegrationError::TooManySteps { at: self.node.state, steps, step, stiffness }
    }

    /// The equation has no value near the present state.
    pub fn failed(&self, source: MotionError) -> IntegrationError {
        IntegrationError::equation(&self.node.state, source)
    }

    /// No step is short enough: the equation has no value (`source`, or just ahead), or changes too fast.
    pub fn stuck(&mut self, step: f64, source: Option<MotionError>) -> IntegrationError {
        /// Part of the coordinate, rad (m), by which to look ahead.
        const AHEAD: f64 = 1e-6;
        let Node { state: at, acceleration } = self.node;
        let sense = if at.speed == 0.0 { acceleration.signum() } else { at.speed.signum() };
        let coordinate = at.coordinate + sense * AHEAD * at.coordinate.abs().max(1.0);
        let source = source.or_else(|| self.equation.acceleration(&State { coordinate, ..at }).err());
        match source {
            Some(source) => self.failed(source),
            None => IntegrationError::StepTooSmall { at, step },
        }
    }

    /// The error that the end isn't reached, with the reason.
    pub fn not_reached(&self, why: Text) -> IntegrationError {
        IntegrationError::NotReached { goal: self.request.until, at: self.node.state, why }
    }

    /// The motion that was found.
    pub fn conclude(mut self) -> Result<Trajectory, IntegrationError> {
        let ends = [self.first, self.node];
        let samples = samples(&mut self.equation, &self.segments, self.request, ends)?;
        let statistics = self.equation.cost;
        Ok(Trajectory { samples, events: self.events, statistics, end: self.node.state })
    }
}

/// The motion inside one smooth piece of the equation, as a function of time.
pub trait Curve {
    /// State at a time of the segment that begins with the state `from`.
    fn at(&self, from: &State, time: f64) -> State;
}

/// A part of the motion inside one smooth piece.
#[derive(Debug, Clone)]
pub(crate) struct Segment<C> {
    pub(crate) from: State,
    /// Time at its end, s.
    pub(crate) end: f64,
    /// The motion in it; `None` where the speed is held constant regardless of the equation.
    pub(crate) curve: Option<C>,
}

impl<C: Curve> Segment<C> {
    fn at(&self, time: f64) -> State {
        match &self.curve {
            Some(curve) => curve.at(&self.from, time),
            None => self.from.coasting_until(time),
        }
    }

    fn node(&self, equation: &mut CountedEquation<'_>, time: f64) -> Result<Node, IntegrationError> {
        let state = self.at(time);
        let acceleration = match self.curve {
            Some(_) => acceleration(equation, &state)?,
            None => 0.0,
        };
        Ok(Node { state, acceleration })
    }

    /// Enters the smooth piece of the equation that holds the segment, by a state well inside.
    fn enter(&self, equation: &mut CountedEquation<'_>) -> Result<(), IntegrationError> {
        if self.curve.is_some() {
            let middle = self.at(0.5 * (self.from.time + self.end));
            equation.enter(&middle).map_err(|source| IntegrationError::equation(&middle, source))?;
        }
        Ok(())
    }
}

/// The samples of a motion from `first` to `last`: the requested number of equally spaced ones after the first, the last at the end.
///
/// Segments that contain no sample may be missing.
pub(crate) fn samples<C: Curve>(
    equation: &mut CountedEquation<'_>,
    segments: &[Segment<C>],
    &Request { samples: count, accelerations, .. }: &Request,
    [first, last]: [Node; 2],
) -> Result<Vec<Sample>, IntegrationError> {
    let mut samples = Vec::with_capacity(count + 1);
    samples.push(Sample::from(first));
    let (mut index, mut entered) = (0, None);
    for k in 1..count {
        let time = instant(first.state.time, last.state.time, k, count);
        while index + 1 < segments.len() && segments[index].end <= time {
            index += 1;
        }
        let Some(segment) = segments.get(index) else { break };
        if !accelerations {
            samples.push(Sample::from(Node { state: segment.at(time), acceleration: 0.0 }));
            continue;
        }
        if entered != Some(index) {
            segment.enter(equation)?;
            entered = Some(index);
        }
        samples.push(Sample::from(segment.node(equation, time)?));
    }
    samples.resize(count, Sample::from(last));
    samples.push(Sample::from(last));
    Ok(samples)
}

/// Time of the sample `k` of `count`, s.
pub(crate) fn instant(start: f64, end: f64, k: usize, count: usize) -> f64 {
    start + (end - start) * (k as f64 / count as f64)
}
