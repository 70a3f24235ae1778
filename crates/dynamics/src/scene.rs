//! The steady regime that a scene asks for.

use assur_force::Loads;
use assur_integrator::Motion as IsMotion;
use assur_kinematics::Linkage;
use assur_mechanism::{FlywheelPlace, InputPair, Mechanism, Motion, Solve, Torque};
use assur_motor::{
    Characteristic, FlywheelSize, MotorWarning, check_breakdown, check_rms, check_rotor_inertia,
    check_starting, flywheel_sizes, rms_torque,
};

use crate::motor::{DriveMotor, MotorWish};
use crate::told::{Tell, Told};
use crate::{CycleRequest, DriveRequest, DynamicsError, Machine, Regime, Survey, TorqueRequest};

/// The steady regime of a scene with its drive.
#[derive(Debug, Clone)]
pub struct Steady {
    /// The regime.
    pub regime: Regime,
    /// The motor; `None` without one.
    pub motor: Option<SteadyMotor>,
    /// Mean of the resisting moment over the cycle, reduced to the input shaft, N m, against the motion.
    pub mean_resistance: f64,
    /// Work of the resistance over a cycle, J.
    pub resistance_work: f64,
    /// The sizes of a steel disc a tenth as wide as its diameter on the input shaft and on the motor shaft (S fig. 13);
    /// empty without motor or flywheel.
    pub flywheel_sizes: Vec<FlywheelSize>,
}

/// How the motor works in the regime. Torques and speeds of its own shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyMotor {
    /// The motor.
    pub motor: DriveMotor,
    /// Its characteristic.
    pub characteristic: Characteristic,
    /// Least and greatest speed of the motor, rad/s: the working section.
    pub speed: [f64; 2],
    /// Least and greatest torque, N m.
    pub torque: [f64; 2],
    /// Root mean square torque over a cycle, N m.
    pub rms_torque: f64,
    /// Greatest torque that the load at rest asks for in any position of the cycle, N m.
    pub starting_load: f64,
    /// What an engineer should know.
    pub warnings: Vec<MotorWarning>,
}

impl SteadyMotor {
    /// `count` points (speed rad/s, torque N m) of the characteristic from rest to a little above synchronous speed.
    pub fn curve(&self, count: usize) -> Vec<[f64; 2]> {
        let end = 1.1 * self.characteristic.synchronous_speed();
        let last = count.saturating_sub(1).max(1) as f64;
        let speed = |i: usize| end * (i as f64) / last;
        (0..count).map(|i| [speed(i), self.characteristic.torque(speed(i))]).collect()
    }

    /// `count` points (speed, torque) of the working section.
    pub fn working_section(&self, count: usize) -> Vec<[f64; 2]> {
        let [low, high] = self.speed;
        let last = count.saturating_sub(1).max(1) as f64;
        let speed = |i: usize| low + (high - low) * (i as f64) / last;
        (0..count).map(|i| [speed(i), self.characteristic.torque(speed(i))]).collect()
    }
}

/// Finds the steady regime of a scene.
///
/// # Errors
///
/// [`DynamicsError`]: no such motion in the scene, a position that fails, no motor, no regime.
pub fn steady(linkage: &Linkage, loads: &Loads) -> Result<Steady, DynamicsError> {
    steady_told(linkage, loads, None)
}

/// The same; `tell` is told of every state that is evaluated, and may stop the search: then it fails.
///
/// # Errors
///
/// As [`steady`].
pub fn steady_told(
    linkage: &Linkage,
    loads: &Loads,
    tell: Option<&mut Tell<'_>>,
) -> Result<Steady, DynamicsError> {
    let mechanism = &linkage.mechanism;
    let Some(Motion::Steady { mean_speed, unevenness }) = mechanism.motion else {
        return Err(DynamicsError::NoMotion { kind: "steady" });
    };
    let mut machine = Machine::new(linkage, loads);
    let request = CycleRequest {
        start: mechanism.input.from,
        length: mechanism.input.period().ok_or(DynamicsError::NoCycle)?,
        mean_speed,
        constant_inertia: constant_inertia(mechanism),
    };
    let mut told;
    let motion: &mut dyn IsMotion = match tell {
        Some(tell) => {
            told = Told { motion: &mut machine, tell };
            &mut told
        }
        None => &mut machine,
    };
    let mut survey = Survey::new(motion, request)?;
    let (drive, found) = drive_request(mechanism, &survey, unevenness)?;
    let regime = survey.solve(&drive)?;
    let motor = match (found, drive.torque) {
        (Some((motor, characteristic)), TorqueRequest::Motor { efficiency, .. }) => {
            let load = survey.greatest_resistance();
            Some(steady_motor(motor, characteristic, &regime, load, efficiency))
        }
        _ => None,
    };
    let flywheel_sizes = sizes(&regime, motor.is_some(), drive.flywheel_on_motor);
    let (mean_resistance, resistance_work) = (survey.mean_resistance(), survey.resistance_work());
    Ok(Steady { regime, motor, mean_resistance, resistance_work, flywheel_sizes })
}

/// The input link about its pin (a sliding one: its mass): the part of J(q) that never varies.
fn constant_inertia(mechanism: &Mechanism) -> f64 {
    let link = &mechanism.links[mechanism.input.link];
    match mechanism.input.pair {
        InputPair::Pin(point) => {
            let pin = mechanism.place_in(point, mechanism.input.link).unwrap_or_default();
            let arm = [link.center[0] - pin[0], link.center[1] - pin[1]];
            link.inertia + link.mass * (arm[0] * arm[0] + arm[1] * arm[1])
        }
        InputPair::Slide(_) => link.mass,
    }
}

type Found = Option<(DriveMotor, Characteristic)>;

fn drive_request(
    mechanism: &Mechanism,
    survey: &Survey<'_>,
    unevenness: Option<f64>,
) -> Result<(DriveRequest, Found), DynamicsError> {
    let free = DriveRequest {
        torque: TorqueRequest::None,
        flywheel: Some(0.0),
        flywheel_on_motor: false,
        unevenness,
    };
    let Some(drive) = &mechanism.drive else { return Ok((free, None)) };
    let given = |solve: Solve| if let Solve::Given(value) = solve { Some(value) } else { None };
    let (torque, found) = match &drive.torque {
        Torque::None => (TorqueRequest::None, None),
        Torque::Balance => (TorqueRequest::Balance, None),
        Torque::Constant(moment) => (TorqueRequest::Constant(*moment), None),
        Torque::Motor { motor, catalogue, max_speed, characteristic } => {
            let wish = MotorWish {
                motor,
                catalogue: catalogue.as_deref(),
                max_speed: *max_speed,
                kind: *characteristic,
            };
            let (motor, characteristic) = chosen(&wish, survey, drive.efficiency)?;
            let torque = TorqueRequest::Motor {
                characteristic,
                rotor: motor.rotor(),
                ratio: given(drive.ratio),
                efficiency: drive.efficiency,
            };
            (torque, Some((motor, characteristic)))
        }
    };
    let flywheel = drive.flywheel.map_or(Some(0.0), given);
    let flywheel_on_motor = drive.flywheel_on == FlywheelPlace::Motor && found.is_some();
    Ok((DriveRequest { torque, flywheel, flywheel_on_motor, unevenness }, found))
}

fn chosen(
    wish: &MotorWish<'_>,
    survey: &Survey<'_>,
    efficiency: f64,
) -> Result<(DriveMotor, Characteristic), DynamicsError> {
    let power = survey.required_power(efficiency);
    if matches!(wish.motor, assur_mechanism::Motor::Auto) && power <= 0.0 {
        return Err(DynamicsError::NoLoad { work: -survey.resistance_work() });
    }
    let motor = wish.find(Some([power, survey.wanted_speed()]))?;
    let characteristic = Characteristic::new(motor.kind, &motor.rated)?;
    Ok((motor, characteristic))
}

fn steady_motor(
    motor: DriveMotor,
    characteristic: Characteristic,
    regime: &Regime,
    load: f64,
    efficiency: f64,
) -> SteadyMotor {
    let ratio = regime.ratio.unwrap_or(1.0);
    let speeds: Vec<(f64, f64)> =
        regime.weighted_speeds().iter().map(|(v, time)| (ratio * v, *time)).collect();
    let speed = [ratio * regime.speed_min.abs(), ratio * regime.speed_max.abs()];
    let ends = speed.map(|speed| characteristic.torque(speed));
    let nodes = speeds.iter().map(|(speed, _)| characteristic.torque(*speed));
    let (low, high) = nodes
        .chain(ends)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), torque| (low.min(torque), high.max(torque)));
    let rms = rms_torque(speeds.iter().map(|(speed, time)| (characteristic.torque(*speed), *time)));
    let starting_load = (load / (ratio * efficiency)).max(0.0);
    let ratio_printed = motor.row.and_then(|row| row.starting_torque_ratio);
    let rotor = match motor.row {
        Some(row) => check_rotor_inertia(row),
        None => motor.rated.inertia.is_none().then(|| MotorWarning::RotorInertiaUnknown {
            designation: "the motor given by its data".to_owned(),
        }),
    };
    let warnings = [
        check_breakdown(&characteristic, speed),
        check_starting(&characteristic, ratio_printed, starting_load),
        check_rms(&characteristic, rms),
        rotor,
    ];
    SteadyMotor {
        motor,
        characteristic,
        speed,
        torque: [low, high],
        rms_torque: rms,
        starting_load,
        warnings: warnings.into_iter().flatten().collect(),
    }
}

fn sizes(regime: &Regime, has_motor: bool, on_motor: bool) -> Vec<FlywheelSize> {
    let ratio = regime.ratio.filter(|_| has_motor && regime.flywheel > 0.0);
    ratio.map_or_else(Vec::new, |ratio| {
        let inertia = if on_motor { regime.flywheel * ratio * ratio } else { regime.flywheel };
        flywheel_sizes(inertia, ratio, regime.speed_max.abs()).to_vec()
    })
}
