//! All plans of one position.

use assur_force::{
    Acting, AnalyzerPlugin, Cause, Construction, ForceAnalyzer, Kinetostatics, LoadState, Loads, Reactions,
    analyzers, joints, solve_by,
};
use assur_geometry::{Center, instant_centers};
use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{LinkId, Named, PairId};
use assur_words::{Text, text};
use serde::Serialize;

use crate::plan::length;
use crate::{DiagramError, VectorPlan, acceleration_plan, construction_plans, force_polygons, velocity_plan};

/// All plans of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanSheet {
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Velocities.
    pub velocities: VectorPlan,
    /// Accelerations.
    pub accelerations: VectorPlan,
    /// Instant centers.
    pub centers: Vec<Center>,
    /// Force polygons, from the last group to the input link; empty without loads.
    pub polygons: Vec<VectorPlan>,
    /// Constructions of the registered analyzers that have one and support the mechanism.
    pub constructions: Vec<VectorPlan>,
    /// Reactions by cause; `None` without loads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub by_cause: Option<Split>,
}

/// All plans at the coordinate of a state. `moves`: plans of velocities with the speed of the state, else per unit speed.
///
/// The analyzer must give reactions. A construction that fails at this position (the published form of longitudinal
/// reactions, where its pole is at infinity) is left out.
///
/// # Errors
///
/// [`DiagramError`] where there is no position, no reaction, or a load without a value.
pub fn sheet(
    linkage: &Linkage,
    loads: &Loads,
    state: &LoadState,
    moves: bool,
    analyzer: &AnalyzerPlugin,
) -> Result<PlanSheet, DiagramError> {
    let mut position = linkage.position();
    linkage.solve(state.coordinate, Order::Second, &mut position)?;
    loads.finite(&linkage.mechanism, state, &position.bodies)?;
    let list = loads.acting(state, &position.bodies);
    let (mut polygons, mut constructions, mut by_cause) = (Vec::new(), Vec::new(), None);
    if !list.is_empty() {
        let drawn = self::constructions(linkage, &position, &list)?;
        constructions = drawn.iter().flat_map(|(_, drawn)| construction_plans(drawn)).collect();
        let out = reactions(linkage, &position, loads, state, analyzer.instance)?;
        polygons = force_polygons(linkage, &position, &list, &out);
        by_cause = Some(split(linkage, &position, loads, state, analyzer.instance)?);
    }
    let motion = moves.then_some(state);
    Ok(PlanSheet {
        coordinate: state.coordinate,
        velocities: velocity_plan(linkage, &position, motion),
        accelerations: acceleration_plan(linkage, &position, motion),
        centers: instant_centers(linkage, &position),
        polygons,
        constructions,
        by_cause,
    })
}

/// The reactions at a position, with the dry friction of the pairs.
fn reactions(
    linkage: &Linkage,
    position: &Position,
    loads: &Loads,
    state: &LoadState,
    analyzer: &dyn ForceAnalyzer,
) -> Result<Reactions, DiagramError> {
    if loads.frictions().is_some() {
        let carrying = vec![true; linkage.groups().len()];
        let mut forces = Kinetostatics::new(linkage, loads, analyzer, &carrying);
        forces.solve(state, position)?;
        return Ok(forces.reactions);
    }
    let (mut wrenches, mut out) = (loads.total(state, &position.bodies), Reactions::new(linkage));
    solve_by(analyzer, linkage, position, &mut wrenches, &mut out)?;
    Ok(out)
}

/// The constructions of all analyzers that have one and support the mechanism, step by step, each with the name of its
/// analyzer; of two forms of one method with the same drawing, only one. A construction that fails at this position is left out.
pub fn constructions(
    linkage: &Linkage,
    position: &Position,
    loads: &[Acting],
) -> Result<Vec<(&'static str, Construction)>, DiagramError> {
    let mut found: Vec<(&'static str, Construction)> = Vec::new();
    for plugin in analyzers()? {
        if plugin.supports(linkage).is_err() {
            continue;
        }
        let Ok(Some(drawn)) = plugin.instance.construction(linkage, position, loads) else { continue };
        if found.iter().all(|(_, other)| other.title != drawn.title) {
            found.push((plugin.name, drawn));
        }
    }
    Ok(found)
}

/// The effect of one cause.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Share {
    /// Weight, inertia, all, or the name of a load.
    pub cause: Text,
    /// The reactions that it causes.
    pub reactions: Vec<JointForce>,
    /// The balancing moment (N m) or force (N) for this cause; over time the power of all drives, W.
    pub balancing: f64,
    /// Over time the load of each drive, N m or N, in the order of the scene.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<f64>,
}

/// Reactions by cause at one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Split {
    /// What drives, in the order of the [loads that balance](Share::balancing_loads); empty where there is one such load.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<Text>,
    /// Under all loads at once.
    pub whole: Share,
    /// By cause: weight, inertia, then each load by its name, then the dry friction of the pairs as it was found. Causes without effect here are listed too.
    pub shares: Vec<Share>,
    /// Greatest difference of a force and the sum of its shares, relative to the greatest force of the total and all
    /// shares.
    pub residual: f64,
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
    state: &LoadState,
    analyzer: &dyn ForceAnalyzer,
) -> Result<Split, DiagramError> {
    let list = loads.acting(state, &position.bodies);
    let mut causes: Vec<Cause> = list.iter().map(|load| load.cause.of_all()).collect();
    causes.sort_unstable();
    causes.dedup();
    let solve = |told: Text, cause: Option<Cause>| -> Result<Share, DiagramError> {
        let acting = list.iter().filter(|load| cause.is_none_or(|cause| cause == load.cause.of_all()));
        let (mut wrenches, mut out) =
            (Acting::total(acting, linkage.structure.links), Reactions::new(linkage));
        solve_by(analyzer, linkage, position, &mut wrenches, &mut out)?;
        Ok(Share::of(told, linkage, out))
    };
    let mut whole = solve(text!("plan-all-causes"), None)?;
    let ideal = whole.clone();
    let each = causes.into_iter().map(|cause| solve(cause.name(&linkage.mechanism).into(), Some(cause)));
    let mut shares = each.collect::<Result<Vec<_>, _>>()?;
    if loads.frictions().is_some() {
        let out = reactions(linkage, position, loads, state, analyzer)?;
        whole = Share::of(whole.cause, linkage, out);
        shares.push(Share::of_friction(&whole, &ideal));
    }
    let residual = residual(&whole, &shares);
    let drives = match whole.drives.len() {
        0 | 1 => Vec::new(),
        _ => linkage.mechanism.input.drivers.iter().map(|driver| driver.label.clone().into()).collect(),
    };
    Ok(Split { drives, whole, shares, residual })
}

impl Share {
    /// What was found under the loads of a cause.
    pub fn of(cause: Text, linkage: &Linkage, found: Reactions) -> Self {
        let reactions = joint_forces(linkage, &found);
        Self { cause, reactions, balancing: found.balancing, drives: found.drives }
    }

    /// The loads that balance, N m or N: of each drive over time, else the balancing load.
    pub fn balancing_loads(&self) -> &[f64] {
        if self.drives.is_empty() { std::slice::from_ref(&self.balancing) } else { &self.drives }
    }

    /// What the friction that was found adds to the reactions of ideal pairs.
    fn of_friction(whole: &Self, ideal: &Self) -> Self {
        let each = whole.reactions.iter().zip(&ideal.reactions).map(|(whole, ideal)| JointForce {
            force: [0, 1].map(|axis| whole.force[axis] - ideal.force[axis]),
            moment: whole.moment.zip(ideal.moment).map(|(whole, ideal)| whole - ideal),
            ..whole.clone()
        });
        let (reactions, balancing) = (each.collect(), whole.balancing - ideal.balancing);
        let drives = whole.drives.iter().zip(&ideal.drives).map(|(whole, ideal)| whole - ideal).collect();
        Self { cause: text!("plan-cause-friction"), reactions, balancing, drives }
    }
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

/// The force that a pin or slide exerts on one of its links.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct JointForce {
    /// Pin or slide.
    pub joint: Named<PairId>,
    /// The link that the force acts on.
    pub on: Named<LinkId>,
    /// Force, N.
    pub force: [f64; 2],
    /// Of a slide, for the sliding link: moment about its point, N m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
}

/// All reactions: pins in the order of the points, then slides; each for every link that it joins.
pub(crate) fn joint_forces(linkage: &Linkage, reactions: &Reactions) -> Vec<JointForce> {
    let mechanism = &linkage.mechanism;
    let mut list = Vec::new();
    for joint in joints(&linkage.mechanism, &linkage.structure) {
        for (nth, link) in joint.links.iter().enumerate() {
            list.push(JointForce {
                joint: mechanism.named_pair(joint.id),
                on: mechanism.named_link(*link),
                force: joint.force(nth, &reactions.pairs),
                moment: joint.moment(&reactions.pairs).filter(|_| nth == 0),
            });
        }
    }
    list
}
