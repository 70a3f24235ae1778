//! Follows the assembly from the first position: finds where two modes meet and where the mechanism can no longer be
//! assembled.

use std::f64::consts::TAU;

use assur_group::GroupError;
use assur_mechanism::{CoordinateKind, Driver, Input, Mechanism};
use assur_number::Lanes;
use assur_structure::Structure;

use crate::branch::{Branch, Passage};
use crate::first::{First, first_ways};
use crate::poses::{Guesses, iterated};
use crate::ways::{Transition, Ways};
use crate::wide::{Extended, Wide};
use crate::{
    AssemblyRange, Chain, ChainError, dependence::Dependence, enclosures::turns_regularly,
    follower::Follower, interpolants::Interpolants,
};

/// Samples over one turn, or over the length of the range of a sliding input.
const SAMPLES: usize = 720;

/// If the first position is itself singular, its assembly is chosen at this displacement from it, in units of the
/// coordinate.
const BESIDE: f64 = 1e-4;

/// Over time the samples are at most those of so many turns.
const MOST_TURNS_IN_TIME: f64 = 64.0;

/// Longest motion that is followed until the modes repeat, in turns.
const MOST_TURNS: usize = 4;

/// The result of following the assembly.
#[derive(Debug)]
pub(crate) struct Followed {
    pub(crate) ways: Ways,
    /// `None`: not even the first position can be assembled.
    pub(crate) range: Option<AssemblyRange>,
    /// Why the first position can't be assembled, if so.
    pub(crate) first_failure: Option<ChainError>,
    /// What ends the range, below and above.
    pub(crate) ends: [Option<ChainError>; 2],
    pub(crate) interpolants: Interpolants,
    /// Starting poses for the groups that iterate.
    pub(crate) guesses: Option<Guesses>,
}

impl Followed {
    /// Without an event: these modes hold wherever the mechanism can be assembled.
    fn constant(ways: Ways, range: Option<AssemblyRange>, first_failure: Option<ChainError>) -> Self {
        let interpolants = Interpolants::default();
        Self { ways, range, first_failure, ends: [None; 2], interpolants, guesses: None }
    }
}

/// The chains of a mechanism, for one position and for eight.
pub(crate) type Chains<'a> = (&'a Chain<f64>, &'a Chain<Lanes>);

/// Chooses the assembly of the first position and follows it.
pub(crate) fn follow(mechanism: &Mechanism, structure: &Structure, chains: Chains<'_>) -> Followed {
    let (chain, from) = (chains.0, mechanism.input.from);
    let extended = Extended::new(mechanism, structure);
    let begin = |q: f64| first_ways(mechanism, structure, (chain, &extended), q);
    let found = match begin(from) {
        // Coincident equal links may point in any direction; their assembly is chosen a small distance past the
        // position.
        Err((
            _,
            ChainError { source: GroupError::Singular { .. } | GroupError::SingularStart { .. }, .. },
        )) => begin(from + BESIDE * coordinate_unit(mechanism, structure)),
        found => found,
    };
    match found {
        Err((ways, failure)) => {
            Followed::constant(Ways::new(from, None, ways, Vec::new()), None, Some(failure))
        }
        Ok((first, _)) if turns_regularly(mechanism, structure, &chain.needed, &first) => {
            let range = AssemblyRange { low: from, high: from + TAU, full: true };
            Followed::constant(Ways::new(from, Some(TAU), first, Vec::new()), Some(range), None)
        }
        Ok(start) => by_samples(mechanism, structure, chains, (&extended, start)),
    }
}

/// Follows the assembly of the first position from sample to sample.
pub(crate) fn by_samples(
    mechanism: &Mechanism,
    structure: &Structure,
    (chain, lane_chain): Chains<'_>,
    (extended, start): (&Extended<'_>, First),
) -> Followed {
    let unit = coordinate_unit(mechanism, structure);
    let dependence = Dependence::of(structure);
    let wide = Wide::new(extended, &dependence);
    let iterated = iterated(structure);
    let follower = Follower { chain, lane_chain, structure, dependence: &dependence, wide, iterated, unit };
    let mut path = Path { follower, from: mechanism.input.from, start };
    let found = match mechanism.input.kind() {
        CoordinateKind::Angle => path.turn(),
        CoordinateKind::Length => path.stroke(mechanism, structure.scale),
        CoordinateKind::Time => path.time(mechanism, unit),
    };
    let assembled = (&found.ways, found.guesses.as_ref());
    Followed { interpolants: Interpolants::of(structure, unit, &mut path.follower.wide, assembled), ..found }
}

/// Follows the branches that start at the first position.
struct Path<'a> {
    follower: Follower<'a>,
    from: f64,
    start: First,
}

impl Path<'_> {
    /// A pinned input: a full turn if possible, otherwise both directions up to the ends of the range.
    fn turn(&mut self) -> Followed {
        let mut turns = 1;
        loop {
            let (length, samples) = (TAU * turns as f64, SAMPLES * turns);
            let mut branch = self.branch(length, samples);
            if branch.failure.is_some() {
                let back = self.branch(-length, samples);
                return self.joined(&branch, &back, Some(TAU));
            }
            self.follower.close(&mut branch);
            // After an odd number of meetings in one turn the mechanism is in the other assembly, so its true cycle
            // is longer.
            let first = &self.start.0;
            if branch.last() == *first || turns == MOST_TURNS {
                let range = AssemblyRange { low: self.from, high: self.from + TAU, full: true };
                let transitions = transitions(&branch, true);
                let ways = Ways::new(self.from, Some(length), first.clone(), transitions);
                let poses = self.follower.iterated.iter().map(|link| (link, branch.poses[*link].iter()));
                let grid = (self.from, branch.step(), true);
                let guesses = Guesses::new(grid, self.follower.structure.scale, poses);
                return Followed { guesses, ..Followed::constant(ways, Some(range), None) };
            }
            turns *= 2;
        }
    }

    /// A sliding input: the range of the scene, extended on both sides to find where the mechanism can no longer be
    /// assembled.
    fn stroke(&mut self, mechanism: &Mechanism, scale: f64) -> Followed {
        let last = mechanism.input.coordinate(mechanism.input.positions.saturating_sub(1));
        let length = 4.0 * scale.max((last - self.from).abs());
        let (forth, back) = (self.branch(length, 4 * SAMPLES), self.branch(-length, 4 * SAMPLES));
        self.joined(&forth, &back, None)
    }

    /// Over time: from the first position to the last.
    fn time(&mut self, mechanism: &Mechanism, unit: f64) -> Followed {
        let [first, last] = mechanism.input.ends();
        let length = if last > first { last - first } else { unit };
        // As many samples as over the turns of a crank that moves as much.
        let turns = (length / unit / TAU).clamp(1.0, MOST_TURNS_IN_TIME);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few turns")]
        let forth = self.branch(length, SAMPLES * turns.ceil() as usize);
        let back = self.branch(-length / SAMPLES as f64, 1);
        self.joined(&forth, &back, None)
    }

    fn branch(&mut self, length: f64, steps: usize) -> Branch {
        let (first, start) = &self.start;
        let branch = Branch::new(self.from, (length, steps), first, (start, &self.follower.iterated));
        self.follower.follow(branch, length < 0.0)
    }

    /// Joins two branches from one start into one interval, which repeats after `period` if it is shorter.
    fn joined(&self, forth: &Branch, back: &Branch, period: Option<f64>) -> Followed {
        let mut all = transitions(back, false);
        all.extend(transitions(forth, true));
        let range =
            AssemblyRange { low: self.from + back.reached, high: self.from + forth.reached, full: false };
        let before = back.samples.saturating_sub(1);
        let poses = self.follower.iterated.iter().map(|link| {
            let [back, forth] = [back, forth].map(|branch| &branch.poses[*link]);
            // A group may have been followed beyond where a later one ends the branch.
            (link, back.iter().skip(1).take(before).rev().chain(forth.iter()))
        });
        let grid = (self.from - before as f64 * forth.step(), forth.step(), false);
        let guesses = Guesses::new(grid, self.follower.structure.scale, poses);
        let period = period.filter(|period| range.high - range.low < *period);
        let ways = Ways::new(range.low, period, back.last(), all);
        let ends = [back.failure, forth.failure];
        Followed { ends, guesses, ..Followed::constant(ways, Some(range), None) }
    }
}

/// The transitions of a branch in increasing order of the coordinate.
fn transitions(branch: &Branch, forth: bool) -> Vec<Transition> {
    let one = |group: usize, passage: &Passage| Transition {
        coordinate: branch.coordinate(passage.distance),
        group,
        ways: if forth { [passage.before, passage.after] } else { [passage.after, passage.before] },
        is_change_point: passage.is_change_point,
    };
    let passages = branch.passages.iter().enumerate();
    let mut all: Vec<_> =
        passages.flat_map(|(group, all)| all.iter().map(move |passage| one(group, passage))).collect();
    all.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
    all
}

/// Unit of the coordinate for steps and tolerances: 1 rad, the typical length of the mechanism in m, or the time in which a drive moves
/// by that.
pub(crate) fn coordinate_unit(mechanism: &Mechanism, structure: &Structure) -> f64 {
    match mechanism.input.kind() {
        CoordinateKind::Angle => 1.0,
        CoordinateKind::Length => structure.scale,
        CoordinateKind::Time => time_unit(&mechanism.input, structure.scale),
    }
}

/// The time in which the fastest drive moves by 1 rad or by the typical length of the mechanism on the average; at most the whole time
/// of the motion, s.
fn time_unit(input: &Input, scale: f64) -> f64 {
    let [first, last] = input.ends();
    let whole = if last > first { last - first } else { 1.0 };
    let at = |sample: usize| first + whole * sample as f64 / SAMPLES as f64;
    let travel = |driver: &Driver| {
        let unit = if driver.is_angle() { 1.0 } else { scale };
        let place = |sample: usize| driver.law.as_ref().map_or(0.0, |law| law.at(at(sample))[0]);
        (1..=SAMPLES).map(|sample| (place(sample) - place(sample - 1)).abs() / unit).sum::<f64>()
    };
    let most = input.drivers.iter().map(travel).fold(0.0, f64::max);
    if most > 1.0 { whole / most } else { whole }
}
