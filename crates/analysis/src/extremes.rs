//! Extremes and means of a quantity between the positions: the points of its curve show between which coordinates an extreme lies,
//! and the calculation at further ones finds it.

use assur_force::tolerance;
use assur_number::quadrature::{Integrals, PLACES, integrals, panels};
use assur_number::{Lanes, Statistic};

use crate::Calculation;
use crate::filler::{Filler, instant};
use crate::results::{Column, Table};

/// Refinement rounds. Eight interior points keep 2/9 of the bracket in each; after these rounds rounding of the values decides.
const ROUNDS: usize = 8;
/// Even panels over a cycle, each of which has [`PLACES`] places: between two places where its formula changes a load has no more waves.
const PANELS: u32 = 24;
/// Accuracy of means, as a part of the greatest integral over a panel.
const ACCURACY: f64 = 1e-10;
/// Halvings of panels at most: of a curve that needs more the means are reported as uncertain.
const HALVINGS: usize = 1000;
/// Means are sure up to this part of the root mean square: no more digits are shown.
const SURE: f64 = 1e-6;
/// A mean below this part of the root mean square has no correct digit: some rounding units.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A local extreme of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// Its coordinate, rad or m.
    pub at: f64,
    /// The value, SI; infinite where the values grow without limit towards the coordinate.
    pub value: f64,
    /// Whether the values beside it are smaller; otherwise they are greater.
    pub is_greatest: bool,
    /// The coordinates between which it lies.
    pub within: [f64; 2],
}

/// Values of greatest magnitude over the positions and between them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Peaks {
    /// Of each quantity.
    pub farthest: Vec<(Column, Turn)>,
    /// The extreme of the power of the balancing load, W.
    pub power: Option<Turn>,
    /// Means of the balancing load over the whole cycle.
    pub balancing: Option<Means>,
}

/// Means of a quantity over the coordinate, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Means {
    /// The mean.
    pub mean: f64,
    /// The root mean square.
    pub rms: f64,
    /// By how much either may be off, as the quadrature estimates.
    pub error: f64,
}

impl Means {
    /// Whether all digits that are shown are right.
    pub fn are_sure(&self) -> bool {
        self.error <= SURE * self.rms
    }
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
    /// The value of greatest magnitude of a quantity; `None` where it was not looked for.
    pub fn of(&self, column: Column) -> Option<Turn> {
        self.farthest.iter().find(|(known, _)| *known == column).map(|(_, turn)| *turn)
    }
}

impl Calculation {
    /// Finds local extremes of what is read from a row, of which each is known to lie between two coordinates.
    pub fn refined(&self, turns: &[Turn], read: impl Fn(&Table, usize) -> Option<f64>) -> Vec<Turn> {
        self.with_values(read, |values| turns.iter().map(|turn| refined(*turn, values)).collect())
    }

    /// Where what is read from a row grows without limit: towards the end of the values between a coordinate that has one and a
    /// coordinate that has none, in each of some pairs.
    pub fn unlimited(&self, ends: &[[f64; 2]], read: impl Fn(&Table, usize) -> Option<f64>) -> Vec<Turn> {
        self.with_values(read, |values| ends.iter().filter_map(|ends| unlimited(*ends, values)).collect())
    }

    /// Means, between two coordinates, of what is read from a row; `size`: its greatest magnitude, about. `None` where it has no value
    /// somewhere.
    pub fn means(
        &self,
        ends: [f64; 2],
        size: f64,
        read: impl Fn(&Table, usize) -> Option<f64>,
    ) -> Option<Means> {
        let length = (ends[1] - ends[0]).abs();
        let least = tolerance(ends[0].abs().max(ends[1].abs()), Some(length));
        let parts = panels(ends, PANELS, &self.known_places(ends), least);
        // Value and square have one accuracy.
        let size = if size > 0.0 { size } else { 1.0 };
        let Integrals { values, error } = self.with_values(read, |values| {
            integrals(parts, ACCURACY, HALVINGS, |places: &[f64; PLACES]| {
                let at = |lane: usize| places[lane.min(PLACES - 1)];
                let halves =
                    [0, Lanes::WIDTH].map(|first| values(std::array::from_fn(|lane| at(first + lane))));
                let row = |value: &f64| value.is_finite().then_some([value / size, (value / size).powi(2)]);
                halves.as_flattened()[..PLACES].iter().map(row).collect()
            })
        })?;
        let [mean, square] = [values[0] / length, (values[1] / length).max(0.0)];
        let error = (error / length).max((square + error / length).sqrt() - square.sqrt());
        // What is left of a mean of zero is rounding.
        let mean = if mean.abs() <= ROUNDING * square.sqrt() { 0.0 } else { mean };
        Some(Means { mean: size * mean, rms: size * square.sqrt(), error: size * error })
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

/// The end of the values between a coordinate that has one and one that has none, if they grow without limit towards it: at least
/// like the inverse root of the distance, as all does of which a determinant that vanishes there is the divisor.
fn unlimited(
    [known, without]: [f64; 2],
    values: &mut dyn FnMut([f64; Lanes::WIDTH]) -> [f64; Lanes::WIDTH],
) -> Option<Turn> {
    /// Rounds of sections, each of which leaves 1/9 of the interval: down to rounding.
    const ROUNDS: usize = 17;
    /// Parts of the interval in which the values lie: how near to its end two of them are compared.
    const NEAR: [f64; 2] = [1e-3, 1e-7];
    /// The inverse root is 100 times as great at the nearer one.
    const GROWTH: f64 = 10.0;
    let (mut inside, mut outside) = (known, without);
    for _ in 0..ROUNDS {
        let step = (outside - inside) / (Lanes::WIDTH + 1) as f64;
        let found = values(std::array::from_fn(|lane| inside + step * (lane + 1) as f64));
        let count = found.iter().take_while(|value| !value.is_nan()).count() as f64;
        (inside, outside) = (inside + step * count, inside + step * (count + 1.0));
    }
    let at = |lane: usize| inside + (known - inside) * NEAR[lane.min(1)];
    let [far, near, ..] = values(std::array::from_fn(at));
    (near.abs() > GROWTH * far.abs()).then(|| Turn::at(inside, f64::INFINITY.copysign(near)))
}
