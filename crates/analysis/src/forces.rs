//! Loads, reactions and the balancing load of one position.

use std::sync::Arc;

use crate::plan::Wanted;
use crate::results::{Named, PairReaction};
use assur_force::{AnalyzerPlugin, ForceError, JointReaction, Loads, Reactions, State, joint_reactions};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::PairId;

use crate::names::Names;

/// A force below this part of the greatest of the position has no line of action worth telling.
const LEAST_FORCE: f64 = 1e-9;

/// Scratch of the force analysis.
#[derive(Debug)]
pub(crate) struct Forces<'a> {
    linkage: &'a Linkage,
    loads: &'a Loads,
    analyzer: &'static AnalyzerPlugin,
    wrenches: Vec<Wrench<f64>>,
    reactions: Reactions,
}

impl<'a> Forces<'a> {
    /// For the groups that the plan says to carry a load.
    pub(crate) fn new(
        linkage: &'a Linkage,
        loads: &'a Loads,
        analyzer: &'static AnalyzerPlugin,
        carrying: &[bool],
    ) -> Self {
        let wrenches = vec![Wrench::ZERO; linkage.structure.links];
        let reactions = Reactions::new(linkage).without_idle(carrying);
        Self { linkage, loads, analyzer, wrenches, reactions }
    }

    /// Reactions (where the method gives them) and balancing load of a solved position.
    pub(crate) fn solve(
        &mut self,
        state: &State,
        position: &Position,
        wanted: &Wanted,
        names: &Names,
    ) -> Result<(Option<Named<PairReaction>>, f64), ForceError> {
        self.loads.apply(state, &position.bodies, &mut self.wrenches);
        self.loads.inertia(state, &position.bodies, &mut self.wrenches);
        self.analyzer.instance.solve(self.linkage, position, &mut self.wrenches, &mut self.reactions)?;
        let named = self.analyzer.gives_reactions.then(|| self.named(position, wanted, names));
        Ok((named, self.reactions.balancing))
    }

    fn named(&self, position: &Position, wanted: &Wanted, names: &Names) -> Named<PairReaction> {
        let joints = joint_reactions(self.linkage, &self.reactions);
        let each = joints.iter().flat_map(|joint| &joint.forces);
        let greatest = each.map(|(_, force)| force[0].hypot(force[1])).fold(0.0, f64::max);
        let told = joints.iter().filter(|joint| wanted.reactions.contains(&joint.joint));
        told.map(|joint| {
            let forces = joint.forces.iter().map(|(link, force)| (Arc::clone(&names.links[*link]), *force));
            let reaction = PairReaction {
                forces: forces.collect(),
                moment: joint.moment,
                offset: self.offset(joint, position, LEAST_FORCE * greatest),
            };
            (names.pair(joint.joint), reaction)
        })
        .collect()
    }

    /// Where along the guide the force alone would do the same: moment = offset times the force along the normal.
    fn offset(&self, joint: &JointReaction, position: &Position, least: f64) -> Option<f64> {
        let (PairId::Slide(id), Some(moment), Some((_, force))) =
            (joint.joint, joint.moment, joint.forces.first())
        else {
            return None;
        };
        let slide = &self.linkage.mechanism.slides[id];
        let (s, c) = slide.angle.sin_cos();
        let along = position.bodies[slide.on].turned([c, s]);
        let normal = along[0] * force[1] - along[1] * force[0];
        (normal.abs() > least).then(|| moment / normal)
    }
}
