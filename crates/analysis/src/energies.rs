//! Energies over a motion: works of the driving and of the resisting loads, and the kinetic energy (E eq. 1).

use std::sync::Arc;

use assur_dynamics::{Driven, Machine, Steady, Transient, equation, request};
use assur_force::{Cause, Loads, Side, State};
use assur_group::{Body, Order};
use assur_integrator::{Motion as _, Request, Sample, State as Place, Trajectory, Until, solve};

use crate::motion::CYCLE_INTERVALS;
use crate::results::{Column, Owner, Quantity, Schema, Table};
use crate::{Calculation, InputMotion};

/// Fewest intervals of the quadrature over a transient motion.
const FEWEST: usize = 500;
/// Intervals of the quadrature over each smooth part of an interval of a cycle.
const IN_INTERVAL: u32 = 4;

/// Works of the driving and of the resisting loads, J.
type Works = [f64; 2];

/// Energies over a motion.
struct Course {
    /// Between each sample and the next one: the works, and how much their rates change.
    intervals: Vec<(Works, [f64; 2])>,
    /// Kinetic energy at each sample, of flywheel and rotor as well, J.
    kinetic: Vec<f64>,
}

impl Calculation {
    /// The energies at the samples of the motion; no table where there is no motion or not all loads are known.
    pub(crate) fn energies(&self) -> Table {
        let loads = self.loads.as_ref().filter(|_| self.knows_all_loads());
        let course = loads.and_then(|loads| match &self.motion {
            InputMotion::Prescribed => None,
            InputMotion::Transient(found) => self.transient_course(loads, found),
            InputMotion::Steady(found) => self.steady_course(loads, found),
        });
        let Some(course) = course else { return Table::default() };
        let mut schema = Schema::new(&self.linkage.mechanism);
        let section = schema.section();
        let all = [Quantity::DrivingWork, Quantity::ResistingWork, Quantity::KineticEnergy];
        schema.add(section, all.map(|quantity| Column::of(quantity, Owner::Input)));
        let mut table = Table::new(Arc::new(schema));
        for (number, energies) in course.energies().into_iter().enumerate() {
            let finite = energies.iter().all(|energy| energy.is_finite());
            table.push(number, energies.map(|energy| finite.then_some(energy)));
        }
        table
    }

    /// A transient motion solved once more, with another number of samples.
    pub(crate) fn solved_again<'a>(
        &'a self,
        loads: &'a Loads,
        found: &Transient,
        samples: usize,
    ) -> Option<(Driven<Machine<'a>>, Trajectory)> {
        let mut motion = equation(&self.linkage, loads).ok()?;
        let asked = request(&self.linkage.mechanism, &mut motion).ok()?;
        let until = if found.unrest.is_some() { Until::Turn } else { asked.until };
        let finer = Request { samples, until, ..asked };
        let trajectory = solve(found.integrator, &mut motion, &finer).ok()?.trajectory;
        Some((motion, trajectory))
    }

    /// Works need the moments between the samples.
    fn transient_course(&self, loads: &Loads, found: &Transient) -> Option<Course> {
        let samples = found.instants.len() - 1;
        let parts = 4 * FEWEST.div_ceil(4 * samples);
        let (mut motion, trajectory) = self.solved_again(loads, found, samples * parts)?;
        let mut at = |sample: &Sample, is_before: bool| {
            let state = motion.instant(sample, is_before).ok()?.state;
            let torque = motion.drive().torque(&state);
            let moments = split(loads, &state, motion.machine().bodies(state.coordinate).ok()?, torque, 1.0);
            let State { time, coordinate, speed, .. } = state;
            Some(Acting { time, coordinate, speed, moments })
        };
        let last = trajectory.samples.len() - 1;
        let nodes = trajectory.samples.iter().enumerate().map(|(index, sample)| at(sample, index == last));
        let nodes = nodes.collect::<Option<Vec<_>>>()?;
        let jumps = trajectory.events.iter().map(|event| {
            let Place { time, coordinate, speed } = event.state;
            let sample = Sample { time, coordinate, speed, acceleration: 0.0 };
            Some([at(&sample, true)?, at(&sample, false)?])
        });
        let jumps = jumps.collect::<Option<Vec<_>>>()?;
        let intervals = nodes.windows(parts + 1).step_by(parts).map(|nodes| over_time(nodes, &jumps));
        Some(Course { intervals: intervals.collect(), kinetic: found.energy.kinetic.clone() })
    }

    /// A cycle of the regime, whose state is known at every coordinate.
    fn steady_course(&self, loads: &Loads, found: &Steady) -> Option<Course> {
        let input = &self.linkage.mechanism.input;
        let step = input.sign() * input.period()? / f64::from(CYCLE_INTERVALS);
        let at = |i: u32| input.from + step * f64::from(i);
        let intervals = (0..CYCLE_INTERVALS).map(|i| self.over_coordinate(loads, found, [at(i), at(i + 1)]));
        let kinetic = (0..=CYCLE_INTERVALS).map(|i| {
            let state = found.regime.state(at(i));
            0.5 * (state.inertia + found.regime.drive_inertia) * state.speed * state.speed
        });
        Some(Course { intervals: intervals.collect::<Option<_>>()?, kinetic: kinetic.collect() })
    }

    /// The works in a regime between two coordinates, by Simpson's rule between the jumps of the loads.
    fn over_coordinate(
        &self,
        loads: &Loads,
        found: &Steady,
        [from, to]: [f64; 2],
    ) -> Option<(Works, [f64; 2])> {
        let sense = (to - from).signum();
        let mut position = self.linkage.position();
        let mut moments = |coordinate: f64, side| {
            self.linkage.solve(coordinate, Order::First, &mut position).ok()?;
            let state = State { side, ..self.state(coordinate) };
            let torque = found.regime.state(coordinate).drive;
            Some(split(loads, &state, &position.bodies, torque, sense))
        };
        let mut machine = Machine::new(&self.linkage, loads);
        let (mut works, mut changes, mut start) = ([0.0; 2], [0.0; 2], from);
        while (to - start) * sense > 0.0 {
            let State { time, speed, .. } = self.state(start);
            let piece = machine.enter(&Place { time, coordinate: start, speed }).ok()?;
            let bound = piece.coordinate[usize::from(sense > 0.0)];
            let end = if (to - bound) * sense > 0.0 && (bound - start) * sense > 0.0 { bound } else { to };
            let step = (end - start) / f64::from(IN_INTERVAL);
            let nodes = (0..=IN_INTERVAL).map(|i| {
                let side = if i == IN_INTERVAL { Side::Before } else { Side::After };
                moments(start + step * f64::from(i), side)
            });
            let nodes = nodes.collect::<Option<Vec<_>>>()?;
            for (part, (work, changed)) in works.iter_mut().zip(&mut changes).enumerate() {
                *work += simpson(step, nodes.iter().map(|moments| moments[part]));
                *changed += change(nodes.iter().map(|moments| moments[part]));
            }
            start = end;
        }
        Some((works, changes))
    }
}

/// What acts at an instant of a motion.
#[derive(Clone, Copy)]
struct Acting {
    time: f64,
    coordinate: f64,
    speed: f64,
    /// Moments that drive and that resist a motion along the growing coordinate.
    moments: [f64; 2],
}

impl Acting {
    /// The power of what drives the motion, or of what resists it.
    fn power(&self, part: usize) -> f64 {
        // A moment that drives along the growing coordinate resists a motion along the falling one.
        self.speed * self.moments[if self.speed < 0.0 { 1 - part } else { part }]
    }
}

/// The works over equally spaced instants: by Simpson's rule over time, or by trapezoids over the coordinate where the
/// moments jump.
fn over_time(nodes: &[Acting], jumps: &[[Acting; 2]]) -> (Works, [f64; 2]) {
    let mut works = [0.0; 2];
    for pair in nodes.windows(3).step_by(2) {
        let inside = |[before, _]: &&[Acting; 2]| before.time > pair[0].time && before.time <= pair[2].time;
        let mut inside = jumps.iter().filter(inside).peekable();
        if inside.peek().is_none() {
            let step = pair[1].time - pair[0].time;
            (0..2).for_each(|part| works[part] += simpson(step, pair.iter().map(|node| node.power(part))));
            continue;
        }
        let mut from = pair[0];
        for [before, after] in inside.chain([&[pair[2]; 2]]) {
            let way = before.coordinate - from.coordinate;
            for (part, work) in works.iter_mut().enumerate() {
                let acting = if way < 0.0 { 1 - part } else { part };
                *work += 0.5 * way * (from.moments[acting] + before.moments[acting]);
            }
            from = *after;
        }
    }
    (works, [0, 1].map(|part| change(nodes.iter().map(|node| node.power(part)))))
}

/// The integral over equally spaced values, an odd number of them.
fn simpson(step: f64, values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let last = values.len() - 1;
    let weight = |index: usize| match index {
        0 => 1.0,
        _ if index == last => 1.0,
        _ if index % 2 == 1 => 4.0,
        _ => 2.0,
    };
    step / 3.0 * values.enumerate().map(|(index, value)| weight(index) * value).sum::<f64>()
}

/// The sum of the sizes of all changes from value to value.
fn change(values: impl Iterator<Item = f64> + Clone) -> f64 {
    values.clone().zip(values.skip(1)).map(|(one, next)| (next - one).abs()).sum()
}

/// The moments of the drive and of each load, reduced to the input: the sum of those that drive a motion in a direction of
/// the coordinate, and of those that resist it. All weights are one load.
fn split(loads: &Loads, state: &State, bodies: &[Body<f64>], torque: f64, direction: f64) -> [f64; 2] {
    let mut moments: Vec<(Option<Cause>, f64)> = vec![(None, torque)];
    loads.by_cause(state, bodies, &mut |cause, link, wrench| {
        if matches!(cause, Cause::Inertia(_)) {
            return;
        }
        let cause = cause.of_all();
        let moment = assur_force::power(&wrench, &bodies[link]);
        match moments.iter_mut().find(|(known, _)| *known == Some(cause)) {
            Some((_, sum)) => *sum += moment,
            None => moments.push((Some(cause), moment)),
        }
    });
    let sum =
        |sense: f64| moments.iter().map(|(_, moment)| moment).filter(|moment| *moment * sense > 0.0).sum();
    [sum(direction), sum(-direction)]
}

impl Course {
    /// Driving work and resisting work up to each sample, and kinetic energy there, J. What the quadrature misses of the
    /// change of the kinetic energy belongs to either work as its rate changes.
    fn energies(&self) -> Vec<[f64; 3]> {
        let mut sums = [0.0; 2];
        let mut all: Vec<_> = self.kinetic.first().map(|kinetic| [0.0, 0.0, *kinetic]).into_iter().collect();
        for (kinetic, (works, changes)) in self.kinetic.windows(2).zip(&self.intervals) {
            let missed = kinetic[1] - kinetic[0] - works[0] - works[1];
            let both = changes[0] + changes[1];
            let share = if both > 0.0 { changes[0] / both } else { 0.5 };
            sums[0] += works[0] + share * missed;
            sums[1] += works[1] + (1.0 - share) * missed;
            all.push([sums[0], sums[1], kinetic[1]]);
        }
        all
    }
}
