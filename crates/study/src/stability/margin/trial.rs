//! The mechanism with one length changed, ready to be placed.

use assur_group::{Body, GroupError, Order};
use assur_kinematics::{Chain, Linkage, Ways};
use assur_mechanism::Mechanism;
use assur_structure::Structure;

/// In a mechanism with change points a gap less than this part of its size is none: behind a group whose ways meet,
/// places are known to the root of their rounding only.
const BLURRED: f64 = 1e-12;

/// A changed mechanism.
pub(super) struct Trial {
    chain: Chain<f64>,
    ways: Ways,
    /// Gaps up to this are none, m.
    closed: f64,
    /// By group: the squared determinant of the place that was tried last; infinite where it was not reached.
    pub(super) squares: Vec<f64>,
}

impl Trial {
    /// Takes the changed mechanism apart; `None` where its lengths make no groups.
    pub(super) fn of(linkage: &Linkage, mechanism: &Mechanism) -> Option<Self> {
        let structure = Structure::of(mechanism).ok()?;
        let chain = Chain::<f64>::compile(mechanism, &structure).ok()?;
        let (ways, closed) = if linkage.change_points().next().is_none() {
            (linkage.ways.clone(), 0.0)
        } else {
            let moved = moved(linkage, &structure);
            let ways = linkage.ways.without(mechanism.input.from, |group| moved[group]);
            (ways, BLURRED * structure.scale)
        };
        let squares = vec![0.0; chain.groups.len()];
        Some(Self { chain, ways, closed, squares })
    }

    /// Places all groups at a coordinate; `None` where one of them does not assemble. `bodies` hold the place that kinds
    /// which iterate begin with, `iterates` says by group which do.
    pub(super) fn place(&mut self, q: f64, iterates: &[bool], bodies: &mut [Body<f64>]) -> Option<()> {
        self.squares.fill(f64::INFINITY);
        let solved = self.chain.solve(q, self.ways.at(q), Order::Place, bodies, &mut self.squares);
        let reached = solved.as_ref().err().map_or(self.squares.len(), |error| error.group);
        for square in &mut self.squares[..reached] {
            *square *= *square;
        }
        let Err(error) = solved else { return Some(()) };
        match error.source {
            // Equal links upon each other may point anywhere; an iteration that ends so has found nothing.
            GroupError::Singular { .. } if !iterates[error.group] => {}
            GroupError::NoAssembly { gap_m } if gap_m <= self.closed => {}
            _ => return None,
        }
        self.squares[error.group] = 0.0;
        Some(())
    }
}

/// By group: whether the change of a length is felt by it, in its own pairs or through the groups before.
fn moved(linkage: &Linkage, changed: &Structure) -> Vec<bool> {
    let before = &linkage.structure;
    let geometry = |structure: &Structure| structure.pairs.first().map(|named| named.pair.geometry);
    let mut links = vec![false; before.links];
    links[linkage.mechanism.input.link] = geometry(before) != geometry(changed);
    let mut moved = Vec::with_capacity(before.groups.len());
    for (old, new) in before.groups.iter().zip(&changed.groups) {
        let reached = old.frame.outer.iter().any(|pair| links[pair.a] || links[pair.b]);
        let felt = reached || !old.frame.pairs().eq(new.frame.pairs());
        for &link in old.frame.links.iter().filter(|_| felt) {
            links[link] = true;
        }
        moved.push(felt);
    }
    moved
}
