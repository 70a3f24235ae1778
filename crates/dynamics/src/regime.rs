//! The steady regime of a scene with the dry friction of its pairs, and with the motors that fit.

use std::sync::Arc;

use assur_force::Loads;
use assur_integrator::{EquationOfMotion as _, State};
use assur_kinematics::Linkage;
use assur_mechanism::{Drive, Mechanism, Motion, MotorChoice, Solve, Torque};
use assur_motor::Motor;
use assur_number::search::try_bisect;
use serde::{Serialize, Serializer};

use crate::scene::{Steady, chosen_motor, cycle_request, steady_motion};
use crate::{DynamicsError, Machine, friction::KnownMotion, machine::Watcher, steady::CycleRequest};

/// Finds the steady regime of a scene. The watcher sees every state that is evaluated and may stop the search with an
/// error.
///
/// # Errors
///
/// [`DynamicsError`]: no such motion in the scene, a position that fails, no motor, no regime.
pub fn steady(
    linkage: &Linkage,
    loads: &Loads,
    watcher: Option<&mut Watcher<'_>>,
) -> Result<Steady, DynamicsError> {
    steady_of(linkage, loads, &linkage.mechanism, watcher)
}

/// The steady regime with the motion and the drive of `mechanism`, which is else that of the linkage.
pub(crate) fn steady_of(
    linkage: &Linkage,
    loads: &Loads,
    mechanism: &Mechanism,
    watcher: Option<&mut Watcher<'_>>,
) -> Result<Steady, DynamicsError> {
    let mut machine = Machine::new(linkage, loads);
    if machine.has_friction() {
        return with_friction(machine, mechanism, watcher);
    }
    steady_motion(&mut machine, mechanism, watcher)
}

/// The steady regime of a machine with dry friction: friction is that of the speeds and accelerations of the regime before, until
/// both agree.
fn with_friction(
    mut machine: Machine<'_>,
    mechanism: &Mechanism,
    mut watcher: Option<&mut Watcher<'_>>,
) -> Result<Steady, DynamicsError> {
    let (request, _) = cycle_request(mechanism)?;
    let mut course = KnownMotion::Uniform(request.mean_speed);
    let mut before = f64::INFINITY;
    for _ in 0..MOST_ROUNDS {
        machine.assume(Some(course.clone()));
        let bends = bends(&mut machine, &request)?;
        machine.bend_at(bends, request.length);
        let found = steady_motion(&mut machine, mechanism, watcher.as_deref_mut())?;
        let next = KnownMotion::Regime(Arc::new(found.regime.clone()));
        let change = change(&course, &next, &request);
        // It falls by the same factor from round to round, down to its rounding.
        if change <= CONVERGED || change <= NEARLY && change > 0.5 * before {
            machine.assume(None);
            return check_friction(machine, &request, found);
        }
        (course, before) = (next, change);
    }
    Err(DynamicsError::NotPeriodic { cycles: MOST_ROUNDS, residual: before })
}

/// Rounds in which the friction of a regime has to agree with the regime.
const MOST_ROUNDS: usize = 60;
/// Relative change of the speed at which a round has converged, and at which its rounding may be all that is left.
const CONVERGED: f64 = 1e-13;
const NEARLY: f64 = 1e-9;
/// Positions of a cycle at which regimes are compared.
const PLACES: u32 = 360;

fn places(request: &CycleRequest) -> impl Iterator<Item = f64> {
    let (start, step) = (request.start, request.mean_speed.signum() * request.length / f64::from(PLACES));
    (0..PLACES).map(move |place| start + step * f64::from(place))
}

/// The greatest change of the speed from one course to another, as part of the mean speed.
fn change(before: &KnownMotion, after: &KnownMotion, request: &CycleRequest) -> f64 {
    let off = |place: f64| ((after.at(place)[0] - before.at(place)[0]) / request.mean_speed).abs();
    places(request).map(off).fold(0.0, f64::max)
}

/// Refuses a regime in which at some position another acceleration is possible, or none.
fn check_friction(
    machine: Machine<'_>,
    request: &CycleRequest,
    found: Steady,
) -> Result<Steady, DynamicsError> {
    let mut motion = machine.with_drive(found.regime.drive());
    for coordinate in places(request) {
        let state = State { time: 0.0, coordinate, speed: found.regime.state(coordinate).speed };
        let failed = |source| DynamicsError::Equation { coordinate, source };
        motion.enter(&state).map_err(failed)?;
        motion.reduced(&state).map_err(failed)?;
    }
    Ok(found)
}

/// The coordinates of a cycle at which another face is pressed: there the moment of friction has a kink.
fn bends(machine: &mut Machine<'_>, request: &CycleRequest) -> Result<Vec<f64>, DynamicsError> {
    let step = request.mean_speed.signum() * request.length / f64::from(PLACES);
    let mut all = Vec::new();
    for from in places(request) {
        let state = |coordinate| State { time: 0.0, coordinate, speed: request.mean_speed };
        let failed = |source| DynamicsError::Equation { coordinate: from, source };
        machine.enter(&state(from + 0.5 * step)).map_err(failed)?;
        let mut pressing = |coordinate: f64| {
            machine.reduced(&state(coordinate)).map_err(failed)?;
            machine.bends(&state(coordinate)).map_err(failed)
        };
        let [start, end] = [pressing(from)?, pressing(from + step)?];
        for which in (0..start.len()).filter(|which| start[*which] * end[*which] < 0.0) {
            let same =
                |coordinate: f64| pressing(coordinate).map(|forces| forces[which] * start[which] > 0.0);
            all.push(try_bisect(from, from + step, 0.0, same)?[1]);
        }
    }
    all.sort_by(f64::total_cmp);
    Ok(all)
}

/// A motor in the place of that of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Advice {
    /// The row of its catalogue.
    #[serde(flatten, serialize_with = "entry")]
    pub motor: &'static Motor,
    /// The greatest unevenness for which it stays on the stable section of its characteristic, and what goes with it; `None` if
    /// the motor has no regime.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub regime: Option<AdvisedRegime>,
}

fn entry<S: Serializer>(motor: &Motor, serializer: S) -> Result<S::Ok, S::Error> {
    motor.entry(None).serialize(serializer)
}

/// The regime of the greatest unevenness that a motor allows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AdvisedRegime {
    /// (max - min) / mean of the input speed.
    pub unevenness: f64,
    /// Motor speed / input speed.
    pub ratio: f64,
    /// Moment of inertia of the flywheel for it, kg m²; 0 where none is needed.
    pub flywheel: f64,
    /// Greatest torque of the motor over the cycle, N m.
    pub greatest_torque: f64,
    /// Breakdown torque over this greatest torque, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_reserve: Option<f64>,
    /// Torque of the load at rest on the motor shaft, N m: the greatest of all positions of the cycle.
    pub starting_load: f64,
    /// Torque of the motor at rest, N m, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub starting_torque: Option<f64>,
}

impl AdvisedRegime {
    fn of(found: &Steady) -> Option<Self> {
        let work = &found.motor.as_ref()?.work;
        let greatest_torque = work.torque[1];
        let reserve = work.characteristic.breakdown_torque.map(|torque| torque / greatest_torque);
        Some(Self {
            unevenness: found.regime.figures.unevenness,
            ratio: found.regime.figures.ratio?,
            flywheel: found.regime.flywheel,
            greatest_torque,
            torque_reserve: reserve.filter(|ratio| ratio.is_finite()),
            starting_load: work.starting_load,
            starting_torque: work.starting_torque,
        })
    }

    /// Whether the motor starts against the load at rest; `None` where its torque at rest is not known.
    pub fn starts(&self) -> Option<bool> {
        self.starting_torque.map(|torque| torque >= self.starting_load)
    }
}

/// The motors that have the power which a scene needs and keep its limit of speed, the best first, at most `most` of them;
/// each with the greatest unevenness at which it stays on the stable section of its characteristic. Also returns how many
/// such motors there are.
///
/// # Errors
///
/// [`DynamicsError`]: no steady motion with a motor in the scene, or no motor that fits.
pub fn advise(linkage: &Linkage, loads: &Loads, most: usize) -> Result<(Vec<Advice>, usize), DynamicsError> {
    let mut mechanism = linkage.mechanism.clone();
    set_motor(&mut mechanism, MotorChoice::Auto, None);
    let chosen = chosen_motor(linkage, loads, &mechanism)?;
    let others = chosen.runners_up.iter().map(|candidate| candidate.motor);
    let all: Vec<_> = chosen.row().into_iter().chain(others).collect();
    let advice = all.iter().take(most).map(|motor| {
        let (designation, catalogue) = (motor.designation.clone(), motor.catalogue.clone());
        set_motor(&mut mechanism, MotorChoice::Designation(designation), Some(catalogue));
        let found = steady_of(linkage, loads, &mechanism, None);
        Advice { motor, regime: found.ok().as_ref().and_then(AdvisedRegime::of) }
    });
    Ok((advice.collect(), all.len()))
}

/// Sets the motor of a scene, whose flywheel is to be found for the greatest unevenness that it allows.
fn set_motor(mechanism: &mut Mechanism, new: MotorChoice, from: Option<String>) {
    if let Some(Motion::Steady { unevenness, .. }) = &mut mechanism.motion {
        *unevenness = Some(Solve::Wanted);
    }
    let Some(Drive { torque: Torque::Motor { motor, catalogue, .. }, flywheel, ratio, .. }) =
        &mut mechanism.drive
    else {
        return;
    };
    (*motor, *flywheel, *ratio) = (new, Some(Solve::Wanted), Solve::Wanted);
    if from.is_some() {
        *catalogue = from;
    }
}
