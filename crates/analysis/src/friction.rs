//! Dry friction over the cycle: works, efficiency, where the mechanism is self-locking and where it jams.

use assur_force::{ForceError, Kinetostatics, Loads, UnitBalance};
use assur_group::Order;
use assur_kinematics::Position;
use assur_mechanism::{Mechanism, PairId};
use assur_number::quadrature::{PLACES, integrals, panels};
use assur_number::search::{bisect, least};
use assur_words::{Text, number, text};
use indexmap::IndexMap;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::Calculation;

/// Friction over the cycle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrictionCycle {
    /// Efficiency of the cycle, from its works; `None` where a position jams, or nothing works.
    pub efficiency: Option<f64>,
    /// Work of the friction of each pair over the cycle, J, never positive; `None` where a position jams.
    pub friction_work: IndexMap<String, Option<f64>>,
    /// Intervals of the coordinate in which the efficiency is 0, rad or m.
    pub self_braking: Vec<[f64; 2]>,
    /// Intervals of the coordinate without a solution.
    pub dead_angles: Vec<[f64; 2]>,
    /// Distance of the places between which intervals are looked for, rad or m.
    pub step: f64,
    /// Greatest spectral radius over the cycle, where there is a solution.
    pub certificate: f64,
    /// Whether several inputs drive, each of which may drive and be driven: then there is no efficiency, and nothing brakes itself.
    pub is_of_several: bool,
}

impl FrictionCycle {
    /// The intervals with efficiency 0, those first that are at least a step long; shorter ones lie about places at which the
    /// balancing load changes its sense, where it passes through less than the friction takes.
    pub fn self_braking_by_length(&self) -> [Vec<[f64; 2]>; 2] {
        let (wide, narrow) = self.self_braking.iter().partition(|ends| ends[1] - ends[0] >= self.step);
        [wide, narrow]
    }
}

impl Serialize for FrictionCycle {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        if !self.is_of_several {
            map.serialize_entry("efficiency", &self.efficiency)?;
        }
        map.serialize_entry("friction_work", &self.friction_work)?;
        if !self.is_of_several {
            map.serialize_entry("self_braking", &self.self_braking)?;
            map.serialize_entry("dead_angles", &self.dead_angles)?;
        }
        map.end()
    }
}

/// What is said where a position jams: with one pair its coefficient too.
pub(crate) fn jammed(mechanism: &Mechanism, error: Text, limit: Option<f64>) -> Text {
    let Some(limit) = limit else { return error };
    let factor = number(format_args!("{limit:.9}"));
    match &mechanism.frictions[..] {
        [only] => {
            let coefficient = number(format_args!("{:.9}", limit * only.coefficient));
            text!("analysis-jammed-coefficient", error, factor, coefficient)
        }
        _ => text!("analysis-jammed", error, factor),
    }
}

/// The efficiency from the power (work) of the balancing load and the loss, which is not negative; `None` where both are zero.
pub(crate) fn efficiency(driving: f64, loss: f64) -> Option<f64> {
    if driving == 0.0 && loss == 0.0 {
        return None;
    }
    // 0 less the power, which may be zero of either sign.
    Some(if driving > 0.0 { (1.0 - loss / driving).max(0.0) } else { (0.0 - driving) / (loss - driving) })
}

/// How the mechanism is at a coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// It can't be assembled, or has no forces for another reason.
    Absent,
    /// No solution.
    Dead,
    /// The efficiency is 0.
    Braking,
    /// Anything else.
    Working,
}

/// The mechanism at a coordinate.
#[derive(Debug, Clone, Copy)]
struct Sample {
    coordinate: f64,
    state: State,
    /// Margins to a certificate of 1 (the factor of all coefficients that it bears, minus 1), to self-locking, and to being driven; infinite where it works otherwise.
    room: [f64; 3],
}

/// Distance from a place where the balancing load does no work, rad or m.
const BESIDE: f64 = 1e-9;

/// Golden sections between two samples for an interval that lies between them.
const SECTIONS: usize = 40;

/// Places of the grid on which intervals are looked for.
const GRID: u32 = 720;

/// Relative accuracy of works, and how many times intervals are halved at most.
const ACCURACY: f64 = 1e-11;
const MOST_HALVINGS: usize = 100_000;

/// Cells between two changes of a direction with which works are begun.
const CELLS: u32 = 6;

impl Calculation {
    /// Friction over the cycle; `None` where there is none.
    pub fn friction_cycle(&self) -> Option<FrictionCycle> {
        let (loads, analyzer) = (self.loads.as_ref()?, self.analyzer?);
        loads.frictions().filter(|_| self.positions_have_forces() && analyzer.treats_friction)?;
        let carrying = &self.plan.groups_carrying;
        let forces = Kinetostatics::new(&self.linkage, loads, analyzer.instance, carrying);
        let mut cycle =
            Cycle { calculation: self, loads, forces, position: self.linkage.position(), certificate: 0.0 };
        let input = &self.linkage.mechanism.input;
        let ends = input.ends();
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let (dead_angles, self_braking) = cycle.intervals([low, high], input.is_cycle());
        let works = if dead_angles.is_empty() { cycle.works([low, high]) } else { None };
        let pairs = self.linkage.mechanism.frictions.iter().map(|friction| friction.pair);
        let named = pairs.clone().map(|pair| self.linkage.mechanism.pair_name(pair).to_string());
        let friction_work =
            named.enumerate().map(|(k, name)| (name, works.as_ref().map(|works| works[k + 1])));
        let total = works.as_ref().map(|works| -works[1..].iter().sum::<f64>());
        let is_of_several = input.is_list;
        let both = works.as_ref().zip(total).filter(|_| !is_of_several);
        Some(FrictionCycle {
            efficiency: both.and_then(|(works, loss)| efficiency(works[0], loss)),
            friction_work: friction_work.collect(),
            self_braking: if is_of_several { Vec::new() } else { self_braking },
            dead_angles,
            step: (high - low) / f64::from(GRID),
            certificate: cycle.certificate,
            is_of_several,
        })
    }
}

/// The forces along the cycle.
struct Cycle<'a> {
    calculation: &'a Calculation,
    loads: &'a Loads,
    forces: Kinetostatics<'a>,
    position: Position,
    /// Greatest spectral radius so far.
    certificate: f64,
}

impl Cycle<'_> {
    /// Work by unit of travel in the direction of motion: of the balancing load, then of the friction of each pair; or how the
    /// mechanism is instead.
    fn powers(&mut self, coordinate: f64) -> Result<Vec<f64>, State> {
        let Calculation { linkage, .. } = self.calculation;
        let mut solve = |coordinate| {
            let solved = linkage.solve(coordinate, Order::Second, &mut self.position);
            solved.map_err(|_| State::Absent)?;
            let state = self.calculation.state(coordinate);
            let way = if state.speed == 0.0 {
                self.loads.speed_of_friction(&state, false)
            } else {
                state.speed.signum()
            };
            Ok((way, self.forces.solve(&state, &self.position)))
        };
        let (mut way, mut solved) = solve(coordinate)?;
        if let Err(ForceError::IdleBalance { .. }) = solved {
            // Where the balancing load does no work it is as just after.
            (way, solved) = solve(coordinate + way * BESIDE)?;
        }
        solved.map_err(|error| match error {
            ForceError::Jammed { .. } => State::Dead,
            _ => State::Absent,
        })?;
        let bodies = &self.position.bodies;
        let lever = UnitBalance::of(&linkage.mechanism).map_or(1.0, |unit| unit.power(bodies));
        let mut powers = vec![self.forces.reactions.balancing * lever * way];
        if let Some(friction) = &self.forces.reactions.friction {
            let of = |pair: PairId| {
                let all = friction.frictions.powers(&friction.forces, bodies);
                all.filter(|(bearing, _)| bearing.pair == pair)
                    .map(|(_, power)| (power * way).min(0.0))
                    .sum::<f64>()
            };
            powers.extend(linkage.mechanism.frictions.iter().map(|friction| of(friction.pair)));
        }
        Ok(powers)
    }

    fn sample(&mut self, coordinate: f64) -> Sample {
        let powers = match self.powers(coordinate) {
            Err(state) => return Sample { coordinate, state, room: [f64::INFINITY; 3] },
            Ok(powers) => powers,
        };
        let (driving, loss) = (powers[0], -powers[1..].iter().sum::<f64>());
        let state = if driving > 0.0 && driving < loss { State::Braking } else { State::Working };
        let radii = self.forces.reactions.friction.iter().flat_map(|friction| &friction.certificates);
        let radius = radii.copied().filter(|radius| radius.is_finite()).fold(0.0, f64::max);
        self.certificate = self.certificate.max(radius);
        let of = |holds: bool, room: f64| if holds { room } else { f64::INFINITY };
        // Towards a dead point the radius grows like 1 / x, so that its inverse is what falls to a place between two samples.
        let room = [1.0 / radius - 1.0, driving - loss, -driving];
        Sample { coordinate, state, room: room.map(|room| of(state == State::Working && room > 0.0, room)) }
    }

    /// Adds places between samples where the mechanism may jam or lock itself though it does neither at the samples.
    fn add_narrow(&mut self, samples: &[Sample]) -> Vec<Sample> {
        let mut all = Vec::new();
        for (index, three) in samples.windows(3).enumerate() {
            if index == 0 {
                all.push(three[0]);
            }
            all.push(three[1]);
            for kind in 0..3 {
                let [a, b, c] = [three[0], three[1], three[2]].map(|sample| sample.room[kind]);
                // A least value that the slopes beside it might take below zero.
                if !(b.is_finite() && b <= a && b <= c && b <= (a - b) + (c - b)) {
                    continue;
                }
                let ends = [three[0].coordinate, three[2].coordinate];
                let room = |q: f64| {
                    let found = self.sample(q);
                    if found.state == State::Working { found.room[kind] } else { f64::NEG_INFINITY }
                };
                let (place, value) = least(ends[0], ends[1], SECTIONS, room);
                if value == f64::NEG_INFINITY {
                    all.push(self.sample(place));
                }
            }
        }
        all.extend(samples.last());
        all.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
        all
    }

    /// The places where something may change: of a grid, and more and more densely towards each change of a direction.
    fn places(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        let length = high - low;
        let mut all: Vec<f64> = (0..=GRID).map(|i| low + length * f64::from(i) / f64::from(GRID)).collect();
        for turn in self.turns([low, high]) {
            let around = (1..24).map(|i| 0.5 * length / f64::from(GRID) * 0.4_f64.powi(i));
            all.extend(around.flat_map(|off| [turn - off, turn + off]).filter(|q| *q > low && *q < high));
        }
        all.sort_by(f64::total_cmp);
        all
    }

    /// The coordinates within an interval at which a direction of friction changes.
    fn turns(&self, ends: [f64; 2]) -> Vec<f64> {
        self.loads.frictions().map_or_else(Vec::new, |frictions| frictions.turns(ends))
    }

    /// The intervals without a solution, and those with efficiency 0.
    fn intervals(&mut self, [low, high]: [f64; 2], closes: bool) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
        let samples: Vec<Sample> =
            self.places([low, high]).into_iter().map(|place| self.sample(place)).collect();
        let samples = self.add_narrow(&samples);
        let mut pieces: Vec<(State, [f64; 2])> = Vec::new();
        let mut before = None;
        for Sample { coordinate: place, state: now, .. } in samples {
            let mut start = place;
            if let Some((last, state)) = before.filter(|(_, state)| *state != now) {
                let [end, begin] = bisect(last, place, 0.0, |q| self.sample(q).state == state);
                if let Some(piece) = pieces.last_mut() {
                    piece.1[1] = end;
                }
                start = begin;
            }
            match pieces.last_mut().filter(|(state, _)| *state == now) {
                Some(piece) => piece.1[1] = place,
                None => pieces.push((now, [start, place])),
            }
            before = Some((place, now));
        }
        let of = |wanted: State| {
            let mut found: Vec<[f64; 2]> =
                pieces.iter().filter(|(state, _)| *state == wanted).map(|(_, ends)| *ends).collect();
            // An interval that goes on beyond the end of the cycle is one.
            if let (true, [first, .., last]) = (closes, &found[..])
                && first[0] <= low
                && last[1] >= high
            {
                let joined = [last[0], first[1] + (high - low)];
                found.remove(0);
                found.pop();
                found.push(joined);
            }
            found
        };
        (of(State::Dead), of(State::Braking))
    }

    /// The works over an interval; `None` where a position has none, and for a single position.
    fn works(&mut self, [low, high]: [f64; 2]) -> Option<Vec<f64>> {
        if low >= high {
            return None;
        }
        let mut ends = vec![low];
        ends.extend(self.turns([low, high]));
        ends.push(high);
        let changes = self.calculation.changes([low, high]);
        let pieces = ends.windows(2).flat_map(|ends| panels([ends[0], ends[1]], CELLS, &changes, 0.0));
        let powers = |places: &[f64; PLACES]| places.iter().map(|place| self.powers(*place).ok()).collect();
        integrals(pieces, ACCURACY, MOST_HALVINGS, powers).map(|works| works.values)
    }
}
