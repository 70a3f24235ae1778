//! Where a formula leaves its smooth branch.

use assur_number::search::bisect;

use crate::formula::{Formula, Variable, Variables};
use crate::interval::Interval;

/// Steps of the search: more only where intervals overestimate much; the branch is then said to end early, which costs
/// another search and changes no value.
const MOST_STEPS: usize = 1000;

/// How far is searched, in units of the variable.
const REACH: f64 = 1e6;

/// Width of an interval, relative to the variable or to 1, below which it is not halved further.
const WIDTH: f64 = 1e-15;

impl Formula {
    /// Where the argument of a switch first may change its sign when one variable grows (`along` = 1) or falls (-1) from its
    /// value in `at`, the others staying; ±infinity where it does not within a far reach.
    ///
    /// Intervals prove that there is no change before; a place where the argument touches zero counts as a change.
    pub fn smooth_until(&self, switch: usize, at: &Variables, variable: Variable, along: f64) -> f64 {
        let mut here = at.get(variable);
        let end = here + along * REACH * here.abs().max(1.0);
        let mut step = (end - here).abs();
        let argument =
            |x: f64| self.argument_of(switch, |name| if name == variable { x } else { at.get(name) });
        for _ in 0..MOST_STEPS {
            let there = if along > 0.0 { (here + step).min(end) } else { (here - step).max(end) };
            let between = self.argument_of(switch, |name| {
                if name == variable {
                    Interval::between(here, there)
                } else {
                    Interval::between(at.get(name), at.get(name))
                }
            });
            if !between.may_be_zero() {
                if there.total_cmp(&end).is_eq() {
                    return along * f64::INFINITY;
                }
                (here, step) = (there, 2.0 * step);
            } else if step > WIDTH * here.abs().max(1.0) {
                step *= 0.5;
            } else {
                let side = argument(here) >= 0.0;
                let [last, next] = bisect(here, there, 0.0, |x| (argument(x) >= 0.0) == side);
                return f64::midpoint(last, next);
            }
        }
        here
    }
}
