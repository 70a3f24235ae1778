//! The modes of a group: all its real assemblies in one position.

use assur_group::{AssurGroup, Body, GroupError, Mode};

use crate::{Linkage, Position, track::pose_distance};

/// The modes of a group in a position, and which of them the mechanism is in.
#[derive(Debug, Clone)]
pub struct Modes {
    /// In the order that the kind documents.
    pub all: Vec<Mode<f64>>,
    /// Index of the present one.
    pub present: usize,
    /// Whether the kind numbers its ways itself; otherwise they are counted in their order.
    is_numbered: bool,
}

impl Modes {
    /// The number of a mode in the order of its kind, from 0; a reader counts from 1.
    pub fn number(&self, index: usize) -> usize {
        if self.is_numbered { self.all[index].way } else { index }
    }

    /// The mode nearest to the present one, which has the opposite sign of its determinant: the one that it meets where both end.
    pub fn rival(&self, linkage: &Linkage) -> Option<usize> {
        let present = &self.all[self.present];
        let apart = |mode: &Mode<f64>| distance(mode, present, linkage.structure.scale);
        let others = self.all.iter().enumerate().filter(|(_, mode)| mode.way != present.way);
        others.min_by(|a, b| apart(a.1).total_cmp(&apart(b.1))).map(|(index, _)| index)
    }

    /// What the present mode has become after a change of the mechanism: of all modes of one way before and after, the nearest two
    /// belong together, then the nearest of the others. `None` where what is left is farther than `limit`, rad or parts of the scale.
    pub fn present_after(&self, after: &Self, limit: f64, scale: f64) -> Option<usize> {
        let apart = |[old, new]: [usize; 2]| {
            let [one, other] = [&self.all[old], &after.all[new]];
            (one.way == other.way).then(|| distance(one, other, scale))
        };
        let pairs = (0..self.all.len()).flat_map(|old| (0..after.all.len()).map(move |new| [old, new]));
        let partners = nearest_first(pairs, apart, limit, |[a, b], [c, d]| a == c || b == d);
        partners.into_iter().find(|[old, _]| *old == self.present).map(|[_, new]| new)
    }
}

fn distance(one: &Mode<f64>, other: &Mode<f64>, scale: f64) -> f64 {
    pose_distance(one.bodies.iter().copied(), other.bodies.iter().copied(), scale)
}

impl Linkage {
    /// The modes of a group in a solved position; `None` where its kind can't list them.
    pub fn modes(&self, group: usize, position: &Position) -> Result<Option<Modes>, GroupError> {
        let kernel = self.groups()[group].as_ref();
        if !self.structure.groups[group].plugin.iterates {
            let (all, way) = (by_ways(kernel, &position.bodies), self.ways.at(position.coordinate)[group]);
            let present = all.iter().position(|mode| mode.way == usize::from(way)).unwrap_or(0);
            return Ok(Some(Modes { all, present, is_numbered: true }));
        }
        let all = kernel.modes(&position.bodies)?;
        let own = || kernel.frame().links.iter().map(|&link| position.bodies[link]);
        Ok(all.map(|all| {
            let apart =
                |mode: &Mode<f64>| pose_distance(mode.bodies.iter().copied(), own(), self.structure.scale);
            let nearest = all.iter().enumerate().min_by(|a, b| apart(a.1).total_cmp(&apart(b.1)));
            let present = nearest.map_or(0, |(index, _)| index);
            Modes { all, present, is_numbered: false }
        }))
    }
}

/// The modes of a kind that numbers its ways: those that exist.
pub(crate) fn by_ways(kernel: &dyn AssurGroup<f64>, bodies: &[Body<f64>]) -> Vec<Mode<f64>> {
    let placed = |way: usize| {
        let mut bodies = bodies.to_vec();
        let health = kernel.place(&mut bodies, way).ok()?.abs();
        let bodies = kernel.frame().links.iter().map(|&link| bodies[link]).collect();
        Some(Mode { bodies, way, health })
    };
    (0..kernel.ways()).filter_map(placed).collect()
}

/// Pairs of two that are less than a limit apart, the nearest first, none of which excludes another one.
pub(crate) fn nearest_first(
    all: impl Iterator<Item = [usize; 2]>,
    apart: impl Fn([usize; 2]) -> Option<f64>,
    limit: f64,
    excludes: impl Fn([usize; 2], [usize; 2]) -> bool,
) -> Vec<[usize; 2]> {
    let near = all.filter_map(|pair| Some((apart(pair).filter(|apart| *apart < limit)?, pair)));
    let mut near: Vec<(f64, [usize; 2])> = near.collect();
    near.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut taken: Vec<[usize; 2]> = Vec::new();
    for (_, pair) in near {
        if !taken.iter().any(|one| excludes(*one, pair)) {
            taken.push(pair);
        }
    }
    taken
}

#[cfg(test)]
mod tests;
