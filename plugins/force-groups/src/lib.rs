//! Group by group (S, stage 9): the groups from the last to the first, each with the loads on its own links and what the
//! groups after it hand on; then the input link, which gives the reaction at the ground and the balancing load.
//!
//! ```text
//!   loads --> group n --> ... --> group 1 --> input link --> balancing moment M, or force F along the slide
//! ```
//!
//! Where the balancing load acts elsewhere, its size follows from linearity: the drive must be idle under all loads
//! together, M(loads) + B M(unit load) = 0.

use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, Reactions, UnitBalance};
use assur_group::{Body, Pair, PairGeometry, Wrench};
use assur_kinematics::{Linkage, Position};

assur_force::inventory::submit! {
    AnalyzerPlugin {
        name: "groups",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "group by group from the last to the input link: every reaction and the balancing load",
        source: "S stage 9: kinetostatics of Assur groups",
        instance: &Groups,
        gives_reactions: true,
    }
}

/// The method.
#[derive(Debug, Clone, Copy)]
pub struct Groups;

impl ForceAnalyzer for Groups {
    fn supports(&self, _linkage: &Linkage) -> Result<(), String> {
        Ok(())
    }

    fn by_groups(&self) -> bool {
        true
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

/// All reactions under these loads, and the moment or force of the drive. A group that carries no load hands none on.
#[inline]
fn pass(
    linkage: &Linkage,
    position: &Position,
    solved: &[bool],
    loads: &mut [Wrench<f64>],
    pairs: &mut [Wrench<f64>],
) -> Result<f64, ForceError> {
    for (index, group) in linkage.groups().iter().enumerate().rev() {
        if !solved[index] {
            continue;
        }
        if let Err(source) = group.reactions(&position.bodies, loads, pairs) {
            let group = linkage.structure.group_name(&linkage.mechanism, index);
            return Err(ForceError::Group { group, coordinate: position.coordinate, source });
        }
    }
    let input = linkage.mechanism.input.link;
    let (reaction, drive) = input_link(&linkage.structure.pairs[0].pair, input, &position.bodies, loads);
    pairs[0] = reaction;
    Ok(drive)
}

/// Equilibrium of the input link: the reaction on body `a` of its pair with the ground, and the drive.
#[inline]
fn input_link(pair: &Pair, input: usize, bodies: &[Body<f64>], loads: &[Wrench<f64>]) -> (Wrench<f64>, f64) {
    let (body, load) = (&bodies[input], &loads[input]);
    match pair.geometry {
        PairGeometry::Pin { at_a, .. } => {
            let reaction = Wrench { fx: -load.fx, fy: -load.fy, m: 0.0 };
            (reaction, -load.about(body.arm(at_a)))
        }
        PairGeometry::Slide { point, .. } => {
            // The coordinate is the way along the guide, so that PF1 of the origin is the guide's direction.
            let (c, s) = (body.x1, body.y1);
            let [x, y] = bodies[pair.a].point(point);
            // The drive takes the component along the guide, the guide the one across.
            let across = c * load.fy - s * load.fx;
            let sign = if pair.a == input { 1.0 } else { -1.0 };
            let (fx, fy) = (sign * across * s, -sign * across * c);
            let m = -sign * load.about([x - body.x, y - body.y]);
            (Wrench { fx, fy, m }, -(load.fx * c + load.fy * s))
        }
    }
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
