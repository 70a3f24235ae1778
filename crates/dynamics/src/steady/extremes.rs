//! Least and greatest values of a function that is known with its derivative at the nodes of panels.

use assur_number::search::bisect;

use super::collocation::{RULE, S, Values};

/// The function on one panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    /// Path coordinate of its start.
    pub(crate) x: f64,
    /// Its length.
    pub(crate) h: f64,
    /// Values at the start and at the nodes.
    pub(crate) values: Values,
    /// Derivative with respect to x at the start and at the nodes.
    pub(crate) slopes: Values,
}

/// An extreme value and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extreme {
    /// Index of the panel.
    pub(crate) piece: usize,
    /// Part of the panel.
    pub(crate) theta: f64,
    /// Path coordinate.
    pub(crate) x: f64,
    pub(crate) value: f64,
}

/// Least and greatest value; ends of panels, where the derivative may jump, included. Of equal values the first.
pub(crate) fn extremes(pieces: &[Piece]) -> Option<[Extreme; 2]> {
    let mut found: Option<[Extreme; 2]> = None;
    for (index, piece) in pieces.iter().enumerate() {
        let at =
            |theta: f64, value: f64| Extreme { piece: index, theta, x: piece.x + theta * piece.h, value };
        let between = |theta: f64| at(theta, RULE.interpolate(&piece.values, theta));
        note(&mut found, at(0.0, piece.values[0]));
        for i in 1..=S {
            let [before, after] = [piece.slopes[i - 1], piece.slopes[i]];
            if before * after < 0.0 {
                note(&mut found, between(piece.turning_point([RULE.c[i - 1], RULE.c[i]], before.signum())));
            } else if after == 0.0 {
                note(&mut found, between(RULE.c[i]));
            }
        }
        note(&mut found, at(1.0, piece.values[S]));
    }
    found
}

fn note(found: &mut Option<[Extreme; 2]>, new: Extreme) {
    let Some([least, greatest]) = found else {
        *found = Some([new, new]);
        return;
    };
    // Where two panels meet, rounding must not decide.
    let slack = 4.0 * f64::EPSILON * new.value.abs();
    if new.value < least.value - slack {
        *least = new;
    }
    if new.value > greatest.value + slack {
        *greatest = new;
    }
}

impl Piece {
    /// Zero of the derivative between two parts of the panel; `sign`: sign of the derivative at the first.
    fn turning_point(&self, [low, high]: [f64; 2], sign: f64) -> f64 {
        let keeps_sign = |theta: f64| RULE.interpolate(&self.slopes, theta) * sign > 0.0;
        let [low, high] = bisect(low, high, 2.0 * f64::EPSILON, keeps_sign);
        f64::midpoint(low, high)
    }
}
