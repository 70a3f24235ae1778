//! Flywheel and gear ratio together (S stage 6), for a periodic speed with the wanted mean and unevenness.
//!
//! The unknowns are the level (with a motor the gear ratio; without one the energy at the start of the cycle) and the
//! flywheel. Each trial is a closed cycle; Newton's method takes the derivatives of its least and greatest speed from
//! the variational equation and stays within a factor of the last trial.

use assur_motor::Characteristic;
use assur_number::elementary;
use assur_number::search::bisect;
use serde::Serialize;

use super::solution::{Closing, CycleSolution, SpeedRange};
use super::{segment::Setup, shooting::Shooting};
use crate::DynamicsError;
use crate::drive::{InputDrive, TorqueSource};

/// Trials of ratio and flywheel.
const MOST_TRIALS: usize = 60;

/// Relative deviations below this are rounding.
const ROUNDING: f64 = 2e-12;

/// One trial of ratio and flywheel, with its periodic regime (S stage 6).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Trial {
    /// Number of the trial, from 1.
    pub number: usize,
    /// Gear ratio; `None` without a motor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Flywheel on its own shaft, kg m².
    pub flywheel: f64,
    /// Mean speed, rad/s, signed.
    pub mean_speed: f64,
    /// Unevenness.
    pub unevenness: f64,
}

/// What is given and what is wanted. Speeds are positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TuningTarget {
    /// Mean speed that the level is to give; `None`: any.
    pub(crate) mean: Option<f64>,
    /// Unevenness that the flywheel is to give; `None`: the flywheel is given.
    pub(crate) unevenness: Option<f64>,
    pub(crate) closing: Closing,
    /// The flywheel sits on the motor shaft.
    pub(crate) on_motor: bool,
    /// Rotor on the motor shaft, kg m².
    pub(crate) rotor: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unknowns {
    pub(crate) source: TorqueSource,
    /// T at the start of the cycle.
    pub(crate) energy: f64,
    /// On its own shaft.
    pub(crate) flywheel: f64,
}

/// A regime with its unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Tuned {
    pub(crate) unknowns: Unknowns,
    pub(crate) solution: CycleSolution,
    pub(crate) range: SpeedRange,
    pub(crate) trials: Vec<Trial>,
}

impl TuningTarget {
    pub(crate) fn setup(&self, unknowns: &Unknowns, sense: f64) -> Setup {
        let ratio = unknowns.ratio().unwrap_or(0.0);
        let flywheel = unknowns.flywheel;
        let own = if self.on_motor { flywheel } else { 0.0 };
        let on_input = if self.on_motor { 0.0 } else { flywheel };
        let inertia = on_input + ratio * ratio * (self.rotor + own);
        let by_flywheel = if self.on_motor { ratio * ratio } else { 1.0 };
        let by_ratio = if unknowns.ratio().is_some() { 2.0 * ratio * (self.rotor + own) } else { 0.0 };
        let drive = InputDrive { source: unknowns.source, sense, inertia };
        Setup { drive, inertia_by: [by_ratio, by_flywheel] }
    }

    /// Deviation of a cycle from the requested mean (relative) and unevenness (of its inverse, relative, which is
    /// nearly linear in the flywheel).
    fn misses(&self, range: &SpeedRange) -> [f64; 2] {
        let mean = self.mean.map_or(0.0, |wanted| range.mean() / wanted - 1.0);
        [mean, self.unevenness.map_or(0.0, |wanted| wanted / range.unevenness() - 1.0)]
    }
}

impl Unknowns {
    pub(crate) fn ratio(&self) -> Option<f64> {
        if let TorqueSource::Motor { ratio, .. } = self.source { Some(ratio) } else { None }
    }

    /// The ratio where there is a motor, else the initial energy.
    fn level(&self) -> f64 {
        self.ratio().unwrap_or(self.energy)
    }

    fn set_level(&mut self, level: f64) {
        if let TorqueSource::Motor { ratio, .. } = &mut self.source {
            *ratio = level;
        } else {
            self.energy = level;
        }
    }

    /// What closing the cycle found: initial energy, constant moment.
    fn take(&mut self, solution: &CycleSolution) {
        self.energy = solution.start;
        if let TorqueSource::Constant(_) = self.source {
            self.source = solution.setup.drive.source;
        }
    }
}

/// The search for one machine and one request.
pub(crate) struct Tuner<'s, 'a> {
    pub(crate) shooting: &'s mut Shooting<'a>,
    pub(crate) target: TuningTarget,
    pub(crate) trials: Vec<Trial>,
}

impl Tuner<'_, '_> {
    fn regime(
        &mut self,
        unknowns: &Unknowns,
        near: Option<&CycleSolution>,
    ) -> Result<(CycleSolution, SpeedRange), DynamicsError> {
        let setup = self.target.setup(unknowns, self.shooting.path.cycle.sense);
        self.shooting.check_inertia(&setup)?;
        let (solution, range) = self.resolved(setup, unknowns.energy, near)?;
        self.trials.push(Trial {
            number: self.trials.len() + 1,
            ratio: unknowns.ratio(),
            flywheel: unknowns.flywheel,
            mean_speed: self.shooting.path.cycle.sense * range.mean(),
            unevenness: range.unevenness(),
        });
        Ok((solution, range))
    }

    /// The periodic cycle, on panels short enough that its speed is positive between their nodes, too: it isn't where the machine
    /// nearly stalls within a panel.
    fn resolved(
        &mut self,
        setup: Setup,
        energy: f64,
        near: Option<&CycleSolution>,
    ) -> Result<(CycleSolution, SpeedRange), DynamicsError> {
        let mut near = near.cloned();
        loop {
            let solution =
                self.shooting.close(setup, self.target.closing, energy, near.take(), &mut Vec::new())?;
            let range = solution.speed_range().ok_or(DynamicsError::NoCycle)?;
            if range.least.value > 0.0 {
                return Ok((solution, range));
            }
            if !self.shooting.refine(&solution)?.1 {
                return Err(DynamicsError::Stalled(self.shooting.path.cycle.coordinate(range.least.at.x)));
            }
            near = Some(solution);
        }
    }

    /// Finds ratio (or energy) and flywheel from a first guess.
    pub(crate) fn tune(mut self, mut unknowns: Unknowns) -> Result<Tuned, DynamicsError> {
        let (mut solution, mut range) = self.regime(&unknowns, None)?;
        let mut before = f64::INFINITY;
        for _ in 0..MOST_TRIALS {
            let misses = self.target.misses(&range);
            let worst = misses[0].abs().max(misses[1].abs());
            if worst <= ROUNDING || (worst < 1e-10 && worst > 0.3 * before) {
                unknowns.take(&solution);
                return Ok(Tuned { unknowns, solution, range, trials: self.trials });
            }
            before = worst;
            unknowns.take(&solution);
            let step = self.step(&solution, &range, misses);
            let bare = self.target.unevenness.is_some() && unknowns.flywheel + step[1] < 0.0;
            if bare && let Some(found) = self.without_flywheel(&unknowns) {
                return Ok(found);
            }
            (unknowns, solution, range) = self.damped(&unknowns, step, misses, &solution)?;
        }
        let misses = self.target.misses(&range);
        Err(DynamicsError::NotTuned {
            trials: self.trials.len(),
            mean_miss: misses[0],
            unevenness_miss: misses[1],
        })
    }

    /// Newton's step of level and flywheel.
    fn step(&self, solution: &CycleSolution, range: &SpeedRange, misses: [f64; 2]) -> [f64; 2] {
        let directions = solution.directions(self.target.closing);
        let [level, flywheel] = directions.map(|direction| {
            let [mean, unevenness] = range.change(&direction);
            let delta = range.unevenness();
            let by_mean = self.target.mean.map_or(0.0, |wanted| mean / wanted);
            [by_mean, self.target.unevenness.map_or(0.0, |wanted| -unevenness * wanted / (delta * delta))]
        });
        match (self.target.mean, self.target.unevenness) {
            (Some(_), Some(_)) => {
                let determinant = level[0] * flywheel[1] - flywheel[0] * level[1];
                let a = (-misses[0] * flywheel[1] + misses[1] * flywheel[0]) / determinant;
                let b = (-misses[1] * level[0] + misses[0] * level[1]) / determinant;
                [a, b]
            }
            (Some(_), None) => [-misses[0] / level[0], 0.0],
            (None, Some(_)) => [0.0, -misses[1] / flywheel[1]],
            (None, None) => [0.0, 0.0],
        }
    }

    /// Takes the step, shorter where the trial fails or is worse.
    fn damped(
        &mut self,
        from: &Unknowns,
        step: [f64; 2],
        misses: [f64; 2],
        near: &CycleSolution,
    ) -> Result<(Unknowns, CycleSolution, SpeedRange), DynamicsError> {
        const SHORTEST: f64 = 1e-6;
        let norm = |misses: [f64; 2]| elementary::hypot(misses[0], misses[1]);
        let mut part = 1.0;
        let mut last = None;
        while part > SHORTEST {
            let mut next = *from;
            let level = from.level();
            next.set_level((level + part * step[0]).clamp(0.6 * level, 1.6 * level));
            next.flywheel =
                (from.flywheel + part * step[1]).clamp(0.1 * from.flywheel, 10.0 * from.flywheel.max(1e-12));
            match self.regime(&next, Some(near)) {
                Ok((solution, range)) => {
                    let now = norm(self.target.misses(&range));
                    if now < (1.0 - 0.1 * part) * norm(misses) || now < 1e-9 {
                        return Ok((next, solution, range));
                    }
                }
                Err(error @ (DynamicsError::Equation { .. } | DynamicsError::Held(_))) => {
                    return Err(error);
                }
                Err(error) => last = Some(error),
            }
            part *= 0.5;
        }
        Err(last.unwrap_or(DynamicsError::NotTuned {
            trials: self.trials.len(),
            mean_miss: misses[0],
            unevenness_miss: misses[1],
        }))
    }

    /// The regime without a flywheel, if its unevenness is within what is allowed.
    fn without_flywheel(&mut self, near: &Unknowns) -> Option<Tuned> {
        let wanted = self.target.unevenness?;
        let target = TuningTarget { unevenness: None, ..self.target };
        let tuner = Tuner { shooting: &mut *self.shooting, target, trials: self.trials.clone() };
        let found = tuner.tune(Unknowns { flywheel: 0.0, ..*near }).ok()?;
        self.trials.clone_from(&found.trials);
        (found.range.unevenness() <= wanted).then_some(found)
    }
}

/// Motor speed on the stable branch that gives a torque, or where the branch ends.
pub(crate) fn working_speed(characteristic: &Characteristic, torque: f64) -> f64 {
    let (slow, fast) = stable_branch(characteristic);
    let [slow, fast] = bisect(slow, fast, 0.0, |speed| characteristic.torque(speed) > torque);
    0.5 * (slow + fast)
}

/// Ends of the stable branch: breakdown as motor (of a straight line: a hundredth of the synchronous speed), and as brake.
fn stable_branch(characteristic: &Characteristic) -> (f64, f64) {
    let synchronous = characteristic.synchronous_speed;
    let slow = characteristic.breakdown_speed().unwrap_or(0.0).max(0.01 * synchronous);
    (slow, 2.0 * synchronous - slow)
}

/// Ratio at which the motor carries the mean moment `needed` at the input speed `speed`.
pub(crate) fn working_ratio(
    characteristic: &Characteristic,
    efficiency: f64,
    needed: f64,
    speed: f64,
) -> Result<f64, DynamicsError> {
    let power = |motor: f64| motor * characteristic.torque(motor);
    let wanted = if needed > 0.0 { needed * speed / efficiency } else { needed * speed * efficiency };
    let (mut slow, fast) = stable_branch(characteristic);
    // The greatest power is above the breakdown speed.
    let synchronous = characteristic.synchronous_speed;
    for k in 0..200 {
        let trial = slow + (synchronous - slow) * f64::from(k) / 200.0;
        if power(trial) > power(slow) {
            slow = trial;
        }
    }
    if power(slow) < wanted {
        return Err(DynamicsError::TooWeak { needed: wanted, most: power(slow) });
    }
    let [slow, fast] = bisect(slow, fast, 0.0, |motor| power(motor) > wanted);
    Ok(0.5 * (slow + fast) / speed)
}
