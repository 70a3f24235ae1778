//! The positions of one point of a sweep, eight at once.

use assur_analysis::Calculation;
use assur_force::{ForceError, Joint, Kinetostatics, LaneKinetostatics, Reactions, State, applicable};
use assur_group::plane::{dot, minus, vector};
use assur_group::{Body, GroupError, Wrench};
use assur_kinematics::{LanePosition, Position, PositionError};
use assur_mechanism::{Motion, Slide};
use assur_number::{Lanes, Real};

use crate::Status;
use crate::measure::Measure;
use crate::point::Worker;
use crate::rows::Outcome;
use crate::statistics::Valid;

/// The positions of a mechanism, whose numbers are added to what is found.
pub(crate) struct Positions<'a, 'w> {
    calculation: &'a Calculation,
    worker: &'a mut Worker<'w>,
    position: LanePosition,
    /// For what is done lane by lane.
    single: Position,
    forces: Option<LaneKinetostatics<'a>>,
    /// The first failure.
    failure: Option<(Status, String)>,
    /// Positions with a failure.
    failed: usize,
}

impl<'a, 'w> Positions<'a, 'w> {
    pub(crate) fn new(calculation: &'a Calculation, worker: &'a mut Worker<'w>) -> Self {
        let (linkage, carrying) = (&calculation.linkage, &calculation.plan.groups_carrying);
        let forces = match (&calculation.loads, calculation.analyzer) {
            (Some(loads), Some(analyzer)) if has_forces(calculation) => {
                Some(LaneKinetostatics::new(Kinetostatics::new(linkage, loads, analyzer.instance, carrying)))
            }
            _ => None,
        };
        worker.angles.clear();
        worker.found.input = Some(linkage.mechanism.input.clone());
        let memory = worker.memory.take();
        let (position, single) = memory.unwrap_or_else(|| (linkage.lane_position(), linkage.position()));
        Self { calculation, worker, position, single, forces, failure: None, failed: 0 }
    }

    /// Calculates every position.
    pub(crate) fn outcome(mut self) -> Result<Outcome, Outcome> {
        let positions = self.calculation.linkage.mechanism.input.positions;
        for first in (0..positions).step_by(Lanes::WIDTH) {
            self.add(first, positions);
        }
        self.worker.memory = Some((self.position, self.single));
        match (self.failure, &self.calculation.no_motion) {
            (Some((status, message)), _) => Err(Outcome::failure(status, &message, Some(self.failed))),
            (None, Some(message)) => Err(Outcome::failure(Status::NoSolution, &message.to_string(), Some(0))),
            (None, None) => {
                Ok(Outcome { status: Status::Ok, message: String::new(), failed: Some(0), motor: None })
            }
        }
    }

    /// Adds eight positions, or what is left of them.
    fn add(&mut self, first: usize, count: usize) {
        let Calculation { linkage, plan, .. } = self.calculation;
        let input = &linkage.mechanism.input;
        // The lanes after the last position repeat it, and are not counted.
        let at = Lanes::of(|lane| input.coordinate((first + lane).min(count - 1)));
        let lanes = Block { first, valid: std::array::from_fn(|lane| first + lane < count) };
        let mut solved = lanes;
        let mut failures = Vec::new();
        if let Err(errors) = linkage.solve_lanes(at, plan.order, &mut self.position) {
            for (lane, error) in errors.into_iter().filter(|(lane, _)| lanes.valid[*lane]) {
                solved.valid[lane] = false;
                let assembly = matches!(error.source, GroupError::NoAssembly { .. });
                let status = if assembly { Status::NoAssembly } else { Status::NoSolution };
                let message = PositionError { index: Some(first + lane), ..error }.to_string();
                failures.push((lane, status, message));
            }
        }
        self.health(&solved);
        self.places(&solved);
        for (lane, error) in self.forces(&solved) {
            failures.push((lane, Status::NoSolution, format!("position {}: {error}", first + lane)));
        }
        failures.sort_by_key(|(lane, ..)| *lane);
        self.failed += failures.len();
        let earliest = failures.into_iter().next().map(|(_, status, message)| (status, message));
        self.failure = self.failure.take().or(earliest);
    }

    fn wants(&self, what: fn(&Measure) -> bool) -> bool {
        self.worker.sweep.measures.iter().any(what)
    }

    fn health(&mut self, block: &Block) {
        let Calculation { linkage, plan, .. } = self.calculation;
        let needed = || plan.groups_needed.iter().enumerate().filter(|(_, needed)| **needed);
        if needed().next().is_none() {
            return;
        }
        let healths = needed().map(|(group, _)| self.position.health[group].abs());
        let least = healths.fold(Lanes::from_f64(f64::INFINITY), lesser);
        self.worker.found.health.add(block.valid, block.numbers(), least);
        if self.wants(|measure| measure.transmission) {
            let least = Lanes::of(|lane| {
                self.position.copy_lane(lane, &mut self.single);
                let of_group = |group: usize| {
                    let found = &linkage.structure.groups[group];
                    let health = self.single.health[group].abs();
                    found.plugin.force_angle.transmission(&found.frame, &self.single.bodies, health)
                };
                needed().map(|(group, _)| of_group(group)).fold(f64::INFINITY, f64::min)
            });
            self.worker.found.transmission.add(block.valid, block.numbers(), least);
        }
    }

    fn places(&mut self, block: &Block) {
        let Calculation { linkage, plan, .. } = self.calculation;
        let angles = self.wants(|measure| measure.angles);
        let (found, layout) = (&mut self.worker.found, &self.worker.sweep.layout);
        let (bodies, numbers) = (&self.position.bodies, block.numbers());
        for ((_, place), extent) in plan.wanted.points.iter().zip(&mut found.points) {
            let at = bodies[place.link].point(vector(place.at));
            (0..2).for_each(|axis| extent[axis].add(block.valid, numbers, at[axis]));
        }
        for (slide, displacement) in layout.slides.iter().zip(&mut found.slides) {
            let along = along(&linkage.mechanism.slides[slide.id], bodies);
            displacement.add(block.valid, numbers, along);
        }
        for lane in (0..Lanes::WIDTH).filter(|&lane| angles && block.valid[lane]) {
            let pose = |body: &Body<Lanes>| [body.c, body.s, body.w1].map(|number| number.0[lane]);
            let poses = layout.links.iter().map(|link| (link.id, pose(&bodies[link.id])));
            let angles = self.worker.angles.follow(linkage, self.position.coordinates.0[lane], poses);
            for ([angle, _], extent) in angles.iter().zip(&mut found.links) {
                extent.add_one(lane, numbers.0[lane], *angle);
            }
        }
    }

    /// Adds reactions and balancing loads; returns the lanes that have none.
    fn forces(&mut self, block: &Block) -> Vec<(usize, ForceError)> {
        let Some(forces) = &mut self.forces else { return Vec::new() };
        let states = self.position.coordinates.0.map(|coordinate| self.calculation.state(coordinate));
        let mut failures = forces.solve(&states, &self.position).err().unwrap_or_default();
        failures.retain(|(lane, _)| block.valid[*lane]);
        let mut valid = block.valid;
        for (lane, _) in &failures {
            valid[*lane] = false;
        }
        let (reactions, found) = (&forces.reactions, &mut self.worker.found);
        let numbers = block.numbers();
        found.balancing.add(valid, numbers, reactions.balancing);
        found.load.add(valid, numbers, reactions.balancing.abs());
        let joints = self.worker.sweep.layout.joints.iter().map(|joint| &joint.id);
        for ((joint, force), moment) in joints.zip(&mut found.forces).zip(&mut found.moments) {
            force.add(valid, numbers, greatest_square(joint, &reactions.pairs));
            if let Some(size) = joint.moment(&reactions.pairs) {
                moment.add(valid, numbers, size.abs());
            }
        }
        failures.retain(|(lane, error)| {
            let change_point = matches!(error, ForceError::ChangePoint { .. });
            if change_point {
                self.balancing_alone(block, *lane, &states[*lane]);
            }
            !change_point
        });
        failures
    }

    /// Adds the balancing load at a change point, where the reactions are not determined but the powers of the loads are:
    /// by a method that finds it without reactions, where there is one.
    fn balancing_alone(&mut self, block: &Block, lane: usize, state: &State) {
        let Calculation { linkage, loads: Some(loads), .. } = self.calculation else { return };
        let Some(method) = applicable(linkage).into_iter().find(|plugin| !plugin.gives_reactions) else {
            return;
        };
        self.position.copy_lane(lane, &mut self.single);
        let mut wrenches = loads.total(state, &self.single.bodies);
        let mut alone = Reactions::new(linkage);
        if method.instance.solve(linkage, &self.single, &mut wrenches, &mut alone).is_ok() {
            let (found, number) = (&mut self.worker.found, block.numbers().0[lane]);
            found.balancing.add_one(lane, number, alone.balancing);
            found.load.add_one(lane, number, alone.balancing.abs());
        }
    }
}

/// Eight successive positions.
#[derive(Debug, Clone, Copy)]
struct Block {
    /// Number of the first one.
    first: usize,
    /// Those that have what is added.
    valid: Valid,
}

impl Block {
    fn numbers(&self) -> Lanes {
        Lanes::of(|lane| (self.first + lane) as f64)
    }
}

fn lesser(a: Lanes, b: Lanes) -> Lanes {
    Lanes::of(|lane| if b.0[lane] < a.0[lane] { b.0[lane] } else { a.0[lane] })
}

/// Displacement of a slide, m.
fn along(slide: &Slide, bodies: &[Body<Lanes>]) -> Lanes {
    let (slider, carrier) = (&bodies[slide.link], &bodies[slide.on]);
    let (s, c) = slide.angle.sin_cos();
    let way = minus(slider.point(vector(slide.point)), carrier.point(vector(slide.through)));
    dot(carrier.turned(vector([c, s])), way)
}

/// Square of the greatest force of a joint on one of its links, N². The forces on two links are opposite.
fn greatest_square(joint: &Joint, pairs: &[Wrench<Lanes>]) -> Lanes {
    let ends = if joint.links.len() == 2 { 0..1 } else { 0..joint.links.len() };
    let squares = ends.map(|end| {
        let force = joint.force(end, pairs);
        dot(force, force)
    });
    squares.fold(Lanes::ZERO, |a, b| -lesser(-a, -b))
}

/// Whether forces belong to the positions: not where the motion is transient, or not found.
fn has_forces(calculation: &Calculation) -> bool {
    let transient = matches!(calculation.linkage.mechanism.motion, Some(Motion::Transient { .. }));
    !transient && calculation.no_motion.is_none()
}
