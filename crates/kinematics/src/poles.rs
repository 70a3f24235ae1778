//! Finds where links run to infinity: two guides of a group become parallel without coinciding.

use assur_group::Order;
use assur_number::{elementary, search::least};

use crate::{AssemblyRange, Enclosures, Linkage, Position, samples::SUSPECT};

/// Samples over one turn, or over the range of a sliding input.
const SAMPLES: u32 = 720;

/// Width to which a zero is located, rad or parts of the scale. At this distance from a pole the links are of the
/// order of 1/`NEAR` times the scale away, well beyond `AWAY`.
const NEAR: f64 = 1e-6;
const AWAY: f64 = 1e3;

/// While the determinant is greater than this, no link is as far away.
const CLEAR: f64 = 10.0 / AWAY;

impl Linkage {
    /// Coordinates at which links of a group with a single mode run to infinity, with the index of the group.
    /// Positions can be calculated on both sides, but no real mechanism passes through. Every call searches anew,
    /// over one full turn or the range of a sliding input.
    pub fn poles(&self) -> Vec<(f64, usize)> {
        let suspects: Vec<usize> = (0..self.groups().len())
            .filter(|&i| self.chain.needed[i] && self.groups()[i].ways() == 1)
            .collect();
        let Some(range) = self.range.filter(|_| !suspects.is_empty()) else { return Vec::new() };
        if self.keep_clear(&suspects, &range) {
            return Vec::new();
        }
        let mut position = self.position();
        let step = (range.high - range.low) / f64::from(SAMPLES);
        // One sample more on each side of a full turn, for a zero at the seam.
        let places: Vec<f64> = (-1..=i64::from(SAMPLES) + 1)
            .map(|i| range.low + step * i as f64)
            .filter(|q| range.full || (range.low..=range.high).contains(q))
            .collect();
        let samples: Vec<Vec<f64>> =
            places.iter().map(|q| self.health_at(&suspects, *q, &mut position)).collect();
        let mut found: Vec<(f64, usize)> = Vec::new();
        for (nth, &group) in suspects.iter().enumerate() {
            for (i, three) in samples.windows(3).enumerate() {
                let three = [three[0][nth], three[1][nth], three[2][nth]];
                if three[1] > SUSPECT || three[1] > three[0] || three[1] >= three[2] {
                    continue;
                }
                let health = |q: f64| self.health_at(&[group], q, &mut position)[0];
                let (place, _) = least(places[i], places[i + 2], 90, health);
                // A zero at the seam of a full turn is found at both ends.
                let turn = if range.full { range.high - range.low } else { f64::INFINITY };
                let same = |(other, _): &(f64, usize)| {
                    let apart = (other - place).abs();
                    apart.min((turn - apart).abs()) <= NEAR * self.coordinate_unit()
                };
                if !found.iter().any(same) && self.runs_away(group, place, &mut position) {
                    found.push((place, group));
                }
            }
        }
        found
    }

    /// Whether the closed forms prove over intervals of the coordinate that the determinants of groups stay away from zero.
    fn keep_clear(&self, groups: &[usize], range: &AssemblyRange) -> bool {
        let mut needed = vec![false; self.groups().len()];
        groups.iter().flat_map(|group| self.ancestors(*group)).for_each(|group| needed[group] = true);
        let all = || Enclosures::of(&self.mechanism, &self.structure, &needed, self.ways.at(range.low));
        let ends = [range.low, range.high];
        self.ways.are_constant()
            && all().is_some_and(|mut all| all.keep_clear(ends, CLEAR, |group| groups.contains(&group)))
    }

    fn health_at(&self, groups: &[usize], q: f64, position: &mut Position) -> Vec<f64> {
        let solved = self.solve(q, Order::Place, position).is_ok();
        groups.iter().map(|group| if solved { position.health[*group].abs() } else { 0.0 }).collect()
    }

    /// Whether a link of the group is far away at a small distance from the coordinate.
    fn runs_away(&self, group: usize, q: f64, position: &mut Position) -> bool {
        if self.solve(q + NEAR * self.coordinate_unit(), Order::Place, position).is_err() {
            return false;
        }
        let links = &self.structure.groups[group].frame.links;
        let far = |&link: &usize| {
            elementary::hypot(position.bodies[link].x, position.bodies[link].y) > AWAY * self.structure.scale
        };
        links.iter().any(far)
    }
}
