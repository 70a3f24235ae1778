//! What the plans show: force polygons of the groups, and the construction of the force analyzer, by position.

use assur_analysis::Study;
use assur_force::{Construction, Loads, State, find};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};
use assur_results::{Analysis, PositionResult};

use super::draw::scale::Bounds;

/// A force of a polygon.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Side {
    /// Which force: `weight of ram`, `A`.
    pub(crate) name: String,
    /// Its vector, N.
    pub(crate) force: [f64; 2],
    /// Whether it is the answer of a pair; otherwise a load.
    pub(crate) reaction: bool,
}

/// The plans of one position.
#[derive(Debug, Clone, Default)]
pub(crate) struct Plan {
    /// For each group, then for the input link: its forces in drawing order. They close.
    pub(crate) polygons: Vec<Vec<Side>>,
    /// The construction on paper of the force analyzer, or of the longitudinal reactions where they apply.
    pub(crate) construction: Option<Construction>,
}

/// The analyzer whose construction is drawn where the chosen one has none.
const DRAWN: &str = "longitudinal";
/// A load smaller than this part of the largest force of a polygon is not drawn.
const LEAST: f64 = 1e-12;

/// The plans of all positions of the scene; a position that does not exist has an empty one.
pub(crate) fn of(study: &Study, analysis: &Analysis) -> Vec<Plan> {
    let linkage = &study.linkage;
    let mut plans = vec![Plan::default(); linkage.mechanism.input.positions];
    let Some(loads) = &study.loads else { return plans };
    let mut position = linkage.position();
    for found in &analysis.positions {
        if linkage.solve_index(found.index, assur_group::Order::Second, &mut position).is_err() {
            continue;
        }
        let state = state_of(&linkage.mechanism, found);
        if let Some(plan) = plans.get_mut(found.index) {
            plan.polygons = polygons(linkage, loads, &state, &position, found);
            plan.construction = construction(study, loads, &state, &position);
        }
    }
    plans
}

/// The state of motion that the analysis used.
fn state_of(mechanism: &assur_mechanism::Mechanism, found: &PositionResult) -> State {
    let prescribed = State::prescribed(mechanism, found.coordinate);
    State {
        speed: found.speed.unwrap_or(prescribed.speed),
        acceleration: found.acceleration.unwrap_or(prescribed.acceleration),
        ..prescribed
    }
}

fn polygons(
    linkage: &Linkage,
    loads: &Loads,
    state: &State,
    position: &Position,
    found: &PositionResult,
) -> Vec<Vec<Side>> {
    let mechanism = &linkage.mechanism;
    let mut by_cause = Vec::new();
    loads.by_cause(state, &position.bodies, &mut |cause, link, wrench| by_cause.push((cause, link, wrench)));
    let Some(reactions) = &found.reactions else { return Vec::new() };
    let groups = linkage.structure.groups.iter().map(|group| group.frame.links.clone());
    let all = groups.chain(std::iter::once(vec![mechanism.input.link]));
    all.map(|links| {
        let given = by_cause.iter().filter(|(_, link, _)| links.contains(link));
        let mut sides: Vec<Side> = given
            .map(|(cause, _, wrench)| Side {
                name: cause.name(mechanism),
                force: wrench.force(),
                reaction: false,
            })
            .collect();
        let inside = |name: &str| links.iter().any(|&link| mechanism.links[link].name == name);
        for (pair, reaction) in reactions.iter() {
            let on_group = reaction.forces.iter().filter(|(link, _)| inside(link));
            let force = on_group.fold([0.0, 0.0], |sum, (_, force)| [sum[0] + force[0], sum[1] + force[1]]);
            sides.push(Side { name: pair.to_owned(), force, reaction: true });
        }
        let most = sides.iter().map(|side| side.force[0].hypot(side.force[1])).fold(0.0, f64::max);
        sides.retain(|side| side.force[0].hypot(side.force[1]) > LEAST * most);
        sides
    })
    .collect()
}

fn construction(study: &Study, loads: &Loads, state: &State, position: &Position) -> Option<Construction> {
    let mut wrenches = vec![Wrench::ZERO; study.linkage.structure.links];
    loads.apply(state, &position.bodies, &mut wrenches);
    loads.inertia(state, &position.bodies, &mut wrenches);
    [study.analyzer, find(DRAWN).ok()].into_iter().flatten().find_map(|plugin| {
        plugin.instance.supports(&study.linkage).ok()?;
        plugin.instance.construction(&study.linkage, position, &wrenches).ok()?
    })
}

/// What is left open of a polygon, N: rounding, unless the balancing force acts on the group.
pub(crate) fn residual(sides: &[Side]) -> [f64; 2] {
    sides.iter().fold([0.0, 0.0], |sum, side| [sum[0] + side.force[0], sum[1] + side.force[1]])
}

/// Corners of a polygon, from the origin.
pub(crate) fn corners(sides: &[Side]) -> Vec<[f64; 2]> {
    let mut at = [0.0, 0.0];
    std::iter::once(at)
        .chain(sides.iter().map(|side| {
            at = [at[0] + side.force[0], at[1] + side.force[1]];
            at
        }))
        .collect()
}

/// Box around points.
pub(crate) fn bounds(points: impl Iterator<Item = [f64; 2]>) -> Bounds {
    let mut bounds = Bounds::EMPTY;
    points.for_each(|at| bounds.add(at));
    bounds
}
