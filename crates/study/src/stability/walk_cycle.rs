//! Walks the whole mechanism along its coordinate to where each group is least healthy.

use assur_force::{AnalyzerPlugin, Reactions, analyzers};
use assur_group::{Body, Order, Wrench};
use assur_kinematics::{Across, Chain, Linkage, Position};
use assur_number::{Dd, Real};

use super::across::interpolated;
use super::compare::{ORDERS, lifted_load, reactions, transfer};
use super::pole;
use super::row::{DISTANCES, Law, Row, Subject};
use super::walk_group::FACTOR;

static LAW: Law = Law {
    section: "cycle",
    along: "distance of the coordinate from where the group is least healthy, rad or parts of the size",
    expected: "16 eps (1 + |q|) / (product of healths)^k: k = 1 for places, 2 for PF1, PF2 and reactions; around a change \
               point, where the motion is interpolated, k = 1, 2, 3 with the healths where that begins; for the published \
               longitudinal form also / sine^2 of the angle at the pole",
};

/// The published form of longitudinal reactions, whose health is its own.
const PUBLISHED: &str = "longitudinal-published";

/// The mechanism in both numbers, with the same loads.
pub(crate) struct Walk<'a> {
    linkage: &'a Linkage,
    extended: Chain<Dd>,
    analyzers: Vec<&'static AnalyzerPlugin>,
    loads: Vec<Wrench<f64>>,
    scale: f64,
    /// Of each group: it and the groups that it hangs on, directly or not.
    before: Vec<Vec<usize>>,
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

/// Where a walk goes.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) coordinate: f64,
    /// The groups that are least healthy there.
    pub(crate) groups: Vec<usize>,
    /// What is there.
    pub(crate) words: &'static str,
}

/// One stop of a walk.
struct Stop<'a> {
    q: f64,
    distance: f64,
    /// Where the motion is interpolated: healths at the reach of that.
    beside: Option<Vec<f64>>,
    at: &'static str,
    reference: &'a Reference,
}

impl Stop<'_> {
    /// What one formula loses.
    fn rounding(&self) -> f64 {
        FACTOR * f64::EPSILON * (1.0 + self.q.abs())
    }
}

/// 1/health multiplied; finite, so that the bound is a number that says "nothing".
fn growth(healths: impl Iterator<Item = f64>) -> f64 {
    healths.map(|health| 1.0 / health).product::<f64>().min(1e90)
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
        let before = before(linkage);
        Some(Self { linkage, extended, analyzers, loads, scale, before })
    }

    /// Walks to where some groups are least healthy, from the side on which there is more way.
    pub(crate) fn to(&self, target: &Target, rows: &mut Vec<Row>) {
        let grid = super::cycle::coordinates(self.linkage);
        let (first, last) = (grid[0], grid[grid.len() - 1]);
        let q = target.coordinate;
        let side =
            if (q - first).abs() > (last - q).abs() { (first - q).signum() } else { (last - q).signum() };
        let unit = if self.linkage.angular() { 1.0 } else { self.scale };
        let reach = (first - q).abs().max((last - q).abs());
        for distance in DISTANCES.into_iter().filter(|d| d * unit <= reach) {
            self.step(target, q + side * unit * distance, distance, rows);
        }
    }

    fn reference(&self, q: f64, across: Option<Across>) -> Option<Reference> {
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
        let growth =
            (0..health.len()).map(|group| growth(self.before[group].iter().map(|&i| health[i]))).collect();
        Some(Reference { bodies, pairs, growth, health })
    }

    fn step(&self, target: &Target, q: f64, distance: f64, rows: &mut Vec<Row>) {
        let across = self.linkage.across(q);
        let Some(reference) = self.reference(q, across) else { return };
        let mut position = self.linkage.position();
        let beside = across.and_then(|across| {
            self.linkage.solve(across.center + across.reach, Order::Place, &mut position).ok()?;
            Some(position.health.clone())
        });
        let solved = self.linkage.solve(q, Order::Second, &mut position);
        let at = Stop { q, distance, beside, at: target.words, reference: &reference };
        let solved = solved.map_err(|error| error.to_string());
        for &group in &target.groups {
            self.transfer(group, &at, solved.as_ref().map(|()| &position), rows);
        }
        if solved.is_ok() || self.linkage.solve(q, Order::Place, &mut position).is_ok() {
            self.forces(target, &at, &position, rows);
        }
    }

    /// Transfer functions of one group.
    fn transfer(&self, group: usize, at: &Stop<'_>, solved: Result<&Position, &String>, rows: &mut Vec<Row>) {
        let reference = at.reference;
        let place = format!("{}, {}", self.name(group), at.at);
        let links = &self.linkage.structure.groups[group].frame.links;
        for (order, quantity) in ORDERS.into_iter().enumerate() {
            // Across a change point what the closed forms lose beside it is lost; of PF2 the error of w^2/D, one power more.
            let growth = match &at.beside {
                Some(beside) => {
                    growth(self.before[group].iter().map(|&i| beside[i].abs())).powi([1, 2, 3][order])
                }
                None => reference.growth[group].powi([1, 2, 2][order]),
            };
            let outcome = match solved {
                Ok(position) => {
                    // The input itself turns by 1 (moves by 1/scale of the scale) for a unit of the coordinate.
                    let unit = if self.linkage.angular() { 1.0_f64 } else { self.scale };
                    let floor = order.try_into().map_or(1.0, |order: i32| unit.powi(-order));
                    Ok(transfer(&position.bodies, &reference.bodies, links, order, self.scale, floor))
                }
                Err(error) => Err(error.clone()),
            };
            let subject = Subject {
                law: &LAW,
                place: &place,
                method: "closed forms",
                quantity,
                distance: at.distance,
                health: reference.health[group],
                bound: at.rounding() * growth,
            };
            rows.push(subject.row(outcome));
        }
    }

    /// Reactions of all pairs by each analyzer.
    fn forces(&self, target: &Target, at: &Stop<'_>, position: &Position, rows: &mut Vec<Row>) {
        let more = match target.groups.len() - 1 {
            0 => String::new(),
            others => format!(" and {others} more"),
        };
        let place = format!("{}{more}, {}", self.name(target.groups[0]), at.at);
        let reference = at.reference;
        let least = target.groups.iter().map(|&group| reference.health[group]).fold(f64::INFINITY, f64::min);
        let all = growth(reference.health.iter().copied());
        for plugin in &self.analyzers {
            let outcome = self.reactions(plugin, position, reference);
            let own = pole::sine(self.linkage, &position.bodies).filter(|_| plugin.name == PUBLISHED);
            let health = own.map_or(least, |sine| sine.min(least));
            let growth = own.map_or(all, |sine| all / sine.max(f64::MIN_POSITIVE));
            let subject = Subject {
                law: &LAW,
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

    fn name(&self, group: usize) -> String {
        self.linkage.structure.group_name(&self.linkage.mechanism, group)
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

/// Each group with all that it hangs on.
fn before(linkage: &Linkage) -> Vec<Vec<usize>> {
    let groups = &linkage.structure.groups;
    let mut all: Vec<Vec<usize>> = Vec::with_capacity(groups.len());
    for (i, group) in groups.iter().enumerate() {
        let mut mine = vec![i];
        let bodies = group.frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
        for body in bodies.filter(|body| !group.frame.links.contains(body)) {
            if let Some(owner) = groups[..i].iter().position(|other| other.frame.links.contains(&body)) {
                mine.extend(&all[owner]);
            }
        }
        mine.sort_unstable();
        mine.dedup();
        all.push(mine);
    }
    all
}
