//! Finds what the motion does around every change point of a mechanism.

use assur_group::{Body, Order};
use assur_mechanism::{InputPair, Mechanism};
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::Chain;
use crate::assembly::Ways;
use crate::patch::Patch;
use crate::seeds::Seeds;

/// A patch around each change point whose surroundings can be solved.
pub(crate) fn patches(
    mechanism: &Mechanism,
    structure: &Structure,
    chain: &Chain<f64>,
    ways: &Ways,
    seeds: Option<&Seeds>,
) -> Vec<Patch> {
    let mut centers: Vec<(f64, Vec<usize>)> = Vec::new();
    for &(q, group) in &ways.changes {
        match centers.last_mut() {
            Some((last, groups)) if (*last - q).abs() <= 1e-6 => groups.push(group),
            _ => centers.push((q, vec![group])),
        }
    }
    if centers.is_empty() {
        return Vec::new();
    }
    let Ok(mut extended) = Chain::<Dd>::compile(mechanism, structure) else { return Vec::new() };
    let needed: Vec<bool> = (0..structure.groups.len()).map(|group| chain.is_needed(group)).collect();
    extended.limit_to(&needed);
    let solve = |q: Dd| {
        let mut guess = chain.bodies();
        if let Some(seeds) = seeds {
            seeds.put(q.to_f64(), &mut guess);
        }
        let mut bodies: Vec<_> = guess.iter().map(lifted).collect();
        let mut health = vec![Dd::ZERO; extended.groups.len()];
        let solved = extended.solve(q, ways.at(q.to_f64()), Order::Second, &mut bodies, &mut health);
        solved.ok().map(|()| (bodies, health))
    };
    let unit = if matches!(mechanism.input.pair, InputPair::Pin(_)) { 1.0 } else { structure.scale };
    let turns = ways.period.map(|period| period / std::f64::consts::TAU);
    let sample = |(center, groups): &(f64, Vec<usize>)| Patch::sample((*center, groups), turns, unit, solve);
    centers.iter().filter_map(sample).collect()
}

/// The same numbers in 32 digits.
fn lifted(body: &Body<f64>) -> Body<Dd> {
    let Body { x, y, c, s, x1, y1, w1, x2, y2, w2 } = *body;
    let [x, y, c, s, x1, y1, w1, x2, y2, w2] = [x, y, c, s, x1, y1, w1, x2, y2, w2].map(Dd::from_f64);
    Body { x, y, c, s, x1, y1, w1, x2, y2, w2 }
}
