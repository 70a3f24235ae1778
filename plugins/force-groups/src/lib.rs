//! Group by group (S, stage 9): the groups from the last to the first, each with the loads on its own links and the
//! reactions of the groups after it; then the input link, which gives the reaction at the ground and the balancing
//! load.
//!
//! ```text
//!   loads --> group n --> ... --> group 1 --> input link --> balancing moment M, or force F along the slide
//! ```
//!
//! Where the balancing load acts elsewhere, its size follows from linearity: the drive must be idle under all loads
//! together, M(loads) + B M(unit load) = 0.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, Reactions, group_by_group};
use assur_group::{AssurGroup, Wrench};
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::Lanes;
use assur_words::text;

assur_words::resources!();

assur_force::inventory::submit! {
    AnalyzerPlugin {
        name: "groups",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("force-groups"),
        wording: text!("force-groups.wording"),
        source: text!("force-groups.source"),
        instance: &Groups,
        further: &[],
        gives_reactions: true,
        treats_friction: false,
        by_groups: true,
        rank: 0,
    }
}

/// The method.
#[derive(Debug, Clone, Copy)]
pub struct Groups;

impl ForceAnalyzer for Groups {
    #[inline]
    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let (groups, bodies) = (linkage.groups(), &position.bodies);
        let found = group_by_group(linkage, groups, bodies, loads, out, AssurGroup::reactions);
        found.map_err(|reason| reason.explain(linkage, position.coordinate))
    }

    #[inline]
    fn solve_lanes(
        &self,
        linkage: &Linkage,
        position: &LanePosition,
        loads: &mut [Wrench<Lanes>],
        out: &mut Reactions<Lanes>,
    ) -> bool {
        let (groups, bodies) = (&linkage.lane_chain.groups, &position.bodies);
        group_by_group(linkage, groups, bodies, loads, out, AssurGroup::reactions).is_ok()
    }
}

#[cfg(test)]
mod tests;
