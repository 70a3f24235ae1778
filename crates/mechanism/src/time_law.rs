//! The coordinate of a drive over time.

use assur_formula::Formula;
use assur_number::{Curve, Dd, ROUNDING, Real};

/// A law of motion: a coordinate (rad or m) over time (s).
#[derive(Debug, Clone, PartialEq)]
pub enum TimeLaw {
    /// Grows evenly.
    Uniform {
        /// The coordinate at time 0, rad or m.
        from: f64,
        /// What it grows by in a second.
        rate: f64,
    },
    /// Polynomials of the third degree, piece by piece.
    Pieces(Pieces),
    /// Given by a formula over time alone.
    Formula {
        /// The formula.
        formula: Formula,
        /// SI value of a result of 1.
        factor: f64,
    },
}

/// Polynomials of the third degree between the rows of a table, whose first row is at time 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Pieces {
    /// One for each two neighboring rows, in order of time; never empty.
    all: Vec<Piece>,
    /// Time of the last row, s.
    last: f64,
    /// Whether all of it repeats after the last row: the first value equals the last one.
    repeats: bool,
    /// The end of the motion, s.
    until: f64,
}

/// A polynomial of the time since its start.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    /// Where it begins, s.
    start: f64,
    /// Factors of the powers 0 to 3 of the time since the start.
    factors: [f64; 4],
}

/// A time within so much of the whole motion from a row is that of the row.
const SAME_TIME: f64 = 1e-9;

impl TimeLaw {
    /// A coordinate that grows evenly from a first value (rad or m) at this rate (by s).
    pub fn uniform(from: f64, rate: f64) -> Self {
        Self::Uniform { from, rate }
    }

    /// Straight lines between rows (time, coordinate) in a motion that ends at a time: two rows at least, the first at time 0, times ascend.
    pub fn linear(rows: &[[f64; 2]], until: f64) -> Self {
        let pieces = rows.windows(2).map(|ends| {
            let [[start, value], _] = [ends[0], ends[1]];
            Piece { start, factors: [value, slope(ends), 0.0, 0.0] }
        });
        Self::Pieces(Pieces::new(pieces.collect(), rows, until))
    }

    /// The cubic spline through such rows: natural, without bending at both ends, or periodic where the first value equals the last one.
    pub fn smooth(rows: &[[f64; 2]], until: f64) -> Self {
        let bends = bends(rows);
        let pieces = rows.windows(2).zip(bends.windows(2)).map(|(ends, bends)| {
            let [start, value] = ends[0];
            let (step, [one, other]) = (ends[1][0] - start, [bends[0], bends[1]]);
            let speed = slope(ends) - step * (2.0 * one + other) / 6.0;
            Piece { start, factors: [value, speed, one / 2.0, (other - one) / step / 6.0] }
        });
        Self::Pieces(Pieces::new(pieces.collect(), rows, until))
    }

    /// The coordinate, its speed and its acceleration at a time. Where the speed jumps they are those just after it, at the end of the
    /// motion those before it.
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self {
            Self::Uniform { from, rate } => [from + rate * time, *rate, 0.0],
            Self::Pieces(pieces) => {
                let (piece, start) = pieces.piece(time);
                piece.at(time - start)
            }
            Self::Formula { formula, factor } => formula.over_time(time).map(|number| factor * number),
        }
    }

    /// The same law at a time, of a table the polynomial that holds there, continued to all times.
    #[must_use]
    pub fn continued(&self, time: f64) -> Self {
        let Self::Pieces(pieces) = self else { return self.clone() };
        let (piece, start) = pieces.piece(time);
        let all = vec![Piece { start, ..*piece }];
        Self::Pieces(Pieces { all, last: start, repeats: false, until: 0.0 })
    }

    /// The time from which on it says nothing, s; `None`: it has a value at every time.
    pub fn end(&self) -> Option<f64> {
        match self {
            Self::Pieces(Pieces { last, repeats: false, .. }) => Some(*last),
            _ => None,
        }
    }

    /// The times within the motion at which a table jumps, ascending, each with the lowest derivative that does: 1, the speed. Jumps of
    /// formulas are not among them.
    pub fn breaks(&self) -> impl Iterator<Item = (f64, u8)> + '_ {
        let pieces = if let Self::Pieces(pieces) = self { Some(pieces) } else { None };
        pieces.into_iter().flat_map(Pieces::breaks).map(|time| (time, 1))
    }

    /// The number under a key of the scene, if any other one may stand there as well.
    pub fn number(&mut self, key: &str) -> Option<&mut f64> {
        match (self, key) {
            (Self::Uniform { from: number, .. }, "from") | (Self::Uniform { rate: number, .. }, "rate") => {
                Some(number)
            }
            _ => None,
        }
    }
}

impl Pieces {
    fn new(all: Vec<Piece>, rows: &[[f64; 2]], until: f64) -> Self {
        let last = rows.last().map_or(0.0, |row| row[0]);
        Self { all, last, repeats: repeats(rows), until }
    }

    /// The rows of the table: time (s) and coordinate (rad or m).
    pub fn rows(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let end = self.all.last().map(|piece| [self.last, piece.at(self.last - piece.start)[0]]);
        self.all.iter().map(|piece| [piece.start, piece.factors[0]]).chain(end)
    }

    /// Whether it is a spline; otherwise straight lines.
    pub fn is_smooth(&self) -> bool {
        self.all.iter().any(|piece| piece.factors[2..].iter().any(|factor| factor.abs() > 0.0))
    }

    /// The polynomial that holds at a time, and when it begins in that round, s.
    fn piece(&self, time: f64) -> (&Piece, f64) {
        let same = SAME_TIME * self.until;
        let mut round = if self.repeats { ((time + same) / self.last).floor().max(0.0) } else { 0.0 };
        if round > 0.0 && time - round * self.last <= same && time >= self.until - same {
            round -= 1.0;
        }
        let own = time - round * self.last;
        let after = self.all.partition_point(|piece| piece.start <= own + same).max(1);
        let piece = &self.all[after - 1];
        (piece, piece.start + round * self.last)
    }

    /// Whether the speed jumps from one piece, a line, to another; pieces that bend join without a jump.
    fn jumps(&self, piece: usize, next: usize) -> bool {
        let [Piece { factors: [_, one, c, d], .. }, Piece { factors: [_, other, ..], .. }] =
            [piece, next].map(|index| self.all[index]);
        let is_line = c.abs().max(d.abs()) <= 0.0;
        is_line && (other - one).abs() > ROUNDING * one.abs().max(other.abs())
    }

    /// Times strictly within the motion at which the speed jumps.
    fn breaks(&self) -> impl Iterator<Item = f64> + '_ {
        let last = self.all.len() - 1;
        let inner = (0..last).filter(|piece| self.jumps(*piece, piece + 1));
        let mut own: Vec<f64> = inner.map(|piece| self.all[piece + 1].start).collect();
        if self.repeats && self.jumps(last, 0) {
            own.push(self.last);
        }
        let rounds = match (own.is_empty(), self.repeats) {
            (true, _) => 0,
            (false, true) => u64::MAX,
            (false, false) => 1,
        };
        #[expect(clippy::cast_precision_loss, reason = "a motion with 2^53 rounds has no digits of its own")]
        let times = (0..rounds).flat_map(move |round| {
            let start = round as f64 * self.last;
            own.clone().into_iter().map(move |time| start + time)
        });
        times.take_while(|time| *time < self.until * (1.0 - SAME_TIME))
    }
}

impl Piece {
    /// The coordinate, its speed and its acceleration at a time after the start.
    fn at<T: Real>(&self, t: T) -> [T; 3] {
        let [a, b, c, d] = self.factors.map(T::from_f64);
        let [two, three] = [2.0, 3.0].map(T::from_f64);
        [a + t * (b + t * (c + t * d)), b + t * (two * c + three * t * d), two * c + two * three * t * d]
    }
}

impl Curve<3> for TimeLaw {
    fn at(&self, time: f64) -> [f64; 3] {
        Self::at(self, time)
    }

    fn precise(&self, time: Dd) -> [Dd; 3] {
        match self {
            Self::Uniform { from, rate } => {
                let rate = Dd::from_f64(*rate);
                [Dd::from_f64(*from) + rate * time, rate, Dd::ZERO]
            }
            Self::Pieces(pieces) => {
                let (piece, start) = pieces.piece(time.to_f64());
                piece.at(time - Dd::from_f64(start))
            }
            Self::Formula { formula, factor } => {
                formula.over_time_precise(time).map(|number| Dd::from_f64(*factor) * number)
            }
        }
    }
}

/// The slope of the line between two rows.
fn slope(ends: &[[f64; 2]]) -> f64 {
    (ends[1][1] - ends[0][1]) / (ends[1][0] - ends[0][0])
}

/// Whether the last value is the first one, up to the rounding of units.
fn repeats(rows: &[[f64; 2]]) -> bool {
    let (Some([_, first]), Some([_, last])) = (rows.first(), rows.last()) else { return false };
    (last - first).abs() <= ROUNDING * first.abs().max(last.abs())
}

/// Second derivatives of the spline at its rows: at the inner ones the speeds of both sides are equal. A periodic one has the first row
/// once more as the last.
fn bends(rows: &[[f64; 2]]) -> Vec<f64> {
    let count = rows.len() - 1;
    let steps: Vec<f64> = rows.windows(2).map(|ends| ends[1][0] - ends[0][0]).collect();
    let slopes: Vec<f64> = rows.windows(2).map(slope).collect();
    // The row before an unknown and the one after it have these factors, the unknown itself twice their sum.
    let equation = |before: usize, after: usize| {
        [
            steps[before],
            2.0 * (steps[before] + steps[after]),
            steps[after],
            6.0 * (slopes[after] - slopes[before]),
        ]
    };
    if !repeats(rows) || count == 1 {
        let equations: Vec<_> = (1..count).map(|row| equation(row - 1, row)).collect();
        return [0.0].into_iter().chain(tridiagonal(&equations)).chain([0.0]).collect();
    }
    let equations: Vec<_> = (0..count).map(|row| equation((row + count - 1) % count, row)).collect();
    let mut bends = cyclic(&equations);
    bends.push(bends[0]);
    bends
}

/// Solves equations whose unknowns have neighbors, the last one the first as well (Sherman, Morrison): without that tie, and then with the
/// share of it.
fn cyclic(equations: &[[f64; 4]]) -> Vec<f64> {
    let last = equations.len() - 1;
    let (corner, opposite) = (equations[0][0], equations[last][2]);
    let pivot = -equations[0][1];
    let mut open = equations.to_vec();
    open[0][1] -= pivot;
    open[last][1] -= corner * opposite / pivot;
    let plain = tridiagonal(&open);
    for equation in &mut open {
        equation[3] = 0.0;
    }
    (open[0][3], open[last][3]) = (pivot, opposite);
    let tie = tridiagonal(&open);
    let along = |of: &[f64]| of[0] + corner / pivot * of[last];
    let share = along(&plain) / (1.0 + along(&tie));
    plain.iter().zip(&tie).map(|(plain, tie)| plain - share * tie).collect()
}

/// Solves equations [factor of the unknown before, of its own, of the one after, right side], whose own factors prevail.
fn tridiagonal(equations: &[[f64; 4]]) -> Vec<f64> {
    let mut reduced: Vec<[f64; 2]> = Vec::with_capacity(equations.len());
    for [before, own, after, right] in equations {
        let [above, known] = reduced.last().copied().unwrap_or_default();
        let pivot = own - before * above;
        reduced.push([after / pivot, (right - before * known) / pivot]);
    }
    let mut next = 0.0;
    let mut solution: Vec<f64> = reduced
        .iter()
        .rev()
        .map(|[after, known]| {
            next = known - after * next;
            next
        })
        .collect();
    solution.reverse();
    solution
}

#[cfg(test)]
mod tests;
