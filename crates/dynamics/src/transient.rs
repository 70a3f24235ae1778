//! Motion from an initial state: until a time, a coordinate, or rest.

use assur_force::Loads;
use assur_integrator::{
    CountedEquation, Dependence, EquationOfMotion, FixedStep, IntegrationError, Knob, Request, Solution,
    State, Trajectory, Until, enter,
};
use assur_kinematics::Linkage;
use assur_mechanism::{
    Drive, FlywheelPlace, Load, Mechanism, Motion, Solve, StepLength, Torque, Until as AskedUntil,
};
use assur_motor::MotorWarning;
use assur_words::{Describe, Text};

use crate::drive::{InputDrive, TorqueSource};
use crate::machine::{Watched, Watcher};
use crate::{DynamicsError, Machine, instant::Instant, motor::DriveMotor};

/// A transient motion.
#[derive(Debug, Clone)]
pub struct Transient {
    /// Samples, events, cost, end.
    pub trajectory: Trajectory,
    /// Name of the integrator.
    pub integrator: &'static str,
    /// The reason for the integrator, as a sentence.
    pub reason: Text,
    /// What J and Q depend on, the drive included.
    pub dependence: Dependence,
    /// The samples with everything that acts in them.
    pub instants: Vec<Instant>,
    /// Energies over the samples.
    pub energy: EnergyBalance,
    /// Why there is no rest for good, if it was requested and the motion ends at its first turning point instead.
    pub unrest: Option<Text>,
}

impl Transient {
    /// The measured error of a method with fixed steps, which keep no tolerance; 0 for other methods.
    pub fn error_of_fixed_steps(&self) -> f64 {
        let has_fixed_steps =
            assur_integrator::find(self.integrator).is_ok_and(|method| method.knob == Knob::Step);
        self.trajectory.statistics.error.filter(|_| has_fixed_steps).unwrap_or(0.0)
    }
}

/// The method of a transient motion, where it differs from the scene's.
#[derive(Debug, Clone, Copy, Default)]
pub struct Method<'a> {
    /// Name of the integrator; `None`: the scene's.
    pub integrator: Option<&'a str>,
    /// Relative tolerance; `None`: the scene's.
    pub tolerance: Option<f64>,
}

/// Energies over the samples of a motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EnergyBalance {
    /// Of each sample: kinetic energy with flywheel and rotor, J.
    pub kinetic: Vec<f64>,
    /// Of each sample: potential energy of weights and springs, J.
    pub potential: Vec<f64>,
    /// Whether nothing but weights and springs acts, so that the sum must be constant.
    pub conservative: bool,
    /// Largest change of the sum against the first sample, divided by the largest kinetic energy: the drift of the
    /// solution where the machine is conservative, else the work of the other loads.
    pub change: f64,
    /// What the rounding of the coordinate and of its own terms makes of the potential energy in the worst sample, divided by
    /// the largest kinetic energy.
    pub rounding: f64,
    /// What an error as great as the greatest speed would add to the kinetic energy in the worst sample, divided by the largest
    /// kinetic energy, at least 1: steps keep their tolerance of that speed, and where the reduced inertia grows without limit,
    /// that counts for more than all the energy.
    pub by_speed: f64,
}

impl EnergyBalance {
    /// The largest kinetic energy, J, positive.
    pub fn greatest(&self) -> f64 {
        self.kinetic.iter().copied().fold(f64::MIN_POSITIVE, f64::max)
    }
}

/// Solves the transient motion that a scene defines. The watcher sees every state that is evaluated and may stop the
/// motion with an error.
///
/// # Errors
///
/// [`DynamicsError`]: no such motion in the scene, no such integrator or none that suits, a failed position, or an end
/// that is never reached.
pub fn transient(
    linkage: &Linkage,
    loads: &Loads,
    method: &Method<'_>,
    watcher: Option<&mut Watcher<'_>>,
) -> Result<Transient, DynamicsError> {
    let mechanism = &linkage.mechanism;
    let Some(Motion::Transient { integrator: named, tolerance, .. }) = &mechanism.motion else {
        return Err(DynamicsError::NoMotion("transient"));
    };
    let mut motion = equation(linkage, loads)?;
    let mut request = request(mechanism, &mut motion)?;
    request.tolerance = method.tolerance.unwrap_or(*tolerance);
    let dependence = motion.dependence();
    let mut watched = Watched::new(&mut motion, watcher);
    let named = method.integrator.unwrap_or(named);
    let (found, unrest) = solve(named, &mut watched, &request)?;
    let Solution { trajectory, integrator, reason } = found;
    let last = trajectory.samples.len().saturating_sub(1);
    let completed = trajectory.samples.iter().enumerate().map(|(index, sample)| {
        let coordinate = sample.coordinate;
        let instant = motion.instant(sample, index == last);
        instant.map_err(|source| DynamicsError::Equation { coordinate, source })
    });
    let instants = completed.collect::<Result<_, _>>()?;
    let energy = balance(&mut motion, &trajectory, is_conservative(mechanism))?;
    Ok(Transient { trajectory, integrator: integrator.name, reason, dependence, instants, energy, unrest })
}

/// Solves the equation. A motion that is to end at rest, but never rests for good, ends at its first turning point; the
/// reason is returned with it.
fn solve(
    named: &str,
    motion: &mut Watched<'_, '_>,
    request: &Request,
) -> Result<(Solution, Option<Text>), IntegrationError> {
    let first = assur_integrator::solve(named, motion, request);
    let why = match &first {
        Err(IntegrationError::NotReached { why, .. }) if request.until == Until::Rest => why.clone(),
        Err(error @ IntegrationError::TooManySteps { .. }) if request.until == Until::Rest => {
            error.describe()
        }
        _ => return Ok((first?, None)),
    };
    let [slowest, fastest] = motion.speeds;
    if slowest > 0.0 || fastest < 0.0 {
        // It turned nowhere.
        return Ok((first?, None));
    }
    let turning = Request { until: Until::Turn, ..*request };
    let Ok(found) = assur_integrator::solve(named, motion, &turning) else { return Ok((first?, None)) };
    Ok((found, Some(why)))
}

/// The equation of motion of a scene with its drive, for a motion in time. `ratio` and `flywheel` must be given.
///
/// # Errors
///
/// [`DynamicsError::SteadyOnly`], and what is wrong with the motor.
pub fn equation<'a>(linkage: &'a Linkage, loads: &'a Loads) -> Result<Machine<'a>, DynamicsError> {
    Ok(Machine::new(linkage, loads).with_drive(input_drive(&linkage.mechanism)?))
}

/// The request for an integrator that a scene's transient motion makes.
///
/// # Errors
///
/// [`DynamicsError::NoMotion`]; from rest, the first position may fail.
pub fn request(mechanism: &Mechanism, motion: &mut dyn EquationOfMotion) -> Result<Request, DynamicsError> {
    let Some(Motion::Transient { speed, until, samples, tolerance, step, max_steps, .. }) = &mechanism.motion
    else {
        return Err(DynamicsError::NoMotion("transient"));
    };
    let fixed_step = step.map(|step| match step {
        StepLength::Time(step) => FixedStep::Time(step),
        StepLength::Way(step) => FixedStep::Coordinate(step),
    });
    let initial = State { time: 0.0, coordinate: mechanism.input.from, speed: *speed };
    let until = match until {
        AskedUntil::Time(end) => Until::Time(*end),
        AskedUntil::Turn => Until::Turn,
        AskedUntil::Rest => Until::Rest,
        AskedUntil::Way(way) => {
            Until::Coordinate(initial.coordinate + heading(&initial, mechanism, motion)? * way)
        }
    };
    let usual = Request::new(initial, until);
    let max_steps = max_steps.unwrap_or(usual.max_steps);
    Ok(Request { samples: *samples, tolerance: *tolerance, fixed_step, max_steps, ..usual })
}

/// The direction in which the motion begins: that of the speed; from rest, that of the moments; else the input's.
fn heading(
    initial: &State,
    mechanism: &Mechanism,
    motion: &mut dyn EquationOfMotion,
) -> Result<f64, DynamicsError> {
    if initial.speed != 0.0 {
        return Ok(initial.speed.signum());
    }
    match enter(&mut CountedEquation::new(motion), initial, false)? {
        Some((_, acceleration)) => Ok(acceleration.signum()),
        None => Ok(mechanism.input.sign()),
    }
}

/// The motor that drives in time; one is chosen for steady regimes only.
fn motor(drive: &Drive) -> Result<Option<DriveMotor>, DynamicsError> {
    DriveMotor::of(&drive.torque, || Err(DynamicsError::SteadyOnly("`motor = \"auto\"`")))
}

/// A warning where the rotor of the motor of a transient motion counts as massless, since its inertia is not known.
pub fn unknown_rotor(mechanism: &Mechanism) -> Option<MotorWarning> {
    motor(mechanism.drive.as_ref()?).ok()??.unknown_rotor()
}

/// What drives the input link of a scene in time.
fn input_drive(mechanism: &Mechanism) -> Result<InputDrive, DynamicsError> {
    let Some(drive) = &mechanism.drive else { return Ok(InputDrive::NONE) };
    let sense = mechanism.input.sign();
    let steady_only = |what| DynamicsError::SteadyOnly(what);
    let given = |solve: Solve, what| solve.value().ok_or_else(|| steady_only(what));
    let flywheel = given(drive.flywheel.unwrap_or(Solve::Given(0.0)), "`flywheel = \"solve\"`")?;
    let motor = motor(drive)?;
    let rotor = motor.as_ref().map_or(0.0, DriveMotor::rotor);
    let (source, ratio) = match (&drive.torque, motor) {
        (Torque::Balance, _) => return Err(steady_only("`torque = \"balance\"`")),
        (Torque::Constant(moment), _) => (TorqueSource::Constant(*moment), 1.0),
        (Torque::Motor { .. }, Some(DriveMotor { characteristic, .. })) => {
            let ratio = given(drive.ratio, "`ratio = \"solve\"`")?;
            (TorqueSource::Motor { characteristic, ratio, efficiency: drive.efficiency }, ratio)
        }
        (Torque::None | Torque::Motor { .. }, _) => (TorqueSource::None, 1.0),
    };
    let inertia = match drive.flywheel_on {
        FlywheelPlace::Crank => flywheel + ratio * ratio * rotor,
        FlywheelPlace::Motor => ratio * ratio * (rotor + flywheel),
    };
    Ok(InputDrive { source, sense, inertia })
}

fn is_conservative(mechanism: &Mechanism) -> bool {
    let elastic = |load: &Load| load.kind.spring().is_some_and(|spring| spring.damping == 0.0);
    mechanism.frictions.is_empty()
        && mechanism.loads.iter().all(elastic)
        && mechanism.drive.as_ref().is_none_or(|drive| drive.torque == Torque::None)
}

/// Roundings of a term of the potential energy: a few in the place of its ends, and as many in the first sample.
const ROUNDINGS: f64 = 8.0;

fn balance(
    motion: &mut Machine<'_>,
    trajectory: &Trajectory,
    conservative: bool,
) -> Result<EnergyBalance, DynamicsError> {
    let mut found = EnergyBalance { conservative, ..EnergyBalance::default() };
    let fastest = trajectory.samples.iter().map(|sample| sample.speed.abs()).fold(0.0, f64::max);
    for sample in &trajectory.samples {
        let (coordinate, speed) = (sample.coordinate, sample.speed);
        let failed = |source| DynamicsError::Equation { coordinate, source };
        let state = State { time: sample.time, coordinate, speed };
        let reduced = motion.ideal(&state).map_err(failed)?;
        found.kinetic.push(0.5 * reduced.inertia * speed * speed);
        found.by_speed = found.by_speed.max(0.5 * reduced.inertia * speed.abs() * fastest);
        let [potential, terms] = motion.potential_energy(coordinate).map_err(failed)?;
        let uncertain = (reduced.moment * coordinate).abs() + ROUNDINGS * terms;
        found.rounding = found.rounding.max(uncertain * f64::EPSILON);
        found.potential.push(potential);
    }
    let sums: Vec<f64> = found.kinetic.iter().zip(&found.potential).map(|(t, v)| t + v).collect();
    let first = sums.first().copied().unwrap_or(0.0);
    let scale = found.greatest();
    found.rounding /= scale;
    found.by_speed = (found.by_speed / scale).max(1.0);
    found.change = sums.iter().map(|sum| (sum - first).abs()).fold(0.0, f64::max) / scale;
    Ok(found)
}
