//! On which side of its switches a formula is taken.

use crate::number::Sign;

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
