//! Where a formula over the coordinate is not positive.

use crate::branches::Branches;
use crate::formula::{Formula, Variable, Variables};
use crate::interval::Interval;

/// Parts of the range that are looked at. A formula that intervals bound badly takes more: of the rest its values decide.
const MOST_PARTS: usize = 20_000;
/// Equal parts of a range with which the search begins, so that the first place is near the first zero.
const FIRST: u32 = 64;

impl Formula {
    /// A coordinate of a range at which the formula, which depends on nothing else, is not a positive number, and its value
    /// there; `None` where it is positive everywhere.
    ///
    /// Intervals prove it; where they don't show it in many parts, the values in the middle of these decide.
    pub fn not_positive(&self, [from, to]: [f64; 2]) -> Option<(f64, f64)> {
        let value = |coordinate: f64| self.value(&Variables { coordinate, ..Variables::default() });
        let fails = |coordinate: f64| {
            let found = value(coordinate);
            (!(found > 0.0 && found.is_finite())).then_some((coordinate, found))
        };
        let place = |part: u32| from + (to - from) * (f64::from(part) / f64::from(FIRST));
        let mut parts: Vec<_> = (0..FIRST).rev().map(|part| [place(part), place(part + 1)]).collect();
        let mut looked = 0;
        while let Some([low, high]) = parts.pop() {
            let middle = f64::midpoint(low, high);
            if let Some(found) = [low, middle, high].into_iter().find_map(fails) {
                return Some(found);
            }
            looked += 1;
            let ends_in_themselves = middle <= low.min(high) || middle >= low.max(high);
            if self.between([low, high]).low > 0.0 || ends_in_themselves || looked > MOST_PARTS {
                continue;
            }
            parts.extend([[middle, high], [low, middle]]);
        }
        None
    }

    /// Bounds of the formula over a range of the coordinate.
    fn between(&self, [low, high]: [f64; 2]) -> Interval {
        let coordinate = Interval::between(low, high);
        self.number(Branches::default(), |name| match name {
            Variable::Coordinate => coordinate,
            Variable::Speed | Variable::Time | Variable::Place => Interval::between(0.0, 0.0),
        })
    }
}
