//! Walks the whole mechanism along its coordinate to where each group is least healthy.

use assur_force::{AnalyzerPlugin, Reactions, applicable};
use assur_group::{Body, Order, Wrench};
use assur_kinematics::{Chain, Interpolation, Linkage, Position};
use assur_number::{Dd, Real};

use super::across::interpolated;
use super::compare::{ORDERS, lifted_load, reactions, size, transfer};
use super::isolated::Isolated;
use super::pole;
use super::row::{DISTANCES, Row, Subject, unaware};
use super::target::Target;
use super::walk_group::FACTOR;

/// The mechanism in both numbers, with the same loads.
pub(crate) struct Walk<'a> {
    linkage: &'a Linkage,
    extended: Chain<Dd>,
    analyzers: Vec<&'static AnalyzerPlugin>,
    loads: Vec<Wrench<f64>>,
    scale: f64,
    /// Of each group: it and the groups that it hangs on, directly or not.
    before: Vec<Vec<usize>>,
    /// Of each group: longest over shortest length, in whose parts roundings count.
    disparity: Vec<f64>,
}

/// What the reference says at one coordinate.
struct Reference {
    bodies: Vec<Body<Dd>>,
    pairs: Vec<Wrench<Dd>>,
    /// Of each group: 1/health of it and of all that it hangs on, multiplied: how errors of the first reach the last.
    growth: Vec<f64>,
    /// Of each group.
    health: Vec<f64>,
}

/// One stop of a walk.
struct Stop<'a> {
    /// The coordinate, rad or parts of the size.
    q: f64,
    distance: f64,
    /// Where the motion is interpolated: healths at the reach of that.
    beside: Option<Vec<f64>>,
    reference: &'a Reference,
}

impl Stop<'_> {
    /// What one formula loses.
    fn rounding(&self) -> f64 {
        FACTOR * f64::EPSILON * (1.0 + self.q.abs())
    }
}

/// Registered analyzers that can find the reactions of a mechanism.
pub(crate) fn analyzers_of(linkage: &Linkage) -> Vec<&'static AnalyzerPlugin> {
    applicable(linkage).into_iter().filter(|plugin| plugin.gives_reactions).collect()
}

/// A load on every link, all different, moments as long as the mechanism.
pub(crate) fn test_loads(linkage: &Linkage) -> Vec<Wrench<f64>> {
    let load = |link: usize| {
        let turn = link as f64;
        Wrench { fx: turn.cos(), fy: turn.sin(), m: 0.3 * linkage.structure.scale * (2.0 * turn).cos() }
    };
    (0..linkage.structure.links).map(|link| if link == 0 { Wrench::ZERO } else { load(link) }).collect()
}

/// How errors grow over groups that hang on each other: each adds its own, and passes on the others over its health.
/// Finite, so that the bound is a number that says "nothing".
pub(crate) fn growth(healths: impl Iterator<Item = f64>) -> f64 {
    let (count, product) = healths.fold((0.0, 1.0), |(count, all), health| (count + 1.0, all / health));
    (f64::max(count, 1.0) * product).min(1e90)
}

impl<'a> Walk<'a> {
    /// `None` where the chain can't be built in 32 digits.
    pub(crate) fn new(linkage: &'a Linkage) -> Option<Self> {
        let extended = Chain::<Dd>::compile(&linkage.mechanism, &linkage.structure).ok()?;
        let analyzers = analyzers_of(linkage);
        let scale = linkage.structure.scale;
        let loads = test_loads(linkage);
        let before: Vec<_> = (0..linkage.groups().len()).map(|group| linkage.ancestors(group)).collect();
        let disparity = |group| Isolated::of(group).map_or(1.0, |alone| alone.disparity());
        let disparity = linkage.structure.groups.iter().map(disparity).collect();
        Some(Self { linkage, extended, analyzers, loads, scale, before, disparity })
    }

    /// With other loads, one for each link.
    pub(crate) fn with_loads(self, loads: Vec<Wrench<f64>>) -> Self {
        Self { loads, ..self }
    }

    /// Of the coordinate: 1 rad, or the scale in m.
    fn unit(&self) -> f64 {
        if self.linkage.angular() { 1.0 } else { self.scale }
    }

    /// Walks to a place.
    pub(crate) fn to(&self, target: &Target, rows: &mut Vec<Row>) {
        let unit = self.unit();
        for distance in DISTANCES.into_iter().filter(|d| d * unit <= target.reach) {
            for side in &target.sides {
                let q = target.coordinate + side * unit * distance;
                self.stop(target, (q, q), distance, rows);
            }
        }
    }

    fn reference(&self, q: f64, across: Option<Interpolation>) -> Option<Reference> {
        let chain = &self.extended;
        let bodies = if let Some(across) = across {
            interpolated(self.linkage, chain, across, q)?
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
        let health: Vec<f64> =
            chain.groups.iter().map(|kernel| kernel.health(&bodies).abs().to_f64()).collect();
        let growth = (0..health.len()).map(|group| self.growth(group, &health)).collect();
        Some(Reference { bodies, pairs, growth, health })
    }

    /// Compares at a coordinate with the reference at the same, or at one that whole cycles lie between.
    pub(crate) fn stop(&self, target: &Target, (q, exact): (f64, f64), distance: f64, rows: &mut Vec<Row>) {
        let across = self.linkage.interpolation(exact);
        let Some(reference) = self.reference(exact, across) else { return };
        let mut position = self.linkage.position();
        let beside = across.and_then(|across| {
            self.linkage.solve(across.center + across.half_width, Order::Place, &mut position).ok()?;
            Some(position.health.clone())
        });
        let solved = self.linkage.solve(q, Order::Second, &mut position);
        let at = Stop { q: q / self.unit(), distance, beside, reference: &reference };
        let solved = solved.map_err(|error| error.to_string());
        for &group in &target.groups {
            self.transfer((target, group), &at, solved.as_ref().map(|()| &position), rows);
        }
        if solved.is_ok() || self.linkage.solve(q, Order::Place, &mut position).is_ok() {
            let first = rows.len();
            self.forces(target, &at, &position, rows);
            if solved.is_err() {
                rows[first..].iter_mut().for_each(unaware);
            }
        }
    }

    /// Transfer functions of one group.
    fn transfer(
        &self,
        (target, group): (&Target, usize),
        at: &Stop<'_>,
        solved: Result<&Position, &String>,
        rows: &mut Vec<Row>,
    ) {
        let reference = at.reference;
        let place = target.place(self.linkage, group, "");
        let links = &self.linkage.structure.groups[group].frame.links;
        for (order, quantity) in ORDERS.into_iter().enumerate() {
            // Across a change point what the closed forms lose beside it is lost; of PF2 the error of w^2/D, one power more.
            let growth = match &at.beside {
                Some(beside) => self.growth(group, beside).powi([1, 2, 3][order]),
                None => reference.growth[group].powi([1, 2, 2][order]),
            };
            let disparity = self.before[group].iter().fold(1.0_f64, |most, &i| most.max(self.disparity[i]));
            let lost = disparity
                * if order == 2 && at.beside.is_none() { self.cancelled(group, reference) } else { 1.0 };
            let outcome = match solved {
                Ok(position) => {
                    // The input itself turns by 1 (moves by 1/scale of the scale) for a unit of the coordinate.
                    let floor = order.try_into().map_or(1.0, |order: i32| self.unit().powi(-order));
                    Ok(transfer(&position.bodies, &reference.bodies, links, order, self.scale, floor))
                }
                Err(error) => Err(error.clone()),
            };
            let subject = Subject {
                law: target.law,
                place: &place,
                method: "closed forms",
                quantity,
                distance: at.distance,
                health: reference.health[group],
                bound: at.rounding() * growth * lost,
            };
            rows.push(subject.row(outcome));
        }
    }

    /// How errors grow up to a group.
    fn growth(&self, group: usize, health: &[f64]) -> f64 {
        growth(self.before[group].iter().map(|&i| health[i].abs()))
    }

    /// How much greater the terms of PF2, PF1²/health, are than their sum: where the motion is smooth they cancel.
    fn cancelled(&self, group: usize, reference: &Reference) -> f64 {
        let links = &self.linkage.structure.groups[group].frame.links;
        let unit = self.unit();
        let size = |order: usize, power: i32| {
            size(&reference.bodies, links, order, self.scale, unit.powi(-power)) * unit.powi(power)
        };
        (reference.growth[group] * size(1, 1).powi(2) / size(2, 2)).max(1.0)
    }

    /// Reactions of all pairs by each analyzer.
    fn forces(&self, target: &Target, at: &Stop<'_>, position: &Position, rows: &mut Vec<Row>) {
        let more = match target.groups.len() {
            0 | 1 => String::new(),
            all => format!(" and {} more", all - 1),
        };
        let Some(&first) = target.groups.first() else { return };
        let place = target.place(self.linkage, first, &more);
        let reference = at.reference;
        let least = target.groups.iter().map(|&group| reference.health[group]).fold(f64::INFINITY, f64::min);
        let all = growth(reference.health.iter().copied());
        for plugin in &self.analyzers {
            let outcome = self.reactions(plugin, position, reference);
            let own = pole::growth(self.linkage, plugin.name, &position.bodies);
            let (health, growth) = (least.min(1.0 / own), all * own);
            let subject = Subject {
                law: target.law,
                place: &place,
                method: plugin.name,
                quantity: "reactions",
                distance: at.distance,
                health,
                bound: at.rounding() * growth * growth,
            };
            rows.push(subject.row(outcome));
        }
    }

    /// Reactions in the pairs of the groups.
    fn reactions(
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
