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

use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, Reactions, UnitBalance, group_by_group};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};

assur_force::inventory::submit! {
    AnalyzerPlugin {
        name: "groups",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "group by group from the last to the input link: every reaction and the balancing load",
        source: "S stage 9: kinetostatics of Assur groups",
        instance: &Groups,
        gives_reactions: true,
        by_groups: true,
        rank: 0,
    }
}

/// The method.
#[derive(Debug, Clone, Copy)]
pub struct Groups;

impl ForceAnalyzer for Groups {
    fn supports(&self, _linkage: &Linkage) -> Result<(), String> {
        Ok(())
    }

    #[inline]
    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let drive = pass(linkage, position, &out.solved, loads, &mut out.pairs)?;
        match UnitBalance::of(&linkage.mechanism, &position.bodies) {
            None => out.balancing = drive,
            Some(unit) => balance(linkage, position, &unit, drive, out)?,
        }
        Ok(())
    }
}

/// All reactions under these loads, and the moment or force of the drive. A group without load passes none on.
#[inline]
fn pass(
    linkage: &Linkage,
    position: &Position,
    solved: &[bool],
    loads: &mut [Wrench<f64>],
    pairs: &mut [Wrench<f64>],
) -> Result<f64, ForceError> {
    let bodies = &position.bodies;
    group_by_group(linkage, linkage.groups(), bodies, loads, pairs, |index, group, loads, pairs| {
        if !solved[index] {
            return Ok(());
        }
        group.reactions(bodies, loads, pairs).map_err(|source| {
            let group = linkage.structure.group_name(&linkage.mechanism, index);
            ForceError::Group { group, coordinate: position.coordinate, source }
        })
    })
}

/// Adds the reactions of the balancing load that makes the drive idle.
#[cold]
fn balance(
    linkage: &Linkage,
    position: &Position,
    unit: &UnitBalance,
    drive: f64,
    out: &mut Reactions,
) -> Result<(), ForceError> {
    out.scratch_bodies.fill(Wrench::ZERO);
    out.scratch_bodies[unit.link] = unit.wrench;
    let unit_drive = pass(linkage, position, &out.solved, &mut out.scratch_bodies, &mut out.scratch_pairs)?;
    let size = unit.size(drive, unit_drive, linkage, position)?;
    for (sum, unit) in out.pairs.iter_mut().zip(&out.scratch_pairs) {
        sum.fx += size * unit.fx;
        sum.fy += size * unit.fy;
        sum.m += size * unit.m;
    }
    out.balancing = size;
    Ok(())
}

#[cfg(test)]
mod tests;
