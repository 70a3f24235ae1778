//! All plans of one position.

use assur_force::{AnalyzerPlugin, Construction, Loads, Reactions, State, analyzers};
use assur_geometry::{Center, instant_centers};
use assur_group::{Order, Wrench};
use assur_kinematics::{Linkage, Position};
use serde::Serialize;

use crate::{
    DiagramError, Plan, Split, acceleration_plan, construction_plans, force_polygons, named_loads, split,
    velocity_plan,
};

/// All plans of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sheet {
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Velocities.
    pub velocities: Plan,
    /// Accelerations.
    pub accelerations: Plan,
    /// Instant centers.
    pub centers: Vec<Center>,
    /// Force polygons, from the last group to the input link; empty without loads.
    pub polygons: Vec<Plan>,
    /// Constructions of the registered analyzers that have one and support the mechanism.
    pub constructions: Vec<Plan>,
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
/// [`DiagramError`] where there is no position, or no reaction.
pub fn sheet(
    linkage: &Linkage,
    loads: &Loads,
    state: &State,
    moves: bool,
    analyzer: &AnalyzerPlugin,
) -> Result<Sheet, DiagramError> {
    let mut position = linkage.position();
    linkage.solve(state.coordinate, Order::Second, &mut position)?;
    let list = named_loads(loads, state, &position.bodies);
    let (mut polygons, mut constructions, mut by_cause) = (Vec::new(), Vec::new(), None);
    if !list.is_empty() {
        let mut wrenches = loads.total(state, &position.bodies);
        let drawn = self::constructions(linkage, &position, &wrenches)?;
        constructions = drawn.iter().flat_map(construction_plans).collect();
        let mut out = Reactions::new(linkage);
        analyzer.instance.solve(linkage, &position, &mut wrenches, &mut out)?;
        polygons = force_polygons(linkage, &position, &list, &out);
        by_cause = Some(split(linkage, &position, loads, state, analyzer.instance)?);
    }
    let motion = moves.then_some(state);
    Ok(Sheet {
        coordinate: state.coordinate,
        velocities: velocity_plan(linkage, &position, motion),
        accelerations: acceleration_plan(linkage, &position, motion),
        centers: instant_centers(linkage, &position),
        polygons,
        constructions,
        by_cause,
    })
}

/// The constructions of all analyzers that have one and support the mechanism, step by step; of two forms of one method
/// with the same drawing, only one. A construction that fails at this position is left out.
///
/// # Errors
///
/// [`DiagramError::Registry`] where the registry of analyzers is faulty.
pub fn constructions(
    linkage: &Linkage,
    position: &Position,
    wrenches: &[Wrench<f64>],
) -> Result<Vec<Construction>, DiagramError> {
    let mut found: Vec<Construction> = Vec::new();
    for plugin in analyzers()? {
        if plugin.instance.supports(linkage).is_err() {
            continue;
        }
        let Ok(Some(drawn)) = plugin.instance.construction(linkage, position, wrenches) else { continue };
        if found.iter().all(|other| other.title != drawn.title) {
            found.push(drawn);
        }
    }
    Ok(found)
}
