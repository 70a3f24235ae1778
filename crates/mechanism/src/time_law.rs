//! The coordinate of a drive over time.

use assur_formula::Formula;

/// A law of motion: a coordinate (rad or m) over time (s).
#[derive(Debug, Clone, PartialEq)]
pub enum TimeLaw {
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

/// Polynomials of the third degree, each from its start to the start of the next; the last one goes on.
#[derive(Debug, Clone, PartialEq)]
pub struct Pieces {
    /// Each piece, in order of time; never empty.
    pieces: Vec<Piece>,
    /// Time after which all of it repeats, s; `None`: it does not.
    period: Option<f64>,
}

/// A polynomial of the time since its start.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    /// Where it begins, s.
    start: f64,
    /// Factors of the powers 0 to 3 of the time since the start.
    factors: [f64; 4],
}

impl TimeLaw {
    /// A coordinate that grows evenly from a first value (rad or m) at this rate (by s).
    pub fn uniform(from: f64, rate: f64) -> Self {
        let pieces = vec![Piece { start: 0.0, factors: [from, rate, 0.0, 0.0] }];
        Self::Pieces(Pieces { pieces, period: None })
    }

    /// The coordinate, its speed and its acceleration at a time.
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self {
            Self::Pieces(pieces) => pieces.at(time),
            Self::Formula { formula, factor } => formula.over_time(time).map(|number| factor * number),
        }
    }
}

impl Pieces {
    fn at(&self, time: f64) -> [f64; 3] {
        let time = self.period.map_or(time, |period| time.rem_euclid(period));
        let after = self.pieces.partition_point(|piece| piece.start <= time).max(1);
        let Piece { start, factors: [a, b, c, d] } = self.pieces[after - 1];
        let t = time - start;
        [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + 3.0 * t * d), 2.0 * c + 6.0 * t * d]
    }
}
