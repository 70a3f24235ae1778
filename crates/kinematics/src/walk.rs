//! One walk over the cycle that finds where ways meet and where the mechanism ends.

use assur_group::{Body, GroupError};
use assur_mechanism::{InputPair, Mechanism};
use assur_structure::Structure;

use crate::assembly::{Ways, rows_of};
use crate::first::first_ways;
use crate::leg::Leg;
use crate::patch::Patch;
use crate::patches::patches;
use crate::seeds::{Seeds, iterated};
use crate::wide::Wide;
use crate::{Chain, ChainError, Range};

/// Samples over one turn (or over the range of a sliding input).
const SAMPLES: usize = 720;

/// Where the first position itself is singular, its assembly is chosen so far behind it, rad (or parts of the scale).
const BESIDE: f64 = 1e-4;

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
    /// What ends the range, below and above.
    pub(crate) ends: [Option<ChainError>; 2],
}

/// Chooses the assembly of the first position and follows it.
pub(crate) fn walk(mechanism: &Mechanism, structure: &Structure, chain: &Chain<f64>) -> Walked {
    let from = mechanism.input.from;
    let wide = Wide::of(mechanism, structure);
    let unit = if matches!(mechanism.input.pair, InputPair::Pin(_)) { 1.0 } else { structure.scale };
    let begin = |q: f64| first_ways(mechanism, structure, chain, wide.as_ref(), q);
    let found = match begin(from) {
        // Equal links upon each other may point anywhere: what they do on the way through says how they stand.
        Err((_, ChainError { source: GroupError::Singular { .. }, .. })) => begin(from + BESIDE * unit),
        found => found,
    };
    let (first, start) = match found {
        Ok(found) => found,
        Err((ways, failure)) => {
            let ways = Ways { low: from, period: None, changes: Vec::new(), rows: vec![ways] };
            return Walked {
                ways,
                range: None,
                failure: Some(failure),
                patches: Vec::new(),
                seeds: None,
                ends: [None; 2],
            };
        }
    };
    let iterated = iterated(structure);
    let mut walker = Walker { chain, wide: wide.as_ref(), groups: chain.groups.len(), start, iterated, unit };
    let Path { ways, range, seeds, ends } = match mechanism.input.pair {
        InputPair::Pin(_) => walker.turn(from, &first),
        InputPair::Slide(_) => walker.slide(mechanism, structure.scale, &first),
    };
    let patches = patches(mechanism, structure, (chain, wide.as_ref()), &ways, seeds.as_ref());
    Walked { ways, range: Some(range), failure: None, patches, seeds, ends }
}

pub(crate) struct Walker<'a> {
    pub(crate) chain: &'a Chain<f64>,
    /// The same in twice the digits.
    pub(crate) wide: Option<&'a Wide>,
    pub(crate) groups: usize,
    /// The links in the first position: where kinds that iterate begin.
    pub(crate) start: Vec<Body<f64>>,
    /// Links of such kinds.
    pub(crate) iterated: Vec<usize>,
    /// Unit of the coordinate: 1 rad, or the scale in m.
    pub(crate) unit: f64,
}

/// Both legs of a walk as one.
struct Path {
    ways: Ways,
    range: Range,
    seeds: Option<Seeds>,
    ends: [Option<ChainError>; 2],
}

impl Walker<'_> {
    /// A pinned input: a full turn if it can, else both ways to where it ends.
    fn turn(&mut self, from: f64, first: &[u8]) -> Path {
        let period = std::f64::consts::TAU;
        let mut periods = 1;
        loop {
            let length = period * periods as f64;
            let mut leg = self.leg(from, length, SAMPLES * periods, first, false);
            if !leg.complete {
                let back = self.leg(from, -length, SAMPLES * periods, first, true);
                return self.path(from, period / SAMPLES as f64, &leg, &back, first);
            }
            leg.close(length);
            // With an odd number of meetings the mechanism comes back to the other assembly: its true cycle is longer.
            if leg.last == first || periods == MOST_PERIODS {
                let range = Range { low: from, high: from + period, full: true };
                let rows = rows_of(first, &leg.changes);
                let seeds = Seeds::keep(&self.iterated, from, period / SAMPLES as f64, true, &leg.grid);
                let changes = leg.changes.into_iter().map(|(d, group)| (from + d, group)).collect();
                let ways = Ways { low: from, period: Some(length), changes, rows };
                return Path { ways, range, seeds, ends: [None; 2] };
            }
            periods *= 2;
        }
    }

    /// A sliding input: over the range of the scene, and as far again on both sides (the reader wants to know where the
    /// mechanism ends).
    fn slide(&mut self, mechanism: &Mechanism, scale: f64, first: &[u8]) -> Path {
        let from = mechanism.input.from;
        let last = mechanism.input.coordinate(mechanism.input.positions.saturating_sub(1));
        let length = 4.0 * scale.max((last - from).abs());
        let forth = self.leg(from, length, 4 * SAMPLES, first, false);
        let back = self.leg(from, -length, 4 * SAMPLES, first, true);
        self.path(from, length / (4 * SAMPLES) as f64, &forth, &back, first)
    }

    fn path(&self, from: f64, step: f64, forth: &Leg, back: &Leg, first: &[u8]) -> Path {
        let (ways, range) = joined(from, forth, back, first);
        Path { ways, range, seeds: self.seeds(from, step, forth, back), ends: [back.failure, forth.failure] }
    }

    /// Both legs as one row of samples.
    fn seeds(&self, from: f64, step: f64, forth: &Leg, back: &Leg) -> Option<Seeds> {
        let before = back.grid.len().saturating_sub(1);
        let grid: Vec<_> = back.grid.iter().skip(1).rev().chain(&forth.grid).cloned().collect();
        Seeds::keep(&self.iterated, from - before as f64 * step, step, false, &grid)
    }
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
