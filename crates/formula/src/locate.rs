//! Where a formula leaves its smooth branch.

use std::ops::Range;

use assur_number::search::bisect;

use crate::formula::{Formula, OF_MOTION};
use crate::number::Number;
use crate::program::{Branches, Sign, Variable, Variables};
use crate::slope::{Dual, Signed};
use crate::{interval::Interval, rounded::Rounded};

/// Steps of the search: more only where intervals overestimate much; the branch is then said to end early, which costs
/// another search and changes no value.
const MOST_STEPS: usize = 1000;

/// How far is searched, in units of the parameter.
const REACH: f64 = 1e6;

/// Width of an interval, relative to the parameter or to 1, below which it is not halved further.
const WIDTH: f64 = 1e-15;

/// Halvings after which a part of a range in which changes are counted is not halved further: some parts for each of ten
/// thousand changes.
const HALVINGS: u32 = 15;

/// An error of the argument over such a part, as part of all that it may be there, from which on its sign is a matter of rounding.
const LOST: f64 = 0.01;

/// Places in such a part, as parts of its length, at which the argument is looked at: not in the ratio of whole numbers, so that no
/// oscillation shows the same at all of them.
const PLACES: [f64; 4] = [0.0, 0.381_966_011_250_105, 0.763_932_022_500_21, 1.0];

impl Formula {
    /// Where the argument of a switch, which has the sign `side` just ahead of `here`, first may have another sign along a path:
    /// with a growing parameter of the path (`along` = 1) or a falling one (-1); ±infinity where it has not within a far
    /// reach. `path` gives the variables at a parameter, each of which must be monotone along the path.
    ///
    /// Intervals prove that there is no change before; a place where the argument touches zero counts as a change.
    pub fn smooth_until(
        &self,
        switch: usize,
        side: Option<Sign>,
        mut here: f64,
        along: f64,
        path: impl Fn(f64) -> Variables,
    ) -> f64 {
        let end = here + along * REACH * here.abs().max(1.0);
        let mut step = (end - here).abs();
        let stays = |x: f64| Sign::of(self.argument(switch, &path(x))) == side;
        for _ in 0..MOST_STEPS {
            let there = if along > 0.0 { (here + step).min(end) } else { (here - step).max(end) };
            let between = self.argument_between(switch, [path(here), path(there)]);
            if !between.may_be_zero() || (between.is_zero() && side == Some(Sign::Zero)) {
                if there.total_cmp(&end).is_eq() {
                    return along * f64::INFINITY;
                }
                (here, step) = (there, 2.0 * step);
            } else if step > WIDTH * here.abs().max(1.0) {
                step *= 0.5;
            } else if side == Some(Sign::Zero) && stays(there) {
                // It is zero, but intervals don't show it.
                return along * f64::INFINITY;
            } else {
                let [last, next] = bisect(here, there, 0.0, stays);
                return f64::midpoint(last, next);
            }
        }
        here
    }

    /// Whether the argument of a switch, which has the sign `side` at the beginning of a stretch of a motion, has it
    /// throughout: `Some(false)` where it changes its sign at one place in the stretch, `None` where the stretch is too long
    /// to tell. `along` gives bounds of a variable in the stretch and of its derivative by time, `end` its end.
    ///
    /// Bounds of the argument tell, or bounds of its derivative: a monotone argument has at its end the sign that tells. It
    /// counts as changed beyond its rounding only.
    pub fn stays(
        &self,
        switch: usize,
        side: Sign,
        along: impl Fn(Variable) -> [[f64; 2]; 2],
        end: &Variables,
    ) -> Option<bool> {
        let last = self.argument_of(switch, |name| Rounded::variable(end.get(name), OF_MOTION)).sign();
        let stays = last.is_none_or(|last| last == side || last == Sign::Zero);
        let of = |[low, high]: [f64; 2]| Interval::between(low, high);
        let bounds = |switch| self.argument_of(switch, |name| of(along(name)[0]));
        let argument = bounds(switch);
        if !argument.may_be_zero() || argument.is_zero() || side == Sign::Zero {
            return Some(stays);
        }
        let range = &self.switches()[switch].operations;
        let within = |inner: &Range<usize>| range.start <= inner.start && inner.end <= range.end;
        let inner = |index: usize| index != switch && within(&self.switches()[index].operations);
        // At a switch within the argument its derivative jumps, perhaps the argument itself.
        let mut inners = (0..self.switches().len()).filter(|index| inner(*index));
        let smooth = inners.all(|index| !bounds(index).may_be_zero());
        let slope = || {
            let dual = |name| {
                let [value, slope] = along(name).map(of);
                Dual { value, slope }
            };
            self.argument_of(switch, dual).slope
        };
        (smooth && !slope().may_be_zero()).then_some(stays)
    }

    /// The number of changes of the sign of the argument of a switch along a path, between two parameters; of more than `most`
    /// not all are counted. Takes a bounded time; changes that are closer than a part in 30,000 of the range may count as one. Such a
    /// part in which the argument is lost in rounding, as that of `sin(1e30*q)`, counts as one too.
    pub fn changes_between(
        &self,
        switch: usize,
        [from, to]: [f64; 2],
        most: usize,
        path: impl Fn(f64) -> Variables,
    ) -> usize {
        // Parts of the range that are still to be looked at, the last of them first, with their halvings.
        let mut parts = vec![([from, to], 0)];
        let (mut found, mut end) = (0, f64::NAN);
        while let Some(([low, high], halvings)) = parts.pop() {
            let between = self.argument_between(switch, [path(low), path(high)]);
            if !between.may_be_zero() || between.is_zero() {
                continue;
            }
            if halvings < HALVINGS {
                let middle = f64::midpoint(low, high);
                parts.extend([([middle, high], halvings + 1), ([low, middle], halvings + 1)]);
                continue;
            }
            let arguments = PLACES.map(|part| {
                let at = path(low + part * (high - low));
                self.argument_of(switch, |name| Rounded::variable(at.get(name), f64::EPSILON))
            });
            // Neighbors have one change at their common end.
            let counted = low.total_cmp(&end).is_eq();
            if is_lost(&arguments, between) || may_change(&arguments, counted) {
                (found, end) = (found + 1, high);
            }
            if found > most {
                break;
            }
        }
        found
    }

    /// Bounds of the argument of a switch while each variable goes from one value to another.
    fn argument_between(&self, switch: usize, [from, to]: [Variables; 2]) -> Interval {
        self.argument_of(switch, |name| Interval::between(from.get(name), to.get(name)))
    }
}

/// Whether the argument of a switch may change its sign between the first and the last of some [`PLACES`]; `counted`: a change
/// at the first one counts elsewhere. Intervals that are too wide leave this to the values: those of one sign that lie
/// close to a straight line don't change it.
fn may_change(arguments: &[Rounded; 4], counted: bool) -> bool {
    let signs = arguments.map(|argument| argument.sign().filter(|sign| *sign != Sign::Zero));
    let same = |signs: &[Option<Sign>]| signs.windows(2).all(|pair| pair[0] == pair[1]);
    if counted && signs[0].is_none() && same(&signs[1..]) {
        return false;
    }
    let values = arguments.map(|argument| argument.value);
    let [first, .., last] = values;
    let least = values.into_iter().map(f64::abs).fold(f64::INFINITY, f64::min);
    let bent = |(value, part): (f64, f64)| (value - first - part * (last - first)).abs() > 0.5 * least;
    let certain = signs.iter().all(Option::is_some);
    !same(&signs) || (certain && values.into_iter().zip(PLACES).any(bent))
}

/// Whether the argument of a switch is lost in rounding at each of some places: its error leaves the sign open, and is comparable
/// with the bounds of the argument `between` them. An argument that is zero up to rounding (`sin(q)^2 + cos(q)^2 - 1`) has much
/// wider bounds, or the same value everywhere.
fn is_lost(arguments: &[Rounded; 4], between: Interval) -> bool {
    let is_open = |argument: &Rounded| {
        argument.sign().is_none() && argument.error >= LOST * (between.high - between.low)
    };
    let differ = arguments.iter().any(|argument| argument.value.total_cmp(&arguments[0].value).is_ne());
    differ && arguments.iter().all(is_open)
}

/// Parts of the range that are looked at. A formula that intervals bound badly takes more: of the rest its values decide.
const MOST_PARTS: usize = 20_000;
/// Equal parts of a range with which the search begins, so that the first place is near the first zero.
const FIRST: u32 = 64;

impl Formula {
    /// A coordinate of a range at which the formula, which depends on nothing else, is not a positive number of at most `most`,
    /// and its value there; `None` where it is one everywhere.
    ///
    /// Intervals prove it; where they don't show it in many parts, the values in the middle of these decide.
    pub fn not_positive_to(&self, most: f64, [from, to]: [f64; 2]) -> Option<(f64, f64)> {
        let value = |coordinate: f64| self.value(&Variables { coordinate, ..Variables::default() });
        let fails = |coordinate: f64| {
            let found = value(coordinate);
            (!(found > 0.0 && found <= most)).then_some((coordinate, found))
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
            let bounds = self.number(Branches::default(), |name| match name {
                Variable::Coordinate => Interval::between(low, high),
                Variable::Speed | Variable::Time | Variable::Place => Interval::of(0.0),
            });
            let proven = bounds.low > 0.0 && bounds.high <= most;
            if proven || ends_in_themselves || looked > MOST_PARTS {
                continue;
            }
            parts.extend([[middle, high], [low, middle]]);
        }
        None
    }
}
