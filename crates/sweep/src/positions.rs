//! The positions of one point of a sweep, eight at once.

use assur_analysis::Calculation;
use assur_analysis::plan::Wanted;
use assur_analysis::results::{Column, Owner, Part, Quantity};
use assur_force::{ForceError, Joint, Kinetostatics, LaneKinetostatics, Reactions};
use assur_geometry::{courses, distances};
use assur_group::plane::{dot, vector};
use assur_group::{GroupError, Wrench};
use assur_kinematics::{LanePosition, PositionError, ScalarMotion};
use assur_mechanism::Motion;
use assur_number::{Lanes, Real};
use assur_shaking::shaking_size;
use assur_words::{Describe, Text, millimeters, number, text};

use crate::Status;
use crate::layout::Layout;
use crate::measure::Of;
use crate::measured::{Gathered, Measured, ends};
use crate::rows::Failure;

/// Most blocks of eight positions that are kept from one point to the next: some ten times what fits into a fast cache, and
/// for all threads together far less than a sweep may take.
const MOST_KEPT: usize = 64;

/// Solved positions, kept from one point to the next.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    /// Eight positions each; where there are too many to keep, one for each in turn.
    blocks: Vec<LanePosition>,
    /// Whether the blocks hold all positions of the mechanism.
    holds_all: bool,
}

impl Memory {
    /// Keeps the positions if the next mechanism has the same ones.
    pub(crate) fn keep(&mut self, same: bool) {
        self.holds_all &= same;
    }
}

/// The positions of a mechanism, whose numbers are added to what is found.
pub(crate) struct Positions<'a> {
    calculation: &'a Calculation,
    layout: &'a Layout,
    found: &'a mut Measured,
    forces: Option<LaneKinetostatics<'a>>,
    /// The first failure.
    failure: Option<(Status, Text)>,
    /// Positions with a failure.
    failed: usize,
}

impl<'a> Positions<'a> {
    pub(crate) fn new(calculation: &'a Calculation, layout: &'a Layout, found: &'a mut Measured) -> Self {
        let (linkage, carrying) = (&calculation.linkage, &calculation.plan.groups_carrying);
        let forces = match (&calculation.loads, calculation.analyzer) {
            (Some(loads), Some(analyzer)) if calculation.positions_have_forces() => {
                let forces = Kinetostatics::new(linkage, loads, analyzer.instance, carrying);
                Some(LaneKinetostatics::new(forces.without_certificates()))
            }
            _ => None,
        };
        Self { calculation, layout, found, forces, failure: None, failed: 0 }
    }

    /// Calculates every position, or takes those that `memory` holds.
    pub(crate) fn calculate(mut self, memory: &mut Memory) -> Result<(), Failure> {
        let Calculation { linkage, no_motion, .. } = self.calculation;
        let positions = linkage.mechanism.input.positions;
        let Memory { blocks, holds_all } = memory;
        let same_positions = std::mem::take(holds_all);
        self.found.clear(&self.layout.gathered, same_positions);
        if !same_positions {
            self.found.input = Some(linkage.mechanism.input.clone());
        }
        self.between(!same_positions);
        let count = positions.div_ceil(Lanes::WIDTH);
        let kept = if count <= MOST_KEPT { count } else { 1 };
        blocks.resize_with(kept, || linkage.lane_position());
        let mut all_solved = kept == count;
        for (index, position) in (0..count).map(|index| (index, index % kept)) {
            let block = Block::new(index * Lanes::WIDTH, positions);
            let mut failures = Vec::new();
            let mut solved = block;
            if !same_positions {
                failures = self.solve(&block, &mut blocks[position]);
                for (lane, ..) in &failures {
                    solved.valid[*lane] = false;
                }
                all_solved &= failures.is_empty();
                self.places(&solved, &blocks[position]);
            }
            for (lane, error) in self.forces(&solved, &blocks[position]) {
                let position = number(block.first + lane);
                let message = text!("sweep-at-position", position, problem = error.describe());
                failures.push((lane, Status::NoSolution, message));
            }
            self.note(failures);
        }
        if self.layout.asks(&[Of::Friction]) {
            self.found.friction = self.calculation.friction_cycle();
        }
        *holds_all = all_solved;
        match (self.failure, no_motion) {
            (Some((status, message)), _) => Err(Failure { status, message, failed: Some(self.failed) }),
            (None, Some(error)) => {
                Err(Failure { status: Status::NoSolution, message: error.describe(), failed: Some(0) })
            }
            (None, None) if linkage.misfits.iter().any(|misfit| !misfit.fits()) => {
                let worst = linkage.misfits.iter().map(|misfit| misfit.misfit).fold(0.0, f64::max);
                let misfit = millimeters(worst, 6);
                let message = text!("sweep-misfit", misfit);
                Err(Failure { status: Status::NoAssembly, message, failed: Some(0) })
            }
            (None, None) => Ok(()),
        }
    }

    /// Solves eight positions, or what is left of them; returns the lanes that have none.
    fn solve(&self, block: &Block, position: &mut LanePosition) -> Vec<Unsolved> {
        let Calculation { linkage, plan, .. } = self.calculation;
        let input = &linkage.mechanism.input;
        // The lanes after the last position repeat it, and are not counted.
        let at = Lanes::of(|lane| input.coordinate((block.first + lane).min(input.positions - 1)));
        let Err(errors) = linkage.solve_lanes(at, plan.order, position) else { return Vec::new() };
        let failed = errors.into_iter().filter(|(lane, _)| block.valid[*lane]);
        let failure = |(lane, error): (usize, PositionError)| {
            let assembly = matches!(error.source, GroupError::NoAssembly { .. });
            let status = if assembly { Status::NoAssembly } else { Status::NoSolution };
            (lane, status, PositionError { index: Some(block.first + lane), ..error }.describe())
        };
        failed.map(failure).collect()
    }

    /// Counts the failures of a block, and keeps the first one of all.
    fn note(&mut self, mut failures: Vec<Unsolved>) {
        failures.sort_by_key(|(lane, ..)| *lane);
        self.failed += failures.len();
        let earliest = failures.into_iter().next().map(|(_, status, message)| (status, message));
        self.failure = self.failure.take().or(earliest);
    }

    /// What is found between positions; the motion, where it is not that of the point before.
    fn between(&mut self, moved: bool) {
        let (linkage, layout) = (&self.calculation.linkage, self.layout);
        let Wanted { links, slides, points, .. } = &self.calculation.plan.wanted;
        if moved && layout.asks(&[Of::Moving, Of::Parts]) {
            let (links, slides) = (links.iter().copied(), slides.iter().copied());
            let found = courses(linkage, points.iter().map(|(point, _)| *point), slides, links);
            self.found.courses = found.unwrap_or_default();
        }
        if moved && layout.asks(&[Of::Targets]) {
            let targets = layout.targets.iter().map(|(point, _, from)| (points[*point].1, *from));
            self.found.distances = distances(linkage, targets).unwrap_or_default();
        }
        self.found.speed = match linkage.mechanism.motion {
            Some(Motion::Prescribed { speed, acceleration: 0.0 }) => Some(speed),
            _ => None,
        };
        if layout.asks(&[Of::Shaking]) {
            let state = |coordinate| self.calculation.state(coordinate);
            self.found.shaking = shaking_size(linkage, &state).ok();
        }
    }

    /// Adds what is the same under all loads.
    fn places(&mut self, block: &Block, position: &LanePosition) {
        let Calculation { linkage, plan, .. } = self.calculation;
        let (found, layout) = (&mut *self.found, self.layout);
        let (bodies, slides) = (&position.bodies, &linkage.mechanism.slides);
        let needed = || (0..plan.groups_needed.len()).filter(|group| plan.groups_needed[*group]);
        let (has_groups, mut single) = (needed().next().is_some(), None);
        let statistics = found.statistics.iter_mut().zip(&mut found.angles);
        for (of, (statistic, angle)) in layout.gathered.iter().zip(statistics) {
            let values = match of {
                Gathered::Health if has_groups => {
                    let each = needed().map(|group| position.health[group].abs());
                    each.fold(Lanes::from_f64(f64::INFINITY), lesser)
                }
                Gathered::Transmission if has_groups => Lanes::of(|lane| {
                    let single = single.get_or_insert_with(|| linkage.position());
                    position.copy_lane(lane, single);
                    let of_group = |group: usize| {
                        let found = &linkage.structure.groups[group];
                        let health = single.health[group].abs();
                        found.plugin.force_angle.transmission(&found.frame, &single.bodies, health)
                    };
                    needed().map(of_group).fold(f64::INFINITY, f64::min)
                }),
                Gathered::Column(of) => match of.owner {
                    Owner::Point(point) => {
                        let wanted = plan.wanted.points.iter().find(|(id, _)| *id == point);
                        let Some((_, place)) = wanted else { continue };
                        let [x, y] = bodies[place.link].point(vector(place.at));
                        if of.part == Part::X { x } else { y }
                    }
                    Owner::Slide(slide) => ScalarMotion::of_slide(&slides[slide], bodies).pf0,
                    Owner::Link(link) => angle.follow((linkage, link), position, block.valid),
                    _ => continue,
                },
                _ => continue,
            };
            statistic.add(block.valid, block.first, values);
        }
    }

    /// Adds reactions and balancing loads; returns the lanes that have none.
    fn forces(&mut self, block: &Block, position: &LanePosition) -> Vec<(usize, ForceError)> {
        let Some(forces) = &mut self.forces else { return Vec::new() };
        let states = position.coordinates.0.map(|coordinate| self.calculation.state(coordinate));
        let mut failures = forces.solve(&states, position).err().unwrap_or_default();
        failures.retain(|(lane, _)| block.valid[*lane]);
        let mut valid = block.valid;
        for (lane, _) in &failures {
            valid[*lane] = false;
        }
        let gathered = &self.layout.gathered;
        let (reactions, first, statistics) = (&forces.reactions, block.first, &mut self.found.statistics);
        for (of, statistic) in gathered.iter().zip(&mut *statistics) {
            // Beside passive parts what is not determined has no greatest value.
            let determined = |joint: &Joint| {
                let open = joint.open(&reactions.open).iter().fold(Lanes::ZERO, |all, open| all + *open);
                std::array::from_fn(|lane| valid[lane] && open.0[lane] == 0.0)
            };
            let (valid, values) = match of {
                Gathered::Column(of @ Column { quantity: Quantity::Balancing, .. }) => {
                    (valid, balancing(reactions, of.owner))
                }
                Gathered::BalancingSize(of) => (valid, balancing(reactions, of.owner).abs()),
                Gathered::Force(joint) => (determined(joint), greatest_square(joint, &reactions.pairs)),
                Gathered::Moment(joint) => {
                    (determined(joint), joint.moment(&reactions.pairs).unwrap_or(Lanes::ZERO).abs())
                }
                _ => continue,
            };
            statistic.add(valid, first, values);
        }
        failures.retain(|(lane, error)| {
            let change_point = matches!(error, ForceError::ChangePoint(_));
            let state = &states[*lane];
            let alone = change_point.then(|| forces.balancing_alone(*lane, state, position)).flatten();
            for (of, statistic) in gathered.iter().zip(&mut *statistics) {
                match (of, alone) {
                    (Gathered::Column(Column::BALANCING), Some(load)) => statistic.push(first + lane, load),
                    (Gathered::BalancingSize(Column::BALANCING), Some(load)) => {
                        statistic.push(first + lane, load.abs());
                    }
                    _ => {}
                }
            }
            !change_point
        });
        failures
    }
}

/// The balancing load, or over time that of a drive.
fn balancing(reactions: &Reactions<Lanes>, owner: Owner) -> Lanes {
    match owner {
        Owner::Drive(drive) => reactions.drives.get(drive).copied().unwrap_or(Lanes::from_f64(f64::NAN)),
        _ => reactions.balancing,
    }
}

/// The lane of a position that is not solved, and why.
type Unsolved = (usize, Status, Text);

/// Eight successive positions.
#[derive(Debug, Clone, Copy)]
struct Block {
    /// Number of the first one.
    first: usize,
    /// Those that have what is added.
    valid: [bool; Lanes::WIDTH],
}

impl Block {
    /// The positions from `first` on, of `count` in all.
    fn new(first: usize, count: usize) -> Self {
        Self { first, valid: std::array::from_fn(|lane| first + lane < count) }
    }
}

fn lesser(a: Lanes, b: Lanes) -> Lanes {
    Lanes::of(|lane| if b.0[lane] < a.0[lane] { b.0[lane] } else { a.0[lane] })
}

/// Square of the greatest force of a joint on one of its links, N². The forces on two links are opposite.
fn greatest_square(joint: &Joint, pairs: &[Wrench<Lanes>]) -> Lanes {
    let squares = (0..ends(joint)).map(|end| {
        let force = joint.force(end, pairs);
        dot(force, force)
    });
    squares.fold(Lanes::ZERO, |a, b| -lesser(-a, -b))
}
