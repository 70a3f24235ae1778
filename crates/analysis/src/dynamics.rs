//! The motion that was found, as results.

use std::sync::Arc;

use crate::results::{
    CourseRow, Dynamics, Energy, EventRow, Instant, Integration, MotorReport, MotorWork, Named, PointReport,
    RegimeReport, RunnerUp,
};
use assur_dynamics::{FlywheelByMethod, ReductionPoint, Regime, Steady, SteadyMotor, Transient};
use assur_integrator::{Event, EventKind, State};

use crate::{Course, Study};

/// Intervals of the course of the regime over a cycle.
const COURSE: u32 = 144;
/// Points of the motor's curves.
const CURVE: usize = 61;

impl Study {
    /// Regime, drive and flywheel; `None` without a steady motion.
    pub(crate) fn dynamics(&self) -> Option<Dynamics> {
        let Course::Steady(found) = &self.course else { return None };
        let regime = &found.regime;
        let drive = self.linkage.mechanism.drive.as_ref();
        let has_flywheel = drive.is_some_and(|drive| drive.flywheel.is_some());
        Some(Dynamics {
            flywheel: has_flywheel.then_some(regime.flywheel),
            ratio: regime.ratio,
            mean_speed: Some(regime.mean_speed),
            unevenness: Some(regime.unevenness),
            speed_min: Some(regime.speed_min),
            speed_max: Some(regime.speed_max),
            coordinate_at_min: Some(regime.coordinate_at_min),
            coordinate_at_max: Some(regime.coordinate_at_max),
            excess_work: Some(regime.excess_work),
            dynamic_unevenness: finite(regime.dynamic_unevenness),
            required_power: Some(regime.required_power),
            torque: regime.torque,
            motor: found.motor.as_ref().map(motor),
            flywheel_by_method: by_method(regime, has_flywheel),
            flywheel_methods: if has_flywheel { methods(regime) } else { Vec::new() },
            flywheel_places: found.flywheel_sizes.clone(),
            regime: Some(self.regime(found)),
            reduction_point: self.reduction_point(),
        })
    }

    fn reduction_point(&self) -> Option<PointReport> {
        let mechanism = &self.linkage.mechanism;
        let found = ReductionPoint::farthest(mechanism)?;
        Some(PointReport { name: mechanism.points[found.point].name.clone(), radius: found.radius })
    }

    fn regime(&self, found: &Steady) -> RegimeReport {
        let regime = &found.regime;
        let input = &self.linkage.mechanism.input;
        let cycle = input.sign() * input.period().unwrap_or(0.0);
        let row = |i: u32| course_row(regime, input.from + cycle * (f64::from(i) / f64::from(COURSE)));
        RegimeReport {
            mean_resistance: found.mean_resistance,
            resistance_work: found.resistance_work,
            cycle_time: regime.cycle_time,
            multiplier: regime.multiplier,
            shaft_inertia: regime.shaft_inertia,
            flywheel_needless: regime.flywheel_needless,
            effort: regime.effort,
            iteration: regime.turns.clone(),
            trials: regime.trials.clone(),
            course: (0..=COURSE).map(row).collect(),
        }
    }

    /// How a transient motion was found; `None` without one.
    pub(crate) fn integration(&self) -> Option<Integration> {
        let Course::Transient(found) = &self.course else { return None };
        let statistics = found.trajectory.statistics;
        let tolerance = match self.linkage.mechanism.motion {
            Some(assur_mechanism::Motion::Transient { tolerance, .. }) => tolerance,
            _ => 0.0,
        };
        Some(Integration {
            method: found.integrator.to_owned(),
            case: found.dependence.case(),
            equation: found.dependence.words(),
            reason: found.reason.clone(),
            tolerance,
            steps: statistics.steps,
            rejected: statistics.rejected,
            evaluations: statistics.evaluations,
            jacobians: statistics.jacobians,
            pieces: statistics.pieces,
            stiffness: statistics.stiffness,
            end: instant(&found.trajectory.end),
            events: found.trajectory.events.iter().map(event).collect(),
            energy: energy(found),
        })
    }
}

/// A number that JSON can hold.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

fn course_row(regime: &Regime, coordinate: f64) -> CourseRow {
    let at = regime.state(coordinate);
    CourseRow {
        coordinate,
        speed: at.speed,
        first_turn: regime.first_turn(coordinate).map(|first| first.speed),
        drive: at.drive,
        load: at.load,
        inertia: at.inertia,
        inertia_derivative: at.inertia_derivative,
    }
}

fn by_method(regime: &Regime, has_flywheel: bool) -> Named<f64> {
    let rows = regime.flywheel_by_method.iter().filter(|row| has_flywheel && row.flywheel.is_finite());
    rows.map(|row| (Arc::from(row.method), row.flywheel)).collect()
}

fn methods(regime: &Regime) -> Vec<FlywheelByMethod> {
    let rows = regime.flywheel_by_method.iter().filter(|row| row.flywheel.is_finite());
    rows.copied().collect()
}

fn motor(found: &SteadyMotor) -> MotorReport {
    let (rated, row) = (&found.motor.rated, found.motor.row);
    MotorReport {
        designation: found.motor.designation.clone().unwrap_or_default(),
        catalogue: row.map(|row| row.catalogue.clone()),
        power: rated.power,
        synchronous_speed: rated.synchronous_speed,
        rated_speed: rated.rated_speed,
        max_torque_ratio: rated.max_torque_ratio,
        inertia: rated.inertia,
        mass: row.and_then(|row| row.mass),
        length: row.and_then(|row| row.length),
        diameter: row.and_then(|row| row.diameter),
        work: Some(work(found)),
        runners_up: found
            .motor
            .runners_up
            .iter()
            .map(|other| RunnerUp {
                designation: other.motor.designation.clone(),
                catalogue: other.motor.catalogue.clone(),
                power: other.motor.rated_power,
                rated_speed: other.motor.rated_speed,
                ratio: other.ratio,
                mass: other.motor.mass,
            })
            .collect(),
        warnings: found.warnings.iter().map(ToString::to_string).collect(),
    }
}

fn work(found: &SteadyMotor) -> MotorWork {
    MotorWork {
        characteristic: found.characteristic.name(),
        rated_torque: found.characteristic.rated_torque(),
        breakdown_torque: found.characteristic.breakdown_torque(),
        speed: found.speed,
        torque: found.torque,
        rms_torque: found.rms_torque,
        starting_load: found.starting_load,
        curve: found.curve(CURVE),
        working_section: found.working_section(CURVE),
    }
}

fn instant(state: &State) -> Instant {
    Instant { time: state.time, coordinate: state.coordinate, speed: state.speed }
}

fn event(event: &Event) -> EventRow {
    let kind = match event.kind {
        EventKind::Coordinate => "coordinate",
        EventKind::Speed => "speed",
        EventKind::Time => "time",
        EventKind::Reversal => "reversal",
        EventKind::Rest => "rest",
        EventKind::Held => "held",
        EventKind::Release => "release",
        _ => "other",
    };
    EventRow { kind, at: instant(&event.state) }
}

fn energy(found: &Transient) -> Energy {
    let energy = &found.energy;
    let ends =
        |values: &[f64]| (values.first().copied().unwrap_or(0.0), values.last().copied().unwrap_or(0.0));
    let (kinetic_start, kinetic_end) = ends(&energy.kinetic);
    let (potential_start, potential_end) = ends(&energy.potential);
    Energy {
        conservative: energy.conservative,
        kinetic_start,
        kinetic_end,
        potential_start,
        potential_end,
        change: energy.change,
    }
}
