//! Where a point comes to rest while the input moves: there a load against its motion turns round.

use assur_number::search::try_newton_root;

use crate::breaks::Breaks;
use crate::stroke::{BodyAt, Span};

/// Over how many places of the cycle a rest is bracketed.
const GRID: u32 = 720;

/// A velocity below this part of its greatest over the cycle is a rest, if it is a minimum.
const REST: f64 = 1e-9;

/// The rests of a point; places that the mechanism can't take are passed over.
pub(crate) fn rests(body: &mut BodyAt<'_>, at: [f64; 2], span: &Span) -> Breaks {
    let mut slope = |q: f64| -> Result<[f64; 2], String> {
        let body = body(q)?;
        let arm = body.arm(at);
        let (v, a) = (body.first(arm), body.second(arm));
        Ok([v[0].hypot(v[1]), v[0] * a[0] + v[1] * a[1]])
    };
    let mut greatest = 0.0_f64;
    let mut minima = Vec::new();
    let mut before = slope(span.from);
    for index in 1..=GRID {
        let (low, high) = (span.at(index - 1, GRID), span.at(index, GRID));
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
        // No derivative at hand: a slope of 0 makes the root finder bisect.
        let Ok(q) = try_newton_root(low, high, |q| slope(q).map(|s| (s[1], 0.0))) else { continue };
        if slope(q).is_ok_and(|s| s[0] <= REST * greatest) {
            rests.push(q);
        }
    }
    Breaks::new(rests, span.periodic.then_some(span.length))
}
