//! The results of the analysis besides the transfer functions: rates, reduction, reactions, checks, motion over time.

use assur_analysis::results::{Analysis, Check, PositionResult, Rates};

use super::plans::Planner;
use super::series::{Series, greatest};

/// A force this small compared with the greatest one of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// The results of one analysis, with its series.
#[derive(Debug)]
pub(crate) struct Found {
    /// Name of the force analyzer.
    pub(crate) analyzer: String,
    pub(crate) analysis: Analysis,
    /// Empty until the checks are done.
    pub(crate) checks: Vec<Check>,
    /// All its series over the positions.
    pub(crate) series: Vec<Series>,
    /// Reactions, and the balancing load as the last.
    pub(crate) reactions: Vec<Reaction>,
    /// Plans of any position.
    pub(crate) plans: Planner,
    /// Greatest velocity (m/s) and acceleration (m/s²) of a point; `None` if the positions have none.
    pub(crate) fastest: Option<[f64; 2]>,
    /// Indices in `series` of the content of the motion view.
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

impl Reaction {
    /// `A on crank`, `balancing load`.
    pub(crate) fn name(&self) -> String {
        if self.pair.is_empty() { BALANCING.to_owned() } else { format!("{} on {}", self.pair, self.link) }
    }

    /// Whether it is the force of the same pair on the same link.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.pair == other.pair && self.link == other.link
    }
}

const BALANCING: &str = "balancing load";

impl Found {
    /// Gathers the series of an analysis.
    pub(crate) fn of(analyzer: String, analysis: Analysis, plans: Planner, positions: usize) -> Self {
        let mut gather = Gather { analysis: &analysis, positions, series: Vec::new() };
        let motion = gather.motion();
        gather.rates();
        let reactions = gather.reactions();
        let series = gather.series;
        let fastest = fastest(&analysis);
        Self { analyzer, checks: Vec::new(), series, reactions, plans, fastest, motion, analysis }
    }

    /// The results of a position; `None` where it does not exist.
    pub(crate) fn position(&self, index: usize) -> Option<&PositionResult> {
        let positions = &self.analysis.positions;
        positions.binary_search_by_key(&index, |position| position.index).ok().map(|at| &positions[at])
    }

    /// The balancing load over the positions.
    pub(crate) fn balancing(&self) -> Option<&Series> {
        let balancing = self.reactions.iter().find(|reaction| reaction.pair.is_empty())?;
        self.series.get(*balancing.series.first()?)
    }
}

/// Series that are being collected from the positions of an analysis.
struct Gather<'a> {
    analysis: &'a Analysis,
    positions: usize,
    series: Vec<Series>,
}

impl Gather<'_> {
    /// Adds a series if any position has it, and returns its index.
    fn add(
        &mut self,
        of: String,
        short: String,
        unit: &str,
        read: impl Fn(&PositionResult) -> Option<f64>,
    ) -> Option<usize> {
        let mut values = vec![f64::NAN; self.positions];
        for position in &self.analysis.positions {
            if let (Some(value), Some(slot)) = (read(position), values.get_mut(position.index)) {
                *slot = value;
            }
        }
        if values.iter().all(|value| value.is_nan()) {
            return None;
        }
        self.series.push(Series { of, short, unit: unit.to_owned(), values, floor: 0.0 });
        Some(self.series.len() - 1)
    }

    /// Speed and acceleration of the input, reduced inertia and moment.
    fn motion(&mut self) -> Vec<usize> {
        type Read = fn(&PositionResult) -> Option<f64>;
        let [speed, acceleration, inertia, derivative, moment] = if self.analysis.input.angular {
            ["rad/s", "rad/s2", "kg m2", "kg m2/rad", "N m"]
        } else {
            ["m/s", "m/s2", "kg", "kg/m", "N"]
        };
        let all: [(&str, &str, &str, Read); 5] = [
            ("input speed", "w", speed, |p| p.speed),
            ("input acceleration", "e", acceleration, |p| p.acceleration),
            ("reduced inertia J", "J", inertia, |p| p.reduced.map(|r| r.inertia)),
            ("derivative J'", "J'", derivative, |p| p.reduced.map(|r| r.inertia_derivative)),
            ("reduced moment Q", "Q", moment, |p| p.reduced.map(|r| r.moment)),
        ];
        all.into_iter()
            .filter_map(|(of, short, unit, read)| self.add(of.into(), short.into(), unit, read))
            .collect()
    }

    /// Velocities and accelerations of points and links.
    fn rates(&mut self) {
        let Some(first) = self.analysis.positions.first() else { return };
        for (order, linear, angular) in
            [(1, ("v", "m/s"), ("w", "rad/s")), (2, ("a", "m/s2"), ("e", "rad/s2"))]
        {
            let Some(rates) = rates_of(first, order) else { continue };
            for (point, _) in rates.points.iter() {
                for (axis, letter) in ["x", "y"].into_iter().enumerate() {
                    let read = |p: &PositionResult| rates_of(p, order)?.points.get(point).map(|v| v[axis]);
                    let name = format!("{}{letter}", linear.0);
                    self.add(format!("point {point} {name}"), format!("{point}.{name}"), linear.1, read);
                }
            }
            for (link, _) in rates.links.iter() {
                let read = |p: &PositionResult| rates_of(p, order)?.links.get(link).copied();
                let name = angular.0;
                self.add(format!("link {link} {name}"), format!("{link}.{name}"), angular.1, read);
            }
        }
    }

    /// Force and moment of every pair, then the balancing load.
    fn reactions(&mut self) -> Vec<Reaction> {
        let (mut found, analysis) = (Vec::new(), self.analysis);
        for (pair, link) in pairs(analysis) {
            let force = |p: &PositionResult| {
                let forces = &p.reactions.as_ref()?.get(&pair)?.forces;
                forces.iter().find(|(name, _)| **name == *link).map(|(_, force)| *force)
            };
            let of = |what: &str| format!("{pair} on {link} {what}");
            let short = |what: &str| format!("{pair}>{link}.{what}");
            let mut series = Vec::new();
            series.extend(self.add(of("Fx"), short("Fx"), "N", |p| force(p).map(|f| f[0])));
            series.extend(self.add(of("Fy"), short("Fy"), "N", |p| force(p).map(|f| f[1])));
            series.extend(self.add(of("F"), short("F"), "N", |p| force(p).map(|f| f[0].hypot(f[1]))));
            let moment = |p: &PositionResult| p.reactions.as_ref()?.get(&pair)?.moment;
            let moment = self.add(of("M"), short("M"), "N m", moment);
            if series.len() == 3 {
                found.push(Reaction { pair, link, series, moment });
            }
        }
        self.mark_rounding(&found);
        let unit = if analysis.input.balancing_is_moment { "N m" } else { "N" };
        if let Some(index) = self.add(BALANCING.into(), "balancing".into(), unit, |p| p.balancing) {
            let (pair, link) = (String::new(), String::new());
            found.push(Reaction { pair, link, series: vec![index], moment: None });
        }
        found
    }

    /// Sets the limit below which forces of the pairs count as zero.
    fn mark_rounding(&mut self, reactions: &[Reaction]) {
        let forces = || reactions.iter().flat_map(|reaction| &reaction.series).copied();
        let floor = ROUNDING * greatest(forces().flat_map(|index| &self.series[index].values));
        forces().for_each(|index| self.series[index].floor = floor);
    }
}

/// Velocities (order 1) or accelerations (order 2) of a position.
pub(crate) fn rates_of(position: &PositionResult, order: usize) -> Option<&Rates> {
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

/// Pairs and links: of a pair of two links one, because the other force is opposite; of a multiple joint all.
fn pairs(analysis: &Analysis) -> Vec<(String, String)> {
    let reactions = analysis.positions.iter().find_map(|position| position.reactions.as_ref());
    let mut pairs = Vec::new();
    for (pair, reaction) in reactions.iter().flat_map(|reactions| reactions.iter()) {
        // The force on a moving link is more informative than the one on the ground.
        let moving = reaction.forces.iter().filter(|(link, _)| &**link != "ground");
        let count = if reaction.forces.len() > 2 { usize::MAX } else { 1 };
        pairs.extend(moving.take(count).map(|(link, _)| (pair.to_owned(), link.to_string())));
    }
    pairs
}
