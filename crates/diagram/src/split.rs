//! Reactions by cause: superposition.

use assur_force::{Cause, ForceAnalyzer, Loads, Reactions, State};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};
use serde::Serialize;

use crate::plan::length;
use crate::{DiagramError, JointForce, NamedLoad, joint_forces, named_loads};

/// The effect of one cause.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Share {
    /// `weight`, `inertia`, `all`, or the name of a load.
    pub cause: String,
    /// The reactions that it causes.
    pub reactions: Vec<JointForce>,
    /// The balancing moment (N m) or force (N) for this cause.
    pub balancing: f64,
}

/// Reactions by cause at one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Split {
    /// Under all loads at once.
    pub whole: Share,
    /// By cause: weight, inertia, then each load by its name. Causes without effect here are listed too.
    pub shares: Vec<Share>,
    /// Greatest difference of a force and the sum of its shares, relative to the greatest force of the total and all
    /// shares.
    pub residual: f64,
}

/// Loads that count as one cause: all weights, all inertia loads, or a load of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Weight,
    Inertia,
    Load(Cause),
}

impl Kind {
    fn of(cause: Cause) -> Self {
        match cause {
            Cause::Weight(_) => Self::Weight,
            Cause::Inertia(_) => Self::Inertia,
            load => Self::Load(load),
        }
    }
}

/// The reactions at a position, in total and by cause. The analyzer must give reactions.
///
/// # Errors
///
/// [`DiagramError::Force`] where the analyzer finds no reactions.
pub fn split(
    linkage: &Linkage,
    position: &Position,
    loads: &Loads,
    state: &State,
    analyzer: &dyn ForceAnalyzer,
) -> Result<Split, DiagramError> {
    let list = named_loads(loads, state, &position.bodies);
    let mut kinds: Vec<Kind> = list.iter().map(|load| Kind::of(load.cause)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let solve = |cause: String, kind: Option<Kind>| {
        let acting = list.iter().filter(|load| kind.is_none_or(|kind| kind == Kind::of(load.cause)));
        share(linkage, position, analyzer, cause, acting)
    };
    let whole = solve("all".to_owned(), None)?;
    let mut shares = Vec::new();
    for kind in kinds {
        let cause = match kind {
            Kind::Weight => "weight".to_owned(),
            Kind::Inertia => "inertia".to_owned(),
            Kind::Load(cause) => cause.name(&linkage.mechanism),
        };
        shares.push(solve(cause, Some(kind))?);
    }
    let residual = residual(&whole, &shares);
    Ok(Split { whole, shares, residual })
}

fn share<'a>(
    linkage: &Linkage,
    position: &Position,
    analyzer: &dyn ForceAnalyzer,
    cause: String,
    loads: impl Iterator<Item = &'a NamedLoad>,
) -> Result<Share, DiagramError> {
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    for load in loads {
        wrenches[load.link].add_at([0.0; 2], load.wrench.force(), load.wrench.m);
    }
    let mut out = Reactions::new(linkage);
    analyzer.solve(linkage, position, &mut wrenches, &mut out)?;
    Ok(Share { cause, reactions: joint_forces(linkage, &out), balancing: out.balancing })
}

fn residual(whole: &Share, shares: &[Share]) -> f64 {
    let forces = shares.iter().chain([whole]).flat_map(|share| &share.reactions);
    let greatest = forces.map(|reaction| length(reaction.force)).fold(0.0, f64::max);
    if greatest == 0.0 {
        return 0.0;
    }
    let open = whole.reactions.iter().enumerate().map(|(id, reaction)| {
        let left = shares.iter().fold(reaction.force, |left, share| {
            let force = share.reactions[id].force;
            [left[0] - force[0], left[1] - force[1]]
        });
        length(left)
    });
    open.fold(0.0, f64::max) / greatest
}
