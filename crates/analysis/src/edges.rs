//! What lies between the positions and after them: both sides of each place where the formula of a load changes, and the end of
//! the cycle. Drawings need them; no other result does.

use assur_dynamics::Instant;
use assur_force::{Loads, Side, State, tolerance};
use assur_number::Lanes;

use crate::Calculation;
use crate::angles::Angles;
use crate::blocks::Blocks;
use crate::filler::Filler;
use crate::motion::InputMotion;
use crate::results::Table;

/// Most places between the positions: a formula of a load that changes more often is drawn as a curve.
const MOST: usize = 1000;

/// Rows beside those of the positions, with the same columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Edges {
    /// For each place where the formula of a load changes, in the order of the positions: a row just before it and a row just
    /// after it. Angles of links are in (-pi, pi].
    pub sides: Table,
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
        let (mut sides, mut ending) = (filler.table(), filler.table());
        let input = &self.linkage.mechanism.input;
        let closed = input.is_cycle();
        if closed {
            let state = self.state(input.coordinate(input.positions));
            filler.add(input.positions, &[instant(state); Lanes::WIDTH], 1, &mut ending);
            Angles::after(positions).follow(&self.linkage, &mut ending);
        }
        let last = input.positions - usize::from(!closed);
        let ends = [0, last].map(|index| input.coordinate(index));
        for (number, place) in self.changes(ends).into_iter().enumerate() {
            let pair = self.both_sides(place, ends);
            filler.add(2 * number, &std::array::from_fn(|lane| instant(pair[lane % 2])), 2, &mut sides);
        }
        Edges { sides, ending }
    }

    /// The coordinates between two ends, in their order, at which the formula of a load changes; none where forces are not
    /// determined, or where there are very many.
    fn changes(&self, ends: [f64; 2]) -> Vec<f64> {
        let Some(loads) = self.loads.as_ref().filter(|_| self.positions_have_forces()) else {
            return Vec::new();
        };
        let along = self.goes_along(ends);
        let [start, end] = if along { ends } else { [ends[1], ends[0]] };
        let mut places = self.walk(loads, start, end);
        if !along {
            places.reverse();
        }
        if places.len() > MOST { Vec::new() } else { places }
    }

    /// The changes on the way of the motion.
    fn walk(&self, loads: &Loads, start: f64, end: f64) -> Vec<f64> {
        let (sense, mut phase) = ((end - start).signum(), loads.phase());
        let least = tolerance(start.abs().max(end.abs()), None);
        let (mut at, mut places) = (start, Vec::new());
        while places.len() <= MOST {
            let piece = loads.enter(&State { side: Side::After, ..self.state(at) }, &mut phase);
            let next = piece.coordinate[usize::from(sense > 0.0)];
            let (way, left) = (sense * (next - at), sense * (end - next));
            if way.is_nan() || way <= least || left.is_nan() || left < -least {
                break;
            }
            places.push(next);
            at = next;
        }
        places
    }

    /// Whether the motion goes from the first end to the second one.
    fn goes_along(&self, ends: [f64; 2]) -> bool {
        self.state(ends[0]).speed * (ends[1] - ends[0]) >= 0.0
    }

    /// The states before and after a place, in the order of the positions.
    fn both_sides(&self, place: f64, ends: [f64; 2]) -> [State; 2] {
        let after = State { side: Side::After, ..self.state(place) };
        let way = if after.speed == 0.0 { ends[1] - ends[0] } else { after.speed };
        let behind = place - 2.0 * way.signum() * tolerance(place.abs().max((ends[1] - ends[0]).abs()), None);
        let acceleration = match self.motion {
            InputMotion::Steady(_) => self.state(behind).acceleration,
            _ => after.acceleration,
        };
        let before = State { side: Side::Before, acceleration, ..after };
        if self.goes_along(ends) { [before, after] } else { [after, before] }
    }
}

fn instant(state: State) -> Instant {
    Instant { state, holding: None, friction: 0.0 }
}
