//! Walks of the whole mechanism along its coordinate towards places where a group is nearly singular.

use assur_check::Finding;
use assur_force::{AnalyzerPlugin, Reactions, applicable};
use assur_group::{Order, Wrench, plane};
use assur_kinematics::{Linkage, Position};
use assur_structure::Group;
use assur_words::{Describe, Text, name, text};

use super::exact::{Exact, ORDERS, Reference, reactions, size, transfer};
use super::row::{Comparison, DISTANCES, FACTOR, REACTIONS, accept_without_digits};
use super::target::Target;

/// Above this, the product of the error growth over the groups means that no digit remains; the bound stays finite.
const MOST_GROWTH: f64 = 1e90;

/// The mechanism, its reference, and the methods that are compared with it.
pub(crate) struct Walk<'a> {
    linkage: &'a Linkage,
    exact: Exact<'a>,
    analyzers: Vec<&'static AnalyzerPlugin>,
    pub(crate) loads: Vec<Wrench<f64>>,
    scale: f64,
    /// Of each group: itself and the groups that it depends on.
    ancestors: Vec<Vec<usize>>,
    /// Of each group: the ratio of the mechanism's size to its shortest link, to which rounding is relative.
    disparity: Vec<f64>,
}

struct Stop<'a> {
    /// The coordinate, rad or parts of the size.
    q: f64,
    distance: f64,
    /// Where the motion is interpolated: the healths at the ends of the interpolation.
    beside: Option<Vec<f64>>,
    reference: &'a Reference,
}

impl Stop<'_> {
    /// The loss of accuracy in one formula.
    fn rounding(&self) -> f64 {
        FACTOR * f64::EPSILON * (1.0 + self.q.abs())
    }
}

/// Registered analyzers that can find the reactions of a mechanism.
pub(crate) fn analyzers_of(linkage: &Linkage) -> Vec<&'static AnalyzerPlugin> {
    // Beside passive links reactions are not determined, and what is has no reference by groups.
    let has_all = linkage.structure.passive.is_empty();
    applicable(linkage).into_iter().filter(|plugin| plugin.gives_reactions && has_all).collect()
}

/// A load on every link, all different, with moments as large as a force on the size of the mechanism.
pub(crate) fn test_loads(linkage: &Linkage) -> Vec<Wrench<f64>> {
    let load = |link: usize| {
        let turn = link as f64;
        Wrench { fx: turn.cos(), fy: turn.sin(), m: 0.3 * linkage.structure.scale * (2.0 * turn).cos() }
    };
    (0..linkage.structure.links).map(|link| if link == 0 { Wrench::ZERO } else { load(link) }).collect()
}

/// How errors grow over groups that depend on each other: each group adds its own, and passes on the others divided by
/// its health.
pub(crate) fn growth(healths: impl Iterator<Item = f64>) -> f64 {
    let (count, product) = healths.fold((0.0, 1.0), |(count, all), health| (count + 1.0, all / health));
    (f64::max(count, 1.0) * product).min(MOST_GROWTH)
}

/// Largest coordinate of the pairs of a group (at least its scale) over the shortest distance between two pins of a link.
pub(crate) fn disparity(group: &Group) -> f64 {
    let frame = &group.frame;
    let (mut size, mut shortest) = (frame.scale, f64::INFINITY);
    let mut pins: Vec<(usize, [f64; 2])> = Vec::new();
    for pair in frame.pairs() {
        let places = pair.places();
        size = places.iter().fold(size, |size, (_, at)| size.max(at[0].hypot(at[1])));
        if !pair.is_slide() {
            pins.extend(places.iter().filter(|(body, _)| frame.links.contains(body)));
        }
    }
    for (i, (link, at)) in pins.iter().enumerate() {
        for (_, other) in pins[i + 1..].iter().filter(|(body, _)| body == link) {
            let [x, y] = plane::minus(*at, *other);
            shortest = shortest.min(x.hypot(y));
        }
    }
    if shortest > 0.0 { (size / shortest).max(1.0) } else { 1.0 }
}

impl<'a> Walk<'a> {
    /// `None` where the mechanism can't be built in 32 digits.
    pub(crate) fn new(linkage: &'a Linkage) -> Option<Self> {
        Some(Self {
            linkage,
            exact: Exact::of(linkage)?,
            analyzers: analyzers_of(linkage),
            loads: test_loads(linkage),
            scale: linkage.structure.scale,
            ancestors: (0..linkage.groups().len()).map(|group| linkage.ancestors(group)).collect(),
            disparity: linkage.structure.groups.iter().map(disparity).collect(),
        })
    }

    pub(crate) fn to(&self, target: &Target, rows: &mut Vec<Comparison>) {
        let unit = self.linkage.coordinate_unit();
        for distance in DISTANCES.into_iter().filter(|d| d * unit <= target.reach) {
            for side in &target.sides {
                let q = target.coordinate + side * unit * distance;
                self.stop(target, (q, q), distance, rows);
            }
        }
    }

    /// Compares at the coordinate `q` with the reference at `exact`, which is `q` or whole cycles away.
    pub(crate) fn stop(
        &self,
        target: &Target,
        (q, exact): (f64, f64),
        distance: f64,
        rows: &mut Vec<Comparison>,
    ) {
        let Some(reference) = self.exact.at(exact, &self.loads) else { return };
        let mut position = self.linkage.position();
        let beside = self.linkage.interpolation(exact).and_then(|across| {
            self.linkage.solve(across.center + across.half_width, Order::Place, &mut position).ok()?;
            Some(position.health.clone())
        });
        let solved = self.linkage.solve(q, Order::Second, &mut position);
        let at = Stop { q: q / self.linkage.coordinate_unit(), distance, beside, reference: &reference };
        let solved = solved.map_err(|error| error.describe());
        for &group in &target.groups {
            self.transfer((target, group), &at, solved.as_ref().map(|()| &position), rows);
        }
        if solved.is_ok() || self.linkage.solve(q, Order::Place, &mut position).is_ok() {
            let first = rows.len();
            self.forces(target, &at, &position, rows);
            if solved.is_err() {
                rows[first..].iter_mut().for_each(accept_without_digits);
            }
        }
    }

    fn transfer(
        &self,
        (target, group): (&Target, usize),
        at: &Stop<'_>,
        solved: Result<&Position, &Text>,
        rows: &mut Vec<Comparison>,
    ) {
        let reference = at.reference;
        let place = target.place(self.linkage, group, 0);
        let links = &self.linkage.structure.groups[group].frame.links;
        let disparity = self.ancestors[group].iter().fold(1.0_f64, |most, &i| most.max(self.disparity[i]));
        for (order, quantity) in ORDERS.into_iter().enumerate() {
            // When interpolating across a change point the error is that of the closed forms beside it; PF2 has the
            // error of w^2/D, one power more.
            let growth = match &at.beside {
                Some(beside) => self.growth(group, beside).powi([1, 2, 3][order]),
                None => self.growth(group, &reference.health).powi([1, 2, 2][order]),
            };
            let lost = disparity
                * if order == 2 && at.beside.is_none() { self.cancelled(group, reference) } else { 1.0 };
            let outcome = match solved {
                Ok(position) => {
                    // PF1 of the input itself is 1 rad (or 1/scale of the scale) per unit of the coordinate.
                    let floor = order
                        .try_into()
                        .map_or(1.0, |order: i32| self.linkage.coordinate_unit().powi(-order));
                    Ok(transfer(&position.bodies, &reference.bodies, links, order, self.scale, floor))
                }
                Err(error) => Err(error.clone()),
            };
            let row = Comparison {
                method: text!("stability-closed-forms"),
                quantity,
                distance: at.distance,
                health: reference.health[group],
                finding: Finding::within(place.clone(), at.rounding() * growth * lost),
            };
            rows.push(row.judged(outcome));
        }
    }

    fn growth(&self, group: usize, health: &[f64]) -> f64 {
        growth(self.ancestors[group].iter().map(|&i| health[i].abs()))
    }

    /// Ratio of the terms of PF2, PF1^2 / health, to their sum: where the motion is smooth they cancel.
    fn cancelled(&self, group: usize, reference: &Reference) -> f64 {
        let links = &self.linkage.structure.groups[group].frame.links;
        let unit = self.linkage.coordinate_unit();
        let size = |order: usize, power: i32| {
            size(&reference.bodies, links, order, self.scale, unit.powi(-power)) * unit.powi(power)
        };
        (self.growth(group, &reference.health) * size(1, 1).powi(2) / size(2, 2)).max(1.0)
    }

    fn forces(&self, target: &Target, at: &Stop<'_>, position: &Position, rows: &mut Vec<Comparison>) {
        let Some((&first, others)) = target.groups.split_first() else { return };
        let place = target.place(self.linkage, first, others.len());
        let reference = at.reference;
        let least = target.groups.iter().map(|&group| reference.health[group]).fold(f64::INFINITY, f64::min);
        let all = growth(reference.health.iter().copied());
        for plugin in &self.analyzers {
            let condition = plugin.instance.condition(self.linkage, position);
            let growth = (all * condition).min(MOST_GROWTH);
            let row = Comparison {
                method: name(plugin.name),
                quantity: REACTIONS,
                distance: at.distance,
                health: least.min(1.0 / condition),
                finding: Finding::within(place.clone(), at.rounding() * growth * growth),
            };
            rows.push(row.judged(self.reactions(plugin, position, reference)));
        }
    }

    fn reactions(
        &self,
        plugin: &AnalyzerPlugin,
        position: &Position,
        reference: &Reference,
    ) -> Result<f64, Text> {
        let mut loads = self.loads.clone();
        let mut out = Reactions::new(self.linkage);
        let solved = plugin.instance.solve(self.linkage, position, &mut loads, &mut out);
        solved.map_err(|error| error.describe())?;
        // The reference has the reactions of groups alone, those of driven pairs with their drives.
        let drives = self.linkage.mechanism.input.drivers.len();
        Ok(reactions(&out.pairs[drives..], &reference.pairs[drives..], self.scale))
    }
}
