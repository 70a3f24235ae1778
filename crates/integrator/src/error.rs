//! Why an integration failed, and at which state.

use assur_plugin::RegistryError;
use assur_words::{Describe, Text, name, number, text};

use crate::{Dependence, MotionError, State, Until, integrators};

/// Why there is no trajectory.
#[derive(Clone)]
pub enum IntegrationError {
    /// The request itself is impossible (what is wrong and what is allowed).
    Request(Text),
    /// The method does not support this equation.
    Unsupported {
        /// Name of the method.
        integrator: &'static str,
        /// Why not.
        reason: Text,
    },
    /// No linked method suits the equation (what the equation depends on).
    NoMethod(Dependence),
    /// There is no such method, or the registry is faulty.
    Registry(RegistryError),
    /// The accuracy would need steps too small for floating-point numbers.
    StepTooSmall {
        /// Place reached.
        at: State,
        /// The step, s.
        step: f64,
    },
    /// The allowed number of steps is used up.
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
    EndOfRange {
        /// Place reached.
        at: State,
        /// What fails beyond.
        source: MotionError,
    },
    /// The equation has no value, however small the step.
    Equation {
        /// Place reached.
        at: State,
        /// What failed.
        source: MotionError,
    },
    /// The requested end isn't reached.
    NotReached {
        /// The requested end.
        goal: Until,
        /// Place reached.
        at: State,
        /// What prevents it.
        why: Text,
    },
    /// A smooth piece that the equation gave has no states in the direction of motion.
    EmptyPiece {
        /// Place reached.
        at: State,
    },
}

impl IntegrationError {
    /// The equation has no value at a state, or near it.
    pub fn equation(at: &State, source: MotionError) -> Self {
        match source {
            MotionError::Mechanism(_) => Self::EndOfRange { at: *at, source },
            _ => Self::Equation { at: *at, source },
        }
    }
}

/// Above this product of step and eigenvalue the step of an explicit method is limited by stability, not by accuracy:
/// the bound on the negative real axis is 3.3 for dopri5, 6.1 for dop853 and 2.8 for rk4.
pub(crate) const SUSPICIOUS: f64 = 1.5;

assur_words::errors!(IntegrationError; Registry(RegistryError));

impl Describe for IntegrationError {
    fn describe(&self) -> Text {
        match self {
            Self::Request(fault) => text!("integrator-bad-request", fault),
            Self::Unsupported { integrator, reason } => {
                text!("integrator-unsupported", method = name(*integrator), reason)
            }
            Self::NoMethod(dependence) => text!("integrator-no-method", equation = dependence.describe()),
            Self::Registry(error) => error.describe(),
            Self::StepTooSmall { at, step } => text!(
                "integrator-step-too-small",
                state = at.describe(),
                step = number(format_args!("{step:.1e}"))
            ),
            Self::TooManySteps { at, steps, step, stiffness } => text!(
                "integrator-too-many-steps",
                state = at.describe(),
                steps = *steps,
                step = number(format_args!("{step:.1e}")),
                advice = advice(*stiffness)
            ),
            Self::Unstable { at, step, product, allowed } => text!(
                "integrator-unstable",
                step = number(format_args!("{step:e}")),
                state = at.describe(),
                product = number(format_args!("{product:.2}")),
                allowed = number(allowed),
                below = number(format_args!("{:.2e}", step * allowed / product)),
                method = implicit()
            ),
            Self::EndOfRange { at, source } => {
                text!("integrator-end-of-range", state = at.describe(), cause = source.describe())
            }
            Self::Equation { at, source } => {
                text!("integrator-no-value", state = at.describe(), cause = source.describe())
            }
            Self::NotReached { goal, at, why } => {
                text!("integrator-not-reached", goal = goal.describe(), state = at.describe(), why)
            }
            Self::EmptyPiece { at } => text!("integrator-empty-piece", state = at.describe()),
        }
    }
}

impl Describe for Until {
    fn describe(&self) -> Text {
        match self {
            Self::Time(end) => text!("integrator-goal-time", time = number(end)),
            Self::Coordinate(end) => text!("integrator-goal-coordinate", coordinate = number(end)),
            Self::Turn => text!("integrator-goal-turn"),
            Self::Rest => text!("integrator-goal-rest"),
        }
    }
}

/// The method that stiff equations ask for: one that declares it, if a program has one.
fn implicit() -> Text {
    let stiff = integrators().unwrap_or_default().into_iter().find(|plugin| plugin.stiff);
    stiff.map_or_else(|| text!("integrator-implicit"), |plugin| name(format!("`{}`", plugin.name)))
}

/// What to do about too many steps.
fn advice(stiffness: Option<f64>) -> Text {
    let rounded = |product: f64| number(format_args!("{product:.2}"));
    match stiffness {
        Some(product) if product > SUSPICIOUS => {
            text!("integrator-advice-stiff", product = rounded(product), method = implicit())
        }
        Some(product) => text!("integrator-advice-not-stiff", product = rounded(product)),
        None => text!("integrator-advice"),
    }
}
