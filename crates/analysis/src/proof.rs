//! Independent checks of motions: work against energy, and a cycle repeated by steps in time.

use assur_check::{Check, Finding};
use assur_dynamics::{Machine, Regime, Steady, Transient};
use assur_integrator::{
    AUTO, EquationOfMotion, Event, EventKind, Piece, Request, Sample, Solution, State, Trajectory, Until,
    solve,
};
use assur_number::ROUNDING;
use assur_number::quadrature::simpson;
use assur_words::{Text, name, text};

use crate::{Calculation, motion::CYCLE_INTERVALS};

/// Intervals of the quadrature of the work, multiples of four. A finer grid is tried only where the coarser one is inconclusive,
/// and the finest only where the energies don't balance: a reduced inertia that nearly vanishes at a dead center makes the work
/// peak there.
const INTERVALS: [usize; 3] = [500, 4000, 32_000];
/// Tolerance of the repeated cycle.
const TOLERANCE: f64 = 1e-10;
/// Steps that Simpson's rule is applied to, finely and coarsely.
const STEPS: f64 = 4.0;
/// How many times greater than one that is measured a rounding may be.
const ROUNDINGS: f64 = 4.0;

impl Calculation {
    /// Change of the kinetic energy compared with the work of all moments, by quadrature over a finer trajectory.
    pub(crate) fn work_check(&self, found: &Transient) -> Option<Check> {
        let loads = self.loads.as_ref()?;
        let mut worst = None;
        for samples in INTERVALS {
            let (mut motion, trajectory) = self.solved_again(loads, found, samples, true)?;
            let mut balance = Balance::of(&mut motion, &trajectory, samples > INTERVALS[0])?;
            balance.unresolved += found.energy.rounding * found.energy.greatest();
            let steps = (trajectory.statistics.steps + 1) as f64;
            let own = 2.0 * (self.tolerance() * steps + found.error_of_fixed_steps());
            let found = worst.insert(balance.worst(own));
            // The error of the quadrature is no greater than that of the motion; with more instants it is smaller.
            let tells = found.bound <= 2.0 * (own + ROUNDING) || samples > INTERVALS[0];
            if found.error <= found.bound && tells && found.why != OF_QUADRATURE {
                break;
            }
        }
        Some(Check::of(text!("analysis-work"), text!("analysis-work.reason"), worst?))
    }

    /// One cycle from the state of the regime by an integrator in time: it must come back, and take the same time.
    pub(crate) fn cycle_check(&self, found: &Steady) -> Option<Check> {
        let (loads, regime) = (self.loads.as_ref()?, &found.regime);
        let input = &self.linkage.mechanism.input;
        let mut motion = Machine::new(&self.linkage, loads).with_drive(regime.drive());
        let start = State { time: 0.0, coordinate: input.from, speed: regime.state(input.from).speed };
        let end = input.from + input.sign() * input.period()?;
        let asked =
            Request { tolerance: TOLERANCE, samples: 1, ..Request::new(start, Until::Coordinate(end)) };
        let Solution { trajectory, integrator, .. } = solve(AUTO, &mut motion, &asked).ok()?;
        let back = (trajectory.end.speed / start.speed - 1.0).abs();
        let time = (trajectory.end.time / regime.cycle_time - 1.0).abs();
        let own = 2.0 * TOLERANCE * (trajectory.statistics.steps + 1) as f64;
        let limits = counted(regime, [input.from, end]).map(|times| times * own + regime.effort.residual);
        let by_limit = |one: &(f64, f64), other: &(f64, f64)| (one.0 / one.1).total_cmp(&(other.0 / other.1));
        let (residual, limit) = [back, time].into_iter().zip(limits).max_by(by_limit)?;
        let found = Finding::of(name(integrator.name), residual, limit);
        Some(Check::of(text!("analysis-cycle"), text!("analysis-cycle.reason"), found))
    }
}

/// Amplification of a relative speed error of one step (as a part of the greatest speed): in the speed at the end of the cycle,
/// and in the duration of the cycle, both relative. The error of a step changes the energy by J w times the error of the speed,
/// and this change is a large part of J w^2 wherever the machine is slow.
fn counted(regime: &Regime, [from, to]: [f64; 2]) -> [f64; 2] {
    let part = |i: u32| from + (to - from) * (f64::from(i) / f64::from(CYCLE_INTERVALS));
    let states = (0..=CYCLE_INTERVALS).map(|i| regime.state(part(i)));
    // Momentum and speed.
    let states = states.map(|at| ((at.inertia + regime.drive_inertia) * at.speed.abs(), at.speed.abs()));
    let states: Vec<(f64, f64)> = states.collect();
    let most = |of: fn(&(f64, f64)) -> f64| states.iter().map(of).fold(0.0, f64::max);
    let energy = most(|at| at.0) * most(|at| at.1);
    let end = states.last().map_or(1.0, |(momentum, speed)| energy / (momentum * speed));
    // A cycle lasts as long at each coordinate as it is slow there.
    let slowness = states.iter().map(|(_, speed)| 1.0 / speed).sum::<f64>();
    let late = states.iter().map(|(momentum, speed)| energy / (momentum * speed * speed)).sum::<f64>();
    [end, late / slowness]
}

/// Kinetic energy and power of all moments at equally spaced instants.
struct Balance {
    step: f64,
    kinetic: Vec<f64>,
    power: Vec<f64>,
    /// What the rounding of the speed makes of the power, where a steep characteristic holds a speed, and that of the
    /// coordinate.
    rounding: Vec<f64>,
    /// The greatest work over a rounding unit of the coordinate in every step, and the rounding of the potential energy, J: the
    /// motion is known no better.
    unresolved: f64,
    /// What an error of the size of the greatest speed in each step would add to the kinetic energy, up to each instant, J: an error of a step is
    /// a part of that speed, and where the reduced inertia grows without limit it counts for more than the energy.
    by_speed: Vec<f64>,
    /// What lies between each instant and the next one.
    between: Vec<Between>,
}

/// Why a residual may prove nothing: what its limit mostly consists of.
const OF_QUADRATURE: Text = text!("analysis-wide-quadrature");
const OF_ROUNDING: Text = text!("analysis-wide-rounding");
const OF_MOTION: Text = text!("analysis-wide-motion");

/// What the power does between two instants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Between {
    /// It follows one formula, and the speed changes little.
    Smooth,
    /// One formula follows another.
    Change,
    /// It can't be known from the two instants: another formula begins and ends between them, or the motion would go through
    /// all its speeds in the four steps that are added up together.
    Unseen,
}

impl Between {
    fn of(
        before: &Sample,
        after: &Sample,
        [piece, next]: [&Piece; 2],
        fastest: f64,
        events: &[Event],
    ) -> Self {
        let dimensions = [
            (piece.coordinate, next.coordinate, before.coordinate, after.coordinate),
            (piece.speed, next.speed, before.speed, after.speed),
            (piece.time, next.time, before.time, after.time),
        ];
        // A piece reaches the state that follows it, or ends where the next one begins.
        let leaves = |([low, high], _, _, to): &([f64; 2], _, _, f64)| *to < *low || *to > *high;
        let adjoins = |([low, high], [from, until], start, end): &([f64; 2], [f64; 2], f64, f64)| {
            let [bound, begin] = if end >= start { [high, from] } else { [low, until] };
            (begin - bound).abs() <= ROUNDING * bound.abs().max(1.0)
        };
        let left = dimensions.iter().filter(|dimension| leaves(dimension));
        let switched = events.iter().filter(|event| {
            let at = event.state.time;
            event.kind == EventKind::Switch && before.time <= at && at <= after.time
        });
        let switched = switched.count();
        let gain = before.acceleration.abs().max(after.acceleration.abs()) * (after.time - before.time);
        if STEPS * gain > fastest || left.clone().any(|dimension| !adjoins(dimension)) || switched > 1 {
            return Self::Unseen;
        }
        if left.count() + switched > 0 { Self::Change } else { Self::Smooth }
    }
}

impl Balance {
    /// `careful`: what the rounding of the coordinate makes of the power is measured, too.
    fn of(motion: &mut dyn EquationOfMotion, trajectory: &Trajectory, careful: bool) -> Option<Self> {
        let samples = &trajectory.samples;
        let step =
            (samples.last()?.time - samples.first()?.time) / samples.len().saturating_sub(1).max(1) as f64;
        let on_speed = motion.dependence().moment_on_speed;
        let (mut kinetic, mut power, mut rounding) = (Vec::new(), Vec::new(), Vec::new());
        let (mut pieces, mut unresolved) = (Vec::new(), 0.0_f64);
        let fastest = samples.iter().map(|sample| sample.speed.abs()).fold(0.0, f64::max);
        let steps = (trajectory.statistics.steps + 1) as f64;
        let (mut by_speed, mut greatest) = (Vec::new(), 0.0_f64);
        for &Sample { time, coordinate, speed, acceleration } in samples {
            let state = State { time, coordinate, speed };
            pieces.push(motion.enter(&state).ok()?);
            let reduced = motion.reduced(&state).ok()?;
            greatest = greatest.max(0.5 * reduced.inertia * speed.abs() * fastest);
            by_speed.push(greatest);
            if speed == 0.0 {
                kinetic.push(0.0);
                power.push(0.0);
                rounding.push(0.0);
                continue;
            }
            kinetic.push(0.5 * reduced.inertia * speed * speed);
            // At a speed that is held the moments have the value that holds it.
            let held = 0.5 * reduced.inertia_derivative * speed * speed;
            let moment = if acceleration == 0.0 { held } else { reduced.moment };
            power.push(moment * speed);
            unresolved = unresolved.max((moment * coordinate).abs() * f64::EPSILON);
            let more = |value: f64, much: bool| if much { value * (1.0 + f64::EPSILON) } else { value };
            let beside = State { coordinate: more(coordinate, careful), speed: more(speed, on_speed), time };
            let measured = careful || on_speed;
            let change = if measured { motion.reduced(&beside).ok()?.moment - reduced.moment } else { 0.0 };
            // One difference tells the size of a rounding, not its greatest value.
            rounding.push(ROUNDINGS * (change * speed).abs());
        }
        let pairs = samples.windows(2).zip(pieces.windows(2));
        let between =
            pairs.map(|(s, p)| Between::of(&s[0], &s[1], [&p[0], &p[1]], fastest, &trajectory.events));
        let between = between.collect();
        let unresolved = unresolved * steps;
        Some(Self { step, kinetic, power, rounding, unresolved, by_speed, between })
    }

    /// The residual nearest to its limit, both as parts of the largest energy; `own`: error of the motion itself.
    fn worst(&self, own: f64) -> Finding {
        let (mut work, mut error, mut size) = (0.0_f64, 0.0_f64, 0.0_f64);
        let scale = self.kinetic.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let (mut worst, mut widest) = ([0.0, own + ROUNDING], OF_MOTION);
        for start in (0..self.power.len().saturating_sub(4)).step_by(4) {
            let (fine, uncertain) = self.panel(start);
            work += fine;
            size += fine.abs();
            error += uncertain;
            let total = scale.max(size);
            let residual = (self.kinetic[start + 4] - self.kinetic[0] - work).abs() / total;
            let of_motion = own * (self.by_speed[start + 4] / total).max(1.0);
            let limit = (error + self.unresolved) / total + of_motion + ROUNDING;
            if residual / limit >= worst[0] / worst[1] {
                let parts = [
                    (error / total, OF_QUADRATURE),
                    (self.unresolved / total, OF_ROUNDING),
                    (of_motion, OF_MOTION),
                ];
                let greatest = parts.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
                (worst, widest) = ([residual, limit], greatest.map_or_else(Text::default, |(_, why)| why));
            }
        }
        let found = Finding::of(text!("check-input-link"), worst[0], worst[1]);
        if found.holds.is_none() { Finding { why: widest, ..found } } else { found }
    }

    /// The work over four steps by Simpson's rule, and its greatest error.
    fn panel(&self, start: usize) -> (f64, f64) {
        let p = &self.power[start..=start + 4];
        let (fine, coarse) = (simpson(self.step, p), simpson(2.0 * self.step, &[p[0], p[2], p[4]]));
        let trapezoids = self.step * (0.5 * p[0] + p[1] + p[2] + p[3] + 0.5 * p[4]);
        let between = &self.between[start..start + 4];
        let mut error = 2.0 * (fine - coarse).abs();
        let rounding = self.step * self.rounding[start..start + 4].iter().sum::<f64>();
        if between.contains(&Between::Change) {
            // In every step the power lies between its two values, which bounds the error of a trapezoid.
            let variation: f64 = p.windows(2).map(|two| (two[1] - two[0]).abs()).sum();
            error = error.max((fine - trapezoids).abs() + 0.5 * self.step * variation);
        }
        if between.contains(&Between::Unseen) {
            error += (self.kinetic[start + 4] - self.kinetic[start] - fine).abs();
        }
        (fine, error + rounding)
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
pub(crate) use tests::twice_the_limit;
