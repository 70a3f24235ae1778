//! The least change of a length that breaks a mechanism.

use assur_number::search::{bisect, try_least};

use super::survey::may_touch;

/// First change that is tried, in parts of the length.
const FIRST: f64 = 1e-3;

/// Each change is greater than the one before by this part (of what is left to zero, where that is less).
const GROWTH: f64 = 0.3;

/// A length is not made shorter than this part of itself.
pub(super) const SHORTEST: f64 = 1e-6;

/// Changes nearer to each other than this part of the length are one.
const FINEST: f64 = 1e-16;

/// Steps of the search for a length at which it breaks between two at which it does not.
const STEPS: usize = 32;

/// The changes that are tried.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// A length of the size that counts, m.
    pub(super) size: f64,
    /// The last change, m.
    pub(super) last: f64,
    /// The change that leaves nothing of the length, m; infinite if there is none.
    pub(super) nothing: f64,
}

impl Reach {
    fn next(self, change: f64) -> f64 {
        let step = if change > 0.0 { GROWTH * change.min(self.nothing - change) } else { FIRST * self.size };
        (change + step).min(self.last)
    }
}

/// The smallest change that breaks, m. `clearance` of a change is how near the mechanism comes to not assembling, squared;
/// `None` where it breaks.
///
/// Greater and greater changes are tried until one breaks, or until the clearance has a minimum between them that does.
pub(super) fn least(reach: Reach, mut clearance: impl FnMut(f64) -> Option<f64>) -> Option<f64> {
    let finest = FINEST * reach.size;
    let mut tried = [(0.0, f64::INFINITY), (0.0, clearance(0.0).unwrap_or(0.0))];
    while tried[1].0 < reach.last {
        let change = reach.next(tried[1].0);
        let Some(value) = clearance(change) else {
            let [_, broken] = bisect(tried[1].0, change, finest, |change| clearance(change).is_some());
            // An iteration that began too far away may not have found what is there.
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
