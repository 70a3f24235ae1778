//! Finds what the motion does around every change point of a mechanism.

use assur_group::Order;
use assur_mechanism::{InputPair, Mechanism};
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::Chain;
use crate::assembly::Ways;
use crate::patch::{Meeting, Patch, Solved};
use crate::seeds::Seeds;
use crate::wide::Wide;

/// A patch for each group around each of its change points, where the surroundings can be solved.
pub(crate) fn patches(
    mechanism: &Mechanism,
    structure: &Structure,
    (chain, wide): (&Chain<f64>, Option<&Wide>),
    ways: &Ways,
    seeds: Option<&Seeds>,
) -> Vec<Patch> {
    let Some(wide) = wide.filter(|_| !ways.changes.is_empty()) else { return Vec::new() };
    let around = Around { chain, extended: &wide.chain, ways, seeds };
    let unit = if matches!(mechanism.input.pair, InputPair::Pin(_)) { 1.0 } else { structure.scale };
    let turns = ways.period.map(|period| period / std::f64::consts::TAU);
    let sample = |&(center, group): &(f64, usize)| {
        let (links, needed) = (&structure.groups[group].frame.links, ancestors(structure, group));
        let meeting = Meeting { center, group, links, turns };
        Patch::sample(meeting, unit, |q| around.solve(q, group, &needed))
    };
    ways.changes.iter().filter_map(sample).collect()
}

/// The groups whose links determine the motion of a group, in solving order, itself last.
pub(crate) fn ancestors(structure: &Structure, group: usize) -> Vec<usize> {
    let mut owner = vec![None; structure.links];
    let mut needed = vec![false; group + 1];
    for (index, found) in structure.groups[..=group].iter().enumerate() {
        found.frame.links.iter().for_each(|&link| owner[link] = Some(index));
    }
    needed[group] = true;
    for index in (0..=group).rev() {
        if needed[index] {
            let ends = structure.groups[index].frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
            ends.filter_map(|end| owner[end]).for_each(|found| needed[found] = true);
        }
    }
    (0..=group).filter(|&index| needed[index]).collect()
}

/// Solves the surroundings of change points in 32 digits.
struct Around<'a> {
    chain: &'a Chain<f64>,
    extended: &'a Chain<Dd>,
    ways: &'a Ways,
    seeds: Option<&'a Seeds>,
}

impl Around<'_> {
    /// A group, with those that determine its motion. No others are solved, so that the numbers of a group are the same
    /// whatever else is needed.
    fn solve(&self, q: Dd, group: usize, needed: &[usize]) -> Option<Solved> {
        let mut guess = self.chain.bodies();
        if let Some(seeds) = self.seeds {
            seeds.put(q.to_f64(), &mut guess);
        }
        let mut bodies: Vec<_> = guess.iter().map(|body| body.map(Dd::from_f64)).collect();
        self.extended.set_input(q, &mut bodies);
        let ways = self.ways.at(q.to_f64());
        let mut health = Dd::ZERO;
        for &index in needed {
            let kernel = &self.extended.groups[index];
            health = kernel.solve(&mut bodies, usize::from(ways[index]), Order::Second).ok()?;
        }
        let links = self.extended.groups[group].frame().links.iter();
        Some((links.map(|link| bodies[*link]).collect(), health))
    }
}
