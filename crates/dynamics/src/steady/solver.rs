//! From a request to a regime: first guesses, the search, refinement.

use assur_integrator::EquationOfMotion;
use assur_words::text;

use super::path::{CyclePath, Path, PathPanel, RULE};
use super::regime::{CycleRequest, DriveRequest, Effort, Figures, Regime, TorqueRequest};
use super::solution::{Closing, CycleSolution, Extreme, Iteration, SpeedRange};
use super::tuning::{Tuned, Tuner, TuningTarget, Unknowns, working_ratio, working_speed};
use super::{diagram::WorkDiagram, segment::Setup, shooting::Shooting};
use crate::{DynamicsError, drive::TorqueSource};

/// Accuracy to which polynomials resolve the machine before the regime is known.
const RESOLVE: f64 = 1e-9;

/// How many times as far off as in the middle of a panel a polynomial may be elsewhere: 1.1 times by its nodes, and the rest since
/// the derivative that it misses changes over a panel.
const OFF_THE_MIDDLE: f64 = 8.0;

const MOST_ROUNDS: usize = 12;

/// Rejects a cycle after which the machine is another one than at its start: after a part of a turn of a crank, or under a
/// load that depends on how many turns there were.
fn check_repeats(path: &mut Path<'_>, panels: &[PathPanel], speed: f64) -> Result<(), DynamicsError> {
    /// Part of the greatest value: all are known much better, and change by much more after any cycle that is wrong.
    const SAME: f64 = 1e-6;
    let nodes = || panels.iter().flat_map(|panel| &panel.coefficients.nodes);
    let inertia = nodes().map(|node| node.inertia.abs()).fold(0.0, f64::max);
    let moment = nodes().map(|node| node.moment_at(speed).abs()).fold(0.0, f64::max);
    let length = path.cycle.length;
    let moment = moment.max(inertia * speed * speed / length);
    for panel in panels {
        let (x, before) = (panel.x + RULE.middle * panel.h, &panel.coefficients.middle);
        path.enter(x + length, speed)?;
        let after = path.reduced(x + length, speed)?;
        let compared = [
            (text!("dynamics-inertia"), before.inertia, after.inertia, inertia),
            (
                text!("dynamics-inertia-derivative"),
                before.slope,
                after.slope,
                (before.slope * length).abs().max(inertia) / length,
            ),
            (text!("dynamics-moment"), before.moment_at(speed), after.moment, moment),
        ];
        for (what, before, after, size) in compared {
            if (before - after).abs() > SAME * size {
                let coordinates = [x, x + length].map(|x| path.cycle.coordinate(x));
                return Err(DynamicsError::NotRepeating { what, coordinates, values: [before, after] });
            }
        }
    }
    Ok(())
}

/// Finds steady regimes of one machine over one cycle.
pub struct RegimeSolver<'a> {
    shooting: Shooting<'a>,
    diagram: WorkDiagram,
    pub(crate) request: CycleRequest,
}

impl<'a> RegimeSolver<'a> {
    /// Evaluates a machine (without its drive) over a cycle.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::OverTime`], [`DynamicsError::NoCycle`], [`DynamicsError::NotRepeating`], [`DynamicsError::Equation`]
    /// where a position fails.
    pub fn new(motion: &'a mut dyn EquationOfMotion, request: CycleRequest) -> Result<Self, DynamicsError> {
        if motion.dependence().moment_on_time {
            return Err(DynamicsError::OverTime);
        }
        let usable = |value: f64| value.is_finite() && value != 0.0;
        if !usable(request.length) || !usable(request.mean_speed) || request.length < 0.0 {
            return Err(DynamicsError::NoCycle);
        }
        let CycleRequest { start, length, mean_speed, .. } = request;
        let mut path = Path::new(motion, CyclePath { start, sense: mean_speed.signum(), length });
        let panels = path.panels(mean_speed.abs(), RESOLVE)?;
        check_repeats(&mut path, &panels, mean_speed.abs())?;
        let diagram = WorkDiagram::new(&panels, length, mean_speed.abs());
        Ok(Self { shooting: Shooting { path, panels, cycles: 0 }, diagram, request })
    }

    /// Mean of the reduced resisting moment over the cycle, N m, against the motion. Moments that depend on the speed
    /// are evaluated at the requested mean speed, and after [`solve`](Self::solve) at that of the regime; this also
    /// holds for work and power.
    pub fn mean_resistance(&self) -> f64 {
        self.diagram.mean_moment
    }

    /// Work of the resistance over a cycle, J; negative where the loads drive.
    pub fn resistance_work(&self) -> f64 {
        self.diagram.resistance
    }

    /// Power that the motor must have (S stage 5), W: mean resistance work / (time of a cycle * efficiency). Negative where the
    /// loads drive: the motor brakes, and the losses of the reducer help it (times the efficiency).
    pub fn required_power(&self, efficiency: f64) -> f64 {
        let power = self.diagram.resistance * self.diagram.speed / self.request.length;
        if power > 0.0 { power / efficiency } else { power * efficiency }
    }

    /// How often the machine was evaluated up to now.
    pub fn evaluations(&self) -> usize {
        self.shooting.path.evaluations
    }

    /// Greatest resisting moment over the cycle, N m, against the motion.
    pub fn greatest_resistance(&self) -> f64 {
        let nodes = self.shooting.panels.iter().flat_map(|panel| &panel.coefficients.nodes);
        nodes.map(|node| -node.moment_at(self.diagram.speed)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Finds the periodic regime, with ratio and flywheel where they are wanted.
    ///
    /// # Errors
    ///
    /// [`DynamicsError`], with the place where the machine stalls, or the requirement that can't be met and by how
    /// much.
    pub fn solve(&mut self, drive: &DriveRequest) -> Result<Regime, DynamicsError> {
        let target = self.target(drive)?;
        let mut unknowns = self.first_guess(drive, &target)?;
        let (mut trials, mut round) = (Vec::new(), 0);
        let (tuned, misses) = loop {
            let tuner = Tuner { shooting: &mut self.shooting, target, trials };
            let found = tuner.tune(unknowns)?;
            let (misses, refined) = self.shooting.refine(&found.solution)?;
            round += 1;
            if !refined || round == MOST_ROUNDS {
                break (found, misses);
            }
            (unknowns, trials) = (found.unknowns, found.trials);
        };
        self.check_speed(drive, &tuned)?;
        self.diagram = self.diagram_at(tuned.range.mean())?;
        let (first, iterations) = self.iterate_from_mean_speed(&tuned, &target)?;
        let efficiency = match drive.torque {
            TorqueRequest::Motor { efficiency, .. } => efficiency,
            _ => 1.0,
        };
        let flywheel_by_method = self.diagram.flywheels(&tuned, &target, self.request.constant_inertia);
        let Tuned { unknowns, solution, range, trials } = tuned;
        let (times, cycle_time) = solution.times();
        Ok(Regime {
            mean_resistance: self.mean_resistance(),
            resistance_work: self.resistance_work(),
            cycle_time,
            multiplier: solution.multiplier(),
            drive_inertia: solution.setup.drive.inertia,
            flywheel_needless: target.unevenness.is_some() && unknowns.flywheel == 0.0,
            effort: Effort {
                cycles: self.shooting.cycles,
                evaluations: self.shooting.path.evaluations,
                panels: self.shooting.panels.len(),
                residual: misses.residual,
            },
            iterations,
            trials,
            flywheel: unknowns.flywheel,
            figures: figures(&unknowns, &solution, &range, self.required_power(efficiency)),
            flywheel_by_method,
            error_of_moments: OFF_THE_MIDDLE * misses.moment,
            solution,
            first,
            times,
        })
    }

    /// The work diagram at another mean speed.
    fn diagram_at(&mut self, mean_speed: f64) -> Result<WorkDiagram, DynamicsError> {
        let Shooting { path, panels, .. } = &mut self.shooting;
        let length = self.request.length;
        // At another speed a switch that depends on it has another place.
        if path.switches {
            return Ok(WorkDiagram::new(&path.panels(mean_speed, RESOLVE)?, length, mean_speed));
        }
        Ok(WorkDiagram::new(panels, length, mean_speed))
    }

    /// Without a drive the loads alone determine the mean speed, and no parameter is free to change it.
    fn check_speed(&self, drive: &DriveRequest, tuned: &Tuned) -> Result<(), DynamicsError> {
        /// Mean speeds are given to two or three digits.
        const NEAR: f64 = 0.01;
        let sense = self.shooting.path.cycle.sense;
        let (wanted, found) = (self.request.mean_speed, sense * tuned.range.mean());
        if drive.torque == TorqueRequest::None && ((found - wanted) / wanted).abs() > NEAR {
            return Err(DynamicsError::OtherSpeed { wanted, found });
        }
        Ok(())
    }

    /// Runs cycle after cycle from the mean speed until the relative change of the speed at the start is below
    /// `tolerance`: the slow method, for comparison with [`solve`](Self::solve).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPeriodic`] after `most` cycles, and the errors of [`solve`](Self::solve).
    pub fn settle(
        &mut self,
        regime: &Regime,
        tolerance: f64,
        most: usize,
    ) -> Result<Vec<Iteration>, DynamicsError> {
        let setup = regime.solution.setup;
        let mut energy = self.energy(&setup, self.request.mean_speed.abs());
        let (mut iterations, mut guess, mut residual) = (Vec::new(), None, f64::NAN);
        for number in 1..=most {
            let found = self.shooting.run(setup, energy, guess.as_ref())?;
            iterations.push(found.iteration(number));
            residual = ((found.end - found.start) / found.start).abs();
            if residual <= tolerance {
                return Ok(iterations);
            }
            energy = found.end;
            guess = Some(found);
        }
        Err(DynamicsError::NotPeriodic { cycles: most, residual })
    }

    /// The first cycle from the mean speed (S fig. 9) and the iteration from there (S fig. 10).
    fn iterate_from_mean_speed(
        &mut self,
        tuned: &Tuned,
        target: &TuningTarget,
    ) -> Result<(Option<CycleSolution>, Vec<Iteration>), DynamicsError> {
        let setup = tuned.solution.setup;
        let energy = self.energy(&setup, tuned.range.mean());
        let Ok(first) = self.shooting.run(setup, energy, Some(&tuned.solution)) else {
            return Ok((None, Vec::new()));
        };
        let mut iterations = Vec::new();
        self.shooting.close(setup, target.closing, energy, Some(first.clone()), &mut iterations)?;
        Ok((Some(first), iterations))
    }

    fn energy(&self, setup: &Setup, speed: f64) -> f64 {
        let inertia = self.shooting.panels.first().map_or(0.0, |panel| panel.coefficients.nodes[0].inertia);
        0.5 * (inertia + setup.drive.inertia) * speed * speed
    }

    fn target(&self, drive: &DriveRequest) -> Result<TuningTarget, DynamicsError> {
        let mean = self.request.mean_speed.abs();
        let unevenness = drive.unevenness.filter(|_| drive.flywheel.is_none());
        let on_motor = drive.flywheel_on_motor;
        let target = |closing, mean, rotor| TuningTarget { mean, unevenness, closing, on_motor, rotor };
        Ok(match drive.torque {
            TorqueRequest::Motor { rotor, ratio, .. } => {
                target(Closing::Speed, if ratio.is_none() { Some(mean) } else { None }, rotor)
            }
            TorqueRequest::Balance => target(Closing::Moment, Some(mean), 0.0),
            TorqueRequest::None | TorqueRequest::Constant(_) if self.shooting.path.by_speed => {
                target(Closing::Speed, None, 0.0)
            }
            TorqueRequest::None | TorqueRequest::Constant(_) => {
                self.check_work(drive.torque)?;
                target(Closing::Free, Some(mean), 0.0)
            }
        })
    }

    /// A machine whose speed nothing restores needs a cycle whose work is zero.
    fn check_work(&self, torque: TorqueRequest) -> Result<(), DynamicsError> {
        /// Rounding of the quadrature.
        const ZERO: f64 = 1e-9;
        let moment = if let TorqueRequest::Constant(moment) = torque { moment } else { 0.0 };
        let own = moment * self.request.length;
        let work = own - self.diagram.resistance;
        let range = self.diagram.excess_work();
        let energy = 0.5 * self.diagram.mean_inertia * self.request.mean_speed.powi(2);
        if work.abs() > ZERO * (range + own.abs() + energy) {
            return Err(DynamicsError::NoRegime { work, energy });
        }
        Ok(())
    }

    fn first_guess(&self, drive: &DriveRequest, target: &TuningTarget) -> Result<Unknowns, DynamicsError> {
        let needed = self.diagram.mean_moment;
        let mut speed = self.request.mean_speed.abs();
        let source = match drive.torque {
            TorqueRequest::None => TorqueSource::None,
            TorqueRequest::Balance => TorqueSource::Constant(needed),
            TorqueRequest::Constant(moment) => TorqueSource::Constant(moment),
            TorqueRequest::Motor { characteristic, ratio: Some(ratio), efficiency, .. } => {
                let torque =
                    if needed > 0.0 { needed / (ratio * efficiency) } else { needed * efficiency / ratio };
                speed = working_speed(&characteristic, torque) / ratio;
                TorqueSource::Motor { characteristic, ratio, efficiency }
            }
            TorqueRequest::Motor { characteristic, ratio: None, efficiency, .. } => {
                let ratio = working_ratio(&characteristic, efficiency, needed, speed)?;
                TorqueSource::Motor { characteristic, ratio, efficiency }
            }
        };
        let mut unknowns = Unknowns { source, energy: 0.0, flywheel: drive.flywheel.unwrap_or(0.0) };
        if let Some(unevenness) = target.unevenness {
            unknowns.flywheel = self.guess_flywheel(target, &unknowns, speed, unevenness);
        }
        let setup = target.setup(&unknowns, self.shooting.path.cycle.sense);
        unknowns.energy = self.energy(&setup, speed);
        if let (Some(unevenness), true) = (target.unevenness, target.closing != Closing::Speed) {
            let (_, energy) = self.diagram.wittenbauer(speed, unevenness);
            unknowns.energy = if energy > 0.0 { energy } else { unknowns.energy };
        }
        Ok(unknowns)
    }

    /// From the energy-mass diagram, which takes the drive as constant.
    fn guess_flywheel(&self, target: &TuningTarget, unknowns: &Unknowns, speed: f64, unevenness: f64) -> f64 {
        let (total, _) = self.diagram.wittenbauer(speed, unevenness);
        let ratio = unknowns.ratio().unwrap_or(1.0);
        let rotor = ratio * ratio * target.rotor;
        let least = 1e-3 * (self.diagram.mean_inertia + rotor);
        let guess = (total - rotor).max(0.05 * total).max(least);
        if target.on_motor { guess / (ratio * ratio) } else { guess }
    }
}

/// The figures of a regime that was found.
fn figures(
    unknowns: &Unknowns,
    solution: &CycleSolution,
    range: &SpeedRange,
    required_power: f64,
) -> Figures {
    let (cycle, low, high) = (solution.cycle, range.least, range.greatest);
    let energy = |at: &Extreme| solution.segments[at.piece].energy_at(at.theta);
    let angle = (high.at.x - low.at.x).rem_euclid(cycle.length);
    let place = |at: &Extreme| cycle.coordinate(at.x.rem_euclid(cycle.length));
    let torque =
        if let TorqueSource::Constant(moment) = solution.setup.drive.source { Some(moment) } else { None };
    Figures {
        ratio: unknowns.ratio(),
        mean_speed: cycle.sense * range.mean(),
        unevenness: range.unevenness(),
        speed_min: cycle.sense * low.value,
        speed_max: cycle.sense * high.value,
        coordinate_at_min: place(&low.at),
        coordinate_at_max: place(&high.at),
        // Past the end of the cycle the energy starts again, with the small change that a cycle may leave.
        excess_work: energy(&high.at) - energy(&low.at),
        dynamic_unevenness: Some(2.0 * range.unevenness() / angle).filter(|value| value.is_finite()),
        required_power,
        torque,
    }
}
