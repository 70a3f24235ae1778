//! One walk over the cycle that finds where ways meet and where the mechanism ends.

use assur_group::{AssurGroup, Body, GroupError, Order};
use assur_mechanism::{InputPair, Mechanism};
use assur_structure::Structure;

use crate::assembly::Ways;
use crate::first::first_ways;
use crate::patch::Patch;
use crate::patches::patches;
use crate::seeds::{Seeds, iterated};
use crate::{Chain, ChainError, Range};

/// Samples over one turn (or over the range of a sliding input).
const SAMPLES: usize = 720;

/// Two ways meet where the dimensionless determinant falls below this: it is the square root of a length's rounding.
const MEETING: f64 = 2e-7;

/// A local minimum of the determinant above this can't be the foot of a meeting between two samples.
const SUSPECT: f64 = 0.2;

/// Longest motion that is walked before ways must repeat, in periods.
const MOST_PERIODS: usize = 4;

/// What a walk found.
#[derive(Debug)]
pub(crate) struct Walked {
    pub(crate) ways: Ways,
    pub(crate) range: Option<Range>,
    pub(crate) failure: Option<ChainError>,
    pub(crate) patches: Vec<Patch>,
    pub(crate) seeds: Option<Seeds>,
}

/// Chooses the assembly of the first position and follows it.
pub(crate) fn walk(mechanism: &Mechanism, structure: &Structure, chain: &Chain<f64>) -> Walked {
    let from = mechanism.input.from;
    let (first, start) = match first_ways(mechanism, structure, chain) {
        Ok(found) => found,
        Err((ways, failure)) => {
            let ways = Ways { low: from, period: None, changes: Vec::new(), rows: vec![ways] };
            return Walked { ways, range: None, failure: Some(failure), patches: Vec::new(), seeds: None };
        }
    };
    let iterated = iterated(structure);
    let mut walker = Walker { chain, groups: chain.groups.len(), start, iterated };
    let (ways, range, seeds) = match mechanism.input.pair {
        InputPair::Pin(_) => walker.turn(from, &first),
        InputPair::Slide(_) => walker.slide(mechanism, structure.scale, &first),
    };
    let patches = patches(mechanism, structure, chain, &ways, seeds.as_ref());
    Walked { ways, range: Some(range), failure: None, patches, seeds }
}

struct Walker<'a> {
    chain: &'a Chain<f64>,
    groups: usize,
    /// The links in the first position: where kinds that iterate begin.
    start: Vec<Body<f64>>,
    /// Links of such kinds.
    iterated: Vec<usize>,
}

/// One direction of a walk: where it ended, and the changes on the way (distance from the start, group).
struct Leg {
    reached: f64,
    complete: bool,
    changes: Vec<(f64, usize)>,
    last: Vec<u8>,
    grid: Vec<Vec<Body<f64>>>,
}

impl Walker<'_> {
    /// A pinned input: a full turn if it can, else both ways to where it ends.
    fn turn(&mut self, from: f64, first: &[u8]) -> (Ways, Range, Option<Seeds>) {
        let period = std::f64::consts::TAU;
        let mut periods = 1;
        loop {
            let length = period * periods as f64;
            let leg = self.leg(from, length, SAMPLES * periods, first);
            if !leg.complete {
                let back = self.leg(from, -length, SAMPLES * periods, first);
                let (ways, range) = joined(from, &leg, &back, first);
                return (ways, range, self.seeds(from, period / SAMPLES as f64, &leg, &back));
            }
            // With an odd number of meetings the mechanism comes back to the other assembly: its true cycle is longer.
            if leg.last == first || periods == MOST_PERIODS {
                let range = Range { low: from, high: from + period, full: true };
                let rows = rows_of(first, &leg.changes);
                let seeds = Seeds::keep(&self.iterated, from, period / SAMPLES as f64, true, &leg.grid);
                let changes = leg.changes.into_iter().map(|(d, group)| (from + d, group)).collect();
                return (Ways { low: from, period: Some(length), changes, rows }, range, seeds);
            }
            periods *= 2;
        }
    }

    /// A sliding input: over the range of the scene, and as far again on both sides (the reader wants to know where the
    /// mechanism ends).
    fn slide(&mut self, mechanism: &Mechanism, scale: f64, first: &[u8]) -> (Ways, Range, Option<Seeds>) {
        let from = mechanism.input.from;
        let last = mechanism.input.coordinate(mechanism.input.positions.saturating_sub(1));
        let length = 4.0 * scale.max((last - from).abs());
        let forth = self.leg(from, length, 4 * SAMPLES, first);
        let back = self.leg(from, -length, 4 * SAMPLES, first);
        let (ways, range) = joined(from, &forth, &back, first);
        (ways, range, self.seeds(from, length / (4 * SAMPLES) as f64, &forth, &back))
    }

    /// Both legs as one row of samples.
    fn seeds(&self, from: f64, step: f64, forth: &Leg, back: &Leg) -> Option<Seeds> {
        let before = back.grid.len().saturating_sub(1);
        let grid: Vec<_> = back.grid.iter().skip(1).rev().chain(&forth.grid).cloned().collect();
        Seeds::keep(&self.iterated, from - before as f64 * step, step, false, &grid)
    }

    /// Walks `length` from the start in equal steps, group after group.
    fn leg(&mut self, from: f64, length: f64, samples: usize, first: &[u8]) -> Leg {
        let at = |i: usize| from + length * (i as f64) / (samples as f64);
        let mut grid: Vec<Vec<Body<f64>>> = Vec::with_capacity(samples + 1);
        for i in 0..=samples {
            let mut bodies = self.start.clone();
            self.chain.set_input(at(i), &mut bodies);
            grid.push(bodies);
        }
        let mut leg = Leg {
            reached: length,
            complete: true,
            changes: Vec::new(),
            last: first.to_vec(),
            grid: Vec::new(),
        };
        for group in (0..self.groups).filter(|group| self.chain.is_needed(*group)) {
            let health = self.healths(group, first[group], &mut grid);
            let flips = self.meetings(group, &at, &health, &mut leg, first);
            self.replace(group, first[group], &at, &flips, &mut grid);
            if health.len() < grid.len() {
                let near = &grid[health.len().saturating_sub(1)];
                let end = self.end(group, &at, (health.len(), near), &leg, first);
                leg.complete = false;
                leg.reached = end - from;
                grid.truncate(health.len());
            }
            leg.changes.extend(flips.iter().map(|q| (q - from, group)));
            leg.changes.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        }
        let reached = leg.reached.abs();
        leg.changes.retain(|change| change.0.abs() <= reached);
        for (_, group) in &leg.changes {
            leg.last[*group] = 1 - leg.last[*group];
        }
        leg.grid = grid;
        leg
    }

    /// Places one group at every sample in its first way; stops at the first that can't be assembled for good.
    fn healths(&self, group: usize, way: u8, grid: &mut [Vec<Body<f64>>]) -> Vec<f64> {
        let kernel = &self.chain.groups[group];
        let mut health = Vec::with_capacity(grid.len());
        for i in 0..grid.len() {
            // A kind that iterates starts from the sample before.
            if i > 0 {
                for &link in &kernel.frame().links {
                    grid[i][link] = grid[i - 1][link];
                }
            }
            match kernel.place(&mut grid[i], usize::from(way)) {
                Ok(found) => health.push(found.abs()),
                // At a change point itself a group may say "singular": it is passed, not the end.
                Err(GroupError::Singular { .. }) if i > 0 => health.push(0.0),
                Err(_) => break,
            }
        }
        health
    }

    /// Coordinates where two ways of a group meet: the determinant touches zero.
    fn meetings(
        &self,
        group: usize,
        at: &impl Fn(usize) -> f64,
        health: &[f64],
        leg: &mut Leg,
        first: &[u8],
    ) -> Vec<f64> {
        let mut found: Vec<f64> = Vec::new();
        if self.chain.groups[group].ways() != 2 {
            return found;
        }
        for i in 0..health.len() {
            let before = if i > 0 { health[i - 1] } else { f64::INFINITY };
            let after = health.get(i + 1).copied().unwrap_or(f64::INFINITY);
            if health[i] > before || health[i] >= after || health[i] > SUSPECT {
                continue;
            }
            // The first position itself may be a meeting; the leg then begins behind it.
            let (low, high) = (at(i.saturating_sub(1)), at((i + 1).min(health.len() - 1)));
            let (place, least) = self.least_health(group, low, high, leg, first, at(0));
            let start = (place - at(0)).abs() < 1e-9;
            let meets = least < MEETING && self.is_undetermined(group, place, leg, first, at(0));
            if meets && !start && found.last().is_none_or(|last| (last - place).abs() > 1e-6) {
                found.push(place);
            }
        }
        found
    }

    /// Golden-section search for the least determinant of a group.
    fn least_health(
        &self,
        group: usize,
        low: f64,
        high: f64,
        leg: &Leg,
        first: &[u8],
        from: f64,
    ) -> (f64, f64) {
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        let f = |q: f64| self.health_at(group, q, leg, first, from);
        let (mut a, mut b) = (low, high);
        let (mut x, mut y) = (b - ratio * (b - a), a + ratio * (b - a));
        let (mut fx, mut fy) = (f(x), f(y));
        for _ in 0..90 {
            if fx <= fy {
                (b, y, fy) = (y, x, fx);
                x = b - ratio * (b - a);
                fx = f(x);
            } else {
                (a, x, fx) = (x, y, fy);
                y = a + ratio * (b - a);
                fy = f(y);
            }
        }
        if fx <= fy { (x, fx) } else { (y, fy) }
    }

    /// Determinant of a group at any coordinate, the groups before it in their known ways; 0 where it does not assemble.
    fn health_at(&self, group: usize, q: f64, leg: &Leg, first: &[u8], from: f64) -> f64 {
        self.at(group, q, leg, first, from, |kernel, bodies, way| kernel.place(bodies, way)).unwrap_or(0.0)
    }

    /// Whether a group says that it is not determined there: that the rounding of its data may make its ways meet. Ways may
    /// come as close as 1e-9 and pass each other, where the determinant is no root of what the lengths say (pins of a
    /// guide that almost meet). A kind that iterates is not asked, nor a group next to a change point of another one.
    fn is_undetermined(&self, group: usize, q: f64, leg: &Leg, first: &[u8], from: f64) -> bool {
        /// So far from a change point the places of other groups are noise, rad or m.
        const NOISE: f64 = 1e-6;
        if leg.changes.iter().any(|(d, _)| (from + d - q).abs() < NOISE) {
            return true;
        }
        let links = &self.chain.groups[group].frame().links;
        let solved = self
            .at(group, q, leg, first, from, |kernel, bodies, way| kernel.solve(bodies, way, Order::First));
        solved.is_err() || links.iter().any(|link| self.iterated.contains(link))
    }

    /// Asks a group at any coordinate, the groups before it in their known ways.
    fn at(
        &self,
        group: usize,
        q: f64,
        leg: &Leg,
        first: &[u8],
        from: f64,
        ask: impl Fn(&dyn AssurGroup<f64>, &mut [Body<f64>], usize) -> Result<f64, GroupError>,
    ) -> Result<f64, GroupError> {
        let mut bodies = self.start.clone();
        self.chain.set_input(q, &mut bodies);
        let way = |i: usize| {
            let flips = leg.changes.iter().filter(|(d, g)| *g == i && d.abs() < (q - from).abs()).count();
            (usize::from(first[i]) ^ (flips & 1)).min(self.chain.groups[i].ways() - 1)
        };
        for i in (0..group).filter(|i| self.chain.is_needed(*i)) {
            self.chain.groups[i].place(&mut bodies, way(i))?;
        }
        Ok(ask(&*self.chain.groups[group], &mut bodies, way(group))?.abs())
    }

    /// Places a group again behind its meetings, in the other way.
    fn replace(
        &self,
        group: usize,
        way: u8,
        at: &impl Fn(usize) -> f64,
        flips: &[f64],
        grid: &mut [Vec<Body<f64>>],
    ) {
        let start = at(0);
        for (i, bodies) in grid.iter_mut().enumerate() {
            let passed = flips.iter().filter(|q| (**q - start).abs() < (at(i) - start).abs()).count();
            if passed % 2 == 1 {
                // A sample on the meeting itself keeps the place that both ways share.
                let _ = self.chain.groups[group].place(bodies, usize::from(1 - way));
            }
        }
    }

    /// Where a group stops assembling, by bisection between the sample that failed and the one before, with its links.
    fn end(
        &self,
        group: usize,
        at: &impl Fn(usize) -> f64,
        (failed, near): (usize, &[Body<f64>]),
        leg: &Leg,
        first: &[u8],
    ) -> f64 {
        let (mut good, mut bad) = (at(failed.saturating_sub(1)), at(failed));
        for _ in 0..60 {
            let middle = 0.5 * (good + bad);
            if self.assembles(group, (middle, near), leg, first, at(0)) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        good
    }

    fn assembles(
        &self,
        group: usize,
        (q, near): (f64, &[Body<f64>]),
        leg: &Leg,
        first: &[u8],
        from: f64,
    ) -> bool {
        let mut bodies = near.to_vec();
        self.chain.set_input(q, &mut bodies);
        self.chain.groups.iter().enumerate().take(group + 1).all(|(i, kernel)| {
            if !self.chain.is_needed(i) {
                return true;
            }
            let flips = leg.changes.iter().filter(|(d, g)| *g == i && d.abs() < (q - from).abs()).count();
            let way = usize::from(first[i]) ^ (flips & 1);
            kernel.place(&mut bodies, way.min(kernel.ways() - 1)).is_ok()
        })
    }
}

/// Ways in each interval between changes.
fn rows_of(first: &[u8], changes: &[(f64, usize)]) -> Vec<Vec<u8>> {
    let mut rows = vec![first.to_vec()];
    for (_, group) in changes {
        let mut row = rows[rows.len() - 1].clone();
        row[*group] = 1 - row[*group];
        rows.push(row);
    }
    rows
}

/// Two legs from one start as one interval.
fn joined(from: f64, forth: &Leg, back: &Leg, first: &[u8]) -> (Ways, Range) {
    let mut backward: Vec<_> = back.changes.clone();
    backward.sort_by(|a, b| a.0.total_cmp(&b.0));
    let before = back.last.clone();
    let changes: Vec<_> =
        backward.iter().chain(&forth.changes).map(|(d, group)| (from + d, *group)).collect();
    let relative: Vec<_> = changes.clone();
    let rows = if changes.is_empty() { vec![first.to_vec()] } else { rows_of(&before, &relative) };
    let range = Range { low: from + back.reached, high: from + forth.reached, full: false };
    (Ways { low: range.low, period: None, changes, rows }, range)
}
