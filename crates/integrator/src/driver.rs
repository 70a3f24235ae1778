//! The loop around a one-step method: pieces, events, ends, samples and the size of steps, the same for all methods.

use crate::crossing::{SIDES, Side, Walls, turning};
use crate::recorder::Recorder;
use crate::{
    Attempt, Entered, Equation, Event, EventKind, IntegrationError, Motion, MotionError, Node, Pace, Piece,
    Request, Scale, State, Statistics, Stepper, Trajectory, enter, first_step,
};

mod hold;
mod landing;
mod report;

/// A cut this near to the end of a step takes its state from the dense output, whose error falls to zero there as
/// (θ(1-θ))²; a cut further inside has its step made anew.
const NEAR_END: f64 = 0.95;

/// A predicted crossing is aimed this much too far, so that it is met inside the step.
const OVERSHOOT: f64 = 1.02;

/// At a fixed step stability is looked at once in so many steps.
const STABILITY_PERIOD: usize = 64;

/// Solves the equation by the steps of a method: the `run` of an [`IntegratorPlugin`](crate::IntegratorPlugin).
///
/// # Errors
///
/// [`IntegrationError`] with the place reached.
pub fn drive<S: Stepper + Default>(
    motion: &mut dyn Motion,
    request: &Request,
) -> Result<Trajectory, IntegrationError> {
    let mut drive = Drive::new(S::default(), motion, request);
    drive.begin()?;
    while !drive.finished {
        drive.advance()?;
    }
    drive.conclude()
}

struct Drive<'a, S> {
    equation: Equation<'a>,
    stepper: S,
    request: &'a Request,
    pace: Pace,
    node: Node,
    piece: Piece,
    walls: Walls,
    scale: Scale,
    /// Proposed step, s.
    step: f64,
    /// Step to redo, and the wall that it shall meet.
    redo: Option<(f64, Side)>,
    error_before: f64,
    after_rejection: bool,
    stalls: usize,
    recorder: Recorder,
    events: Vec<Event>,
    statistics: Statistics,
    finished: bool,
}

/// A step about to be tried.
#[derive(Debug, Clone, Copy)]
struct Plan {
    h: f64,
    /// Ends exactly at this time.
    time: Option<f64>,
    /// Meant to meet this wall.
    wall: Option<Side>,
}

impl<'a, S: Stepper> Drive<'a, S> {
    fn new(stepper: S, motion: &'a mut dyn Motion, request: &'a Request) -> Self {
        let node = Node { state: request.initial, acceleration: 0.0 };
        Self {
            equation: Equation::new(motion),
            pace: stepper.pace(),
            stepper,
            request,
            node,
            piece: Piece::UNBOUNDED,
            walls: Walls::new(&Piece::UNBOUNDED, request, &node),
            scale: Scale::new(request.tolerance, &node.state),
            step: f64::INFINITY,
            redo: None,
            error_before: 1.0,
            after_rejection: false,
            stalls: 0,
            recorder: Recorder::new(request),
            events: Vec::new(),
            statistics: Statistics::default(),
            finished: false,
        }
    }

    fn begin(&mut self) -> Result<(), IntegrationError> {
        match enter(&mut self.equation, &self.node.state, false)? {
            Entered::Held => {
                self.recorder.begin(&self.node);
                self.hold()
            }
            Entered::Moving(piece, acceleration) => {
                self.go_on(piece, acceleration);
                self.recorder.begin(&self.node);
                self.step = self.initial_step();
                self.check_stability()
            }
        }
    }

    fn initial_step(&mut self) -> f64 {
        match self.pace {
            Pace::Unlimited => f64::INFINITY,
            Pace::Fixed => first_step::fixed(self.request, &self.node),
            Pace::Adaptive(control) => {
                let longest = self.request.latest() - self.node.state.time;
                let tolerance = self.request.tolerance;
                first_step::adaptive(&mut self.equation, &self.node, tolerance, control.order, longest)
            }
        }
    }

    /// Continues in a piece.
    fn go_on(&mut self, piece: Piece, acceleration: f64) {
        self.node.acceleration = acceleration;
        self.piece = piece;
        self.walls = Walls::new(&piece, self.request, &self.node);
    }

    fn advance(&mut self) -> Result<(), IntegrationError> {
        if self.statistics.steps + self.statistics.rejected >= self.request.max_steps {
            return Err(self.too_many());
        }
        if let Some((side, dt)) = self.touching() {
            return self.land(side, self.node.advanced(dt));
        }
        let plan = self.plan()?;
        let attempt = self.stepper.attempt(&mut self.equation, &self.node, plan.h, &self.scale);
        let (attempt, acceleration) = match attempt.and_then(|attempt| self.finish_if_good(attempt)) {
            Ok((attempt, Some(acceleration))) => (attempt, acceleration),
            Ok((attempt, None)) => return self.reject(plan, attempt.error, None),
            Err(source) => return self.reject(plan, f64::INFINITY, Some(source)),
        };
        let mut to = Node { state: attempt.end, acceleration };
        to.state.time = plan.time.unwrap_or(to.state.time);
        self.judge(plan, attempt.error, to)
    }

    fn finish_if_good(&mut self, attempt: Attempt) -> Result<(Attempt, Option<f64>), MotionError> {
        if attempt.error <= 1.0 {
            let acceleration = self.stepper.finish(&mut self.equation)?;
            return Ok((attempt, Some(acceleration)));
        }
        Ok((attempt, None))
    }

    /// A wall so near that uniformly accelerated motion meets it without a step.
    fn touching(&self) -> Option<(Side, f64)> {
        /// Part of a step below which the error of a parabola is far below rounding.
        const NEGLIGIBLE: f64 = 1e-9;
        let reach = NEGLIGIBLE * if self.step.is_finite() { self.step } else { 0.0 };
        SIDES
            .into_iter()
            .filter_map(|side| self.walls.time_to(side, &self.node).map(|dt| (side, dt)))
            .filter(|(_, dt)| *dt <= reach)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn plan(&mut self) -> Result<Plan, IntegrationError> {
        if let Some((h, side)) = self.redo.take() {
            return Ok(Plan { h, time: None, wall: Some(side) });
        }
        let mut plan = Plan { h: self.step, time: None, wall: None };
        let margin = if S::PARABOLIC { 1.0 } else { OVERSHOOT };
        for side in SIDES {
            if let Some(time) = self.walls.time_to(side, &self.node).filter(|time| time * margin < plan.h) {
                (plan.h, plan.wall) = (time * margin, Some(side));
            }
        }
        let stop = self.piece.time[1].min(self.request.latest());
        let left = stop - self.node.state.time;
        if plan.h * 1.01 >= left && left.is_finite() {
            plan = Plan { h: left, time: Some(stop), wall: None };
        }
        if plan.h.is_finite() { Ok(plan) } else { Err(self.not_reached("nothing brings it there")) }
    }

    fn reject(
        &mut self,
        plan: Plan,
        error: f64,
        source: Option<MotionError>,
    ) -> Result<(), IntegrationError> {
        self.statistics.rejected += 1;
        self.after_rejection = true;
        let factor = match self.pace {
            Pace::Adaptive(control) => control.after_rejected(error),
            Pace::Fixed | Pace::Unlimited => 0.5,
        };
        self.step = plan.h * factor;
        let least = 4.0 * f64::EPSILON * self.node.state.time.abs().max(1e-12);
        match (self.step > least, source, self.pace) {
            // At a fixed step nothing is retried: the step is the user's word.
            (_, Some(source), Pace::Fixed | Pace::Unlimited) | (false, Some(source), _) => {
                Err(self.failed(source))
            }
            (false, None, _) => Err(IntegrationError::StepTooSmall { at: self.node.state, step: self.step }),
            (true, ..) => Ok(()),
        }
    }

    /// Decides about a step that is exact enough: all of it, up to an event, or anew up to an event.
    fn judge(&mut self, plan: Plan, error: f64, to: Node) -> Result<(), IntegrationError> {
        if self.walls.may_leave(&self.node, &to) {
            let dense = self.dense(&to)?;
            if let Some((theta, side)) = self.walls.first_exit(&dense) {
                if theta < NEAR_END && !S::PARABOLIC {
                    self.statistics.rejected += 1;
                    self.redo = Some((theta * plan.h, side));
                    return Ok(());
                }
                self.pace_on(&Plan { wall: Some(side), ..plan }, error);
                let state = self.walls.snap(side, dense.at(theta));
                self.record(&dense, state.time)?;
                return self.land(side, state);
            }
            if let Some(side) = self.walls.passed_by_rounding(&self.node.state, &to.state) {
                self.pace_on(&Plan { wall: Some(side), ..plan }, error);
                self.record(&dense, to.state.time)?;
                return self.land(side, to.state);
            }
        }
        self.accept(plan, error, to)
    }

    fn dense(&mut self, to: &Node) -> Result<crate::Dense, IntegrationError> {
        let dense = self.stepper.dense(&mut self.equation, &self.node, to);
        dense.map_err(|source| self.failed(source))
    }

    fn record(&mut self, dense: &crate::Dense, until: f64) -> Result<(), IntegrationError> {
        self.recorder.step(&mut self.equation, dense, until, false)
    }

    fn accept(&mut self, plan: Plan, error: f64, to: Node) -> Result<(), IntegrationError> {
        let turned = self.node.state.speed * to.state.speed < 0.0;
        if turned || self.recorder.wants(to.state.time) {
            let dense = self.dense(&to)?;
            self.record(&dense, to.state.time)?;
            if turned {
                let state = State { speed: 0.0, ..dense.at(turning(&dense)) };
                self.events.push(Event { state, kind: EventKind::Reversal });
            }
        }
        self.pace_on(&plan, error);
        self.statistics.steps += 1;
        self.stalls = 0;
        self.scale.extend(&to.state);
        self.node = to;
        if self.statistics.steps.is_multiple_of(STABILITY_PERIOD) {
            self.check_stability()?;
        }
        match (plan.time, plan.wall) {
            (Some(_), _) => self.land_in_time(),
            (None, Some(side)) => self.land_if_at(side, plan.h),
            (None, None) => Ok(()),
        }
    }

    /// Next step from the error of this one. A step that was shortened for an event says only that more would do.
    fn pace_on(&mut self, plan: &Plan, error: f64) {
        let Pace::Adaptive(control) = self.pace else { return };
        let factor = control.after_accepted(error, self.error_before);
        let factor = if self.after_rejection { factor.min(1.0) } else { factor };
        let next = plan.h * factor;
        let shortened = plan.time.is_some() || plan.wall.is_some();
        self.step = if shortened { next.max(self.step) } else { next };
        if !shortened {
            self.error_before = error.max(1e-4);
        }
        self.after_rejection = false;
    }
}
