//! Motion from an initial state: until a time, a way, or rest.

use assur_force::Loads;
use assur_integrator::{Dependence, Equation, Motion, Request, Solution, State, Trajectory, Until, enter};
use assur_kinematics::Linkage;
use assur_mechanism::{Drive, FlywheelPlace, Mechanism, Motion as Asked, Solve, Torque, Until as AskedUntil};
use assur_motor::Characteristic;

use crate::motor::MotorWish;
use crate::told::{Tell, Told};
use crate::{DriveMotor, Driven, DynamicsError, Machine, Shaft, Source};

/// A transient motion.
#[derive(Debug, Clone)]
pub struct Transient {
    /// Samples, events, cost, end.
    pub trajectory: Trajectory,
    /// Name of the integrator.
    pub integrator: &'static str,
    /// Why it, as a sentence.
    pub reason: String,
    /// What J and Q depend on, the drive included.
    pub dependence: Dependence,
    /// Energies over the samples.
    pub energy: EnergyBalance,
    /// What was on the input shaft.
    pub shaft: Shaft,
    /// The motor, if there is one.
    pub motor: Option<DriveMotor>,
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
    /// Largest change of the sum against the first sample over the largest kinetic energy: the drift where the machine is
    /// conservative, else the work of the other loads.
    pub change: f64,
}

/// Solves the transient motion that a scene asks for.
///
/// # Errors
///
/// As [`transient_by`].
pub fn transient(linkage: &Linkage, loads: &Loads) -> Result<Transient, DynamicsError> {
    transient_by(linkage, loads, None, None)
}

/// The same by another integrator or to another tolerance than the scene's.
///
/// # Errors
///
/// [`DynamicsError`]: no such motion in the scene, no such integrator or none that suits, a failed position, the end is
/// never reached.
pub fn transient_by(
    linkage: &Linkage,
    loads: &Loads,
    integrator: Option<&str>,
    tolerance: Option<f64>,
) -> Result<Transient, DynamicsError> {
    transient_told(linkage, loads, integrator, tolerance, None)
}

/// The same; `tell` is told of every state that is evaluated, and may stop the motion: then it fails.
///
/// # Errors
///
/// As [`transient_by`].
pub fn transient_told(
    linkage: &Linkage,
    loads: &Loads,
    integrator: Option<&str>,
    tolerance: Option<f64>,
    tell: Option<&mut Tell<'_>>,
) -> Result<Transient, DynamicsError> {
    let Some(Asked::Transient { integrator: named, tolerance: scenes, .. }) = &linkage.mechanism.motion
    else {
        return Err(DynamicsError::NoMotion { kind: "transient" });
    };
    let (shaft, motor) = shaft_of(&linkage.mechanism)?;
    let mut motion = Driven::new(Machine::new(linkage, loads), shaft);
    let mut request = request(&linkage.mechanism, &mut motion)?;
    request.tolerance = tolerance.unwrap_or(*scenes);
    let dependence = motion.dependence();
    let mut told;
    let equation: &mut dyn Motion = match tell {
        Some(tell) => {
            told = Told { motion: &mut motion, tell };
            &mut told
        }
        None => &mut motion,
    };
    let Solution { trajectory, integrator, reason } =
        assur_integrator::solve(integrator.unwrap_or(named), equation, &request)?;
    let integrator = integrator.name;
    let conservative = is_conservative(&linkage.mechanism);
    let energy = balance(&mut motion, &trajectory, conservative)?;
    Ok(Transient { trajectory, integrator, reason, dependence, energy, shaft, motor })
}

/// The equation of motion of a scene with its drive, for a motion in time. `ratio` and `flywheel` must be given.
///
/// # Errors
///
/// [`DynamicsError::SteadyOnly`], and what is wrong with the motor.
pub fn equation<'a>(linkage: &'a Linkage, loads: &'a Loads) -> Result<Driven<Machine<'a>>, DynamicsError> {
    let (shaft, _) = shaft_of(&linkage.mechanism)?;
    Ok(Driven::new(Machine::new(linkage, loads), shaft))
}

/// The request for an integrator that a scene's transient motion makes.
///
/// # Errors
///
/// [`DynamicsError::NoMotion`]; from rest, the first position may fail.
pub fn request(mechanism: &Mechanism, motion: &mut dyn Motion) -> Result<Request, DynamicsError> {
    let Some(Asked::Transient { speed, until, samples, tolerance, .. }) = &mechanism.motion else {
        return Err(DynamicsError::NoMotion { kind: "transient" });
    };
    let initial = State { time: 0.0, coordinate: mechanism.input.from, speed: *speed };
    let until = match until {
        AskedUntil::Time(end) => Until::Time(*end),
        AskedUntil::Rest => Until::Rest,
        AskedUntil::Way(way) => {
            Until::Coordinate(initial.coordinate + heading(&initial, mechanism, motion)? * way)
        }
    };
    Ok(Request { samples: *samples, tolerance: *tolerance, ..Request::new(initial, until) })
}

/// The sense in which the motion begins: of the speed; from rest, where the moments lead; else the input's.
fn heading(initial: &State, mechanism: &Mechanism, motion: &mut dyn Motion) -> Result<f64, DynamicsError> {
    if initial.speed != 0.0 {
        return Ok(initial.speed.signum());
    }
    match enter(&mut Equation::new(motion), initial, false)? {
        Some((_, acceleration)) => Ok(acceleration.signum()),
        None => Ok(mechanism.input.sign()),
    }
}

/// What a scene puts on the input shaft.
fn shaft_of(mechanism: &Mechanism) -> Result<(Shaft, Option<DriveMotor>), DynamicsError> {
    let Some(drive) = &mechanism.drive else { return Ok((Shaft::FREE, None)) };
    let sense = mechanism.input.sign();
    let flywheel = given(drive.flywheel.unwrap_or(Solve::Given(0.0)), "`flywheel = \"solve\"`")?;
    let (source, motor) = source_of(drive, sense)?;
    let ratio = if let Source::Motor { ratio, .. } = source { ratio } else { 1.0 };
    let rotor = motor.as_ref().map_or(0.0, DriveMotor::rotor);
    let inertia = match drive.flywheel_on {
        FlywheelPlace::Crank => flywheel + ratio * ratio * rotor,
        FlywheelPlace::Motor => ratio * ratio * (rotor + flywheel),
    };
    Ok((Shaft { source, sense, inertia }, motor))
}

fn given(solve: Solve, what: &'static str) -> Result<f64, DynamicsError> {
    match solve {
        Solve::Given(value) => Ok(value),
        Solve::Wanted => Err(DynamicsError::SteadyOnly { what }),
    }
}

fn source_of(drive: &Drive, sense: f64) -> Result<(Source, Option<DriveMotor>), DynamicsError> {
    match &drive.torque {
        Torque::None => Ok((Source::None, None)),
        Torque::Balance => Err(DynamicsError::SteadyOnly { what: "`torque = \"balance\"`" }),
        Torque::Constant(moment) => Ok((Source::Constant(sense * moment), None)),
        Torque::Motor { motor, catalogue, max_speed, characteristic } => {
            let wish = MotorWish {
                motor,
                catalogue: catalogue.as_deref(),
                max_speed: *max_speed,
                kind: *characteristic,
            };
            let ratio = given(drive.ratio, "`ratio = \"solve\"`")?;
            let motor = wish.find(None)?;
            let characteristic = Characteristic::new(motor.kind, &motor.rated)?;
            Ok((Source::Motor { characteristic, ratio, efficiency: drive.efficiency }, Some(motor)))
        }
    }
}

fn is_conservative(mechanism: &Mechanism) -> bool {
    mechanism.forces.is_empty()
        && mechanism.moments.is_empty()
        && mechanism.contacts.is_empty()
        && mechanism.springs.iter().all(|spring| spring.damping == 0.0)
        && mechanism.drive.as_ref().is_none_or(|drive| drive.torque == Torque::None)
}

fn balance(
    motion: &mut Driven<Machine<'_>>,
    trajectory: &Trajectory,
    conservative: bool,
) -> Result<EnergyBalance, DynamicsError> {
    let mut found = EnergyBalance { conservative, ..EnergyBalance::default() };
    for sample in &trajectory.samples {
        let (coordinate, speed) = (sample.coordinate, sample.speed);
        let failed = |source| DynamicsError::Equation { coordinate, source };
        let state = State { time: sample.time, coordinate, speed };
        let inertia = motion.reduced(&state).map_err(failed)?.inertia;
        found.kinetic.push(0.5 * inertia * speed * speed);
        found.potential.push(motion.machine().potential_energy(coordinate).map_err(failed)?);
    }
    let sums: Vec<f64> = found.kinetic.iter().zip(&found.potential).map(|(t, v)| t + v).collect();
    let first = sums.first().copied().unwrap_or(0.0);
    let scale = found.kinetic.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    found.change = sums.iter().map(|sum| (sum - first).abs()).fold(0.0, f64::max) / scale;
    Ok(found)
}
