//! The least change of a length at which a mechanism no longer assembles.

use assur_number::search::{bisect, try_least};

use super::survey::may_touch;

/// First change that is tried, as part of the length.
const FIRST: f64 = 1e-3;

/// Each change exceeds the previous one by this part of it (or of what remains to zero, if that is less).
const GROWTH: f64 = 0.3;

/// Shortest length that is tried, as part of the length.
pub(super) const SHORTEST: f64 = 1e-6;

/// Changes that differ by less than this part of the length are equal.
const FINEST: f64 = 1e-16;

/// Steps of the search for the limit between a length that assembles and one that doesn't.
const STEPS: usize = 32;

#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// The characteristic size of the length, m.
    pub(super) size: f64,
    /// The last change, m.
    pub(super) last: f64,
    /// The change that makes the length zero, m; infinite if there is none.
    pub(super) nothing: f64,
}

impl Reach {
    fn next(self, change: f64) -> f64 {
        let step = if change > 0.0 { GROWTH * change.min(self.nothing - change) } else { FIRST * self.size };
        (change + step).min(self.last)
    }
}

/// The smallest change at which the mechanism no longer assembles, m. `clearance` of a change is the least squared
/// determinant; `None` if the mechanism does not assemble.
///
/// Growing changes are tried until one fails, or until the clearance has a minimum between them that does.
pub(super) fn least(reach: Reach, mut clearance: impl FnMut(f64) -> Option<f64>) -> Option<f64> {
    let finest = FINEST * reach.size;
    let mut tried = [(0.0, f64::INFINITY), (0.0, clearance(0.0).unwrap_or(0.0))];
    while tried[1].0 < reach.last {
        let change = reach.next(tried[1].0);
        let Some(value) = clearance(change) else {
            let [_, broken] = bisect(tried[1].0, change, finest, |change| clearance(change).is_some());
            // An iteration that started too far away may have missed the solution.
            match clearance(broken) {
                None => return Some(broken),
                Some(value) => {
                    tried = [tried[1], (broken, value)];
                    continue;
                }
            }
        };
        let [before, middle] = tried;
        if may_touch(middle.1, [before.1, value]) {
            let found = try_least(before.0, change, STEPS, |change| clearance(change).ok_or(change));
            if let Err(broken) = found {
                return Some(bisect(before.0, broken, finest, |change| clearance(change).is_some())[1]);
            }
        }
        tried = [middle, (change, value)];
    }
    None
}
