//! The chain in about 32 digits, for the few questions about an assembly that 16 digits can't answer.
//!
//! Near a meeting of two ways the determinant is a square root of what the lengths leave: 16 digits of the lengths are 8
//! of the determinant, and whether the ways meet, pass beside each other or leave a gap is lost in them.

use std::collections::HashMap;

use assur_group::{Body, GroupError, Order};
use assur_number::{Dd, Real};

use crate::Chain;
use crate::dependence::Dependence;

/// States of the chain that are kept: the change points of many groups often lie at one coordinate.
const MOST_STATES: usize = 64;

/// The links of a group and its determinant at one coordinate.
pub(crate) type Solved = (Vec<Body<Dd>>, Dd);

/// What a solution needs to know of the groups.
pub(crate) trait Assembly {
    /// The way of a group at a coordinate.
    fn way(&self, group: usize, coordinate: f64) -> u8;
    /// Puts the links of groups that iterate where the iteration begins.
    fn guess(&self, coordinate: f64, bodies: &mut [Body<f64>]);
}

/// The chain in double-double, with the states in which it was asked for lately.
#[derive(Debug)]
pub(crate) struct Wide<'a> {
    chain: Chain<Dd>,
    dependence: &'a Dependence,
    /// Up to which order states are solved.
    order: Order,
    states: HashMap<[u64; 2], State>,
}

/// All links at one coordinate, as far as they were asked for.
#[derive(Debug)]
struct State {
    bodies: Vec<Body<Dd>>,
    is_solved: Vec<bool>,
}

impl<'a> Wide<'a> {
    pub(crate) fn new(chain: Chain<Dd>, dependence: &'a Dependence) -> Self {
        Self { chain, dependence, order: Order::Place, states: HashMap::new() }
    }

    /// Forgets all states: the ways of groups are others, or another order is wanted.
    pub(crate) fn restart(&mut self, order: Order) {
        self.order = order;
        self.states.clear();
    }

    /// Solves a group in a way, and the groups that determine its motion in theirs. No others are solved, so that the numbers
    /// of a group are the same whatever else is needed.
    pub(crate) fn solve(
        &mut self,
        q: Dd,
        (group, way): (usize, u8),
        assembly: &impl Assembly,
    ) -> Result<Solved, GroupError> {
        let key = [q.hi.to_bits(), q.lo.to_bits()];
        if self.states.len() >= MOST_STATES && !self.states.contains_key(&key) {
            self.states.clear();
        }
        let chain = &self.chain;
        let state = self.states.entry(key).or_insert_with(|| {
            let mut guess = vec![Body::ground(); chain.bodies().len()];
            assembly.guess(q.to_f64(), &mut guess);
            let mut bodies: Vec<_> = guess.iter().map(|body| body.map(Dd::from_f64)).collect();
            chain.set_input(q, &mut bodies);
            State { bodies, is_solved: vec![false; chain.groups.len()] }
        });
        for ancestor in self.dependence.ancestors(group, |group| state.is_solved[group]) {
            let way = assembly.way(ancestor, q.to_f64());
            chain.groups[ancestor].solve(&mut state.bodies, usize::from(way), self.order)?;
            state.is_solved[ancestor] = true;
        }
        let kernel = &chain.groups[group];
        let health = kernel.solve(&mut state.bodies, usize::from(way), self.order)?;
        Ok((kernel.frame().links.iter().map(|link| state.bodies[*link]).collect(), health))
    }
}
