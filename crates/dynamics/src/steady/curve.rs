//! Least and greatest values of a function that is known with its derivative at the nodes of panels.

use super::collocation::{Nodal, RULE, S};

/// The function on one panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    pub(crate) x: f64,
    pub(crate) h: f64,
    /// Value at the start and at the nodes.
    pub(crate) start: f64,
    pub(crate) values: Nodal,
    /// Derivative by x at the start and at the nodes.
    pub(crate) start_slope: f64,
    pub(crate) slopes: Nodal,
}

/// An extreme value and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extreme {
    /// Index of the panel.
    pub(crate) piece: usize,
    /// Part of the panel.
    pub(crate) theta: f64,
    /// Place on the path.
    pub(crate) x: f64,
    pub(crate) value: f64,
}

/// Least and greatest value; ends of panels, where the derivative may jump, included. Of equal values the first.
pub(crate) fn extremes(pieces: &[Piece]) -> Option<[Extreme; 2]> {
    let mut found: Option<[Extreme; 2]> = None;
    for (index, piece) in pieces.iter().enumerate() {
        let at =
            |theta: f64, value: f64| Extreme { piece: index, theta, x: piece.x + theta * piece.h, value };
        note(&mut found, at(0.0, piece.start));
        let (mut theta, mut slope) = (0.0, piece.start_slope);
        for (node, next) in RULE.c.iter().zip(piece.slopes) {
            if slope * next < 0.0 {
                let root = piece.turn([theta, *node], slope.signum());
                note(&mut found, at(root, RULE.interpolate(piece.start, &piece.values, root)));
            } else if next == 0.0 {
                note(&mut found, at(*node, RULE.interpolate(piece.start, &piece.values, *node)));
            }
            (theta, slope) = (*node, next);
        }
        note(&mut found, at(1.0, piece.values[S - 1]));
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
    /// Zero of the derivative between two parts, by bisection of its polynomial.
    fn turn(&self, [mut low, mut high]: [f64; 2], sign: f64) -> f64 {
        while high - low > 2.0 * f64::EPSILON {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if RULE.interpolate(self.start_slope, &self.slopes, middle) * sign > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }
}
