//! Where a point or a link comes to rest while the input moves: there a load against its motion reverses.

use assur_number::search::try_newton_root;

use crate::breaks::Breaks;
use crate::grid::{GRID, Span};

/// A minimum of the velocity below this part of its greatest value over the cycle counts as a rest.
const REST: f64 = 1e-9;

/// The rests of a point or link, from its PF1 and PF2; coordinates without a position of the mechanism are skipped.
pub(crate) fn rests(
    motion: &mut dyn FnMut(f64) -> Result<([f64; 2], [f64; 2]), String>,
    span: &Span,
) -> Breaks {
    let mut slope = |q: f64| -> Result<[f64; 2], String> {
        let (v, a) = motion(q)?;
        Ok([v[0].hypot(v[1]), v[0] * a[0] + v[1] * a[1]])
    };
    let mut greatest = 0.0_f64;
    let mut minima = Vec::new();
    let mut before = slope(span.from);
    for index in 1..=GRID {
        let (low, high) = (span.at(index - 1), span.at(index));
        let after = slope(high);
        if let (Ok(a), Ok(b)) = (&before, &after) {
            greatest = greatest.max(b[0]);
            // The square of the velocity falls, then grows: a minimum between.
            if a[1] < 0.0 && b[1] >= 0.0 {
                minima.push([low, high]);
            }
        }
        before = after;
    }
    let mut rests = Vec::new();
    for [low, high] in minima {
        // The derivative is not available: with a slope of 0 the root finder bisects.
        let Ok(q) = try_newton_root(low, high, |q| slope(q).map(|s| (s[1], 0.0))) else { continue };
        if slope(q).is_ok_and(|s| s[0] <= REST * greatest) {
            rests.push(q);
        }
    }
    Breaks::new(rests, span.periodic.then_some(span.length))
}
