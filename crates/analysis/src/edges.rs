//! What lies between the positions and after them: coordinates at which a curve is smooth, both sides of each place where the
//! formula of a load changes, and the end of the cycle. Drawings and extremes between the positions need them; no other result does.

use assur_force::{LoadState, Loads, Side, tolerance};
use assur_mechanism::Motion;
use assur_number::Lanes;

use crate::filler::{Filler, instant};
use crate::{Calculation, angles::Angles, blocks::Blocks, motion::InputMotion, results::Table};

/// Most places between the positions: a formula of a load that changes more often is drawn as a curve.
const MOST: usize = 1000;

/// Coordinates of a curve over the positions: no drawing shows more.
pub const DRAWN: usize = 720;

/// Numbers that are calculated between the positions: 8 MB. A mechanism of very many links has fewer coordinates.
const NUMBERS: usize = 1 << 20;

/// Rows beside those of the positions, with the same columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Edges {
    /// Coordinates between the positions, in their order: so many that a curve through them is smooth, each place twice at which
    /// the formula of a load changes, and the positions that have no solution.
    pub places: Vec<f64>,
    /// Their rows, each with the number of its place; of a place that is there twice the row just before it and the row just after
    /// it. A place without a solution has no row.
    pub between: Table,
    /// The end of the cycle as a row with the number that follows the last position: what the positions lead to, whether or not
    /// that is where they began; angles continue those of the last row. Without a row where the positions are no cycle, or
    /// the end has no solution.
    pub ending: Table,
}

impl Calculation {
    /// What lies between and after the positions.
    pub fn edges(&self, positions: &Table) -> Edges {
        let blocks = Blocks::new(self);
        let mut filler = Filler::new(self, &blocks.columns, self.positions_have_forces());
        let (mut between, mut ending) = (filler.table(), filler.table());
        let input = &self.linkage.mechanism.input;
        let closed = input.is_cycle();
        if closed {
            let state = self.state(input.coordinate(input.positions));
            filler.add(input.positions, &[instant(state); Lanes::WIDTH], 1, &mut ending);
            Angles::after(positions).follow(&self.linkage, &mut ending);
        }
        let last = input.positions - usize::from(!closed);
        let states =
            self.between(positions, last, DRAWN.min(NUMBERS / between.schema().columns().len().max(1)));
        for (block, states) in states.chunks(Lanes::WIDTH).enumerate() {
            let instants = std::array::from_fn(|lane| instant(states[lane.min(states.len() - 1)]));
            filler.add(Lanes::WIDTH * block, &instants, states.len(), &mut between);
        }
        let sense = (input.coordinate(last) - input.coordinate(0)).signum();
        Angles::new(between.schema()).follow_beside(&self.linkage, positions, sense, &mut between);
        Edges { places: states.iter().map(|state| state.coordinate).collect(), between, ending }
    }

    /// The states at the places between the positions, in their order; `count` places and positions in all, but for those at which
    /// the formula of a load changes.
    fn between(&self, positions: &Table, last: usize, count: usize) -> Vec<LoadState> {
        let input = &self.linkage.mechanism.input;
        let ends = [0, last].map(|index| input.coordinate(index));
        let sense = (ends[1] - ends[0]).signum();
        let changes = self.changes(ends);
        let changes = if changes.len() > MOST { Vec::new() } else { changes };
        let mut changes = changes.into_iter().peekable();
        let parts = count.div_ceil(last.max(1)).max(1);
        let mut states = Vec::new();
        for index in 0..=last {
            let [from, to] = [index, (index + 1).min(last)].map(|index| input.coordinate(index));
            for part in 0..if index == last { 1 } else { parts } {
                let place = from + (to - from) * part as f64 / parts as f64;
                let near = tolerance(place.abs().max((ends[1] - ends[0]).abs()), None);
                let mut met = false;
                while let Some(change) = changes.next_if(|change| sense * (place - change) >= -near) {
                    met = (place - change).abs() <= near;
                    states.extend(self.both_sides(change, ends));
                }
                let solved = part == 0 && (index == input.positions || positions.row_of(index).is_some());
                if !met && !solved {
                    states.push(self.state(place));
                }
            }
        }
        states
    }

    /// The coordinates between two ends, in no order, at which forces may jump or bend: where the formula of a load changes or the
    /// sense of a friction.
    pub(crate) fn known_places(&self, ends: [f64; 2]) -> Vec<f64> {
        let mut places = self.changes(ends);
        let frictions = self.loads.as_ref().and_then(Loads::frictions);
        let ends = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        places.extend(frictions.into_iter().flat_map(|frictions| frictions.turns(ends)));
        places
    }

    /// The coordinates between two ends, in their order, at which the formula of a load changes; none where forces are not
    /// determined; of very many the first ones.
    pub(crate) fn changes(&self, ends: [f64; 2]) -> Vec<f64> {
        let Some(loads) = self.loads.as_ref().filter(|_| self.positions_have_forces()) else {
            return Vec::new();
        };
        let along = self.goes_along(ends);
        let [start, end] = if along { ends } else { [ends[1], ends[0]] };
        let mut places = self.walk(loads, start, end);
        if !along {
            places.reverse();
        }
        places
    }

    /// The changes on the way of the motion.
    fn walk(&self, loads: &Loads, start: f64, end: f64) -> Vec<f64> {
        let (sense, mut phase) = ((end - start).signum(), loads.phase());
        let least = tolerance(start.abs().max(end.abs()), None);
        let (mut at, mut places) = (start, Vec::new());
        for _ in 0..=MOST {
            let piece = loads.enter(&LoadState { side: Side::After, ..self.state(at) }, &mut phase);
            let next = piece.coordinate[usize::from(sense > 0.0)];
            let next = self.passed_at(piece.time[1]).filter(|by| sense * (next - by) > 0.0).unwrap_or(next);
            let (way, left) = (sense * (next - at), sense * (end - next));
            if way.is_nan() || way <= least || left.is_nan() || left < -least {
                break;
            }
            places.push(next);
            at = next;
        }
        places
    }

    /// The coordinate that a prescribed motion passes at a time, before it turns back.
    fn passed_at(&self, time: f64) -> Option<f64> {
        let Some(Motion::Prescribed { speed, acceleration }) = self.linkage.mechanism.motion else {
            return None;
        };
        let way = time * (speed + 0.5 * acceleration * time);
        let is_ahead = time.is_finite() && speed * (speed + acceleration * time) > 0.0;
        is_ahead.then(|| self.linkage.mechanism.input.from + way)
    }

    /// Whether the motion goes from the first end to the second one.
    fn goes_along(&self, ends: [f64; 2]) -> bool {
        self.state(ends[0]).speed * (ends[1] - ends[0]) >= 0.0
    }

    /// The states before and after a place, in the order of the positions.
    fn both_sides(&self, place: f64, ends: [f64; 2]) -> [LoadState; 2] {
        let after = LoadState { side: Side::After, ..self.state(place) };
        let way = if after.speed == 0.0 { ends[1] - ends[0] } else { after.speed };
        let behind = place - 2.0 * way.signum() * tolerance(place.abs().max((ends[1] - ends[0]).abs()), None);
        let acceleration = match self.motion {
            InputMotion::Steady(_) => self.state(behind).acceleration,
            _ => after.acceleration,
        };
        let before = LoadState { side: Side::Before, acceleration, ..after };
        if self.goes_along(ends) { [before, after] } else { [after, before] }
    }
}
