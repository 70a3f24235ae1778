//! Where a guide changes the side on which it presses.

use assur_force::{ForceAnalyzer, Loads, Reactions, State};
use assur_group::plane::{dot, perp};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::PairId;
use serde::Serialize;

use crate::DiagramError;

/// A force below this part of the greatest is zero up to rounding, and has no side.
const ROUNDING: f64 = 1e-12;
/// Halvings of a step: to rounding.
const HALVINGS: usize = 60;

/// A change of sign of a guide's force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SignChange {
    /// Coordinate of the change, rad or m.
    pub coordinate: f64,
    /// Number of the position before it.
    pub after_index: usize,
    /// Force across the guide in the position before it, N, positive to the left of the guide's direction.
    pub before: f64,
    /// Force in the position after it, N.
    pub after: f64,
    /// Whether the force jumps through zero instead of passing it.
    pub jump: bool,
}

/// What finds the force of a guide at any coordinate.
#[derive(Debug, Clone, Copy)]
pub struct Solver<'a> {
    /// The compiled mechanism.
    pub linkage: &'a Linkage,
    /// Its loads.
    pub loads: &'a Loads,
    /// The method.
    pub analyzer: &'a dyn ForceAnalyzer,
    /// Up to which order the loads need transfer functions.
    pub order: Order,
    /// By group: whether it carries a load; the others are not solved.
    pub carrying: &'a [bool],
}

/// Where the force of a slide on its sliding link (L: the reaction at B) changes its sign between the positions of the scene.
///
/// `state_at` gives speed and acceleration at a coordinate ([`State::prescribed`] for a prescribed motion). Two changes between
/// neighboring positions are not seen. Over a whole cycle the step from the last position to the first is looked at too.
///
/// # Errors
///
/// [`DiagramError`] where there is no position or no reaction at a coordinate.
pub fn sign_changes(
    solver: &Solver<'_>,
    slide: usize,
    state_at: &dyn Fn(f64) -> State,
) -> Result<Vec<SignChange>, DiagramError> {
    let linkage = solver.linkage;
    let input = &linkage.mechanism.input;
    let mut pairs = linkage.structure.pairs.iter();
    let Some(pair) = pairs.position(|pair| pair.source == PairId::Slide(slide)) else {
        return Ok(Vec::new());
    };
    let mut across = Across::new(*solver, pair, slide, state_at);
    // The position after the last is the first one of the next cycle.
    let closing = usize::from(matches!(input.range, assur_mechanism::Range::Cycle(_)));
    let forces = (0..input.positions + closing).map(|index| across.at(input.coordinate(index)));
    let forces: Vec<f64> = forces.collect::<Result<_, _>>()?;
    let least = ROUNDING * forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    let mut list = Vec::new();
    let mut before = 0.0;
    for (index, after) in forces.into_iter().enumerate() {
        if after.abs() <= least {
            continue;
        }
        if before * after < 0.0 {
            let ends = [input.coordinate(index - 1), input.coordinate(index)];
            let (coordinate, left) = across.root(ends, before)?;
            // What is left on both sides of a root is rounding; at a jump it is of the size of the force.
            let jump = left > 1e-6 * before.abs().max(after.abs());
            list.push(SignChange { coordinate, after_index: index - 1, before, after, jump });
        }
        before = after;
    }
    Ok(list)
}

struct Across<'a> {
    solver: Solver<'a>,
    pair: usize,
    slide: usize,
    state_at: &'a dyn Fn(f64) -> State,
    position: assur_kinematics::Position,
    wrenches: Vec<Wrench<f64>>,
    out: Reactions,
}

impl<'a> Across<'a> {
    fn new(solver: Solver<'a>, pair: usize, slide: usize, state_at: &'a dyn Fn(f64) -> State) -> Self {
        let linkage = solver.linkage;
        let (position, out) = (linkage.position(), Reactions::new(linkage).without_idle(solver.carrying));
        let wrenches = vec![Wrench::ZERO; linkage.structure.links];
        Self { solver, pair, slide, state_at, position, wrenches, out }
    }

    /// Force to the left of the guide's direction on the sliding link, N.
    fn at(&mut self, coordinate: f64) -> Result<f64, DiagramError> {
        let state = (self.state_at)(coordinate);
        let Solver { linkage, loads, analyzer, order, .. } = self.solver;
        linkage.solve(coordinate, order, &mut self.position)?;
        let bodies = &self.position.bodies;
        loads.apply(&state, bodies, &mut self.wrenches);
        loads.inertia(&state, bodies, &mut self.wrenches);
        analyzer.solve(linkage, &self.position, &mut self.wrenches, &mut self.out)?;
        let slide = &linkage.mechanism.slides[self.slide];
        let along = bodies[slide.on].turned([slide.angle.cos(), slide.angle.sin()]);
        Ok(dot(perp(along), self.out.pairs[self.pair].force()))
    }

    /// The change between two coordinates, and the least force on its two sides.
    fn root(&mut self, [mut a, mut b]: [f64; 2], at_a: f64) -> Result<(f64, f64), DiagramError> {
        let mut sizes = [at_a.abs(), f64::INFINITY];
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(a, b);
            let force = self.at(middle)?;
            if force == 0.0 {
                return Ok((middle, 0.0));
            }
            if (force > 0.0) == (at_a > 0.0) {
                (a, sizes[0]) = (middle, force.abs());
            } else {
                (b, sizes[1]) = (middle, force.abs());
            }
        }
        Ok((f64::midpoint(a, b), sizes[0].max(sizes[1])))
    }
}
