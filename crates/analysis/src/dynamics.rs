//! Converts a motion to results.

use std::f64::consts::TAU;

use assur_dynamics::{Advice, DynamicsError, Regime, RegimeState, Transient, advise};
use assur_mechanism::{Motion, ReductionPoint, Solve};
use assur_words::Describe;

use crate::results::{Dynamics, Energy, EnergyMass, EnergyMassTangent, Integration, RegimeOverCycle};
use crate::{AnalysisError, Calculation, InputMotion};

/// Intervals over a cycle at which the regime is reported.
const INTERVALS: u32 = 144;
/// Motors that are compared by the unevenness that they allow.
const MOST_ADVICE: usize = 8;

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
            motor: found.motor.clone(),
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
            reduction_point: ReductionPoint::farthest(&self.linkage.mechanism),
        })
    }

    /// The suitable motors, the best first, at most `most`, each with the greatest unevenness that it allows; and how many
    /// such motors there are.
    pub fn advice(&self, most: usize) -> Result<(Vec<Advice>, usize), AnalysisError> {
        let no_motion = DynamicsError::NoMotion("steady");
        let loads = self.loads.as_ref().ok_or(no_motion)?;
        Ok(advise(&self.linkage, loads, most)?)
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
