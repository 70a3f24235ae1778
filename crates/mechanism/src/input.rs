//! The input: what is driven, its coordinate and the positions.

use crate::{GROUND, LinkId, Name, PairId, PointId, SlideId};

/// The input link, its coordinate and the positions to calculate.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// The link that is driven.
    pub link: LinkId,
    /// The link against which it is driven: the ground, or a moving link (a cylinder, a motor in a joint).
    pub on: LinkId,
    /// The pair between both, which also defines the coordinate.
    pub pair: InputPair,
    /// What the coordinate is called in results; `None`: by no name of its own.
    pub name: Option<Name>,
    /// Coordinate of the first position, rad or m.
    pub from: f64,
    /// Number of positions, at least 1.
    pub positions: usize,
    /// The positions: a whole cycle or a range.
    pub range: Range,
    /// The direction in which the coordinate changes.
    pub direction: Sense,
}

/// The pair that is driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputPair {
    /// Pinned at this point; the coordinate is the angle of the x axis of the link, counted from that of [`Input::on`], rad.
    Pin(PointId),
    /// Sliding; the coordinate is the displacement of this slide, m.
    Slide(SlideId),
}

/// The values of the coordinate at which positions are calculated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// Equally spaced over one cycle of this length (positive; rad or m); the end, which repeats the start, is left
    /// out.
    Cycle(f64),
    /// From `from` to this value, both included.
    To(f64),
}

/// Direction of the motion along the coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// The coordinate grows.
    Ccw,
    /// The coordinate decreases.
    Cw,
}

impl Sense {
    /// +1 or -1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Ccw => 1.0,
            Self::Cw => -1.0,
        }
    }
}

impl Default for Input {
    /// One turn of nothing, in one position.
    fn default() -> Self {
        let (pair, range) = (InputPair::Pin(0), Range::Cycle(std::f64::consts::TAU));
        let (link, on, direction) = (GROUND, GROUND, Sense::Ccw);
        Self { link, on, pair, name: None, from: 0.0, positions: 1, range, direction }
    }
}

impl Input {
    /// Whether the coordinate is an angle (rad); otherwise a displacement (m).
    pub fn is_angle(&self) -> bool {
        matches!(self.pair, InputPair::Pin(_))
    }

    /// Whether it drives one moving link against another; otherwise one against the ground.
    pub fn is_relative(&self) -> bool {
        self.on != GROUND
    }

    /// The link whose pose follows from the coordinate alone; `None` where two moving links are driven.
    pub fn placed(&self) -> Option<LinkId> {
        (!self.is_relative()).then_some(self.link)
    }

    /// The pair that is driven, as the scene names it.
    pub fn driven_pair(&self) -> PairId {
        match self.pair {
            InputPair::Pin(point) => PairId::Pin(point),
            InputPair::Slide(slide) => PairId::Slide(slide),
        }
    }

    /// Sign of the motion along the coordinate: that of `direction`, even if the positions are a range.
    pub fn sign(&self) -> f64 {
        self.direction.sign()
    }

    /// Coordinate of position `index`, rad or m.
    pub fn coordinate(&self, index: usize) -> f64 {
        match self.range {
            Range::Cycle(cycle) => {
                self.from + self.direction.sign() * cycle * (index as f64) / (self.positions as f64)
            }
            // The last position is exactly `to`, without rounding.
            Range::To(to) if index + 1 == self.positions && index > 0 => to,
            Range::To(to) if self.positions > 1 => {
                self.from + (to - self.from) * (index as f64) / ((self.positions - 1) as f64)
            }
            Range::To(_) => self.from,
        }
    }

    /// Where the positions begin and end; the end of a cycle repeats its start.
    pub fn ends(&self) -> [f64; 2] {
        let end = match self.range {
            Range::Cycle(cycle) => self.from + self.sign() * cycle,
            Range::To(to) => to,
        };
        [self.from, end]
    }

    /// Whether the positions are those of a whole cycle.
    pub fn is_cycle(&self) -> bool {
        matches!(self.range, Range::Cycle(_))
    }

    /// Whether the input is where it was after a cycle, so that the motion of the links repeats with it: after whole turns. Of another
    /// cycle only what is given over the coordinate repeats.
    pub fn turns_wholly(&self) -> bool {
        let turns = self.period().filter(|_| self.is_angle()).map(|period| period / std::f64::consts::TAU);
        turns.is_some_and(|turns| {
            turns > 0.5 && (turns - turns.round()).abs() <= assur_number::ROUNDING * turns
        })
    }

    /// Length of one cycle of the mechanism: the cycle of the scene, or one turn (rad) for a range of a pinned input;
    /// `None` for a range of a sliding one.
    pub fn period(&self) -> Option<f64> {
        match (self.range, self.pair) {
            (Range::Cycle(cycle), _) => Some(cycle),
            (Range::To(_), InputPair::Pin(_)) => Some(std::f64::consts::TAU),
            (Range::To(_), InputPair::Slide(_)) => None,
        }
    }
}
