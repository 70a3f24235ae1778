//! Extremes and means of a quantity between the positions: the points of its curve show between which coordinates an extreme lies,
//! and the calculation at further ones finds it.

use assur_number::panel::chebyshev::{INSIDE, NODES, integral, value};
use assur_number::{Lanes, Statistic};

use crate::Calculation;
use crate::filler::{Filler, instant};
use crate::results::{Column, Table};

/// Refinement rounds. Eight interior points keep 2/9 of the bracket in each; after these rounds rounding of the values decides.
const ROUNDS: usize = 8;
/// Panels over a cycle, of which each has [`NODES`] places: between two jumps a load has no more waves.
const PANELS: f64 = 24.0;

/// A local extreme of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Its coordinate, rad or m.
    pub at: f64,
    /// The value, SI.
    pub value: f64,
    /// Whether the values beside it are smaller; otherwise they are greater.
    pub is_greatest: bool,
    /// The coordinates between which it lies.
    pub within: [f64; 2],
}

/// Values of greatest modulus over the positions and between them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Peaks {
    /// Of each quantity.
    pub farthest: Vec<(Column, Turn)>,
    /// The extreme of the power of the balancing load, W.
    pub power: Option<Turn>,
    /// Mean and root mean square of the balancing load over the whole cycle.
    pub balancing: Option<[f64; 2]>,
}

impl Turn {
    /// A value at a coordinate, with its sign.
    pub const fn at(at: f64, value: f64) -> Self {
        Self { at, value, is_greatest: value >= 0.0, within: [at; 2] }
    }

    /// Extremes of all values.
    pub fn statistic(all: &[Self]) -> Statistic {
        all.iter().map(|turn| turn.value).enumerate().collect()
    }
}

impl Peaks {
    /// The value of greatest modulus of a quantity; `None` where it was not looked for.
    pub fn of(&self, column: Column) -> Option<Turn> {
        self.farthest.iter().find(|(known, _)| *known == column).map(|(_, turn)| *turn)
    }
}

impl Calculation {
    /// Finds local extremes of what is read from a row, of which each is known to lie between two coordinates.
    pub fn refined(&self, turns: &[Turn], read: impl Fn(&Table, usize) -> Option<f64>) -> Vec<Turn> {
        self.with_values(read, |values| turns.iter().map(|turn| refined(*turn, values)).collect())
    }

    /// Mean and root mean square, between two coordinates, of what is read from a row; `jumps`: coordinates at which it jumps.
    /// `None` where it has no value somewhere.
    pub fn means(
        &self,
        ends: [f64; 2],
        jumps: &[f64],
        read: impl Fn(&Table, usize) -> Option<f64>,
    ) -> Option<[f64; 2]> {
        let mut places: Vec<f64> = jumps.to_vec();
        places.extend((0..=24).map(|part| ends[0] + (ends[1] - ends[0]) * f64::from(part) / PANELS));
        places.sort_by(f64::total_cmp);
        let sums = self.with_values(read, |values| {
            let of_panel = |two: &[f64]| {
                let at = |node: usize| {
                    0.5 * (two[0] + two[1] + (two[1] - two[0]) * INSIDE.nodes[node.min(NODES - 1)])
                };
                let halves =
                    [0, Lanes::WIDTH].map(|first| values(std::array::from_fn(|lane| at(first + lane))));
                let found: [f64; NODES] =
                    std::array::from_fn(|node| halves[node / Lanes::WIDTH][node % Lanes::WIDTH]);
                let sum = |values| value(&integral(&INSIDE.fit(&values), 0.5 * (two[1] - two[0])), 1.0);
                [sum(found), sum(found.map(|value| value * value))]
            };
            places.windows(2).map(of_panel).fold([0.0; 2], |all, one| [all[0] + one[0], all[1] + one[1]])
        });
        let [mean, square] = sums.map(|sum| sum / (ends[1] - ends[0]).abs());
        (mean.is_finite() && square.is_finite()).then(|| [mean, square.max(0.0).sqrt()])
    }

    /// Hands over what gives the values at eight coordinates; NaN where there is none.
    fn with_values<T>(
        &self,
        read: impl Fn(&Table, usize) -> Option<f64>,
        work: impl FnOnce(&mut dyn FnMut([f64; Lanes::WIDTH]) -> [f64; Lanes::WIDTH]) -> T,
    ) -> T {
        let columns = self.columns_of_positions();
        let mut filler = Filler::new(self, &columns, self.positions_have_forces());
        work(&mut |places| {
            let mut table = filler.table();
            filler.add(0, &places.map(|at| instant(self.state(at))), Lanes::WIDTH, &mut table);
            let value = |lane| read(&table, table.row_of(lane)?);
            std::array::from_fn(|lane| value(lane).unwrap_or(f64::NAN))
        })
    }
}

/// Finds an extreme by sections around the best of eight coordinates.
fn refined(turn: Turn, values: &mut dyn FnMut([f64; Lanes::WIDTH]) -> [f64; Lanes::WIDTH]) -> Turn {
    let sign = if turn.is_greatest { 1.0 } else { -1.0 };
    let ([mut low, mut high], mut best) = (turn.within, turn);
    for _ in 0..ROUNDS {
        let step = (high - low) / (Lanes::WIDTH + 1) as f64;
        let places: [f64; Lanes::WIDTH] = std::array::from_fn(|lane| low + step * (lane + 1) as f64);
        let found = places.into_iter().zip(values(places)).filter(|(_, value)| !value.is_nan());
        let Some((at, value)) = found.max_by(|one, other| (sign * one.1).total_cmp(&(sign * other.1))) else {
            break;
        };
        if sign * value > sign * best.value {
            best = Turn { at, value, ..best };
        }
        [low, high] = [at - step, at + step];
    }
    best
}
