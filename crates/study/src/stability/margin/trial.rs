//! The mechanism with one length changed, ready to be solved.

use assur_group::{Body, GroupError, Order};
use assur_kinematics::{Chain, Linkage, Ways};
use assur_mechanism::Mechanism;
use assur_structure::Structure;

/// In a mechanism with change points a gap below this part of its size is ignored: after a group whose assembly modes
/// meet, positions are known only to the root of their rounding.
const BLURRED: f64 = 1e-12;

/// A changed mechanism.
pub(super) struct Trial {
    chain: Chain<f64>,
    ways: Ways,
    /// Gaps up to this are ignored, m.
    closed: f64,
    /// By group: the squared determinant at the last position that was tried; infinite if the group was not reached.
    pub(super) squares: Vec<f64>,
}

impl Trial {
    /// Decomposes the changed mechanism; `None` if its lengths make no groups.
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

    /// Solves all groups at a coordinate; `None` if one of them does not assemble. `bodies` hold the starting values
    /// for kinds that iterate; `iterates` says by group which do.
    pub(super) fn place(&mut self, q: f64, iterates: &[bool], bodies: &mut [Body<f64>]) -> Option<()> {
        self.squares.fill(f64::INFINITY);
        let solved = self.chain.solve(q, self.ways.at(q), Order::Place, bodies, &mut self.squares);
        let reached = solved.as_ref().err().map_or(self.squares.len(), |error| error.group);
        for square in &mut self.squares[..reached] {
            *square *= *square;
        }
        let Err(error) = solved else { return Some(()) };
        match error.source {
            // With equal coincident links the direction is undetermined; an iteration that ends so has found nothing.
            GroupError::Singular { .. } if !iterates[error.group] => {}
            GroupError::NoAssembly { gap_m } if gap_m <= self.closed => {}
            _ => return None,
        }
        self.squares[error.group] = 0.0;
        Some(())
    }
}

/// By group: whether the change of a length affects it, in its own pairs or through the groups before.
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
