//! Which lengths, made how long, would close a mechanism that can't be assembled.

use assur_group::Body;
use assur_kinematics::{Chain, Linkage, decompose};
use assur_mechanism::{Key, Mechanism, links_of_length_zero};
use assur_number::search::bisect;
use assur_scene::{Dimension, SceneNumber, Unit};
use assur_structure::Structure;

use crate::Fit;
use crate::number::{like, rounded, step_of, written};
use crate::reach::{MOST_POSITIONS, reaches_all, some_positions};

/// Most answers.
const MOST: usize = 4;

/// The first change that is tried, in parts of the number.
const FIRST: f64 = 0.01;
/// From one change that is tried to the next.
const GROWTH: f64 = 1.35;
/// The greatest change that is tried.
const GREATEST: f64 = 4.0;
/// To this part of the number its limit is found.
const WIDTH: f64 = 1e-4;
/// How far beyond the limit a number is taken, in parts of it: the first that holds.
const MARGINS: [f64; 4] = [0.01, 0.005, 0.002, 0.02];

/// Placements of groups after which a position is taken for possible.
const MOST_PLACED: u32 = 256;

/// A number of a scene with which its mechanism can be assembled.
#[derive(Debug, Clone, PartialEq)]
pub struct Closing {
    /// Its key.
    pub key: Key,
    /// Its present value, m or rad.
    pub from: f64,
    /// Its value with which the mechanism can be assembled, m or rad.
    pub to: f64,
    /// That value as it is written, in the unit of the present one.
    pub toml: String,
    /// Whether the mechanism can then be assembled in all positions, or in the first.
    pub fit: Fit,
}

/// Of a scene that can't be assembled in all its positions: the numbers among these of which a change alone closes it, each with its
/// nearest such value and a margin of 1 %, those that change least first. Numbers of which no value makes more than the first position
/// possible come last.
pub fn closings(text: &str, keys: &[Key]) -> Vec<Closing> {
    let Ok(reading) = assur_scene::reading("", text) else { return Vec::new() };
    let Ok(structure) = decompose(&reading.mechanism) else { return Vec::new() };
    let probe = Probe { size: structure.scale, mechanism: reading.mechanism, structure };
    let now = probe.fit(&probe.mechanism);
    if now == Fit::Everywhere {
        return Vec::new();
    }
    let numbers = keys.iter().filter_map(|key| reading.numbers.iter().find(|number| number.key == *key));
    let mut all: Vec<(f64, Closing)> =
        numbers.filter_map(|number| probe.closing(text, number, now)).collect();
    all.sort_by(|one, other| other.1.fit.cmp(&one.1.fit).then(one.0.total_cmp(&other.0)));
    all.into_iter().take(MOST).map(|(_, closing)| closing).collect()
}

/// A mechanism of which one number is changed.
struct Probe {
    mechanism: Mechanism,
    structure: Structure,
    /// Its size, m.
    size: f64,
}

/// A value that holds, one that does not, and what it does.
#[derive(Clone, Copy)]
struct Found {
    holding: f64,
    failing: f64,
    fit: Fit,
}

impl Probe {
    /// The nearest value of a number that closes, with the relative change.
    fn closing(&self, text: &str, number: &SceneNumber, now: Fit) -> Option<(f64, Closing)> {
        let dimension =
            [Dimension::Length, Dimension::Angle].into_iter().find(|of| number.kinds.contains(of))?;
        let old = written(text, &number.key);
        let (value, unit) = old.first().filter(|_| number.is_free())?;
        let from = Unit::of(unit, dimension).ok()?.si(*value);
        let is_angle = dimension == Dimension::Angle;
        let size = if is_angle { 1.0 } else { from.abs().max(0.25 * self.size) };
        let step = if is_angle { 0.1_f64.to_radians() } else { 0.1 * step_of(self.size) };
        // A length that is a single number keeps its sign.
        let is_length =
            !is_angle && !matches!(number.key.steps().last(), Some(assur_mechanism::Step::Index(_)));
        let fit = |value: f64| {
            let is_turned = is_length && from * value <= 0.0 && from != 0.0;
            if is_turned || !number.admits(value) { Fit::Nowhere } else { self.with(number, value) }
        };
        let Found { holding, failing, fit: goal } = nearest(from, size, now, &fit)?;
        let [limit, _] = bisect(holding, failing, WIDTH * size, |value| fit(value) >= goal);
        let beyond = |margin: f64| {
            let margin = margin * limit.abs().max(0.1 * size);
            rounded_to(limit + margin.copysign(limit - from), step)
        };
        let to = MARGINS.into_iter().map(beyond).find(|value| fit(*value) >= goal)?;
        let closing =
            Closing { key: number.key.clone(), from, to, toml: like(&old, to, dimension), fit: goal };
        Some(((to - from).abs() / size, closing))
    }

    /// How far the mechanism can be assembled with another number.
    fn with(&self, number: &SceneNumber, value: f64) -> Fit {
        let mut mechanism = self.mechanism.clone();
        number.set(&mut mechanism, value);
        self.fit(&mechanism)
    }

    fn fit(&self, mechanism: &Mechanism) -> Fit {
        let Mechanism { links, points, slides, .. } = mechanism;
        if !links_of_length_zero(links.len(), points, slides).is_empty() {
            return Fit::Nowhere;
        }
        let mut structure = self.structure.clone();
        structure.set_geometry(mechanism);
        let most = possible(mechanism, &structure);
        if most == Fit::Nowhere {
            return most;
        }
        let needed = vec![true; structure.groups.len()];
        match Linkage::compile_for(mechanism.clone(), structure, &needed) {
            Ok(linkage) if linkage.range.is_none() => Fit::Nowhere,
            Ok(linkage) if most == Fit::Everywhere && reaches_all(&linkage) => Fit::Everywhere,
            Ok(_) => Fit::Here,
            Err(_) => Fit::Nowhere,
        }
    }
}

/// The smallest change by which more positions are possible; of those that make all possible, if there are any.
fn nearest(from: f64, size: f64, now: Fit, fit: &impl Fn(f64) -> Fit) -> Option<Found> {
    let mut last = [from, from];
    let mut best: Option<Found> = None;
    let mut change = FIRST;
    while change < GREATEST {
        for (failing, side) in last.iter_mut().zip([1.0, -1.0]) {
            let value = from + side * change * size;
            let found = Found { holding: value, failing: *failing, fit: fit(value) };
            if found.fit == Fit::Everywhere {
                return Some(found);
            }
            if found.fit > now && best.is_none() {
                best = Some(found);
            }
            *failing = value;
        }
        change *= GROWTH;
    }
    best
}

/// A number rounded to a multiple of a step of any size.
fn rounded_to(value: f64, step: f64) -> f64 {
    if step < 1e-3 { rounded(value, step) } else { (value / step).round() * step }
}

/// How far a mechanism can be assembled at most: position by position, in whatever modes.
fn possible(mechanism: &Mechanism, structure: &Structure) -> Fit {
    let Ok(chain) = Chain::<f64>::compile(mechanism, structure) else { return Fit::Nowhere };
    let mut bodies = chain.bodies();
    for index in some_positions(&mechanism.input, MOST_POSITIONS) {
        chain.set_input(mechanism.input.coordinate(index), &mut bodies);
        if !is_placed(&chain, structure, 0, &mut bodies, &mut 0) {
            return if index == 0 { Fit::Nowhere } else { Fit::Here };
        }
    }
    Fit::Everywhere
}

/// Whether the groups from one on have some mode each; where that is not known, they have.
fn is_placed(
    chain: &Chain<f64>,
    structure: &Structure,
    group: usize,
    bodies: &mut [Body<f64>],
    placed: &mut u32,
) -> bool {
    let Some(kernel) = chain.groups.get(group) else { return true };
    *placed += 1;
    if structure.groups[group].plugin.iterates || *placed > MOST_PLACED {
        return true;
    }
    (0..kernel.ways()).any(|way| {
        kernel.place(bodies, way).is_ok() && is_placed(chain, structure, group + 1, bodies, placed)
    })
}
