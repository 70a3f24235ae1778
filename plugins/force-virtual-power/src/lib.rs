//! Virtual power, or Zhukovsky's lever: the balancing load alone, from the powers of all loads.
//!
//! ```text
//!   sum(F v cos(F, v)) + sum(M w) + Mb = 0     for dq = 1: v = PF1 of the point, w = PF1 of the link
//! ```
//!
//! As a lever: turn the velocity plan by a right angle (here clockwise) and apply every force at the image of its
//! point. The moment of a force about the pole is then its power, and the balancing force holds the plan, as a lever,
//! in equilibrium. Reactions do no work, so they do not enter, and the method does not find them.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod lever;

use assur_force::{
    Acting, AnalyzerPlugin, Construction, ForceAnalyzer, ForceError, Reactions, UnitBalance, power,
};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};
use assur_words::text;

assur_words::resources!();

assur_force::inventory::submit! {
    AnalyzerPlugin {
        name: "virtual-power",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("force-virtual-power"),
        wording: text!("force-virtual-power.wording"),
        source: text!("force-virtual-power.source"),
        instance: &VirtualPower,
        further: &[],
        gives_reactions: false,
        treats_friction: false,
        by_groups: false,
        rank: 4,
    }
}

/// The method.
#[derive(Debug, Clone, Copy)]
pub struct VirtualPower;

/// Moment (N m) or force (N) that the balancing load must have.
fn balancing(
    linkage: &Linkage,
    position: &Position,
    loads: &[Wrench<f64>],
    unit: Option<UnitBalance>,
) -> Result<f64, ForceError> {
    let bodies = &position.bodies;
    let drive = -bodies.iter().zip(loads).skip(1).map(|(body, load)| power(load, body)).sum::<f64>();
    let size = unit.map_or(Ok(drive), |unit| unit.size(drive, -unit.power(bodies), linkage));
    size.map_err(|idle| idle.explain(linkage, position.coordinate))
}

impl ForceAnalyzer for VirtualPower {
    fn treats_time(&self) -> bool {
        false
    }

    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let none = Wrench { fx: f64::NAN, fy: f64::NAN, m: f64::NAN };
        out.pairs.fill(none);
        out.balancing = balancing(linkage, position, loads, out.unit)?;
        Ok(())
    }

    fn construction(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &[Acting],
    ) -> Result<Option<Construction>, ForceError> {
        let wrenches = Acting::total(loads, linkage.structure.links);
        let balancing = balancing(linkage, position, &wrenches, UnitBalance::of(&linkage.mechanism))?;
        Ok(Some(lever::draw(linkage, position, loads, balancing)))
    }
}

#[cfg(test)]
mod tests;
