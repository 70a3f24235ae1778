//! Where the force of a guide changes its side.

use assur_force::{ForceAnalyzer, LoadState, Loads, Reactions};
use assur_group::plane::{dot, perp};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::PairId;
use assur_number::ROUNDING;
use assur_number::search::{try_bisect, try_least};
use serde::Serialize;

use crate::DiagramError;

/// The most positions that are examined for changes; of more positions only so many are taken.
const MOST_POSITIONS: usize = 3600;
/// Least number of coordinates over the range of the input at which the forces are computed, even with fewer positions
/// in the scene.
const SAMPLES: f64 = 180.0;
/// Distance on both sides of a jump of a load at which the forces are computed, as part of the range of the input.
const BESIDE: f64 = 1e-9;
/// Golden-section steps in the search for the least force between three samples: to 1e-8 of their distance.
const SECTIONS: usize = 40;

/// A change of sign of a guide's force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SignChange {
    /// Coordinate of the change, rad or m.
    pub coordinate: f64,
    /// Number of the position before it.
    pub after_index: usize,
    /// Force across the guide in the position before it, N, positive to the left of the guide's direction; if it is
    /// zero there, in the last earlier position where it is not.
    pub before: f64,
    /// Force in the position after it, N; if it is zero there, in the next position where it is not.
    pub after: f64,
    /// Whether the force jumps through zero instead of passing it.
    pub jump: bool,
}

/// Finds the force of a guide at any coordinate.
#[derive(Debug, Clone, Copy)]
pub struct Solver<'a> {
    /// The compiled mechanism.
    pub linkage: &'a Linkage,
    /// Its loads.
    pub loads: &'a Loads,
    /// The method.
    pub analyzer: &'a dyn ForceAnalyzer,
    /// Highest order of transfer functions that the loads need.
    pub order: Order,
    /// By group: whether it carries a load; the others are not solved.
    pub carrying: &'a [bool],
}

/// Where the force of each slide on its sliding link (L: the reaction at B) changes its sign, by slide.
///
/// `state_at` gives speed and acceleration at a coordinate ([`LoadState::prescribed`] for a prescribed motion). Between the
/// positions of the scene the forces are computed in steps of 1/180 of the range at most, on both sides of each jump of
/// a load, and at each minimum that may reach zero, so the changes do not depend on the number of positions. Over a
/// whole cycle this includes the step from the last position to the first.
///
/// # Errors
///
/// [`DiagramError`] where there is no position or no reaction at a coordinate.
pub fn sign_changes(
    solver: &Solver<'_>,
    slides: &[usize],
    state_at: &dyn Fn(f64) -> LoadState,
) -> Result<Vec<Vec<SignChange>>, DiagramError> {
    let input = &solver.linkage.mechanism.input;
    // The position after the last is the first one of the next cycle.
    let closing = usize::from(input.is_cycle());
    let last = input.positions + closing - 1;
    // Of very many positions every so many are enough to find the changes.
    let stride = last.div_ceil(MOST_POSITIONS).max(1);
    let numbers: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
    let positions: Vec<f64> = numbers.iter().map(|index| input.coordinate(*index)).collect();
    let samples = samples(solver.loads, &positions, state_at);
    let mut across = Across::new(*solver, slides, state_at);
    let forces: Vec<Vec<f64>> =
        samples.iter().map(|sample| across.all(sample.coordinate)).collect::<Result<_, _>>()?;
    let of = |nth: usize| {
        let forces = samples.iter().zip(&forces).map(|(sample, all)| (*sample, all[nth]));
        changes(&positions, &forces.collect::<Vec<_>>(), &mut |coordinate| Ok(across.all(coordinate)?[nth]))
    };
    let mut found: Vec<Vec<SignChange>> = (0..slides.len()).map(of).collect::<Result<_, _>>()?;
    if stride > 1 {
        let step = positions[1] - positions[0];
        let mut force = |coordinate: f64, nth: usize| Ok::<_, DiagramError>(across.all(coordinate)?[nth]);
        for (nth, changes) in found.iter_mut().enumerate() {
            for change in changes {
                // The positions beside the change, instead of the examined ones.
                let passed = |index: &usize| (input.coordinate(*index) - change.coordinate) * step <= 0.0;
                let first = numbers[change.after_index];
                let before =
                    (first..numbers[change.after_index + 1]).take_while(passed).last().unwrap_or(first);
                change.after_index = before;
                change.before = force(input.coordinate(before), nth)?;
                change.after = force(input.coordinate(before + 1), nth)?;
            }
        }
    }
    Ok(found)
}

/// A coordinate at which the forces are computed.
#[derive(Debug, Clone, Copy)]
struct Sample {
    coordinate: f64,
    /// Number of the position at it or before it.
    after_index: usize,
    is_position: bool,
}

/// The coordinates at which the forces are computed: those of the positions, and samples between them.
fn samples(loads: &Loads, positions: &[f64], state_at: &dyn Fn(f64) -> LoadState) -> Vec<Sample> {
    let range = positions.last().map_or(0.0, |last| last - positions[0]);
    let mut all = Vec::new();
    for (index, &start) in positions.iter().enumerate() {
        all.push(Sample { coordinate: start, after_index: index, is_position: true });
        let Some(&end) = positions.get(index + 1) else { break };
        let step = end - start;
        let mut between: Vec<f64> = jumps(loads, [start, end], BESIDE * range, state_at);
        let parts = (SAMPLES * (step / range).abs()).ceil().max(1.0);
        between.extend((1..).map(f64::from).take_while(|i| *i < parts).map(|i| start + step * (i / parts)));
        between.sort_by(|a, b| (a * step).total_cmp(&(b * step)));
        let sample = |coordinate| Sample { coordinate, after_index: index, is_position: false };
        all.extend(between.into_iter().map(sample));
    }
    all
}

/// Coordinates beside the ends of the smooth pieces of the loads between two positions.
fn jumps(loads: &Loads, [start, end]: [f64; 2], beside: f64, state: &dyn Fn(f64) -> LoadState) -> Vec<f64> {
    let (mut found, mut at, mut phase) = (Vec::new(), start, loads.phase());
    let inside = |x: f64| x > start.min(end) && x < start.max(end);
    loop {
        let piece = loads.enter(&state(at), &mut phase);
        let next = piece.coordinate[usize::from(end > start)];
        if !inside(next) || !inside(next + beside) {
            return found;
        }
        found.extend([next - beside, next + beside].into_iter().filter(|x| inside(*x)));
        at = next + beside;
    }
}

/// The force of one slide at a coordinate.
type Force<'a> = dyn FnMut(f64) -> Result<f64, DiagramError> + 'a;

/// The changes of one force, whose values at all samples are known.
fn changes(
    positions: &[f64],
    samples: &[(Sample, f64)],
    force: &mut Force<'_>,
) -> Result<Vec<SignChange>, DiagramError> {
    let least = ROUNDING * samples.iter().fold(0.0, |most: f64, (_, force)| most.max(force.abs()));
    let nonzero = |(_, force): &(Sample, f64)| force.abs() > least;
    let mut list = Vec::new();
    let mut before: Option<f64> = None;
    for (k, (sample, after)) in samples.iter().enumerate().filter(|(_, sample)| nonzero(sample)) {
        let previous = k.checked_sub(1).map(|k| samples[k]);
        if let (Some(before), Some((previous, _))) = (before.filter(|before| before * after < 0.0), previous)
        {
            list.push((previous.after_index, [previous.coordinate, sample.coordinate], before));
        } else if let (Some(previous), Some(next)) = (previous, samples.get(k + 1)) {
            let three =
                [previous, (*sample, *after), *next].map(|(sample, force)| [sample.coordinate, force]);
            if let Some(dip) = dip(three, force)?.filter(|(_, size)| *size < -least) {
                list.push((previous.0.after_index, [three[0][0], dip.0], *after));
                list.push((sample.after_index, [dip.0, three[2][0]], -*after));
            }
        }
        before = Some(*after);
    }
    // The forces in the positions around a step; those that are zero have no side.
    let known = |index: usize| {
        let upto = samples.partition_point(|(sample, _)| sample.after_index <= index);
        let in_position = |found: &&(Sample, f64)| found.0.is_position && nonzero(found);
        let size = |found: Option<&(Sample, f64)>| found.map_or(0.0, |found| found.1);
        let before = samples[..upto].iter().rev().find(in_position);
        [size(before), size(samples[upto..].iter().find(in_position))]
    };
    let mut found = Vec::with_capacity(list.len());
    for (after_index, bracket, value) in &list {
        let [before, after] = known(*after_index);
        let alone = list.iter().filter(|other| other.0 == *after_index).count() == 1;
        // A single change is looked for between the positions themselves.
        let ends = [positions[*after_index], positions[*after_index + 1]];
        let (bracket, value) =
            if alone && before * after < 0.0 { (ends, before) } else { (*bracket, *value) };
        let (coordinate, left) = root(bracket, value, force)?;
        // Near a root, the remaining forces on both sides are rounding; at a jump they are of the size of the force.
        let jump = left > 1e-6 * before.abs().max(after.abs());
        found.push(SignChange { coordinate, after_index: *after_index, before, after, jump });
    }
    Ok(found)
}

/// Where the force is least between three samples (coordinate, force) of one sign, and its size there, negative on the other
/// side; `None` where the middle one is not the least of them, or a parabola through them stays far from zero.
fn dip(three: [[f64; 2]; 3], force: &mut Force<'_>) -> Result<Option<(f64, f64)>, DiagramError> {
    let sign = three[1][1].signum();
    let [[q0, f0], [q1, f1], [q2, f2]] = three.map(|[q, force]| [q, sign * force]);
    if f0 <= f1 || f2 < f1 {
        return Ok(None);
    }
    let slopes = [(f1 - f0) / (q1 - q0), (f2 - f1) / (q2 - q1)];
    let curvature = (slopes[1] - slopes[0]) / (q2 - q0);
    let slope = slopes[0] + curvature * (q1 - q0);
    if f1 - slope * slope / (4.0 * curvature) > 0.5 * f1 {
        return Ok(None);
    }
    try_least(q0.min(q2), q0.max(q2), SECTIONS, |q| Ok(sign * force(q)?)).map(Some)
}

/// The change between two coordinates, and the greatest force next to it.
fn root([a, b]: [f64; 2], at_a: f64, force: &mut Force<'_>) -> Result<(f64, f64), DiagramError> {
    let width = 0.5 * f64::EPSILON * a.abs().max(b.abs());
    let [a, b] = try_bisect(a, b, width, |q| Ok::<_, DiagramError>((force(q)? > 0.0) == (at_a > 0.0)))?;
    Ok((f64::midpoint(a, b), force(a)?.abs().max(force(b)?.abs())))
}

/// The forces of slides across their guides, at any coordinate.
struct Across<'a> {
    solver: Solver<'a>,
    /// Slides with their pairs.
    slides: Vec<(usize, usize)>,
    state_at: &'a dyn Fn(f64) -> LoadState,
    position: assur_kinematics::Position,
    wrenches: Vec<Wrench<f64>>,
    out: Reactions,
}

impl<'a> Across<'a> {
    fn new(solver: Solver<'a>, slides: &[usize], state_at: &'a dyn Fn(f64) -> LoadState) -> Self {
        let linkage = solver.linkage;
        let (position, out) = (linkage.position(), Reactions::new(linkage).without_idle(solver.carrying));
        let wrenches = vec![Wrench::ZERO; linkage.structure.links];
        let pair_of =
            |slide| linkage.structure.pairs.iter().position(|pair| pair.source == PairId::Slide(slide));
        let slides = slides.iter().filter_map(|&slide| Some((slide, pair_of(slide)?))).collect();
        Self { solver, slides, state_at, position, wrenches, out }
    }

    /// Forces to the left of the directions of the guides on the sliding links, N.
    fn all(&mut self, coordinate: f64) -> Result<Vec<f64>, DiagramError> {
        let state = (self.state_at)(coordinate);
        let Solver { linkage, loads, analyzer, order, .. } = self.solver;
        linkage.solve(coordinate, order, &mut self.position)?;
        let bodies = &self.position.bodies;
        loads.evaluate(&state, bodies, &mut self.wrenches);
        analyzer.solve(linkage, &self.position, &mut self.wrenches, &mut self.out)?;
        let force = |&(slide, pair): &(usize, usize)| {
            let slide = &linkage.mechanism.slides[slide];
            let along = bodies[slide.on].turned([slide.angle.cos(), slide.angle.sin()]);
            dot(perp(along), self.out.pairs[pair].force())
        };
        Ok(self.slides.iter().map(force).collect())
    }
}
