//! Converts a motion to results.

use std::f64::consts::TAU;

use assur_dynamics::{Advice, DynamicsError, Regime, RegimeState, SteadyMotor, Transient, advise};
use assur_mechanism::{Motion, ReductionPoint, Solve};
use assur_motor::Motor;
use assur_words::Describe;

use crate::results::{
    AdvisedRegime, Dynamics, Energy, EnergyMass, EnergyMassTangent, Integration, MotorAdvice, MotorReport,
    MotorWork, PointReport, RegimeOverCycle,
};
use crate::{AnalysisError, Calculation, InputMotion};

/// Intervals over a cycle at which the regime is reported.
const INTERVALS: u32 = 144;
/// Motors that are compared by the unevenness that they allow.
const MOST_ADVICE: usize = 8;
/// Points of the motor's curves.
const CURVE: usize = 61;

impl Calculation {
    /// Regime, drive and flywheel; `None` without a steady motion.
    pub(crate) fn dynamics(&self) -> Option<Dynamics> {
        let InputMotion::Steady(found) = &self.motion else { return None };
        let regime = &found.regime;
        let drive = self.linkage.mechanism.drive.as_ref();
        let has_flywheel = drive.is_some_and(|drive| drive.flywheel.is_some());
        let methods = regime.flywheel_by_method.iter().filter(|row| has_flywheel && row.flywheel.is_finite());
        let course = self.course(regime);
        Some(Dynamics {
            flywheel: has_flywheel.then_some(regime.flywheel),
            figures: regime.figures.clone(),
            motor: found.motor.as_ref().map(motor),
            flywheel_by_method: methods.clone().map(|row| (row.method, row.flywheel)).collect(),
            flywheel_methods: methods.cloned().collect(),
            flywheel_places: found.flywheel_sizes.clone(),
            motors_by_unevenness: match self.linkage.mechanism.motion {
                Some(Motion::Steady { unevenness: Some(Solve::Wanted), .. }) => {
                    self.advice(MOST_ADVICE).map_or_else(|_| Vec::new(), |(motors, _)| motors)
                }
                _ => Vec::new(),
            },
            energy_mass: energy_mass(regime, self.linkage.mechanism.input.from, &course),
            regime: RegimeOverCycle { found: regime.clone(), course },
            reduction_point: self.reduction_point(),
        })
    }

    /// The suitable motors, the best first, at most `most`, each with the greatest unevenness that it allows; and how many
    /// such motors there are.
    pub fn advice(&self, most: usize) -> Result<(Vec<MotorAdvice>, usize), AnalysisError> {
        let no_motion = DynamicsError::NoMotion("steady");
        let loads = self.loads.as_ref().ok_or(no_motion)?;
        let (found, count) = advise(&self.linkage, loads, most)?;
        Ok((found.iter().map(advised).collect(), count))
    }

    /// The point of the input link to which all loads and links are reduced.
    pub fn reduction_point(&self) -> Option<PointReport> {
        let mechanism = &self.linkage.mechanism;
        let found = ReductionPoint::farthest(mechanism)?;
        Some(PointReport { name: mechanism.named_point(found.point), radius: found.radius })
    }

    /// The regime over a cycle, its end included.
    fn course(&self, regime: &Regime) -> Vec<RegimeState> {
        let input = &self.linkage.mechanism.input;
        let cycle = input.sign() * input.period().unwrap_or(0.0);
        let at = |i: u32| input.from + cycle * (f64::from(i) / f64::from(INTERVALS));
        let state = |at: f64| RegimeState { first_turn: regime.first_cycle_speed(at), ..regime.state(at) };
        (0..=INTERVALS).map(at).map(state).collect()
    }

    /// How a transient motion was found; `None` without one.
    pub(crate) fn integration(&self) -> Option<Integration> {
        let InputMotion::Transient(found) = &self.motion else { return None };
        Some(Integration {
            method: found.integrator.to_owned(),
            case: found.dependence.case(),
            equation: found.dependence.describe(),
            reason: found.reason.clone(),
            tolerance: self.tolerance(),
            statistics: found.trajectory.statistics,
            end: found.trajectory.end,
            turns: self.turns(found),
            events: found.trajectory.events.clone(),
            energy: energy(found),
        })
    }

    /// Turns of the input over a motion; `None` where it slides.
    fn turns(&self, found: &Transient) -> Option<f64> {
        let input = &self.linkage.mechanism.input;
        let way = found.trajectory.end.coordinate - found.trajectory.samples.first()?.coordinate;
        input.is_angle().then_some(way / TAU)
    }
}

fn energy_mass(regime: &Regime, from: f64, course: &[RegimeState]) -> EnergyMass {
    let energy = |inertia: f64, speed: f64| 0.5 * (inertia + regime.drive_inertia) * speed * speed;
    let first = regime.state(from);
    let start = energy(first.inertia, first.speed);
    let ends = [
        (regime.figures.speed_max, regime.figures.coordinate_at_max),
        (regime.figures.speed_min, regime.figures.coordinate_at_min),
    ];
    EnergyMass {
        curve: course.iter().map(|at| [at.inertia, energy(at.inertia, at.speed) - start]).collect(),
        tangents: ends.map(|(speed, coordinate)| {
            let inertia = regime.state(coordinate).inertia;
            let touches = [inertia, energy(inertia, speed) - start];
            EnergyMassTangent { slope: 0.5 * speed * speed, touches, coordinate }
        }),
        origin: [-regime.drive_inertia, -start],
    }
}

fn offered(motor: &Motor, ratio: Option<f64>, regime: Option<AdvisedRegime>) -> MotorAdvice {
    MotorAdvice {
        designation: motor.designation.clone(),
        catalogue: motor.catalogue.clone(),
        power: motor.rated_power,
        rated_speed: motor.rated_speed,
        ratio,
        mass: motor.mass,
        regime,
    }
}

fn advised(Advice { motor, found }: &Advice) -> MotorAdvice {
    let regime = found.as_ref().ok().and_then(|found| {
        let greatest_torque = found.motor.as_ref()?.torque[1];
        let breakdown = found.motor.as_ref()?.motor.characteristic.breakdown_torque;
        Some(AdvisedRegime {
            unevenness: found.regime.figures.unevenness,
            ratio: found.regime.figures.ratio?,
            flywheel: found.regime.flywheel,
            greatest_torque,
            torque_reserve: breakdown
                .map(|torque| torque / greatest_torque)
                .filter(|ratio| ratio.is_finite()),
        })
    });
    offered(motor, None, regime)
}

fn motor(found: &SteadyMotor) -> MotorReport {
    let row = found.motor.row;
    let runners_up = found.motor.runners_up.iter().map(|other| offered(other.motor, Some(other.ratio), None));
    MotorReport {
        designation: found.motor.designation.clone().unwrap_or_default(),
        catalogue: row.map(|row| row.catalogue.clone()),
        rated: found.motor.rated,
        mass: row.and_then(|row| row.mass),
        length: row.and_then(|row| row.length),
        diameter: row.and_then(|row| row.diameter),
        work: MotorWork {
            characteristic: found.motor.characteristic.name(),
            rated_torque: found.motor.characteristic.rated_torque,
            breakdown_torque: found.motor.characteristic.breakdown_torque,
            speed: found.speed,
            torque: found.torque,
            rms_torque: found.rms_torque,
            starting_load: found.starting_load,
            curve: found.curve([0.0, 1.1 * found.motor.characteristic.synchronous_speed], CURVE),
            working_section: found.curve(found.speed, CURVE),
        },
        runners_up: runners_up.collect(),
        warnings: found.warnings.iter().map(Describe::describe).collect(),
    }
}

fn energy(found: &Transient) -> Energy {
    let energy = &found.energy;
    let first = |values: &[f64]| values.first().copied().unwrap_or(0.0);
    let last = |values: &[f64]| values.last().copied().unwrap_or(0.0);
    Energy {
        conservative: energy.conservative,
        kinetic_start: first(&energy.kinetic),
        kinetic_end: last(&energy.kinetic),
        potential_start: first(&energy.potential),
        potential_end: last(&energy.potential),
        change: energy.change,
    }
}
