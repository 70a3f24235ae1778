//! Newton-Euler: equilibrium of every moving link at once, one linear system for the whole mechanism.
//!
//! Three equations for each link. The unknowns are: for each pin, two force components for every link in it but the
//! first; for each slide, a force and a moment; and the balancing load. The system is assembled from points and slides
//! of the mechanism and from the poses of its links alone, without its groups, so it is a check on every method that
//! uses them.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod friction;
mod least_norm;
mod system;

use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, Reactions, joints};
use assur_group::{Order, Pair, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::PairId;
use assur_words::{Text, text};

use friction::{Equilibrium, Frictional};
use system::{Solution, System};

assur_words::resources!();

assur_force::inventory::submit! {
    AnalyzerPlugin {
        name: "newton-euler",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("force-newton-euler"),
        wording: text!("force-newton-euler.wording"),
        source: text!("force-newton-euler.source"),
        instance: &NewtonEuler,
        further: &[],
        gives_reactions: true,
        treats_friction: true,
        by_groups: false,
        rank: 1,
    }
}

/// The method. It allocates memory: it is meant for checks, and for mechanisms that no other method can treat.
#[derive(Debug, Clone, Copy)]
pub struct NewtonEuler;

impl ForceAnalyzer for NewtonEuler {
    fn supports(&self, linkage: &Linkage) -> Result<(), Text> {
        let system = System::of(&linkage.mechanism, linkage.structure.scale);
        let (equations, unknowns) = system.size();
        let passive = !linkage.structure.passive.is_empty();
        if equations == unknowns || passive && equations < unknowns {
            return if passive { determined_friction(linkage, &system) } else { Ok(()) };
        }
        Err(text!("force-newton-euler-unbalanced", equations, unknowns))
    }

    fn treats_passive(&self) -> bool {
        true
    }

    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let system = System::of(&linkage.mechanism, linkage.structure.scale);
        let coordinate = position.coordinate;
        let singular = |health| ForceError::Singular { coordinate, health };
        let put = |solution: &Solution, out: &mut Reactions| {
            out.balancing = solution.balancing;
            out.open.clone_from(&solution.open);
            to_pairs(linkage, &system, solution, &mut out.pairs);
        };
        let Some(mut friction) = out.friction.take() else {
            let solution = system.solve(&position.bodies, loads, &[]).map_err(singular)?;
            if solution.health < NEAR_CHANGE_POINT && linkage.is_at_change_point(position) {
                return Err(singular(solution.health));
            }
            put(&solution, out);
            return Ok(());
        };
        let frictional =
            Frictional { system: &system, mechanism: &linkage.mechanism, bodies: &position.bodies };
        let found = frictional.solve(loads, &mut friction, put, out);
        out.friction = Some(friction);
        match found.map_err(singular)? {
            Equilibrium::Found => Ok(()),
            Equilibrium::None { proved } => {
                Err(ForceError::Jammed { what: text!("force-newton-euler-all"), coordinate, proved })
            }
        }
    }
}

/// At a change point places of 16 digits leave rounding of this size in a system that is singular there.
const NEAR_CHANGE_POINT: f64 = 1e-7;

/// Whether the reaction of each pair with friction is determined beside the passive parts.
fn determined_friction(linkage: &Linkage, system: &System<'_>) -> Result<(), Text> {
    let mechanism = &linkage.mechanism;
    let mut position = linkage.position();
    if mechanism.frictions.is_empty() || linkage.solve_index(0, Order::First, &mut position).is_err() {
        return Ok(());
    }
    let loads = vec![Wrench::ZERO; mechanism.links.len()];
    let Ok(found) = system.solve(&position.bodies, &loads, &[]) else { return Ok(()) };
    for joint in joints(mechanism, &linkage.structure) {
        let is_open = joint.open(&found.open).iter().any(|open| *open > 0.0);
        if is_open && mechanism.frictions.iter().any(|friction| friction.pair == joint.id) {
            return Err(text!("force-newton-euler-open-friction", pair = &mechanism.named_pair(joint.id)));
        }
    }
    Ok(())
}

/// Converts the forces on the links of each pin to the forces in pairs.
///
/// The pairs of a pin make a tree; what a pair carries is the force on its body `a` and on all bodies on that side of it.
fn to_pairs(linkage: &Linkage, system: &System<'_>, solution: &Solution, pairs: &mut [Wrench<f64>]) {
    let named = &linkage.structure.pairs;
    let mut of_pin: Vec<Vec<&Pair>> = vec![Vec::new(); linkage.mechanism.points.len()];
    for one in named {
        if let PairId::Pin(point) = one.source {
            of_pin[point].push(&one.pair);
        }
    }
    for (one, wrench) in named.iter().zip(pairs) {
        *wrench = match one.source {
            PairId::Slide(slide) => solution.slides[slide],
            PairId::Pin(point) => {
                let forces = beyond(&one.pair, &of_pin[point]).into_iter();
                let forces = forces.map(|link| system.force_on(solution, point, link));
                let [fx, fy] = forces.fold([0.0; 2], |sum, force| [sum[0] + force[0], sum[1] + force[1]]);
                Wrench { fx, fy, m: 0.0 }
            }
        };
    }
}

/// The bodies that a pair joins to its body `b`: `a`, and those that other pairs of the pin join to it.
fn beyond(pair: &Pair, of_pin: &[&Pair]) -> Vec<usize> {
    let mut found = vec![pair.a];
    let mut next = 0;
    while let Some(body) = found.get(next).copied() {
        let others = of_pin.iter().filter(|other| other.id != pair.id && other.joins(body));
        let others: Vec<usize> =
            others.map(|other| if other.a == body { other.b } else { other.a }).collect();
        found.extend(others.into_iter().filter(|other| !found.contains(other)).collect::<Vec<_>>());
        next += 1;
    }
    found
}

#[cfg(test)]
mod tests;
