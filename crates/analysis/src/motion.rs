//! How the input moves: as the scene prescribes it, or as the equation of motion determines it.

use assur_dynamics::{
    DynamicsError, Machine, Method, Steady, Transient, Watcher, equation, steady, transient,
};
use assur_force::{LoadState, Loads, Side};
use assur_integrator::{
    AUTO, Dependence, EquationOfMotion as _, IntegrationError, RankedMethod, State, choose,
};
use assur_kinematics::Linkage;
use assur_mechanism::{Key, Mechanism, Motion, Torque};
use assur_words::{Describe, Text, joined, name, number, text};

use crate::progress::{Stopped, Watch};
use crate::{AnalysisError, Options, Progress};

/// Number of intervals over one cycle of a steady regime at which its states are examined.
pub(crate) const CYCLE_INTERVALS: u32 = 360;

/// How the input moves.
#[derive(Debug, Clone)]
pub enum InputMotion {
    /// As the scene prescribes it; at rest without a motion.
    Prescribed,
    /// From an initial state, by an integrator.
    Transient(Box<Transient>),
    /// In the steady regime.
    Steady(Box<Steady>),
}

impl InputMotion {
    /// Solves the motion of a scene. Without loads (because no position exists) there is nothing to solve.
    pub(crate) fn of(
        linkage: &Linkage,
        loads: Option<&Loads>,
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Self, AnalysisError> {
        let Some(loads) = loads else { return Ok(Self::Prescribed) };
        let mut progress = counter(&linkage.mechanism);
        let mut stopped = false;
        let mut watcher = |state: &State| {
            let flow = watch(progress(state));
            stopped |= flow.is_break();
            flow
        };
        let found = Self::found(linkage, loads, options, Some(&mut watcher));
        // A method that is stopped may return another error, or try another method.
        if stopped {
            return Err(Stopped.into());
        }
        let found = found?;
        match found.infinite_at(&linkage.mechanism) {
            Some(coordinate) => {
                let message =
                    text!("analysis-infinite", coordinate = number(format_args!("{coordinate:.6}")));
                Err(AnalysisError::Motion { message, usage: false, key: Key::of("motion") })
            }
            None => Ok(found),
        }
    }

    /// The first coordinate of a cycle at which speed or acceleration of a regime is not finite.
    fn infinite_at(&self, mechanism: &Mechanism) -> Option<f64> {
        let Self::Steady(found) = self else { return None };
        let input = &mechanism.input;
        let cycle = input.sign() * input.period()?;
        let mut each =
            (0..=CYCLE_INTERVALS).map(|i| input.from + cycle * (f64::from(i) / f64::from(CYCLE_INTERVALS)));
        each.find(|coordinate| {
            let at = found.regime.state(*coordinate);
            !(at.speed.is_finite() && at.acceleration.is_finite() && at.time.is_finite())
        })
    }

    fn found(
        linkage: &Linkage,
        loads: &Loads,
        options: &Options,
        watcher: Option<&mut Watcher<'_>>,
    ) -> Result<Self, DynamicsError> {
        match linkage.mechanism.motion {
            Some(Motion::Transient { .. }) => {
                let method = Method { integrator: options.integrator.as_deref(), tolerance: None };
                Ok(Self::Transient(Box::new(transient(linkage, loads, &method, watcher)?)))
            }
            Some(Motion::Steady { .. }) => Ok(Self::Steady(Box::new(steady(linkage, loads, watcher)?))),
            Some(Motion::Prescribed { .. }) | None => Ok(Self::Prescribed),
        }
    }

    /// State of the input at the coordinate of a position. In a transient motion the positions are at rest: the motion
    /// is in the trajectory.
    pub(crate) fn state(&self, mechanism: &Mechanism, coordinate: f64) -> LoadState {
        match self {
            Self::Prescribed | Self::Transient(_) => LoadState::prescribed(mechanism, coordinate),
            Self::Steady(found) => {
                let at = found.regime.state(coordinate);
                let (speed, acceleration, time) = (at.speed, at.acceleration, at.time);
                LoadState { coordinate, speed, acceleration, time, side: Side::After, drive: None }
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

/// Converts the states in which a motion is evaluated into progress.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a count that is shown: not negative, and beyond the largest number nobody counts"
)]
fn counter(mechanism: &Mechanism) -> impl FnMut(&State) -> Progress {
    let is_steady = matches!(mechanism.motion, Some(Motion::Steady { .. }));
    let (start, period, mut evaluations) = (mechanism.input.from, mechanism.input.period(), 0);
    move |state| {
        evaluations += 1;
        if is_steady {
            return Progress::Regime { evaluations };
        }
        let cycles = period.map_or(0.0, |period| ((state.coordinate - start) / period).abs());
        Progress::Motion { time: state.time, cycles: cycles as usize }
    }
}

/// Which case of D the equation of a motion is, and which method is used for it and why; `None` without an equation,
/// and where no position can be assembled.
pub fn method_of_motion(linkage: &Linkage, options: &Options) -> Result<Option<Text>, AnalysisError> {
    let mechanism = &linkage.mechanism;
    if linkage.range.is_none() || !mechanism.has_equation_of_motion() {
        return Ok(None);
    }
    let loads = Loads::compile(linkage)?;
    if let Some(Motion::Transient { integrator: own, tolerance, .. }) = &mechanism.motion {
        let dependence = equation(linkage, &loads)?.dependence();
        let named = options.integrator.as_deref().unwrap_or(own);
        return Ok(Some(integrator_words(dependence, named, *tolerance).map_err(DynamicsError::from)?));
    }
    let mut dependence = Machine::new(linkage, &loads).dependence();
    let drive = mechanism.drive.as_ref();
    dependence.moment_on_speed |= drive.is_some_and(|d| matches!(d.torque, Torque::Motor { .. }));
    Ok(Some(equation_words(dependence)))
}

/// `case 3 of D (J(q), M(q))`.
fn equation_words(dependence: Dependence) -> Text {
    text!("analysis-equation", case = number(dependence.case()), equation = dependence.describe())
}

/// The integrator for such an equation, and the reason for it.
fn integrator_words(dependence: Dependence, named: &str, tolerance: f64) -> Result<Text, IntegrationError> {
    let chosen = choose(named, &dependence, tolerance)?;
    let RankedMethod { integrator, reason } = &chosen.first;
    let method = name(integrator.name);
    if named != AUTO {
        return Ok(text!(
            "analysis-integrator-named",
            method,
            reason,
            summary = &integrator.summary,
            equation = equation_words(dependence)
        ));
    }
    let stiff = chosen.if_stiff().map(|method| text!("analysis-if-stiff", method = name(method.name)));
    let first = text!("analysis-integrator", method, reason);
    Ok(joined("; ", [first].into_iter().chain(stiff)))
}

/// Whether the scene or the chosen method is at fault, rather than the machine that it describes.
pub(crate) fn is_usage(error: &DynamicsError) -> bool {
    use DynamicsError as D;
    matches!(
        error,
        D::NoMotion(_)
            | D::NoCycle
            | D::NotRepeating { .. }
            | D::OverTime
            | D::SteadyOnly(_)
            | D::Rated(_)
            | D::Motor(_)
            | D::Integration(
                IntegrationError::Request(_)
                    | IntegrationError::Unsupported { .. }
                    | IntegrationError::NoMethod(_)
                    | IntegrationError::Registry(_)
            )
    )
}
