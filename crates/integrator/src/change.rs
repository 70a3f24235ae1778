//! Where inside a step the formulas of its piece end although its bounds do not: a change at which several variables have a part.

use assur_number::search::bisect;

use crate::dense::COEFFICIENTS;
use crate::{CountedEquation, Dense, Piece, State, Stretch};

/// Parts of a step that are looked at. Where more are needed, the states at the ends of the parts tell.
const MOST_PARTS: usize = 500;

/// Part of a step that is not halved further.
const LEAST: f64 = 1e-9;

/// The first change inside a step: the last θ at which the formulas of the present piece hold, and the next one.
pub(crate) fn first_change(equation: &CountedEquation<'_>, dense: &Dense) -> Option<[f64; 2]> {
    let holds_at = |theta: f64| equation.holds(&Stretch::at(dense.at(theta))) != Some(false);
    let mut parts = vec![Part::whole(dense)];
    for looked in 0.. {
        let Some(part) = parts.pop() else { break };
        let [from, to] = part.ends;
        match equation.holds(&part.stretch(dense)) {
            None if looked < MOST_PARTS && to - from > LEAST => parts.extend(part.halves()),
            known if known.unwrap_or_else(|| holds_at(to)) => {}
            _ => return Some(bisect(from, to, 0.0, holds_at)),
        }
    }
    None
}

/// A polynomial over a part of a step by Bernstein's coefficients: it lies between the least and the greatest of them.
type Bernstein = [f64; COEFFICIENTS];

/// A part of a step.
struct Part {
    /// θ at its ends.
    ends: [f64; 2],
    coordinate: Bernstein,
    speed: Bernstein,
}

impl Part {
    fn whole(dense: &Dense) -> Self {
        Self { ends: [0.0, 1.0], coordinate: bernstein(&dense.coordinate), speed: bernstein(&dense.speed) }
    }

    /// The second half, and the first.
    fn halves(&self) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = f64::midpoint(from, to);
        let (coordinate, speed) = (halves(self.coordinate), halves(self.speed));
        let half = |which: usize, ends| Self { ends, coordinate: coordinate[which], speed: speed[which] };
        [half(1, [middle, to]), half(0, [from, middle])]
    }

    fn stretch(&self, dense: &Dense) -> Stretch {
        let ends = self.ends.map(|theta| dense.time + theta * dense.step);
        let step = (self.ends[1] - self.ends[0]) * dense.step / (COEFFICIENTS - 1) as f64;
        let acceleration = bounds(self.speed.windows(2).map(|two| (two[1] - two[0]) / step));
        let [coordinate, speed] = [self.coordinate, self.speed].map(bounds);
        let [.., last] = self.coordinate;
        let end = State { time: ends[1], coordinate: last, speed: self.speed[COEFFICIENTS - 1] };
        Stretch { states: Piece { coordinate, speed, time: ends }, acceleration, end }
    }
}

fn bounds(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    values
        .into_iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// Bernstein's coefficients over the whole step, from the innermost bracket of the nested polynomial of [`Dense`] outward.
fn bernstein(nested: &[f64; COEFFICIENTS]) -> Bernstein {
    let mut found = [nested[COEFFICIENTS - 1]; COEFFICIENTS];
    for degree in 1..COEFFICIENTS {
        let outer = COEFFICIENTS - 1 - degree;
        let before = found;
        // Times θ, or times 1 - θ, as a polynomial of the next degree.
        let part = |i: usize, of: usize| i as f64 / degree as f64 * before[of];
        for (i, coefficient) in found.iter_mut().enumerate().take(degree + 1) {
            let by_theta = outer.is_multiple_of(2);
            let product = if by_theta { part(i, i.saturating_sub(1)) } else { part(degree - i, i) };
            *coefficient = nested[outer] + product;
        }
    }
    found
}

/// Those of both halves (de Casteljau).
fn halves(mut second: Bernstein) -> [Bernstein; 2] {
    let mut first = second;
    for (level, coefficient) in first.iter_mut().enumerate().skip(1) {
        for i in 0..COEFFICIENTS - level {
            second[i] = f64::midpoint(second[i], second[i + 1]);
        }
        *coefficient = second[0];
    }
    [first, second]
}

#[cfg(test)]
mod tests;
