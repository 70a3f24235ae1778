//! The modes of a group: all its real assemblies in one position.

use assur_group::{AssurGroup, Body, GroupError, Mode};

use crate::samples::pose_distance;
use crate::{Linkage, Position};

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
    /// The number of a mode as the kind documents it, from 0.
    pub fn number(&self, index: usize) -> usize {
        if self.is_numbered { self.all[index].way } else { index }
    }
}

impl Modes {
    /// The mode nearest to the present one, which has the opposite sign of its determinant: the one that it meets where both end.
    pub fn rival(&self, linkage: &Linkage) -> Option<usize> {
        let present = &self.all[self.present];
        let apart = |mode: &Mode<f64>| {
            pose_distance(
                mode.bodies.iter().copied(),
                present.bodies.iter().copied(),
                linkage.structure.scale,
            )
        };
        let others = self.all.iter().enumerate().filter(|(_, mode)| mode.way != present.way);
        others.min_by(|a, b| apart(a.1).total_cmp(&apart(b.1))).map(|(index, _)| index)
    }
}

impl Linkage {
    /// The modes of a group in a solved position; `None` where its kind can't list them.
    ///
    /// # Errors
    ///
    /// Those of [`AssurGroup::modes`].
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
