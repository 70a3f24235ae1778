//! On which side of its switches a formula is taken.

use crate::formula::{Formula, Variable, Variables};
use crate::number::Sign;
use crate::rounded::Rounded;

/// Given sides of some of the switches of a formula: the signs of their arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Branches {
    /// The switches whose side is given, as bits.
    given: u32,
    positive: u32,
    negative: u32,
}

impl Branches {
    /// Gives the side of a switch.
    pub fn set(&mut self, switch: usize, side: Sign) {
        let bit = 1 << switch;
        let mark = |bits: u32, set: bool| if set { bits | bit } else { bits & !bit };
        self.given |= bit;
        self.positive = mark(self.positive, side == Sign::Positive);
        self.negative = mark(self.negative, side == Sign::Negative);
    }

    /// The given side of a switch.
    #[inline]
    pub fn side(self, switch: usize) -> Option<Sign> {
        let has = |bits: u32| bits >> switch & 1 == 1;
        if !has(self.given) {
            return None;
        }
        Some(match (has(self.positive), has(self.negative)) {
            (true, _) => Sign::Positive,
            (false, true) => Sign::Negative,
            (false, false) => Sign::Zero,
        })
    }

    /// The sides of the switches of a mask alone.
    #[must_use]
    pub fn only(self, switches: u32) -> Self {
        let Self { given, positive, negative } = self;
        Self { given: given & switches, positive: positive & switches, negative: negative & switches }
    }
}

/// How far ahead of a place the side of a switch is looked for, in the least distance that counts. Further ones are
/// needed where the argument only touches zero at the place: `cos(q) - 1` is zero up to its rounding over 1e-8.
const DISTANCES: [f64; 5] = [1.0, 1e2, 1e4, 1e6, 1e8];

const VARIABLES: [Variable; 4] = [Variable::Coordinate, Variable::Speed, Variable::Time, Variable::Place];

/// Rounding of variables that follow from each other along a motion, relative to their sizes: some operations lead from
/// the coordinate to the time. A variable alone is what it is.
pub(crate) const OF_MOTION: f64 = 4.0 * f64::EPSILON;

impl Formula {
    /// The sign of the argument of a switch just ahead of a place, and the distance at which it shows; zero where the argument
    /// is zero identically. `None` where the argument has no value. `ahead` gives the variables at a distance, in the
    /// least distance that counts as ahead.
    ///
    /// An argument within its rounding has no sign.
    pub fn side_ahead(&self, switch: usize, ahead: impl Fn(f64) -> Variables) -> (Option<Sign>, f64) {
        let relative = if self.switches()[switch].used.count() > 1 { OF_MOTION } else { 0.0 };
        let argument = |distance: f64| {
            let at = ahead(distance);
            self.argument_of(switch, |name| Rounded::variable(at.get(name), relative))
        };
        let [least, further @ ..] = DISTANCES;
        let first = argument(least);
        for (found, distance) in [(first, least)]
            .into_iter()
            .chain(further.into_iter().map(|distance| (argument(distance), distance)))
        {
            if let Some(side) = found.sign() {
                return (Some(side), distance);
            }
        }
        // Where nothing moves, the number itself is all that is known.
        let [near, far] = [least, DISTANCES[DISTANCES.len() - 1]].map(&ahead);
        // A variable that is not known does not move.
        let moves = VARIABLES.iter().any(|name| near.get(*name).total_cmp(&far.get(*name)).is_ne());
        let side = if first.value.is_nan() {
            None
        } else if moves {
            Some(Sign::Zero)
        } else {
            Sign::of(first.value)
        };
        (side, least)
    }

    /// The sides of the jumps at a place, and as bits those whose arguments are zero within their rounding.
    pub fn jumps_at(&self, at: &Variables) -> (Branches, u32) {
        let (mut found, mut undecided) = (Branches::default(), 0);
        let jumps = self.jumps();
        for switch in (0..self.switches().len()).filter(|switch| jumps >> switch & 1 == 1) {
            let argument = self.argument_of(switch, |name| Rounded::variable(at.get(name), OF_MOTION));
            match argument.sign() {
                Some(side @ (Sign::Negative | Sign::Positive)) => found.set(switch, side),
                Some(Sign::Zero) | None => undecided |= u32::from(!argument.value.is_nan()) << switch,
            }
        }
        (found, undecided)
    }
}
