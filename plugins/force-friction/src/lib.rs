//! Group by group with dry friction: what `force-groups` does, where friction is added to the loads of the links.
//!
//! Friction depends on magnitudes of reactions. In each block (a group, or several that the owner of a joint's journal couples) the
//! reactions are linear in the magnitudes, so that these fulfill z = |a + W z| ([`assur_friction`]); a and W are what the kernel of
//! the group answers to the loads and to the friction of one magnitude after the other. Where the certificate proves one solution
//! it is found by the iteration and Newton's method; elsewhere all solutions are found, and each leads on to the groups before.
//!
//! ```text
//!   loads --> last block: a, W --> z --> reactions, friction --> ... --> input link --> balancing load
//! ```
//!
//! Where the balancing load acts elsewhere, the whole mechanism is one block, with the drive idle. In a motion whose acceleration is
//! looked for it is one block too, with the acceleration in place of the balancing load: the drive is known, and the equation of
//! the input link gives the acceleration linearly in the magnitudes, through the inertia loads.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod branches;
mod chain;
mod motion;
mod quick;

use assur_force::{
    Accelerations, AnalyzerPlugin, Doubt, Followed, ForceAnalyzer, ForceError, FreeMotion, FrictionAnalysis,
    FrictionIteration, FrictionSolution, Reactions, group_by_group,
};
use assur_group::{AssurGroup, Wrench};
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::{Lanes, elementary};
use assur_words::text;

use branches::Branch;
use chain::Chain;
use quick::Quick;

assur_words::resources!();

assur_force::inventory::submit! {
    AnalyzerPlugin {
        name: "coulomb",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("force-friction"),
        wording: text!("force-friction.wording"),
        source: text!("force-friction.source"),
        instance: &Friction,
        further: &[],
        gives_reactions: true,
        treats_friction: true,
        by_groups: true,
        rank: 1,
    }
}

/// Evaluations of a motion between two searches for other solutions: as many as a step of an integrator takes, which lie side by side.
const FOLLOWED: usize = 12;

/// The method.
#[derive(Debug, Clone, Copy)]
pub struct Friction;

impl ForceAnalyzer for Friction {
    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let (groups, bodies) = (linkage.groups(), &position.bodies[..]);
        if let Some(friction) = &mut out.friction {
            friction.doubts.clear();
            friction.loads.clear();
            friction.loads.extend_from_slice(loads);
            if (Quick { linkage, groups, bodies }.solve(loads, out)).is_some() {
                return Ok(());
            }
            let given = out.friction.as_ref().map(|friction| &friction.loads[..]);
            loads.copy_from_slice(given.unwrap_or_default());
        }
        let Some(chain) = Chain::of(linkage, position, out) else {
            let found = group_by_group(linkage, groups, bodies, loads, out, AssurGroup::reactions);
            return found.map_err(|reason| reason.explain(linkage, position.coordinate));
        };
        let found = chain.solutions(loads, 1.0)?;
        let Some(taken) = branches::taken(&chain, loads, &found) else {
            let what =
                found.jammed.map_or_else(|| text!("force-friction-balance"), |block| chain.name(block));
            return Err(ForceError::Jammed { what, coordinate: position.coordinate, proved: found.proved });
        };
        let doubt = (found.branches.len() > 1 || !found.proved || found.continuum).then(|| {
            let each = found.branches.iter().enumerate();
            let mut solutions: Vec<_> = each.map(|(i, branch)| chain.told(branch, i == taken)).collect();
            solutions.sort_by(|a, b| a.balancing.total_cmp(&b.balancing));
            (0, Doubt { solutions, proved: found.proved, continuum: found.continuum })
        });
        let told = chain.told(&found.branches[taken], true);
        (out.balancing, out.pairs) = (told.balancing, told.pairs);
        if let Some(friction) = &mut out.friction {
            friction.forces = told.forces;
            friction.certificates = found.certificates;
            friction.doubts = doubt.into_iter().collect();
        }
        Ok(())
    }

    fn solve_lanes(
        &self,
        linkage: &Linkage,
        position: &LanePosition,
        loads: &mut [Wrench<Lanes>],
        out: &mut Reactions<Lanes>,
    ) -> bool {
        let (groups, bodies) = (&linkage.lane_chain.groups, &position.bodies[..]);
        if out.friction.is_some() {
            return Quick { linkage, groups, bodies }.solve(loads, out).is_some();
        }
        group_by_group(linkage, groups, bodies, loads, out, AssurGroup::reactions).is_ok()
    }

    fn accelerations(
        &self,
        linkage: &Linkage,
        position: &Position,
        motion: &FreeMotion<'_>,
        out: &mut Reactions,
    ) -> Option<Result<Accelerations, ForceError>> {
        let (groups, bodies) = (linkage.groups(), &position.bodies[..]);
        if let Some(only) = (Quick { linkage, groups, bodies }).accelerated(motion, out) {
            return Some(Ok(Accelerations { solutions: vec![only], proved: true }));
        }
        let Followed { moduli, left } = &out.friction.as_ref()?.followed;
        let chain = Chain::of(linkage, position, out)?.moved_by(motion);
        let near = if *left > 0 { chain.near(motion.loads, 1.0, moduli) } else { None };
        let (branches, proved, left) = match near {
            Some(only) => (vec![only], false, left - 1),
            None => match chain.solutions(motion.loads, 1.0) {
                Ok(found) => (found.branches, found.proved, FOLLOWED),
                Err(error) => return Some(Err(error)),
            },
        };
        let solutions = branches.iter().map(|branch| chain.told(branch, false)).collect();
        let followed = match &branches[..] {
            [only] => Followed { moduli: only.moduli.clone(), left },
            _ => Followed::default(),
        };
        if let Some(friction) = &mut out.friction {
            friction.followed = followed;
        }
        Some(Ok(Accelerations { solutions, proved }))
    }

    fn friction<'a>(
        &self,
        linkage: &'a Linkage,
        position: &'a Position,
        out: &'a Reactions,
    ) -> Option<Box<dyn FrictionAnalysis + 'a>> {
        Some(Box::new(Chain::of(linkage, position, out)?))
    }
}

impl FrictionAnalysis for Chain<'_> {
    fn jamming_limit(&self, loads: &[Wrench<f64>]) -> f64 {
        branches::limit(self, loads)
    }

    fn iteration(&self, loads: &[Wrench<f64>]) -> Vec<FrictionIteration> {
        self.iterations(loads).unwrap_or_default()
    }
}

impl Chain<'_> {
    /// A solution as it is reported: reactions with friction.
    fn told(&self, branch: &Branch, taken: bool) -> FrictionSolution {
        let (mut pairs, mut forces) = (branch.pairs.clone(), vec![0.0; self.frictions.bearings.len()]);
        for unknown in &self.frictions.unknowns {
            let bearing = &self.frictions.bearings[unknown.bearing];
            let [x, y] = unknown.vector(bearing, &self.position.bodies, &branch.pairs);
            let size = if unknown.is_modulus() { elementary::hypot(x, y) } else { x };
            let factor = self.factor(unknown, 1.0) * size;
            let (share, moment) = (factor * unknown.share(bearing), factor * unknown.moment(bearing));
            forces[unknown.bearing] += share;
            for &(pair, sign) in &bearing.path {
                pairs[pair].m += sign * moment;
                if bearing.slides() {
                    let along = bearing.along(&self.position.bodies);
                    pairs[pair].fx += sign * share * along[0];
                    pairs[pair].fy += sign * share * along[1];
                }
            }
        }
        FrictionSolution { balancing: branch.balancing, pairs, forces, taken }
    }
}
