//! Independent checks of motions: work against energy, and a cycle repeated by steps in time.

use assur_check::Check;
use assur_dynamics::{Driven, Machine, Steady, Transient, equation, request};
use assur_integrator::{AUTO, Motion, Piece, Request, Sample, Solution, State, Trajectory, Until, solve};

use crate::Calculation;

/// Intervals of the quadrature of the work; a multiple of four.
const INTERVALS: usize = 4000;
/// Tolerance of the repeated cycle.
const TOLERANCE: f64 = 1e-10;
/// Least part of the largest energy that a sum of energies can resolve.
const ROUNDING: f64 = 1e-12;

impl Calculation {
    /// Change of the kinetic energy against the work of all moments, by quadrature over a finer trajectory.
    pub(crate) fn work_check(&self, found: &Transient) -> Option<Check> {
        let loads = self.loads.as_ref()?;
        let mut motion = equation(&self.linkage, loads).ok()?;
        let asked = request(&self.linkage.mechanism, &mut motion).ok()?;
        let until = if found.unrest.is_some() { Until::Turn } else { asked.until };
        let finer = Request { samples: INTERVALS, until, ..asked };
        let trajectory = solve(found.integrator, &mut motion, &finer).ok()?.trajectory;
        let balance = Balance::of(&mut motion, &trajectory)?;
        let steps = (trajectory.statistics.steps + 1) as f64;
        let (residual, limit) = balance.worst(2.0 * asked.tolerance * steps);
        let reason = "change of the kinetic energy against the work of all moments by Simpson's rule, parts of the largest \
                      energy; limit: twice the error of the quadrature (from half as many points) and the tolerance of every \
                      step";
        Some(Check::of("work and kinetic energy", residual, limit, "input link", reason))
    }

    /// One cycle from the state of the regime by an integrator in time: it must come back, and take the same time.
    pub(crate) fn cycle_check(&self, found: &Steady) -> Option<Check> {
        let (loads, regime) = (self.loads.as_ref()?, &found.regime);
        let input = &self.linkage.mechanism.input;
        let mut motion = Driven::new(Machine::new(&self.linkage, loads), regime.drive());
        let start = State { time: 0.0, coordinate: input.from, speed: regime.state(input.from).speed };
        let end = input.from + input.sign() * input.period()?;
        let asked =
            Request { tolerance: TOLERANCE, samples: 1, ..Request::new(start, Until::Coordinate(end)) };
        let Solution { trajectory, integrator, .. } = solve(AUTO, &mut motion, &asked).ok()?;
        let back = (trajectory.end.speed / start.speed - 1.0).abs();
        let time = (trajectory.end.time / regime.cycle_time - 1.0).abs();
        let limit = 2.0 * TOLERANCE * (trajectory.statistics.steps + 1) as f64 + regime.effort.residual;
        let reason = "a cycle run once more in time from the speed of the regime: relative difference of the speed at its end \
                      and of its duration; limit: the tolerance of every step and the residual of the regime";
        Some(Check::of("cycle in time", back.max(time), limit, integrator.name, reason))
    }
}

/// Kinetic energy and power of all moments at equally spaced instants.
struct Balance {
    step: f64,
    kinetic: Vec<f64>,
    power: Vec<f64>,
    /// Whether a piece of a law begins and ends between an instant and the next one, so that the quadrature misses it.
    steps_over: Vec<bool>,
}

impl Balance {
    fn of(motion: &mut dyn Motion, trajectory: &Trajectory) -> Option<Self> {
        let samples = &trajectory.samples;
        let step =
            (samples.last()?.time - samples.first()?.time) / samples.len().saturating_sub(1).max(1) as f64;
        let mut found = Self { step, kinetic: Vec::new(), power: Vec::new(), steps_over: Vec::new() };
        for (index, &Sample { time, coordinate, speed, acceleration }) in samples.iter().enumerate() {
            let state = State { time, coordinate, speed };
            let piece = motion.enter(&state).unwrap_or(Piece::UNBOUNDED);
            let next = samples.get(index + 1).map_or(coordinate, |next| next.coordinate);
            let width = |[low, high]: [f64; 2]| high - low;
            found
                .steps_over
                .push(width(piece.coordinate) < (next - coordinate).abs() || width(piece.time) < step);
            if speed == 0.0 {
                found.kinetic.push(0.0);
                found.power.push(0.0);
                continue;
            }
            motion.enter(&state).ok()?;
            let reduced = motion.reduced(&state).ok()?;
            found.kinetic.push(0.5 * reduced.inertia * speed * speed);
            // At a speed that is held the moments have the value that holds it.
            let held = 0.5 * reduced.inertia_derivative * speed * speed;
            let moment = if acceleration == 0.0 { held } else { reduced.moment };
            found.power.push(moment * speed);
        }
        Some(found)
    }

    /// The residual nearest to its limit, both as parts of the largest energy; `own`: error of the motion itself.
    fn worst(&self, own: f64) -> (f64, f64) {
        let (mut work, mut error, mut size) = (0.0_f64, 0.0_f64, 0.0_f64);
        let scale = self.kinetic.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let mut worst = (0.0, own + ROUNDING);
        for start in (0..self.power.len().saturating_sub(4)).step_by(4) {
            let p = &self.power[start..=start + 4];
            let fine = self.step / 3.0 * (p[0] + 4.0 * p[1] + 2.0 * p[2] + 4.0 * p[3] + p[4]);
            let coarse = 2.0 * self.step / 3.0 * (p[0] + 4.0 * p[2] + p[4]);
            work += fine;
            size += fine.abs();
            error += (fine - coarse).abs();
            if self.steps_over.iter().skip(start).take(4).any(|over| *over) {
                // A piece that is shorter than a step can't be checked with these steps.
                error += (self.kinetic[start + 4] - self.kinetic[start] - fine).abs();
            }
            let total = scale.max(size);
            let residual = (self.kinetic[start + 4] - self.kinetic[0] - work).abs() / total;
            let limit = 2.0 * error / total + own + ROUNDING;
            if residual / limit >= worst.0 / worst.1 {
                worst = (residual, limit);
            }
        }
        worst
    }
}

#[cfg(test)]
mod tests;
