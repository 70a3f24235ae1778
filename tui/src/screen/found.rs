//! What the analysis found, beside the transfer functions: rates, reduction, reactions, checks, course over time.

use assur_analysis::results::{Analysis, Check, PositionResult};

use super::plans::Planner;
use super::series::Series;
use super::text::{ENGLISH, fill};

/// The results of one analysis, with the series made of them.
#[derive(Debug)]
pub(crate) struct Found {
    /// Name of the force analyzer.
    pub(crate) analyzer: String,
    pub(crate) analysis: Analysis,
    /// Empty until they are done.
    pub(crate) checks: Vec<Check>,
    /// All its series over the positions.
    pub(crate) series: Vec<Series>,
    /// Reactions, and the balancing load as the last.
    pub(crate) reactions: Vec<Reaction>,
    /// Plans of any position.
    pub(crate) plans: Planner,
    /// Greatest velocity (m/s) and acceleration (m/s²) of a point; `None` where the positions have none.
    pub(crate) fastest: Option<[f64; 2]>,
    /// Indices in `series` of what the motion view shows.
    pub(crate) motion: Vec<usize>,
}

/// The force that a pair exerts on one link, as indices of series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Reaction {
    /// The pin or slide; empty for the balancing load.
    pub(crate) pair: String,
    /// The link on which it acts.
    pub(crate) link: String,
    /// Fx, Fy, modulus; for the balancing load its one series.
    pub(crate) series: Vec<usize>,
    /// Moment of a slide.
    pub(crate) moment: Option<usize>,
}

impl Found {
    /// Gathers the series of an analysis.
    pub(crate) fn of(analyzer: String, analysis: Analysis, plans: Planner, positions: usize) -> Self {
        let (series, reactions, motion, checks) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let fastest = fastest(&analysis);
        let mut found = Self { analyzer, analysis, checks, series, reactions, plans, fastest, motion };
        let gather = Gather { positions };
        gather.motion(&mut found);
        gather.rates(&mut found);
        gather.reactions(&mut found);
        found.mark_rounding();
        found
    }

    /// Forces that are rounding beside the largest force of the mechanism.
    fn mark_rounding(&mut self) {
        let forces: Vec<usize> =
            self.reactions.iter().filter_map(|r| r.series.get(..3)).flatten().copied().collect();
        let values = forces.iter().flat_map(|index| &self.series[*index].values);
        let most =
            values.filter(|value| value.is_finite()).fold(0.0_f64, |most, value| most.max(value.abs()));
        for index in forces {
            self.series[index].floor = 1e-13 * most;
        }
    }

    /// The results of a position; `None` where it does not exist.
    pub(crate) fn position(&self, index: usize) -> Option<&PositionResult> {
        let positions = &self.analysis.positions;
        positions.binary_search_by_key(&index, |position| position.index).ok().map(|at| &positions[at])
    }

    /// Whether there are forces to show.
    pub(crate) fn has_forces(&self) -> bool {
        !self.reactions.is_empty()
    }
}

struct Gather {
    positions: usize,
}

type Read<'a> = &'a dyn Fn(&PositionResult) -> Option<f64>;

impl Gather {
    /// Adds a series if any position has it; gives its index.
    fn add(&self, found: &mut Found, of: String, short: String, unit: &str, read: Read<'_>) -> Option<usize> {
        let mut values = vec![f64::NAN; self.positions];
        for position in &found.analysis.positions {
            if let (Some(value), Some(slot)) = (read(position), values.get_mut(position.index)) {
                *slot = value;
            }
        }
        if values.iter().all(|value| value.is_nan()) {
            return None;
        }
        found.series.push(Series { of, short, unit: unit.to_owned(), values, floor: 0.0 });
        Some(found.series.len() - 1)
    }

    fn motion(&self, found: &mut Found) {
        let angular = found.analysis.input.angular;
        let [speed, acceleration] = if angular { ["rad/s", "rad/s2"] } else { ["m/s", "m/s2"] };
        let [inertia, derivative] = if angular { ["kg m2", "kg m2/rad"] } else { ["kg", "kg/m"] };
        let moment = if angular { "N m" } else { "N" };
        let t = &ENGLISH;
        let all: [(&str, &str, &str, Read<'_>); 5] = [
            (t.input_speed, "w", speed, &|p| p.speed),
            (t.input_acceleration, "e", acceleration, &|p| p.acceleration),
            (t.reduced_inertia, "J", inertia, &|p| p.reduced.map(|r| r.inertia)),
            (t.inertia_derivative, "J'", derivative, &|p| p.reduced.map(|r| r.inertia_derivative)),
            (t.reduced_moment, "Q", moment, &|p| p.reduced.map(|r| r.moment)),
        ];
        for (of, short, unit, read) in all {
            let index = self.add(found, of.into(), short.into(), unit, read);
            found.motion.extend(index);
        }
    }

    fn rates(&self, found: &mut Found) {
        let Some(first) = found.analysis.positions.first().cloned() else { return };
        let names = |order: usize| {
            let rates = if order == 1 { &first.velocities } else { &first.accelerations };
            let of = |named: Vec<&str>| named.into_iter().map(str::to_owned).collect::<Vec<_>>();
            rates.as_ref().map(|rates| {
                (
                    of(rates.links.iter().map(|r| r.0).collect()),
                    of(rates.points.iter().map(|r| r.0).collect()),
                )
            })
        };
        for (order, linear, angular) in
            [(1, ("v", "m/s"), ("w", "rad/s")), (2, ("a", "m/s2"), ("e", "rad/s2"))]
        {
            let Some((links, points)) = names(order) else { continue };
            for point in points {
                for (axis, letter) in ["x", "y"].into_iter().enumerate() {
                    let of = format!("{} {}{letter}", fill(ENGLISH.point_of, &[&point]), linear.0);
                    let short = format!("{point}.{}{letter}", linear.0);
                    let read = |p: &PositionResult| rates_of(p, order)?.points.get(&point).map(|v| v[axis]);
                    let _ = self.add(found, of, short, linear.1, &read);
                }
            }
            for link in links {
                let of = format!("{} {}", fill(ENGLISH.link_of, &[&link]), angular.0);
                let short = format!("{link}.{}", angular.0);
                let read = |p: &PositionResult| rates_of(p, order)?.links.get(&link).copied();
                let _ = self.add(found, of, short, angular.1, &read);
            }
        }
    }

    fn reactions(&self, found: &mut Found) {
        for (pair, link) in pairs(&found.analysis) {
            let force = |p: &PositionResult| {
                let forces = &p.reactions.as_ref()?.get(&pair)?.forces;
                forces.iter().find(|(name, _)| **name == *link).map(|(_, force)| *force)
            };
            let of = |what: &str| format!("{} {what}", fill(ENGLISH.pair_on, &[&pair, &link]));
            let short = |what: &str| format!("{pair}>{link}.{what}");
            let mut series = Vec::new();
            series.extend(self.add(found, of("Fx"), short("Fx"), "N", &|p| force(p).map(|f| f[0])));
            series.extend(self.add(found, of("Fy"), short("Fy"), "N", &|p| force(p).map(|f| f[1])));
            series.extend(self.add(found, of("F"), short("F"), "N", &|p| force(p).map(|f| f[0].hypot(f[1]))));
            let moment = |p: &PositionResult| p.reactions.as_ref()?.get(&pair)?.moment;
            let moment = self.add(found, of("M"), short("M"), "N m", &moment);
            if series.len() == 3 {
                found.reactions.push(Reaction { pair, link, series, moment });
            }
        }
        let unit = if found.analysis.input.balancing_is_moment { "N m" } else { "N" };
        let balancing =
            self.add(found, ENGLISH.balancing.into(), ENGLISH.balancing_column.into(), unit, &|p| {
                p.balancing
            });
        if let Some(index) = balancing {
            let (pair, link) = (String::new(), String::new());
            found.reactions.push(Reaction { pair, link, series: vec![index], moment: None });
        }
    }
}

pub(crate) fn rates_of(position: &PositionResult, order: usize) -> Option<&assur_analysis::results::Rates> {
    if order == 1 { position.velocities.as_ref() } else { position.accelerations.as_ref() }
}

/// Greatest velocity and acceleration of a point.
fn fastest(analysis: &Analysis) -> Option<[f64; 2]> {
    let most = |order: usize| {
        let rates = analysis.positions.iter().filter_map(|position| rates_of(position, order));
        let sizes = rates.flat_map(|rates| rates.points.iter().map(|(_, v)| v[0].hypot(v[1])));
        sizes.filter(|size| size.is_finite()).reduce(f64::max)
    };
    Some([most(1)?, most(2)?])
}

/// Pairs and links: of a pair of two links one, since the other force is the opposite one; of a multiple joint all.
fn pairs(analysis: &Analysis) -> Vec<(String, String)> {
    let Some(reactions) = analysis.positions.iter().find_map(|p| p.reactions.as_ref()) else {
        return Vec::new();
    };
    let mut pairs = Vec::new();
    for (pair, reaction) in reactions.iter() {
        // The force on a moving link says more than the one on the ground.
        let moving = reaction.forces.iter().filter(|(link, _)| &**link != "ground");
        let count = if reaction.forces.len() > 2 { usize::MAX } else { 1 };
        pairs.extend(moving.take(count).map(|(link, _)| (pair.to_owned(), link.to_string())));
    }
    pairs
}
