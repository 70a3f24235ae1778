//! One direction of a walk: every group at every sample, the minima of its determinant, and where it ends.

use assur_group::{Body, GroupError};

use crate::ChainError;
use crate::meeting::{Judge, Minimum, least_between};
use crate::walk::Walker;
use crate::wide::needed_ways;

/// Coordinates nearer than this are one, in units of the last place.
const HAIR: f64 = 8.0 * f64::EPSILON;

/// A local minimum of the determinant above this can't be the foot of a meeting between two samples.
const SUSPECT: f64 = 0.2;

/// One direction of a walk: where it ended, and the changes on the way (distance from the start, group).
pub(crate) struct Leg {
    pub(crate) reached: f64,
    pub(crate) complete: bool,
    pub(crate) changes: Vec<(f64, usize)>,
    /// Groups whose ways meet in the start itself: a leg forth leaves them behind, one back begins with them.
    pub(crate) at_start: Vec<usize>,
    /// Meetings so far: coordinate, and what is left of the squared determinant there.
    pub(crate) left: Vec<(f64, f64)>,
    /// Where it is not complete: the group that ends it, and what it says.
    pub(crate) failure: Option<ChainError>,
    pub(crate) last: Vec<u8>,
    pub(crate) grid: Vec<Vec<Body<f64>>>,
}

/// What the minima of a group's determinant are over a leg.
#[derive(Default)]
struct Minima {
    meetings: Vec<f64>,
    at_start: bool,
    /// Meetings, with what is left of the squared determinant.
    left: Vec<(f64, f64)>,
    /// A gap between two samples: the last sample before it, a coordinate in it, and by how much the group misses.
    gap: Option<(usize, f64, f64)>,
}

impl Walker<'_> {
    /// Walks `length` from the start in equal steps, group after group.
    pub(crate) fn leg(&mut self, from: f64, length: f64, samples: usize, first: &[u8], back: bool) -> Leg {
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
            at_start: Vec::new(),
            left: Vec::new(),
            failure: None,
            last: first.to_vec(),
            grid: Vec::new(),
        };
        for group in (0..self.groups).filter(|group| self.chain.is_needed(*group)) {
            let (mut health, mut failure) = self.healths(group, first[group], &mut grid);
            let mut minima = self.minima(group, &at, &health, &leg, first);
            if minima.at_start {
                leg.at_start.push(group);
                if back {
                    minima.meetings.insert(0, from);
                }
            }
            let mut bad = at(health.len());
            if let Some((last, inside, gap_m)) = minima.gap {
                health.truncate(last + 1);
                (bad, failure) = (inside, Some(GroupError::NoAssembly { gap_m }));
            }
            self.replace(group, first[group], &at, &minima.meetings, &mut grid);
            if health.len() < grid.len() {
                let good = health.len().saturating_sub(1);
                let end = self.end(group, (at(good), bad), &grid[good], &leg, first, from);
                leg.complete = false;
                leg.reached = end - from;
                leg.failure = failure.map(|source| ChainError { group, source });
                grid.truncate(health.len());
            }
            leg.left.append(&mut minima.left);
            leg.changes.extend(minima.meetings.iter().map(|q| (q - from, group)));
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
    fn healths(&self, group: usize, way: u8, grid: &mut [Vec<Body<f64>>]) -> (Vec<f64>, Option<GroupError>) {
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
                Err(GroupError::Singular { .. }) => health.push(0.0),
                Err(failure) => return (health, Some(failure)),
            }
        }
        (health, None)
    }

    /// Where two ways of a group meet (its determinant touches zero), up to the first gap between two samples.
    fn minima(
        &self,
        group: usize,
        at: &impl Fn(usize) -> f64,
        health: &[f64],
        leg: &Leg,
        first: &[u8],
    ) -> Minima {
        let mut found = Minima::default();
        if self.chain.groups[group].ways() != 2 {
            return found;
        }
        let (start, last) = (at(0), health.len().saturating_sub(1));
        let reached = (at(last) - start).abs();
        let hair = HAIR * self.unit.max(at(last).abs()).max(start.abs());
        for i in 0..health.len() {
            let before = if i > 0 { health[i - 1] } else { f64::INFINITY };
            let after = health.get(i + 1).copied().unwrap_or(f64::INFINITY);
            if health[i] > before || health[i] >= after || health[i] > SUSPECT {
                continue;
            }
            let (low, high) = (at(i.saturating_sub(1)), at((i + 1).min(last)));
            match self.minimum(group, low, high, (leg, first), start) {
                Minimum::Beside => {}
                Minimum::Gap(inside, gap_m) => {
                    let way = (inside - start) * (at(last) - start).signum();
                    let before = (0..=last).rev().find(|k| (at(*k) - start).abs() < way);
                    if let (Some(before), true) = (before, way <= reached) {
                        found.gap = Some((before, inside, gap_m));
                        return found;
                    }
                }
                // The first position itself may be a meeting; beyond the end another leg will find it.
                Minimum::Meeting(place, left) => {
                    let way = (place - start) * (at(last) - start).signum();
                    found.left.push((place, left));
                    if way.abs() <= hair {
                        found.at_start = true;
                    } else if way > 0.0
                        && way <= reached + hair
                        && found.meetings.last().is_none_or(|last| (last - place).abs() > 1e-6 * self.unit)
                    {
                        found.meetings.push(place);
                    }
                }
            }
        }
        found
    }

    /// What the minimum of a determinant between two coordinates is.
    fn minimum(&self, group: usize, low: f64, high: f64, (leg, first): (&Leg, &[u8]), from: f64) -> Minimum {
        let (place, least) = least_between(low, high, |q| {
            let mut bodies = self.start.clone();
            // Where it does not assemble, or is singular, the determinant is 0.
            self.health_at(group, q, (leg, first), from, &mut bodies).unwrap_or(0.0)
        });
        let ways = |q: f64| {
            let mut ways = needed_ways(self.chain, |i| way_at(i, q, leg, first, from));
            ways.truncate(group + 1);
            ways
        };
        let Some(wide) = self.wide else { return Minimum::Beside };
        let mut bodies = self.start.clone();
        // Where it does not assemble, the links stand as before: near enough for what follows.
        let _ = self.health_at(group, place, (leg, first), from, &mut bodies);
        let judge = Judge {
            wide,
            bodies: &bodies,
            ways: &ways,
            sample: 0.5 * (high - low).abs(),
            resolution: self.chain.groups[group].resolution(&bodies),
            before: &leg.left,
        };
        judge.judge(place, least)
    }

    /// Determinant of a group at any coordinate, the groups before it in their known ways.
    fn health_at(
        &self,
        group: usize,
        q: f64,
        (leg, first): (&Leg, &[u8]),
        from: f64,
        bodies: &mut [Body<f64>],
    ) -> Result<f64, GroupError> {
        self.chain.set_input(q, bodies);
        let mut health = 0.0;
        for (i, kernel) in self.chain.groups.iter().enumerate().take(group + 1) {
            if self.chain.is_needed(i) {
                let way = way_at(i, q, leg, first, from);
                health = kernel.place(bodies, way.min(kernel.ways() - 1))?;
            }
        }
        Ok(health.abs())
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

    /// Where a group stops assembling, by bisection between a coordinate where it does and one where it does not.
    fn end(
        &self,
        group: usize,
        (mut good, mut bad): (f64, f64),
        near: &[Body<f64>],
        leg: &Leg,
        first: &[u8],
        from: f64,
    ) -> f64 {
        for _ in 0..60 {
            let middle = 0.5 * (good + bad);
            let mut bodies = near.to_vec();
            if self.health_at(group, middle, (leg, first), from, &mut bodies).is_ok() {
                good = middle;
            } else {
                bad = middle;
            }
        }
        good
    }
}

impl Leg {
    /// Of a full turn: what meets in the start meets in the end again, and is counted there, once.
    pub(crate) fn close(&mut self, length: f64) {
        let hair = 16.0 * HAIR * (length.abs() + 1.0);
        for group in std::mem::take(&mut self.at_start) {
            let counted = self
                .changes
                .iter()
                .any(|(d, other)| *other == group && (d.abs() - length.abs()).abs() <= hair);
            if !counted {
                self.changes.push((length, group));
                self.last[group] = 1 - self.last[group];
            }
        }
    }
}

/// Way of a group at a coordinate of a leg.
fn way_at(group: usize, q: f64, leg: &Leg, first: &[u8], from: f64) -> usize {
    let flips = leg.changes.iter().filter(|(d, g)| *g == group && d.abs() < (q - from).abs()).count();
    usize::from(first[group]) ^ (flips & 1)
}
