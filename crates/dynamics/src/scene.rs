//! The steady regime that a scene asks for.

use std::cell::RefCell;

use assur_force::Loads;
use assur_integrator::EquationOfMotion;
use assur_kinematics::Linkage;
use assur_mechanism::{FlywheelPlace, InputPair, Mechanism, Motion, Solve, Torque};
use assur_motor::{Characteristic, FlywheelSize, Motor, PassedOver, flywheel_sizes};
use assur_number::{elementary, search};
use assur_words::{Describe, Text};

use crate::machine::{Watched, Watcher};
use crate::motor::{DriveMotor, SteadyMotor};
use crate::steady::{CycleRequest, DriveRequest, Regime, RegimeSolver, TorqueRequest};
use crate::{DynamicsError, Machine, friction::KnownMotion};

/// The steady regime of a scene with its drive.
#[derive(Debug, Clone)]
pub struct Steady {
    /// The regime.
    pub regime: Regime,
    /// The motor; `None` without one.
    pub motor: Option<SteadyMotor>,
    /// The sizes of a steel disc a tenth as wide as its diameter on the input shaft and on the motor shaft (S fig. 13);
    /// empty without motor or flywheel.
    pub flywheel_sizes: Vec<FlywheelSize>,
}

/// Motors that are tried for a drive whose motor is chosen: of more than these the loads are not those of a motor.
const MOST_TRIED: usize = 40;

/// The steady regime of an equation of motion with the motion and the drive of `mechanism`.
pub(crate) fn steady_motion(
    motion: &mut dyn EquationOfMotion,
    mechanism: &Mechanism,
    watcher: Option<&mut Watcher<'_>>,
) -> Result<Steady, DynamicsError> {
    let (request, unevenness) = cycle_request(mechanism)?;
    let mut motion = Watched::new(motion, watcher);
    let mut solver = RegimeSolver::new(&mut motion, request)?;
    let (drive, motor) = drive_request(mechanism, &solver, unevenness.and_then(Solve::value))?;
    let efficiency = mechanism.drive.as_ref().map_or(1.0, |drive| drive.efficiency);
    let works = |drive: &DriveRequest, motor: Option<DriveMotor>| {
        let regime = match &motor {
            Some(motor) if unevenness == Some(Solve::Wanted) => {
                greatest(&mut solver, drive, &motor.characteristic)?
            }
            _ => solver.solve(drive)?,
        };
        let resistance = solver.greatest_resistance();
        let motor = motor.map(|motor| SteadyMotor::new(motor, &regime, resistance, efficiency));
        Ok((regime, motor))
    };
    let (regime, motor) = with_a_fit_motor(&drive, motor.as_ref(), works)?;
    let flywheel_sizes = sizes(&regime, motor.is_some(), drive.flywheel_on_motor);
    Ok(Steady { regime, motor, flywheel_sizes })
}

/// What works with a drive: the regime, and the motor in it.
type RegimeResult = Result<(Regime, Option<SteadyMotor>), DynamicsError>;

/// Why a motor that was tried is not taken; `None` for one that is.
fn refusal(found: &RegimeResult) -> Option<Text> {
    match found {
        Ok((_, motor)) => {
            motor.iter().flat_map(|motor| &motor.warnings).find_map(|warning| warning.unfit.clone())
        }
        Err(error) => Some(error.describe()),
    }
}

/// The regime with the motor of a scene; where it was chosen and does not fit its work, because it would become too hot or could
/// not start, with the next motor that does. If none does, it is the first with its warnings.
fn with_a_fit_motor(
    drive: &DriveRequest,
    motor: Option<&DriveMotor>,
    mut works: impl FnMut(&DriveRequest, Option<DriveMotor>) -> RegimeResult,
) -> RegimeResult {
    let mut refused = motor.map_or_else(Vec::new, |motor| motor.passed_over.clone());
    let mut is_fit = |found: &mut RegimeResult, row: Option<&'static Motor>| {
        let why = refusal(found);
        let fit = why.is_none();
        refused.extend(row.zip(why).map(|(motor, why)| PassedOver { motor, why }));
        if let Ok((_, Some(motor))) = found {
            motor.passed_over(refused.clone());
        }
        fit
    };
    let others = std::iter::successors(motor.and_then(DriveMotor::next), DriveMotor::next);
    let mut first = works(drive, motor.cloned());
    if is_fit(&mut first, motor.and_then(DriveMotor::row)) {
        return first;
    }
    for other in others.take(MOST_TRIED) {
        let row = other.row();
        let mut found = works(&drive.with(&other.characteristic, other.rotor()), Some(other));
        if is_fit(&mut found, row) {
            return found;
        }
    }
    first
}

/// The motor of a scene, looked up or chosen.
pub(crate) fn chosen_motor(
    linkage: &Linkage,
    loads: &Loads,
    mechanism: &Mechanism,
) -> Result<DriveMotor, DynamicsError> {
    let (request, _) = cycle_request(mechanism)?;
    let mut machine = Machine::new(linkage, loads);
    machine.assume(Some(KnownMotion::Uniform(request.mean_speed)));
    let solver = RegimeSolver::new(&mut machine, request)?;
    drive_request(mechanism, &solver, None)?.1.ok_or(DynamicsError::NoMotor)
}

/// The cycle of a scene, and its unevenness.
pub(crate) fn cycle_request(mechanism: &Mechanism) -> Result<(CycleRequest, Option<Solve>), DynamicsError> {
    let Some(Motion::Steady { mean_speed, unevenness }) = mechanism.motion else {
        return Err(DynamicsError::NoMotion("steady"));
    };
    let request = CycleRequest {
        start: mechanism.input.from,
        length: mechanism.input.period().ok_or(DynamicsError::NoCycle)?,
        mean_speed,
        constant_inertia: constant_inertia(mechanism),
    };
    Ok((request, unevenness))
}

/// The input link about its pin (a sliding one: its mass), without a moment of inertia by a formula: the part of J(q) that never
/// varies.
fn constant_inertia(mechanism: &Mechanism) -> f64 {
    let Some(crank) = mechanism.input.crank() else { return 0.0 };
    let link = &mechanism.links[crank];
    match mechanism.input.first().pair {
        InputPair::Pin(point) => {
            let pin = mechanism.place_in(point, crank).unwrap_or_default();
            let arm = [link.center[0] - pin[0], link.center[1] - pin[1]];
            link.inertia.constant() + link.mass * (arm[0] * arm[0] + arm[1] * arm[1])
        }
        InputPair::Slide(_) => link.mass,
    }
}

fn drive_request(
    mechanism: &Mechanism,
    solver: &RegimeSolver<'_>,
    unevenness: Option<f64>,
) -> Result<(DriveRequest, Option<DriveMotor>), DynamicsError> {
    let torque = TorqueRequest::None;
    let free = DriveRequest { torque, flywheel: Some(0.0), flywheel_on_motor: false, unevenness };
    let Some(drive) = &mechanism.drive else { return Ok((free, None)) };
    let motor = DriveMotor::of(&drive.torque, || {
        let power = solver.required_power(drive.efficiency);
        if power > 0.0 {
            Ok([power, solver.request.mean_speed.abs()])
        } else {
            Err(DynamicsError::NoLoad(-solver.resistance_work()))
        }
    })?;
    let torque = match (&drive.torque, &motor) {
        (Torque::Balance, _) => TorqueRequest::Balance,
        (Torque::Constant(moment), _) => TorqueRequest::Constant(*moment),
        (Torque::Motor { .. }, Some(motor)) => TorqueRequest::Motor {
            characteristic: motor.characteristic,
            rotor: motor.rotor(),
            ratio: drive.ratio.value(),
            efficiency: drive.efficiency,
        },
        (Torque::None | Torque::Motor { .. }, _) => TorqueRequest::None,
    };
    let flywheel = drive.flywheel.map_or(Some(0.0), Solve::value);
    let flywheel_on_motor = drive.flywheel_on == FlywheelPlace::Motor && motor.is_some();
    Ok((DriveRequest { torque, flywheel, flywheel_on_motor, unevenness }, motor))
}

fn sizes(regime: &Regime, has_motor: bool, on_motor: bool) -> Vec<FlywheelSize> {
    let ratio = regime.figures.ratio.filter(|_| has_motor && regime.flywheel > 0.0);
    ratio.map_or_else(Vec::new, |ratio| {
        let inertia = if on_motor { regime.flywheel * ratio * ratio } else { regime.flywheel };
        flywheel_sizes(inertia, ratio, regime.figures.speed_max.abs()).to_vec()
    })
}

/// Least unevenness that is tried: no machine is built for less.
const LEAST: f64 = 1e-3;
/// Greatest unevenness that is tried: at 2 the input would stand still once in a cycle.
const MOST: f64 = 1.9;
/// Width of the natural logarithm of the unevenness to which the greatest one is found.
const WIDTH: f64 = 1e-11;

/// How far the speeds of the motor stay inside the stable section of its characteristic, as a part of the section; negative
/// where they leave it.
pub fn section_margin(regime: &Regime, characteristic: &Characteristic) -> f64 {
    let [low, high] = characteristic.stable_section();
    let ratio = regime.figures.ratio.unwrap_or(1.0);
    let [slow, fast] = [regime.figures.speed_min, regime.figures.speed_max].map(|speed| ratio * speed.abs());
    (slow - low).min(high - fast) / (high - low)
}

/// The regime of the greatest unevenness at which the motor stays on the stable section of its characteristic; a flywheel is
/// found for it.
pub(crate) fn greatest(
    solver: &mut RegimeSolver<'_>,
    request: &DriveRequest,
    characteristic: &Characteristic,
) -> Result<Regime, DynamicsError> {
    let mut solve = |unevenness| solver.solve(&DriveRequest { unevenness: Some(unevenness), ..*request });
    let least = solve(LEAST)?;
    let inside = section_margin(&least, characteristic);
    if inside < 0.0 {
        let [low, high] = characteristic.stable_section();
        let speed = least.figures.ratio.unwrap_or(1.0) * least.figures.mean_speed.abs();
        return Err(DynamicsError::OffSection { speed, low, high });
    }
    let kept = RefCell::new((least, solve));
    let margin_at = |logarithm: f64| {
        let (best, solve) = &mut *kept.borrow_mut();
        // Where the machine stalls, it has left the section long before.
        let Ok(regime) = solve(elementary::exp(logarithm)) else { return -1.0 };
        let inside = section_margin(&regime, characteristic);
        if inside >= 0.0 && regime.figures.unevenness > best.figures.unevenness {
            *best = regime;
        }
        inside
    };
    if margin_at(elementary::ln(MOST)) < 0.0 {
        search::root(elementary::ln(LEAST), elementary::ln(MOST), WIDTH, margin_at);
    }
    Ok(kept.into_inner().0)
}
