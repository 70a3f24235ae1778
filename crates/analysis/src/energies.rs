//! Energies over a motion: works of the driving and of the resisting loads and of each load by itself, and the kinetic energy of
//! all links and of each (E eqs. 1-3).

use std::sync::Arc;

use assur_dynamics::{Instant, Machine, Steady, Transient, equation, request};
use assur_force::{Kinetostatics, LoadState, Loads, Side, tolerance};
use assur_group::plane::dot;
use assur_group::{Body, Order};
use assur_integrator::{EquationOfMotion as _, Request, Sample, State, Trajectory, Until, solve};
use assur_kinematics::Position;
use assur_mechanism::{GROUND, LinkId, Mechanism};
use assur_number::quadrature::simpson;

use crate::acting::{Acting, SUMS, Works, add, change, over, over_time, shares};
use crate::results::{Column, Owner, Quantity, Schema, Table};
use crate::{Calculation, InputMotion, motion::CYCLE_INTERVALS};

/// Fewest intervals of the quadrature over a transient motion, without and with dry friction, which jumps where a pair turns and
/// bends where another face is pressed.
const FEWEST: [usize; 2] = [500, 20_000];
/// Intervals of the quadrature over each smooth part of an interval of a cycle.
const IN_INTERVAL: u32 = 4;
/// Where there is dry friction, the ends of a smooth part are taken this far inside it, in intervals.
const INSIDE: f64 = 1e-6;

/// Energies over a motion.
struct EnergyCourse {
    /// Between each sample and the next one: the works, and how much their rates change.
    intervals: Vec<[Works; 2]>,
    /// Kinetic energy at each sample, of flywheel and rotor as well, J.
    kinetic: Vec<f64>,
    /// What acts at each sample.
    acting: Vec<Acting>,
    /// Kinetic energy of each link at each sample, J.
    links: Vec<Vec<f64>>,
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
        let mechanism = &self.linkage.mechanism;
        let mut schema = Schema::new(mechanism);
        let section = schema.section();
        let all = [Quantity::DrivingWork, Quantity::ResistingWork, Quantity::KineticEnergy];
        let has_friction = !mechanism.frictions.is_empty();
        let all = all.into_iter().chain(has_friction.then_some(Quantity::FrictionWork));
        schema.add(section, all.map(|quantity| Column::of(quantity, Owner::Input)));
        let by_load = by_load(mechanism, schema.loads.len());
        schema.add(section, by_load.iter().map(|(owner, _)| Column::of(Quantity::Work, *owner)));
        let links = mechanism.heavy_links().map(Owner::Link);
        schema.add(section, links.map(|link| Column::of(Quantity::KineticEnergy, link)));
        schema.add(section, by_load.iter().map(|(owner, _)| Column::of(Quantity::ReducedLoad, *owner)));
        let mut table = Table::new(Arc::new(schema));
        let samples =
            course.works().into_iter().zip(&course.kinetic).zip(course.acting.iter().zip(&course.links));
        for (number, ((works, kinetic), (acting, links))) in samples.enumerate() {
            let [driving, resisting, friction] = [works[0], works[1], works[2]];
            let moments = by_load.iter().map(|(_, place)| acting.each[*place]);
            let works = by_load.iter().map(|(_, place)| works[SUMS + *place]);
            let row: Vec<f64> = [driving, resisting, *kinetic]
                .into_iter()
                .chain(has_friction.then_some(friction))
                .chain(works)
                .chain(links.iter().copied())
                .chain(moments)
                .collect();
            let finite = row.iter().all(|energy| energy.is_finite());
            table.push(number, row.into_iter().map(|energy| finite.then_some(energy)));
        }
        table
    }

    /// A transient motion solved once more, with another number of samples, with or without their accelerations.
    pub(crate) fn solved_again<'a>(
        &'a self,
        loads: &'a Loads,
        found: &Transient,
        samples: usize,
        accelerations: bool,
    ) -> Option<(Machine<'a>, Trajectory)> {
        let mut motion = equation(&self.linkage, loads).ok()?;
        let asked = request(&self.linkage.mechanism, &mut motion).ok()?;
        let until = if found.unrest.is_some() { Until::Turn } else { asked.until };
        let finer = Request { samples, until, accelerations, ..asked };
        let trajectory = solve(found.integrator, &mut motion, &finer).ok()?.trajectory;
        Some((motion, trajectory))
    }

    /// Works need the moments between the samples.
    fn transient_course(&self, loads: &Loads, found: &Transient) -> Option<EnergyCourse> {
        let samples = found.instants.len() - 1;
        let mechanism = &self.linkage.mechanism;
        let fewest = FEWEST[usize::from(!mechanism.frictions.is_empty())];
        let parts = 4 * fewest.div_ceil(4 * samples);
        let (mut motion, trajectory) = self.solved_again(loads, found, samples * parts, false)?;
        let mut at = |sample: &Sample, is_before: bool| {
            let Instant { state, friction, .. } = motion.instant(sample, is_before).ok()?;
            let torque = motion.drive.torque(&state);
            let bodies = motion.bodies(state.coordinate).ok()?;
            let links = energies_of_links(mechanism, &state, bodies);
            Some((Acting::of(loads, mechanism, &state, bodies, [torque, friction]), links))
        };
        let last = trajectory.samples.len() - 1;
        let nodes = trajectory.samples.iter().enumerate().map(|(index, sample)| at(sample, index == last));
        let (nodes, links): (Vec<Acting>, Vec<Vec<f64>>) =
            nodes.collect::<Option<Vec<_>>>()?.into_iter().unzip();
        let jumps = trajectory.events.iter().map(|event| {
            let State { time, coordinate, speed } = event.state;
            let sample = |acceleration| Sample { time, coordinate, speed, acceleration };
            // From which side it came to a speed at which loads jump, as to rest where it turns back.
            let earlier = trajectory.samples.partition_point(|sample| sample.time < time);
            let change = trajectory.samples[..earlier].last().map_or(0.0, |before| speed - before.speed);
            Some([at(&sample(change), true)?.0, at(&sample(0.0), false)?.0])
        });
        let jumps = jumps.collect::<Option<Vec<_>>>()?;
        let intervals = nodes.windows(parts + 1).step_by(parts).map(|nodes| over_time(nodes, &jumps));
        let intervals = intervals.collect();
        let acting = nodes.iter().step_by(parts).cloned().collect();
        let links = links.into_iter().step_by(parts).collect();
        Some(EnergyCourse { intervals, kinetic: found.energy.kinetic.clone(), acting, links })
    }

    /// A cycle of the regime, whose state is known at every coordinate.
    fn steady_course(&self, loads: &Loads, found: &Steady) -> Option<EnergyCourse> {
        let input = &self.linkage.mechanism.input;
        let step = input.sign() * input.period()? / f64::from(CYCLE_INTERVALS);
        let at = |i: u32| input.from + step * f64::from(i);
        let intervals = (0..CYCLE_INTERVALS).map(|i| self.over_coordinate(loads, found, [at(i), at(i + 1)]));
        let kinetic = (0..=CYCLE_INTERVALS).map(|i| {
            let state = found.regime.state(at(i));
            0.5 * (state.inertia + found.regime.drive_inertia) * state.speed * state.speed
        });
        let (intervals, kinetic) = (intervals.collect::<Option<_>>()?, kinetic.collect());
        let mut position = self.linkage.position();
        let mechanism = &self.linkage.mechanism;
        let mut frictional = self.friction_of_motion(loads);
        let samples = (0..=CYCLE_INTERVALS).map(|i| {
            self.linkage.solve(at(i), order(frictional.is_some()), &mut position).ok()?;
            let state = LoadState { side: Side::After, ..self.state(at(i)) };
            let moments = self.moments_in(found, &state, &position, &mut frictional)?;
            let links = energies_of_links(mechanism, &state, &position.bodies);
            Some((Acting::of(loads, mechanism, &state, &position.bodies, moments), links))
        });
        let (acting, links) = samples.collect::<Option<Vec<_>>>()?.into_iter().unzip();
        Some(EnergyCourse { intervals, kinetic, acting, links })
    }

    /// The force analysis of the dry friction in a regime; `None` where all pairs are ideal.
    fn friction_of_motion<'a>(&'a self, loads: &'a Loads) -> Option<Kinetostatics<'a>> {
        loads.frictions()?;
        let method =
            assur_force::choose(None, true, !self.linkage.structure.passive.is_empty()).ok()?.instance;
        let forces = Kinetostatics::new(&self.linkage, loads, method, &self.plan.groups_carrying);
        Some(forces.without_certificates())
    }

    /// Moments of the drive and of the dry friction of all pairs on the input in a regime.
    fn moments_in(
        &self,
        found: &Steady,
        state: &LoadState,
        position: &Position,
        frictional: &mut Option<Kinetostatics<'_>>,
    ) -> Option<[f64; 2]> {
        let torque = found.regime.state(state.coordinate).drive;
        let Some(frictional) = frictional else { return Some([torque, 0.0]) };
        let period = self.linkage.mechanism.input.period();
        let behind = state.coordinate - state.speed.signum() * 2.0 * tolerance(state.coordinate, period);
        let acceleration = match state.side {
            Side::Before => self.state(behind).acceleration,
            _ => state.acceleration,
        };
        frictional.solve(&LoadState { acceleration, ..*state }, position).ok()?;
        let friction = frictional.reactions.friction.as_ref()?;
        let powers = friction.frictions.powers(&friction.forces, &position.bodies);
        Some([torque, powers.map(|(_, power)| power).sum()])
    }

    /// The works in a regime between two coordinates, by Simpson's rule between the jumps of the loads.
    fn over_coordinate(&self, loads: &Loads, found: &Steady, [from, to]: [f64; 2]) -> Option<[Works; 2]> {
        let sense = (to - from).signum();
        let mut position = self.linkage.position();
        let mut friction = self.friction_of_motion(loads);
        let has_friction = friction.is_some();
        let mut moments = |coordinate: f64, side| {
            self.linkage.solve(coordinate, order(has_friction), &mut position).ok()?;
            let state = LoadState { side, ..self.state(coordinate) };
            let given = self.moments_in(found, &state, &position, &mut friction)?;
            let acting = Acting::of(loads, &self.linkage.mechanism, &state, &position.bodies, given);
            Some(acting.moments(sense))
        };
        let mut machine = Machine::new(&self.linkage, loads);
        let none = vec![0.0; SUMS + Acting::LOADS + self.linkage.mechanism.loads.len()];
        let (mut works, mut changes, mut start) = (none.clone(), none, from);
        while (to - start) * sense > 0.0 {
            let LoadState { time, speed, .. } = self.state(start);
            let piece = machine.enter(&State { time, coordinate: start, speed }).ok()?;
            let bound = piece.coordinate[usize::from(sense > 0.0)];
            let end = if (to - bound) * sense > 0.0 && (bound - start) * sense > 0.0 { bound } else { to };
            let step = (end - start) / f64::from(IN_INTERVAL);
            let nodes = (0..=IN_INTERVAL).map(|i| {
                let (side, inward) = match i {
                    IN_INTERVAL => (Side::Before, -INSIDE),
                    0 => (Side::After, INSIDE),
                    _ => (Side::After, 0.0),
                };
                // A load against the motion vanishes where the motion rests, and so would the friction that it causes.
                let inward = if has_friction { inward } else { 0.0 };
                moments(start + step * (f64::from(i) + inward), side)
            });
            let nodes = nodes.collect::<Option<Vec<_>>>()?;
            add(&mut works, &over(&nodes, |values| simpson(step, values)));
            add(&mut changes, &over(&nodes, change));
            start = end;
        }
        Some([works, changes])
    }
}

/// The order of the transfer functions that works need: friction depends on inertia loads.
fn order(has_friction: bool) -> Order {
    if has_friction { Order::Second } else { Order::First }
}

/// The drive, the weights and the loads of the scene that have a work, each with its place among what acts.
pub(crate) fn by_load(mechanism: &Mechanism, loads: usize) -> Vec<(Owner, usize)> {
    let drive = mechanism.drive.is_some().then_some((Owner::Input, Acting::DRIVE));
    let weights = mechanism.gravity.is_some() && mechanism.links.iter().skip(1).any(|link| link.mass > 0.0);
    // The ground carries the weights.
    let weights = weights.then_some((Owner::Link(GROUND), Acting::WEIGHTS));
    let loads = (0..loads).map(|load| (Owner::Load(load), Acting::LOADS + load));
    drive.into_iter().chain(weights).chain(loads).collect()
}

/// Kinetic energies of the links (E eq. 3), J.
fn energies_of_links(mechanism: &Mechanism, state: &LoadState, bodies: &[Body<f64>]) -> Vec<f64> {
    let of = |link: LinkId| {
        let (found, body) = (&mechanism.links[link], &bodies[link]);
        let velocity = body.first(body.arm(found.center)).map(|v| v * state.speed);
        let (turning, [inertia, _]) = (body.w1 * state.speed, found.inertia.at(state.coordinate));
        0.5 * (found.mass * dot(velocity, velocity) + inertia * turning * turning)
    };
    mechanism.heavy_links().map(of).collect()
}

impl EnergyCourse {
    /// The works up to each sample, J. The defect of the quadrature (change of the kinetic energy minus the sum of the works) is
    /// distributed over the works in proportion to the variation of their integrands.
    fn works(&self) -> Vec<Works> {
        let mut sum = vec![0.0; SUMS + self.acting.first().map_or(0, |acting| acting.each.len())];
        let mut all = vec![sum.clone()];
        for (kinetic, [works, changes]) in self.kinetic.windows(2).zip(&self.intervals) {
            let missed = works[..SUMS].iter().fold(kinetic[1] - kinetic[0], |left, work| left - work);
            add(&mut sum, works);
            add(&mut sum, &shares(changes, missed));
            all.push(sum.clone());
        }
        all
    }
}
