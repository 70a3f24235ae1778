//! Where inside a step the formulas of its piece end although its bounds do not: a change at which several variables have a part.

use assur_number::panel::Bernstein;
use assur_number::search::bisect;

use crate::{CountedEquation, Dense, Piece, State, Stretch, dense::COEFFICIENTS};

/// Parts of a step that are looked at. Where more are needed, the states at the ends of the parts tell.
const MOST_PARTS: usize = 500;

/// Part of a step that is not halved further.
const LEAST: f64 = 1e-9;

/// A part of a motion, over θ in [0, 1] of the whole.
pub trait Part: Sized {
    /// θ at its ends.
    fn ends(&self) -> [f64; 2];

    /// Its second half, and its first.
    fn halves(&self) -> [Self; 2];

    /// Its bounds.
    fn stretch(&self) -> Stretch;
}

/// The first change inside a motion: the last θ at which the formulas of the present piece hold, and the next one. `holds`: see
/// [`EquationOfMotion::holds`](crate::EquationOfMotion::holds); `at`: the state at a θ.
pub fn first_change(
    whole: impl Part,
    at: impl Fn(f64) -> State,
    holds: impl Fn(&Stretch) -> Option<bool>,
) -> Option<[f64; 2]> {
    let holds_at = |theta: f64| holds(&Stretch::at(at(theta))) != Some(false);
    let mut parts = vec![whole];
    for looked in 0.. {
        let Some(part) = parts.pop() else { break };
        let [from, to] = part.ends();
        match holds(&part.stretch()) {
            None if looked < MOST_PARTS && to - from > LEAST => parts.extend(part.halves()),
            known if known.unwrap_or_else(|| holds_at(to)) => {}
            _ => return Some(bisect(from, to, 0.0, holds_at)),
        }
    }
    None
}

/// The first change inside a step, see [`first_change`].
pub(crate) fn first_change_in(equation: &CountedEquation<'_>, dense: &Dense) -> Option<[f64; 2]> {
    first_change(StepPart::whole(dense), |theta| dense.at(theta), |stretch| equation.holds(stretch))
}

#[derive(Clone, Copy)]
struct StepPart<'a> {
    dense: &'a Dense,
    ends: [f64; 2],
    coordinate: Bernstein<COEFFICIENTS>,
    speed: Bernstein<COEFFICIENTS>,
}

impl<'a> StepPart<'a> {
    fn whole(dense: &'a Dense) -> Self {
        Self {
            dense,
            ends: [0.0, 1.0],
            coordinate: bernstein(&dense.coordinate),
            speed: bernstein(&dense.speed),
        }
    }
}

impl Part for StepPart<'_> {
    fn ends(&self) -> [f64; 2] {
        self.ends
    }

    fn halves(&self) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = f64::midpoint(from, to);
        let (coordinate, speed) = (self.coordinate.halves(), self.speed.halves());
        let half =
            |which: usize, ends| Self { ends, coordinate: coordinate[which], speed: speed[which], ..*self };
        [half(1, [middle, to]), half(0, [from, middle])]
    }

    fn stretch(&self) -> Stretch {
        let ends = self.ends.map(|theta| self.dense.time + theta * self.dense.step);
        let acceleration = self.speed.slopes((self.ends[1] - self.ends[0]) * self.dense.step);
        let [coordinate, speed] = [self.coordinate, self.speed].map(|course| course.bounds());
        let end = State { time: ends[1], coordinate: self.coordinate.end(), speed: self.speed.end() };
        Stretch { states: Piece { coordinate, speed, time: ends }, acceleration, end }
    }
}

/// Over the whole step, from the nested polynomial of [`Dense`], whose factors are θ and 1 - θ by turns.
fn bernstein(nested: &[f64; COEFFICIENTS]) -> Bernstein<COEFFICIENTS> {
    Bernstein::nested(nested, |index| if index.is_multiple_of(2) { [0.0, 1.0] } else { [1.0, 0.0] })
}

#[cfg(test)]
mod tests;
