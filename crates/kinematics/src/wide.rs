//! The chain in about 32 digits, for the few questions about an assembly that 16 digits can't answer.
//!
//! Near a meeting of two modes the determinant is the square root of a difference of lengths: 16 digits of the lengths
//! give only 8 digits of the determinant. These don't show whether the modes meet, pass close to each other or leave a
//! gap.

use std::{cell::OnceCell, collections::HashMap};

use assur_group::{Body, GroupError, Order};
use assur_mechanism::Mechanism;
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::{Chain, dependence::Dependence};

/// Number of states of the chain that are kept: the change points of many groups are often at one coordinate.
const MOST_STATES: usize = 64;

/// The links of a group and its determinant at one coordinate.
pub(crate) type Solved = (Vec<Body<Dd>>, Dd);

/// The mode and the starting pose of each group at a coordinate.
pub(crate) trait Assembly {
    fn way(&self, group: usize, coordinate: f64) -> u8;
    /// Sets the links of groups that iterate to their starting poses.
    fn guess(&self, coordinate: f64, bodies: &mut [Body<f64>]);
}

/// The chain in double-double, compiled when it is asked for: most assemblies are followed without it.
#[derive(Debug)]
pub(crate) struct Extended<'a> {
    mechanism: &'a Mechanism,
    structure: &'a Structure,
    chain: OnceCell<Option<Chain<Dd>>>,
}

impl<'a> Extended<'a> {
    pub(crate) fn new(mechanism: &'a Mechanism, structure: &'a Structure) -> Self {
        Self { mechanism, structure, chain: OnceCell::new() }
    }

    /// `None` where a kernel can't be built in 32 digits.
    pub(crate) fn chain(&self) -> Option<&Chain<Dd>> {
        self.chain.get_or_init(|| Chain::compile(self.mechanism, self.structure).ok()).as_ref()
    }
}

/// All links at one coordinate, and which groups are already solved there.
type State = (Vec<Body<Dd>>, Vec<bool>);

/// The chain in double-double with its most recently solved states.
#[derive(Debug)]
pub(crate) struct Wide<'a> {
    extended: &'a Extended<'a>,
    dependence: &'a Dependence,
    /// Highest order of the derivatives in the states.
    order: Order,
    states: HashMap<[u64; 2], State>,
}

impl<'a> Wide<'a> {
    pub(crate) fn new(extended: &'a Extended<'a>, dependence: &'a Dependence) -> Self {
        Self { extended, dependence, order: Order::Place, states: HashMap::new() }
    }

    /// Whether there is a chain in 32 digits; where not, meetings are not searched for.
    pub(crate) fn is_available(&self) -> bool {
        self.extended.chain().is_some()
    }

    /// Discards all states, because the modes of groups or the order have changed.
    pub(crate) fn restart(&mut self, order: Order) {
        self.order = order;
        self.states.clear();
    }

    /// Solves a group in the given mode, and the groups that determine its motion in their modes. No others are solved,
    /// so the numbers of a group don't depend on what else is needed. Only its own lack of an assembly is reported as
    /// [`GroupError::NoAssembly`]: where a group before it ends, nothing is known of it.
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
        let chain = self.extended.chain().ok_or(GroupError::Singular { health: f64::NAN })?;
        let (bodies, is_solved) = self.states.entry(key).or_insert_with(|| {
            let mut guess = vec![Body::ground(); chain.bodies().len()];
            assembly.guess(q.to_f64(), &mut guess);
            let mut bodies: Vec<_> = guess.iter().map(|body| body.map(Dd::from_f64)).collect();
            chain.set_input(q, &mut bodies);
            (bodies, vec![false; chain.groups.len()])
        });
        for ancestor in self.dependence.ancestors(group, |group| is_solved[group]) {
            let way = assembly.way(ancestor, q.to_f64());
            let solved = chain.groups[ancestor].solve(bodies, usize::from(way), self.order);
            solved.map_err(|_| GroupError::Singular { health: f64::NAN })?;
            is_solved[ancestor] = true;
        }
        let kernel = &chain.groups[group];
        let health = kernel.solve(bodies, usize::from(way), self.order)?;
        Ok((kernel.frame().links.iter().map(|link| bodies[*link]).collect(), health))
    }
}
