//! Why an integration failed, and at which state.

use assur_plugin::RegistryError;

use crate::{MotionError, Request, State, Until};

/// Why there is no trajectory.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum IntegrationError {
    /// The request itself is impossible (what is wrong and what is allowed).
    #[error("bad request: {0}")]
    Request(String),
    /// The method can't treat this equation.
    #[error("integrator `{integrator}` can't treat this equation: {reason}")]
    Unsupported {
        /// Name of the method.
        integrator: &'static str,
        /// Why not.
        reason: String,
    },
    /// No linked method can treat the equation (what the equation depends on, in words).
    #[error("no linked integrator can treat this equation ({0})")]
    NoMethod(String),
    /// There is no such method, or the registry is faulty.
    #[error(transparent)]
    Registry(#[from] RegistryError),
    /// The accuracy would need steps too small for floating-point numbers.
    #[error(
        "the motion can't be followed beyond {at}: the tolerance asks for steps below {step:.1e} s; loosen it, or look for a load \
         or an inertia that grows without limit there"
    )]
    StepTooSmall {
        /// Place reached.
        at: State,
        /// The step, s.
        step: f64,
    },
    /// The allowed number of steps is used up.
    #[error("the motion got to {at} in {steps} steps, the most that are taken; the last one was {step:.1e} s{}", stiffness_words(*stiffness))]
    TooManySteps {
        /// Place reached.
        at: State,
        /// Steps taken, rejected ones included.
        steps: usize,
        /// Last step, s.
        step: f64,
        /// Step times the largest eigenvalue of the equation; `None` for an implicit method.
        stiffness: Option<f64>,
    },
    /// The fixed step is too long for the equation.
    #[error(
        "the fixed step {step:e} s is unstable at {at}: h*lambda = {product:.2}, allowed are {allowed}; take a step below {:.2e} s, or `radau5` if the equation is stiff",
        step * allowed / product
    )]
    Unstable {
        /// Place reached.
        at: State,
        /// The step, s.
        step: f64,
        /// Step times the largest eigenvalue.
        product: f64,
        /// The bound of the method.
        allowed: f64,
    },
    /// The motion reaches the end of its range: the mechanism has no position beyond.
    #[error(
        "the motion reaches the end of its range at {at}: {source}; end it before (`until`), or look whether the mechanism \
         shall pass there"
    )]
    EndOfRange {
        /// Place reached.
        at: State,
        /// What fails beyond.
        source: MotionError,
    },
    /// The equation has no value, however small the step.
    #[error("the equation of motion has no value after {at}: {source}")]
    Equation {
        /// Place reached.
        at: State,
        /// What failed.
        source: MotionError,
    },
    /// The requested end isn't reached.
    #[error("{goal} is never reached: the motion got to {at} and {why}")]
    NotReached {
        /// The requested end, in words.
        goal: String,
        /// Place reached.
        at: State,
        /// What prevents it.
        why: &'static str,
    },
    /// A smooth piece that the equation gave has no states in the direction of motion.
    #[error("the equation of motion gave an empty piece at {at}: its bounds must lie ahead of the motion")]
    EmptyPiece {
        /// Place reached.
        at: State,
    },
}

impl IntegrationError {
    /// The requested end is not reached, or was not within the allowed steps.
    pub fn is_unreached(&self) -> bool {
        matches!(self, Self::NotReached { .. } | Self::TooManySteps { .. })
    }

    /// The equation has no value at a state, or near it.
    pub fn equation(at: &State, source: MotionError) -> Self {
        match source {
            MotionError::Mechanism(_) => Self::EndOfRange { at: *at, source },
            _ => Self::Equation { at: *at, source },
        }
    }

    /// The end that `request` asks for isn't reached: `at` is the last state; the rest says why.
    pub fn not_reached(request: &Request, at: State, why: &'static str) -> Self {
        let goal = match request.until {
            Until::Time(end) => format!("time {end} s"),
            Until::Coordinate(end) => format!("coordinate {end}"),
            Until::Turn => "a turning point".to_owned(),
            Until::Rest => "rest".to_owned(),
        };
        Self::NotReached { goal, at, why }
    }
}

/// Above this product of step and eigenvalue the step of an explicit method is limited by stability, not by accuracy:
/// the bound on the negative real axis is 3.3 for dopri5, 6.1 for dop853 and 2.8 for rk4.
pub(crate) const SUSPICIOUS: f64 = 1.5;

fn stiffness_words(stiffness: Option<f64>) -> String {
    match stiffness {
        Some(product) if product > SUSPICIOUS => format!(
            "; the equation is probably stiff (h*lambda = {product:.2}: stability, not accuracy, holds the step): use `radau5`"
        ),
        Some(product) => format!(
            "; it does not look stiff (h*lambda = {product:.2}): loosen the tolerance, allow more steps (`max_steps`), or end the motion earlier (`until`)"
        ),
        None => "; loosen the tolerance, allow more steps (`max_steps`), or end the motion earlier (`until`)"
            .to_owned(),
    }
}
