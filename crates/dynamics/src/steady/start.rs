//! From a request to a regime: first guesses, the search, refinement.

use super::approximate::Diagram;
use super::arc::Solution;
use super::regime::{Reached, Regime};
use super::report::Turn;
use super::shooting::Closing;
use super::sweep::Setup;
use super::tuning::{Tuned, Tuner, Unknowns, Wish};
use super::{DriveRequest, Survey, TorqueRequest};
use crate::DynamicsError;
use crate::shaft::Source;

/// The regime may miss the equation between the nodes by this part of the energy.
const ACCURACY: f64 = 2e-13;

/// Rounds of refinement.
const MOST_ROUNDS: usize = 12;

impl Survey<'_> {
    /// Finds the periodic regime, with ratio and flywheel where they are wanted.
    ///
    /// # Errors
    ///
    /// [`DynamicsError`], with the place where the machine stalls, or what can't be met and by how much.
    pub fn solve(&mut self, drive: &DriveRequest) -> Result<Regime, DynamicsError> {
        let wish = self.wish(drive)?;
        let mut unknowns = self.first_guess(drive, &wish)?;
        let (mut trials, mut round) = (Vec::new(), 0);
        let (tuned, residual) = loop {
            let tuner = Tuner { shooter: &mut self.shooter, wish, trials };
            let found = tuner.tune(unknowns)?;
            let (residual, refined) = self.shooter.refine(&found.solution, ACCURACY)?;
            round += 1;
            if !refined || round == MOST_ROUNDS {
                break (found, residual);
            }
            (unknowns, trials) = (found.unknowns, found.trials);
        };
        self.diagram = Diagram::new(&self.shooter.panels, &self.request);
        let (first, turns) = self.turns_to(&tuned, &wish)?;
        Ok(Regime::new(self.reached(drive, wish, tuned, residual), first, turns))
    }

    fn reached(&self, drive: &DriveRequest, wish: Wish, tuned: Tuned, residual: f64) -> Reached {
        let efficiency = match drive.torque {
            TorqueRequest::Motor { efficiency, .. } => efficiency,
            _ => 1.0,
        };
        Reached {
            diagram: self.diagram.clone(),
            request: self.request,
            wanted_unevenness: drive.unevenness.filter(|_| drive.flywheel.is_none()),
            required_power: self.required_power(efficiency),
            effort: super::Effort {
                cycles: self.shooter.cycles,
                evaluations: self.shooter.road.evaluations,
                panels: self.shooter.panels.len(),
                residual,
            },
            wish,
            tuned,
        }
    }

    /// Runs cycle after cycle from the mean speed until the speed at the start changes by less than `tolerance`
    /// (relative): the slow method, for comparison with [`solve`](Self::solve).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPeriodic`] after `most` cycles, and as [`solve`](Self::solve).
    pub fn settle(
        &mut self,
        regime: &Regime,
        tolerance: f64,
        most: usize,
    ) -> Result<Vec<Turn>, DynamicsError> {
        let setup = *regime.setup();
        let energy = self.energy(&setup, self.request.mean_speed.abs());
        self.shooter.settle(setup, energy, tolerance, most).map(|found| found.1)
    }

    /// The first turn from the mean speed (S fig. 9) and the iteration from there (S fig. 10).
    fn turns_to(
        &mut self,
        tuned: &Tuned,
        wish: &Wish,
    ) -> Result<(Option<Solution>, Vec<Turn>), DynamicsError> {
        let setup = tuned.solution.setup;
        let energy = self.energy(&setup, tuned.swing.mean());
        let Ok(first) = self.shooter.run(setup, energy, Some(&tuned.solution)) else {
            return Ok((None, Vec::new()));
        };
        let mut turns = Vec::new();
        self.shooter.close(setup, wish.closing, energy, Some(first.clone()), &mut turns)?;
        Ok((Some(first), turns))
    }

    fn energy(&self, setup: &Setup, speed: f64) -> f64 {
        let inertia = self.shooter.panels.first().map_or(0.0, |panel| panel.data.start.inertia);
        0.5 * (inertia + setup.shaft.inertia) * speed * speed
    }

    fn wish(&self, drive: &DriveRequest) -> Result<Wish, DynamicsError> {
        let mean = self.request.mean_speed.abs();
        let unevenness = drive.unevenness.filter(|_| drive.flywheel.is_none());
        let on_motor = drive.flywheel_on_motor;
        let wish = |closing, mean, rotor| Wish { mean, unevenness, closing, on_motor, rotor };
        Ok(match drive.torque {
            TorqueRequest::Motor { rotor, ratio, .. } => {
                wish(Closing::Speed, if ratio.is_none() { Some(mean) } else { None }, rotor)
            }
            TorqueRequest::Balance => wish(Closing::Moment, Some(mean), 0.0),
            TorqueRequest::None | TorqueRequest::Constant(_) if self.shooter.road.by_speed => {
                wish(Closing::Speed, None, 0.0)
            }
            TorqueRequest::None | TorqueRequest::Constant(_) => {
                self.check_work(drive.torque)?;
                wish(Closing::Free, Some(mean), 0.0)
            }
        })
    }

    /// A machine whose speed nothing restores needs a cycle without work.
    fn check_work(&self, torque: TorqueRequest) -> Result<(), DynamicsError> {
        /// Rounding of the quadrature.
        const ZERO: f64 = 1e-9;
        let moment = if let TorqueRequest::Constant(moment) = torque { moment } else { 0.0 };
        let own = self.shooter.road.way.sense * moment * self.request.length;
        let work = own - self.diagram.resistance;
        let range = self.diagram.approximate(self.request.mean_speed, 1.0, 0.0, 0.0).excess_work;
        let energy = 0.5 * self.diagram.mean_inertia * self.request.mean_speed.powi(2);
        if work.abs() > ZERO * (range + own.abs() + energy) {
            return Err(DynamicsError::NoRegime { work, energy });
        }
        Ok(())
    }

    fn first_guess(&self, drive: &DriveRequest, wish: &Wish) -> Result<Unknowns, DynamicsError> {
        let needed = self.diagram.mean_moment;
        let mut speed = self.request.mean_speed.abs();
        let source = match drive.torque {
            TorqueRequest::None => Source::None,
            TorqueRequest::Balance => Source::Constant(needed),
            TorqueRequest::Constant(moment) => Source::Constant(self.shooter.road.way.sense * moment),
            TorqueRequest::Motor { characteristic, ratio: Some(ratio), efficiency, .. } => {
                let torque =
                    if needed > 0.0 { needed / (ratio * efficiency) } else { needed * efficiency / ratio };
                speed = working_speed(&characteristic, torque) / ratio;
                Source::Motor { characteristic, ratio, efficiency }
            }
            TorqueRequest::Motor { characteristic, ratio: None, efficiency, .. } => {
                let ratio = working_ratio(&characteristic, efficiency, needed, speed)?;
                Source::Motor { characteristic, ratio, efficiency }
            }
        };
        let mut unknowns = Unknowns { source, energy: 0.0, flywheel: drive.flywheel.unwrap_or(0.0) };
        if let Some(unevenness) = wish.unevenness {
            unknowns.flywheel = self.guess_flywheel(wish, &unknowns, speed, unevenness);
        }
        let setup = wish.setup(&unknowns, self.shooter.road.way.sense);
        unknowns.energy = self.energy(&setup, speed);
        if let (Some(unevenness), true) = (wish.unevenness, wish.closing != Closing::Speed) {
            let (_, energy) = self.diagram.wittenbauer(speed, unevenness);
            unknowns.energy = if energy > 0.0 { energy } else { unknowns.energy };
        }
        Ok(unknowns)
    }

    /// From the energy-mass diagram, which takes the drive as constant.
    fn guess_flywheel(&self, wish: &Wish, unknowns: &Unknowns, speed: f64, unevenness: f64) -> f64 {
        let (total, _) = self.diagram.wittenbauer(speed, unevenness);
        let ratio = unknowns.ratio().unwrap_or(1.0);
        let rotor = ratio * ratio * wish.rotor;
        let least = 1e-3 * (self.diagram.mean_inertia + rotor);
        let guess = (total - rotor).max(0.05 * total).max(least);
        if wish.on_motor { guess / (ratio * ratio) } else { guess }
    }
}

/// Motor speed on the stable branch that gives a torque, or where the branch ends.
fn working_speed(characteristic: &assur_motor::Characteristic, torque: f64) -> f64 {
    let (mut slow, mut fast) = branch(characteristic);
    for _ in 0..60 {
        let middle = 0.5 * (slow + fast);
        if characteristic.torque(middle) > torque { slow = middle } else { fast = middle }
    }
    0.5 * (slow + fast)
}

/// Ends of the stable branch: breakdown as motor (of a straight line: a hundredth of the synchronous speed), and as brake.
fn branch(characteristic: &assur_motor::Characteristic) -> (f64, f64) {
    let synchronous = characteristic.synchronous_speed();
    let slow = characteristic.breakdown_speed().unwrap_or(0.0).max(0.01 * synchronous);
    (slow, 2.0 * synchronous - slow)
}

/// Ratio at which the motor carries the mean moment `needed` at the input speed `speed`.
fn working_ratio(
    characteristic: &assur_motor::Characteristic,
    efficiency: f64,
    needed: f64,
    speed: f64,
) -> Result<f64, DynamicsError> {
    let power = |motor: f64| motor * characteristic.torque(motor);
    let wanted = if needed > 0.0 { needed * speed / efficiency } else { needed * speed * efficiency };
    let (mut slow, mut fast) = branch(characteristic);
    // Of the power, the greatest lies above the breakdown speed.
    let synchronous = characteristic.synchronous_speed();
    for k in 0..200 {
        let trial = slow + (synchronous - slow) * f64::from(k) / 200.0;
        if power(trial) > power(slow) {
            slow = trial;
        }
    }
    if power(slow) < wanted {
        return Err(DynamicsError::TooWeak { needed: wanted, most: power(slow) });
    }
    for _ in 0..60 {
        let middle = 0.5 * (slow + fast);
        if power(middle) > wanted { slow = middle } else { fast = middle }
    }
    Ok(0.5 * (slow + fast) / speed)
}
