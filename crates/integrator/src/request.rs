//! The request to an integrator, and its result.

use assur_words::{Describe, Text, number, text};
use serde::Serialize;

use crate::{IntegrationError, Node, State};

/// When the motion ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Until {
    /// At this time, s (absolute, as [`State::time`]).
    Time(f64),
    /// At this coordinate, rad or m (absolute, as [`State::coordinate`]), from whichever side it is reached.
    Coordinate(f64),
    /// At the first instant of zero speed after the start: a turning point, or rest.
    Turn,
    /// At rest for good: passes turning points. Where the moment depends on time, at the first rest.
    Rest,
}

/// Length of the steps of a method with a fixed step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FixedStep {
    /// In time, s.
    Time(f64),
    /// In the coordinate, rad or m: each step takes the time in which uniformly accelerated motion covers it.
    Coordinate(f64),
}

/// What is requested: initial state, end, accuracy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Initial state.
    pub initial: State,
    /// When the motion ends.
    pub until: Until,
    /// Equally spaced output instants after the first. At least 1.
    pub samples: usize,
    /// Whether the samples have their accelerations, each of which is an evaluation of the equation; else only the first and the last.
    pub accelerations: bool,
    /// Requested relative accuracy of speed and displacement; methods at a fixed step ignore it.
    pub tolerance: f64,
    /// Most steps, accepted and rejected.
    pub max_steps: usize,
    /// Step of the methods with a fixed step. `None`: a thousandth of the (estimated) duration.
    pub fixed_step: Option<FixedStep>,
    /// Latest time, s, for an end by coordinate or rest: if it is reached first, the result is an error. May be
    /// infinite.
    pub time_limit: f64,
}

/// Least displacement that can be requested, as a part of the coordinate or of a thousandth of its unit: some unit
/// roundings.
const RESOLUTION: f64 = 64.0 * f64::EPSILON;

impl Request {
    /// A request with the defaults: 100 samples, tolerance 1e-9, 100 000 steps, no limit of time.
    pub fn new(initial: State, until: Until) -> Self {
        Self {
            initial,
            until,
            samples: 100,
            accelerations: true,
            tolerance: 1e-9,
            max_steps: 100_000,
            fixed_step: None,
            time_limit: f64::INFINITY,
        }
    }

    /// Rejects requests that no method can fulfill.
    ///
    /// # Errors
    ///
    /// [`IntegrationError::Request`] with what is wrong and what is allowed.
    #[expect(clippy::float_cmp, reason = "an end is refused only where it is the very same number")]
    pub fn check(&self) -> Result<(), IntegrationError> {
        let State { time, coordinate, speed } = self.initial;
        let refuse = |what: Text| Err(IntegrationError::Request(what));
        if !(time.is_finite() && coordinate.is_finite() && speed.is_finite()) {
            return refuse(text!("integrator-start-not-finite", state = self.initial.describe()));
        }
        if !(self.tolerance > 0.0 && self.tolerance < 1.0) {
            return refuse(text!(
                "integrator-bad-tolerance",
                tolerance = number(format_args!("{:e}", self.tolerance))
            ));
        }
        if self.samples == 0 || self.max_steps == 0 {
            return refuse(text!("integrator-bad-counts"));
        }
        if let Some(FixedStep::Time(step) | FixedStep::Coordinate(step)) = self.fixed_step
            && !(step > 0.0 && step.is_finite())
        {
            return refuse(text!("integrator-bad-step", step = number(format_args!("{step:e}"))));
        }
        match self.until {
            Until::Time(end) if !(end > time && end.is_finite()) => {
                refuse(text!("integrator-end-before-start", end = number(end), start = number(time)))
            }
            Until::Coordinate(end) if end == coordinate => {
                refuse(text!("integrator-end-at-start", end = number(end)))
            }
            Until::Coordinate(end) if !end.is_finite() => {
                refuse(text!("integrator-bad-end", end = number(end)))
            }
            Until::Coordinate(end) if (end - coordinate).abs() < RESOLUTION * coordinate.abs().max(1e-3) => {
                refuse(text!("integrator-end-near-start", end = number(end), start = number(coordinate)))
            }
            _ if self.time_limit.is_nan() || self.time_limit <= time => {
                refuse(text!("integrator-bad-limit", limit = number(self.time_limit), start = number(time)))
            }
            _ => Ok(()),
        }
    }

    /// The time that no step may pass: the end if it is a time, else the limit.
    pub fn latest(&self) -> f64 {
        match self.until {
            Until::Time(end) => end,
            Until::Coordinate(_) | Until::Turn | Until::Rest => self.time_limit,
        }
    }
}

/// The motion at one output instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// Coordinate, rad (m).
    pub coordinate: f64,
    /// Speed, rad/s (m/s).
    pub speed: f64,
    /// Acceleration from the equation itself, rad/s² (m/s²); at a jump, its value before the jump.
    pub acceleration: f64,
}

impl Sample {
    /// The state of the sample.
    pub fn state(&self) -> State {
        let Self { time, coordinate, speed, .. } = *self;
        State { time, coordinate, speed }
    }
}

impl From<Node> for Sample {
    fn from(Node { state: State { time, coordinate, speed }, acceleration }: Node) -> Self {
        Self { time, coordinate, speed, acceleration }
    }
}

/// What happened at an instant between smooth pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, strum::Display)]
#[serde(rename_all = "lowercase")]
#[strum(serialize_all = "lowercase")]
pub enum EventKind {
    /// A bound of a piece along the coordinate was reached: a row of a table, a contact.
    Coordinate,
    /// A bound of a piece in speed other than zero was reached.
    Speed,
    /// A bound of a piece in time was reached.
    Time,
    /// The formula of a load changed where several variables together make it: the argument of a `sign` passed zero.
    Switch,
    /// The speed passed through zero and changed its sign.
    Reversal,
    /// The speed became zero and stays zero: nothing can restart the motion, or not yet.
    Rest,
    /// The speed is held at a jump of the moment over the speed: each side drives it back.
    Held,
    /// A motion that rested or was held continues.
    Release,
    /// A force changed its sign on whose magnitude dry friction depends: another face is pressed.
    Face,
}

/// An event and the state at which it happened.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Event {
    /// What happened.
    pub kind: EventKind,
    /// State at the event.
    #[serde(flatten)]
    pub state: State,
}

/// What the solution cost.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct SolutionCost {
    /// Accepted steps (panels, for the energy form).
    pub steps: usize,
    /// Rejected steps, and steps redone to end on an event.
    pub rejected: usize,
    /// Evaluations of the equation, those for samples, events and Jacobians included.
    pub evaluations: usize,
    /// Jacobians of an implicit method.
    pub jacobians: usize,
    /// Smooth pieces entered, those for samples included.
    pub pieces: usize,
    /// Step times the largest eigenvalue of the equation, at the end of a run of more than a thousand steps; near 3 or
    /// above, stiffness limits the steps of an explicit method.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// Estimated error of the motion: [`Trajectory::deviation`] from a run at a tenth of the tolerance; for a method with a
    /// fixed step, from the motion by a method that controls its error. `None` for a method without discretization error in
    /// time, and if the other run failed. If it is far above
    /// the tolerance, the motion is too sensitive for it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
}

/// A motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trajectory {
    /// The initial instant and `samples` equally spaced ones after it, the last at the end.
    pub samples: Vec<Sample>,
    /// What happened between, in order of time.
    pub events: Vec<Event>,
    /// What it cost.
    pub statistics: SolutionCost,
    /// The state in which the motion ended.
    pub end: State,
}

#[cfg(test)]
mod tests;
