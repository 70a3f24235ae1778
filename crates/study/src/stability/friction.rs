//! How near the dry friction of a mechanism comes to jamming, and what is lost on the way there.
//!
//! At the coordinate where friction is strongest all coefficients grow by one factor, up to that at which no equilibrium is left. A walk
//! compares the method that is used with the most independent one, at factors that are less by a distance. Forces grow at most as
//! its reciprocal, and so do errors of data.

use std::ops::ControlFlow;

use assur_check::Finding;
use assur_force::{AnalyzerPlugin, Kinetostatics, Loads};
use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_words::{Text, name, text};
use serde::Serialize;

use super::nearest::Grid;
use super::row::{Comparison, DISTANCES, FACTOR, FRICTION};
use super::walk::growth;
use crate::chart::friction::{friction_and_balancing, treating};
use crate::chart::state;

/// Each of so many coordinates of the survey of healths is tried.
const STRIDE: usize = 6;

/// Greatest factor of the coefficients up to which jamming is looked for: beyond it any surface would have long seized.
pub(crate) const MOST: f64 = 1e3;

/// How near the friction of a group, or of the input link, comes to jamming.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FrictionHealth {
    /// `group 1 (RRR rod, rocker)`.
    #[serde(rename = "where")]
    pub place: Text,
    /// Greatest spectral radius over the cycle: below 1 there is exactly one solution.
    pub radius: f64,
    /// Where, rad or m.
    pub coordinate: f64,
    /// The factor of all coefficients from which the mechanism jams there; `None`: none up to a thousand.
    pub jams_at: Option<f64>,
}

/// The methods that treat the friction of a mechanism, the one that is used first.
fn methods(linkage: &Linkage) -> Vec<&'static AnalyzerPlugin> {
    let mut all = treating(linkage).unwrap_or_default();
    all.retain(|plugin| plugin.gives_reactions);
    all.sort_by_key(|plugin| plugin.rank);
    all
}

/// A mechanism with all coefficients times a factor, and its loads.
struct Scaled {
    linkage: Linkage,
    loads: Loads,
}

impl Scaled {
    fn new(linkage: &Linkage, loads: &Loads, factor: f64) -> Option<Self> {
        let mut scaled = linkage.clone();
        scaled.mechanism.frictions.iter_mut().for_each(|friction| friction.coefficient *= factor);
        let loads = Loads::varied(&scaled, Some((&linkage.mechanism, loads))).ok()?;
        Some(Self { linkage: scaled, loads })
    }

    fn by(&self, method: &AnalyzerPlugin) -> Kinetostatics<'_> {
        let carrying = vec![true; self.linkage.groups().len()];
        Kinetostatics::new(&self.linkage, &self.loads, method.instance, &carrying)
    }

    /// The forces of friction and the balancing load.
    fn found(&self, method: &AnalyzerPlugin, position: &Position) -> Result<Vec<f64>, Text> {
        let state = state(&self.linkage.mechanism, position.coordinate);
        friction_and_balancing(&mut self.by(method), &state, position)
    }
}

/// The friction of each group that has some, and the walks to where it jams.
pub(crate) fn friction(
    linkage: &Linkage,
    rows: &mut Vec<Comparison>,
    step: &mut impl FnMut() -> ControlFlow<()>,
) -> ControlFlow<(), Vec<FrictionHealth>> {
    let Some(loads) = Loads::compile(linkage).ok().filter(|loads| loads.frictions().is_some()) else {
        return ControlFlow::Continue(Vec::new());
    };
    let all = methods(linkage);
    let Some((&used, others)) = all.split_first() else { return ControlFlow::Continue(Vec::new()) };
    let Some(own) = Scaled::new(linkage, &loads, 1.0) else { return ControlFlow::Continue(Vec::new()) };
    let mut found = greatest(&own, used);
    for health in &mut found {
        step()?;
        let mut position = linkage.position();
        if linkage.solve(health.coordinate, Order::Second, &mut position).is_err() {
            continue;
        }
        health.jams_at = limit(&own, used, &position);
        if let (Some(limit), Some(judge)) = (health.jams_at, others.last()) {
            walk(&own, [used, judge], &position, (&health.place, limit), rows);
        }
    }
    ControlFlow::Continue(found)
}

/// The greatest spectral radius over the cycle of what is solved together: it is the rate of the iteration, which a position that jams
/// has too.
fn greatest(own: &Scaled, method: &AnalyzerPlugin) -> Vec<FrictionHealth> {
    let linkage = &own.linkage;
    let mut forces = own.by(method);
    let mut position = linkage.position();
    let mut found: Vec<FrictionHealth> = Vec::new();
    for coordinate in Grid::of(linkage, STRIDE).coordinates {
        if linkage.solve(coordinate, Order::Second, &mut position).is_err() {
            continue;
        }
        let all = forces.iteration(&state(&linkage.mechanism, coordinate), &position);
        // Friction that does not act back on what it depends on can't jam.
        for told in all.into_iter().filter(|told| told.radius > 0.0) {
            let health = FrictionHealth { place: told.what, radius: told.radius, coordinate, jams_at: None };
            match found.iter_mut().find(|known| known.place == health.place) {
                None => found.push(health),
                Some(known) if health.radius > known.radius => *known = health,
                Some(_) => {}
            }
        }
    }
    found
}

/// The factor of all coefficients at which a position jams.
fn limit(own: &Scaled, method: &AnalyzerPlugin, position: &Position) -> Option<f64> {
    let strong = Scaled::new(&own.linkage, &own.loads, MOST)?;
    let state = state(&own.linkage.mechanism, position.coordinate);
    let part = strong.by(method).jamming_limit(&state, position)?;
    // Bisection ends at the greatest number below 1 where there is a solution up to the last.
    (part < 1.0 - 4.0 * f64::EPSILON).then_some(part * MOST)
}

/// Compares the method that is used with another one, ever nearer to the factor at which a position jams.
fn walk(
    own: &Scaled,
    [used, judge]: [&AnalyzerPlugin; 2],
    position: &Position,
    (group, limit): (&Text, f64),
    rows: &mut Vec<Comparison>,
) {
    let all = growth(position.health.iter().map(|health| health.abs()));
    for distance in DISTANCES {
        let Some(scaled) = Scaled::new(&own.linkage, &own.loads, limit * (1.0 - distance)) else { return };
        let Ok(known) = scaled.found(judge, position) else { continue };
        let outcome = scaled.found(used, position).map(|found| {
            let size = known.iter().fold(f64::MIN_POSITIVE, |most, force| most.max(force.abs()));
            found
                .iter()
                .zip(&known)
                .fold(0.0, |most, (a, b)| assur_number::greater(most, (a - b).abs() / size))
        });
        let place = text!("stability-place", group, kind = text!("stability-jamming"));
        let bound = FACTOR * f64::EPSILON * all * all / distance;
        let (method, finding) = (name(used.name), Finding::within(place, bound));
        let row = Comparison { method, quantity: FRICTION, distance, health: distance, finding };
        rows.push(row.judged(outcome));
    }
}
