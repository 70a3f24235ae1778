//! Walks the whole mechanism along its coordinate to where each group is least healthy.

use assur_force::{AnalyzerPlugin, Reactions, analyzers};
use assur_group::{Body, Order, Wrench};
use assur_kinematics::{Chain, Linkage, Position};
use assur_number::{Dd, Real};

use super::across::interpolated;
use super::compare::{ORDERS, lifted_load, reactions, transfer};
use super::cycle::GroupHealth;
use super::pole;
use super::row::{DISTANCES, Row, Subject};
use super::walk_group::FACTOR;

/// Half of the interval around a change point in which the motion is interpolated, rad (or parts of the scale).
const PATCH: f64 = 0.0125;

/// The published form of longitudinal reactions, whose health is its own.
const PUBLISHED: &str = "longitudinal-published";

/// The mechanism in both numbers, with the same loads.
pub(crate) struct Walk<'a> {
    linkage: &'a Linkage,
    extended: Chain<Dd>,
    analyzers: Vec<&'static AnalyzerPlugin>,
    loads: Vec<Wrench<f64>>,
    scale: f64,
}

/// What the reference says at one coordinate.
struct Reference {
    bodies: Vec<Body<Dd>>,
    pairs: Vec<Wrench<Dd>>,
    /// 1/health of all groups, multiplied: how errors of the first reach the last.
    growth: f64,
    health: f64,
}

impl<'a> Walk<'a> {
    /// `None` where the chain can't be built in 32 digits.
    pub(crate) fn new(linkage: &'a Linkage) -> Option<Self> {
        let extended = Chain::<Dd>::compile(&linkage.mechanism, &linkage.structure).ok()?;
        let fits =
            |plugin: &&AnalyzerPlugin| plugin.gives_reactions && plugin.instance.supports(linkage).is_ok();
        let analyzers = analyzers().ok()?.into_iter().filter(fits).collect();
        let scale = linkage.structure.scale;
        let load = |link: usize| {
            let turn = link as f64;
            Wrench { fx: turn.cos(), fy: turn.sin(), m: 0.3 * scale * (2.0 * turn).cos() }
        };
        let loads = (0..linkage.structure.links)
            .map(|link| if link == 0 { Wrench::ZERO } else { load(link) })
            .collect();
        Some(Self { linkage, extended, analyzers, loads, scale })
    }

    /// Walks to the least health of one group, from the side on which there is more way.
    pub(crate) fn to(&self, group: usize, least: &GroupHealth, rows: &mut Vec<Row>) {
        let grid = super::cycle::coordinates(self.linkage);
        let (first, last) = (grid[0], grid[grid.len() - 1]);
        let q = least.coordinate;
        let side =
            if (q - first).abs() > (last - q).abs() { (first - q).signum() } else { (last - q).signum() };
        let unit = if self.linkage.angular() { 1.0 } else { self.scale };
        let reach = (first - q).abs().max((last - q).abs());
        for distance in DISTANCES.into_iter().filter(|d| d * unit <= reach) {
            self.step(group, &least.place, q + side * unit * distance, distance, rows);
        }
    }

    fn reference(&self, group: usize, q: f64, change: Option<f64>) -> Option<Reference> {
        let chain = &self.extended;
        let bodies = if let Some(center) = change {
            interpolated(self.linkage, chain, center, q)?
        } else {
            let (mut bodies, mut health) = (chain.bodies(), vec![Dd::ZERO; chain.groups.len()]);
            let ways = self.linkage.ways.at(q);
            chain.solve(Dd::from_f64(q), ways, Order::Second, &mut bodies, &mut health).ok()?;
            bodies
        };
        let mut loads: Vec<_> = self.loads.iter().map(lifted_load).collect();
        let mut pairs = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        for kernel in chain.groups.iter().rev() {
            kernel.reactions(&bodies, &mut loads, &mut pairs).ok()?;
        }
        let product: f64 = chain.groups.iter().map(|kernel| 1.0 / kernel.health(&bodies).abs()).product();
        // Finite, so that the bound is a number that says "nothing".
        let growth = product.min(1e90);
        let health = chain.groups[group].health(&bodies).abs();
        Some(Reference { bodies, pairs, growth, health })
    }

    /// The change point whose surroundings hold the coordinate.
    fn change(&self, q: f64) -> Option<f64> {
        let turn = std::f64::consts::TAU;
        let unit = if self.linkage.angular() { 1.0 } else { self.scale };
        self.linkage.change_points().iter().find_map(|(at, _)| {
            // The change point as it lies next to q, not a turn away.
            let near = if self.linkage.angular() { at + turn * ((q - at) / turn).round() } else { *at };
            ((q - near).abs() < PATCH * unit).then_some(near)
        })
    }

    fn step(&self, group: usize, name: &str, q: f64, distance: f64, rows: &mut Vec<Row>) {
        let change = self.change(q);
        let Some(reference) = self.reference(group, q, change) else { return };
        // Across a change point the motion is interpolated: its error is that of the nodes beside, not of the place.
        let growth = if change.is_some() { 1.0 / PATCH } else { reference.growth };
        let rounding = FACTOR * f64::EPSILON * (1.0 + q.abs());
        let at = if self.linkage.change_points().is_empty() {
            "least health of the cycle"
        } else {
            "change point"
        };
        let place = format!("{name}, {at}");
        let subject = |method, quantity, health, bound| Subject {
            place: &place,
            method,
            quantity,
            distance,
            health,
            bound,
        };
        let mut position = self.linkage.position();
        let solved = self.linkage.solve(q, Order::Second, &mut position);
        let links = &self.linkage.structure.groups[group].frame.links;
        for (order, quantity) in ORDERS.into_iter().enumerate() {
            // Where the motion passes smoothly PF2 does not grow with 1/health, but the error of w^2/D does: one power more.
            let power = if order == 2 && change.is_some() { 3 } else { [1, 2, 2][order] };
            let bound = rounding * growth.powi(power);
            let outcome = match &solved {
                Ok(()) => {
                    // The input itself turns by 1 (moves by 1/scale of the scale) for a unit of the coordinate.
                    let unit = if self.linkage.angular() { 1.0_f64 } else { self.scale };
                    let floor = order.try_into().map_or(1.0, |order: i32| unit.powi(-order));
                    Ok(transfer(&position.bodies, &reference.bodies, links, order, self.scale, floor))
                }
                Err(error) => Err(error.to_string()),
            };
            rows.push(subject("closed forms", quantity, reference.health, bound).row(outcome));
        }
        if solved.is_err() && self.linkage.solve(q, Order::Place, &mut position).is_err() {
            return;
        }
        for plugin in &self.analyzers {
            let outcome = self.forces(plugin, &position, &reference);
            let own = pole::sine(self.linkage, &position.bodies).filter(|_| plugin.name == PUBLISHED);
            let health = own.map_or(reference.health, |sine| sine.min(reference.health));
            let growth = own.map_or(reference.growth, |sine| reference.growth / sine.max(f64::MIN_POSITIVE));
            rows.push(subject(plugin.name, "reactions", health, rounding * growth * growth).row(outcome));
        }
    }

    /// Reactions in the pairs of the groups.
    fn forces(
        &self,
        plugin: &AnalyzerPlugin,
        position: &Position,
        reference: &Reference,
    ) -> Result<f64, String> {
        let mut loads = self.loads.clone();
        let mut out = Reactions::new(self.linkage);
        let solved = plugin.instance.solve(self.linkage, position, &mut loads, &mut out);
        solved.map_err(|error| error.to_string())?;
        Ok(reactions(&out.pairs[1..], &reference.pairs[1..], self.scale))
    }
}
