//! The loop around a one-step method: pieces, events, ends, samples and the size of steps, the same for all methods.

use std::marker::PhantomData;

use assur_words::text;

use crate::change::first_change_in;
use crate::event_location::{Bounds, SIDES, Side, turning};
use crate::{
    Dense, EquationOfMotion, EventKind, FixedStep, IntegrationError, Integrator, MotionError, Node, Pace,
    Request, Run, Scale, State, Step, Stepper, Trajectory, control,
};

mod events;
mod sticking;

/// A cut this near to the end of a step takes its state from the dense output, whose error falls to zero there as
/// (θ(1-θ))²; for a cut further inside, the step is repeated with the shorter length.
const NEAR_END: f64 = 0.95;

/// A step aimed at a predicted crossing is lengthened by this factor, so that the crossing is inside the step.
const OVERSHOOT: f64 = 1.02;

/// Number of steps after which the report looks for stiffness.
const MANY_STEPS: usize = 1000;

/// At a fixed step, stability is checked once in this number of steps.
const PERIOD: usize = 64;

/// The integrator that advances by the steps of the method `S`.
pub struct Steps<S>(PhantomData<fn() -> S>);

impl<S> Steps<S> {
    /// The integrator; it holds no state.
    pub const NEW: Self = Self(PhantomData);
}

impl<S: Stepper> Integrator for Steps<S> {
    fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Trajectory, IntegrationError> {
        let mut drive = Drive::<S>::new(motion, request);
        drive.begin()?;
        while !drive.run.finished {
            drive.advance()?;
        }
        if drive.run.equation.cost.steps > MANY_STEPS {
            drive.run.equation.cost.stiffness = drive.stiffness();
        }
        drive.run.conclude()
    }
}

struct Drive<'a, S> {
    run: Run<'a, Dense>,
    stepper: S,
    /// The bounds of the present piece, narrowed by the end.
    bounds: Bounds,
    scale: Scale,
    /// Proposed step, s.
    step: f64,
    /// A step to repeat, s, and where it is to end.
    redo: Option<(f64, Aim)>,
    /// The [bends](crate::EquationOfMotion::bends) at the present state, and at the end of the step that is judged.
    bends: [Vec<f64>; 2],
    error_before: f64,
    after_rejection: bool,
    /// Events in a row between which no time passed.
    stalls: usize,
    /// Steps in a row whose speed is below the tolerance, and the time before them, s.
    slow: (usize, f64),
}

/// A step about to be tried.
#[derive(Debug, Clone, Copy)]
struct Plan {
    h: f64,
    /// Where it is to end, if it is shortened for that.
    aim: Option<Aim>,
}

/// Where a step is meant to end.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Aim {
    /// Exactly at this time.
    Time(f64),
    /// On a bound of the piece.
    Bound(Side),
    /// Where the equation has a kink.
    Bend,
    /// Just beyond a change that is no bound.
    Switch,
}

impl<'a, S: Stepper> Drive<'a, S> {
    fn new(motion: &'a mut dyn EquationOfMotion, request: &'a Request) -> Self {
        let run = Run::new(motion, request);
        Self {
            stepper: S::default(),
            bounds: Bounds::new(&run.piece, request, &run.node),
            scale: Scale::new(request.tolerance, &run.node.state),
            run,
            step: f64::INFINITY,
            redo: None,
            bends: [Vec::new(), Vec::new()],
            error_before: 1.0,
            after_rejection: false,
            stalls: 0,
            slow: (0, request.initial.time),
        }
    }

    fn begin(&mut self) -> Result<(), IntegrationError> {
        if !self.run.begin()? {
            return self.stick();
        }
        self.start_steps()?;
        self.check_stability()
    }

    /// In a new piece, from rest or after sticking, no step size is known.
    fn start_steps(&mut self) -> Result<(), IntegrationError> {
        self.update_bounds();
        self.note_bends()?;
        self.step = match S::PACE {
            Pace::Unlimited => f64::INFINITY,
            Pace::Fixed => control::fixed_step(self.run.request, &self.run.node),
            Pace::Adaptive(control) => {
                let longest = self.run.request.latest() - self.run.node.state.time;
                let tolerance = self.run.request.tolerance;
                control::first_step(&mut self.run.equation, &self.run.node, tolerance, control.order, longest)
            }
        };
        Ok(())
    }

    fn update_bounds(&mut self) {
        self.bounds = Bounds::new(&self.run.piece, self.run.request, &self.run.node);
    }

    fn advance(&mut self) -> Result<(), IntegrationError> {
        if self.run.is_exhausted() {
            return Err(self.too_many_steps());
        }
        if let Some((side, dt)) = self.touching() {
            return self.meet(side, self.run.node.advanced(dt));
        }
        let plan = self.plan()?;
        let step =
            Step { equation: &mut self.run.equation, from: self.run.node, length: plan.h, scale: self.scale };
        let attempt = self.stepper.attempt(step);
        let finished = attempt.and_then(|attempt| {
            let passed = attempt.error <= 1.0;
            let end = passed.then(|| self.stepper.finish(&mut self.run.equation, &attempt.end));
            Ok((attempt, end.transpose()?))
        });
        let (attempt, acceleration) = match finished {
            Ok((attempt, Some(acceleration))) => (attempt, acceleration),
            Ok((attempt, None)) => return self.reject(plan, attempt.error, None),
            Err(source) => return self.reject(plan, f64::INFINITY, Some(source)),
        };
        let mut to = Node { state: attempt.end, acceleration };
        if let Some(Aim::Time(time)) = plan.aim {
            to.state.time = time;
        }
        self.judge(plan, attempt.error, to)
    }

    /// A bound so near that uniformly accelerated motion meets it without a step of the method.
    fn touching(&self) -> Option<(Side, f64)> {
        /// Part of a step below which the error of a parabola is far below rounding.
        const NEGLIGIBLE: f64 = 1e-9;
        let reach = NEGLIGIBLE * if self.step.is_finite() { self.step } else { 0.0 };
        SIDES
            .into_iter()
            .filter_map(|side| self.bounds.time_to(side, &self.run.node).map(|dt| (side, dt)))
            .filter(|(_, dt)| *dt <= reach)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn plan(&mut self) -> Result<Plan, IntegrationError> {
        if let Some((h, aim)) = self.redo.take() {
            return Ok(Plan { h, aim: Some(aim) });
        }
        if let (Pace::Fixed, Some(FixedStep::Coordinate(_))) = (S::PACE, self.run.request.fixed_step) {
            self.step = control::fixed_step(self.run.request, &self.run.node);
        }
        let mut plan = Plan { h: self.step, aim: None };
        let margin = if S::PARABOLIC { 1.0 } else { OVERSHOOT };
        for side in SIDES {
            let time = self.bounds.time_to(side, &self.run.node);
            if let Some(time) = time.filter(|time| time * margin < plan.h) {
                plan = Plan { h: time * margin, aim: Some(Aim::Bound(side)) };
            }
        }
        let stop = self.run.piece.time[1].min(self.run.request.latest());
        let left = stop - self.run.node.state.time;
        if plan.h * 1.01 >= left && left.is_finite() {
            plan = Plan { h: left, aim: Some(Aim::Time(stop)) };
        }
        if plan.h.is_finite() {
            Ok(plan)
        } else {
            Err(self.run.not_reached(text!("integrator-nothing-brings")))
        }
    }

    fn reject(
        &mut self,
        plan: Plan,
        error: f64,
        source: Option<MotionError>,
    ) -> Result<(), IntegrationError> {
        self.run.equation.cost.rejected += 1;
        self.after_rejection = true;
        let factor = match S::PACE {
            Pace::Adaptive(control) => control.after_rejected(error),
            Pace::Fixed | Pace::Unlimited => 0.5,
        };
        self.step = plan.h * factor;
        let least = 4.0 * f64::EPSILON * self.run.node.state.time.abs().max(1e-12);
        // At a fixed step nothing is retried: the user has decided.
        let retried = matches!(S::PACE, Pace::Adaptive(_)) || source.is_none();
        if retried && self.step > least { Ok(()) } else { Err(self.run.stuck(self.step, source)) }
    }

    /// Decides what to do with a step that is exact enough: accept it whole or up to an event, or repeat it up to an
    /// event.
    fn judge(&mut self, plan: Plan, error: f64, to: Node) -> Result<(), IntegrationError> {
        if self.bends_within(&plan, &to)? {
            return Ok(());
        }
        let may_leave = self.bounds.may_leave(&self.run.node, &to);
        if may_leave || self.run.equation.dependence().moment_switches {
            let dense = self.dense(&to)?;
            let exit = if may_leave { self.bounds.first_exit(&dense) } else { None };
            let change = first_change_in(&self.run.equation, &dense);
            if let Some(change) = change.filter(|[_, after]| exit.is_none_or(|(theta, _)| *after < theta)) {
                return self.meet_change(plan, error, &dense, change);
            }
            if let Some((theta, side)) = exit {
                if theta < NEAR_END && !S::PARABOLIC {
                    self.run.equation.cost.rejected += 1;
                    self.redo = Some((theta * plan.h, Aim::Bound(side)));
                    return Ok(());
                }
                self.propose(&Plan { aim: Some(Aim::Bound(side)), ..plan }, error);
                let state = self.bounds.snap(side, dense.at(theta));
                self.run.record(dense, state.time);
                return self.meet(side, state);
            }
            let rounding = self.bounds.passed_by_rounding(&self.run.node.state, &to.state);
            if let Some(side) = rounding.filter(|_| may_leave) {
                self.propose(&Plan { aim: Some(Aim::Bound(side)), ..plan }, error);
                self.run.record(dense, to.state.time);
                return self.meet(side, to.state);
            }
        }
        self.accept(plan, error, to)
    }

    fn dense(&mut self, to: &Node) -> Result<Dense, IntegrationError> {
        let dense = self.stepper.dense(&mut self.run.equation, &self.run.node, to);
        dense.map_err(|source| self.run.failed(source))
    }

    fn accept(&mut self, plan: Plan, error: f64, to: Node) -> Result<(), IntegrationError> {
        let turned = self.run.node.state.speed * to.state.speed < 0.0;
        if turned || self.run.wants(to.state.time) {
            let dense = self.dense(&to)?;
            self.run.record(dense, to.state.time);
            if turned {
                let state = State { speed: 0.0, ..dense.at(turning(&dense)) };
                self.check_turning(&state)?;
                self.run.reversal(state, self.run.node.state.speed)?;
            }
        }
        self.propose(&plan, error);
        self.run.equation.cost.steps += 1;
        self.stalls = 0;
        self.scale.extend(&to.state);
        self.run.node = to;
        self.bends.swap(0, 1);
        if self.run.equation.cost.steps.is_multiple_of(PERIOD) {
            self.check_stability()?;
        }
        self.check_creeping()?;
        self.run.check_way(self.run.node.state.coordinate)?;
        match plan.aim {
            Some(Aim::Time(_)) => self.meet_time(),
            Some(Aim::Bound(side)) => self.meet_if_at(side, plan.h),
            Some(Aim::Bend) => {
                self.run.event(EventKind::Face);
                Ok(())
            }
            Some(Aim::Switch) | None => Ok(()),
        }
    }

    /// Next step from the error of this one. A step shortened for an event only shows that a longer one would be
    /// possible.
    fn propose(&mut self, plan: &Plan, error: f64) {
        let Pace::Adaptive(control) = S::PACE else { return };
        let factor = control.after_accepted(error, self.error_before);
        let factor = if self.after_rejection { factor.min(1.0) } else { factor };
        let next = plan.h * factor;
        self.step = if plan.aim.is_some() { next.max(self.step) } else { next };
        if plan.aim.is_none() {
            self.error_before = error.max(1e-4);
        }
        self.after_rejection = false;
    }

    /// Step times eigenvalue, here.
    fn stiffness(&mut self) -> Option<f64> {
        if S::IMPLICIT || !self.step.is_finite() {
            return None;
        }
        Some(self.run.equation.eigenvalue(&self.run.node.state).ok()? * self.step)
    }

    pub(super) fn too_many_steps(&mut self) -> IntegrationError {
        let stiffness = self.stiffness();
        self.run.too_many_steps(self.step, stiffness)
    }

    /// At a fixed step no error estimate would notice an unstable step.
    pub(super) fn check_stability(&mut self) -> Result<(), IntegrationError> {
        if S::PACE != Pace::Fixed {
            return Ok(());
        }
        let at = self.run.node.state;
        let eigenvalue = self.run.equation.eigenvalue(&at).map_err(|source| self.run.failed(source))?;
        let (step, product, allowed) = (self.step, self.step * eigenvalue, S::STABLE);
        if product > allowed {
            return Err(IntegrationError::Unstable { at, step, product, allowed });
        }
        Ok(())
    }
}
