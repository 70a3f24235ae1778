//! The input: what is driven, its coordinate and the positions.

use assur_words::CoordinateKind;

use crate::{GROUND, LinkId, Name, PairId, PointId, SlideId, TimeLaw};

/// What is driven, the coordinate of the mechanism and the positions to calculate.
///
/// Where a single pair is driven without a law over time, its coordinate is that of the mechanism. Otherwise the coordinate of the
/// mechanism is the time, transfer functions are velocities and accelerations, and the motion has speed 1 and acceleration 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// What is driven; never empty.
    pub drivers: Vec<Driver>,
    /// Whether the scene gives a list of inputs: results then name each of them.
    pub is_list: bool,
    /// What the coordinate is called in results; `None`: by no name of its own.
    pub name: Option<Name>,
    /// Coordinate of the first position: rad, m, or s.
    pub from: f64,
    /// Number of positions, at least 1.
    pub positions: usize,
    /// The positions: a whole cycle or a range.
    pub range: Range,
    /// The direction in which the coordinate changes.
    pub direction: Sense,
}

/// A link that is driven against another one.
#[derive(Debug, Clone, PartialEq)]
pub struct Driver {
    /// The link that is driven.
    pub link: LinkId,
    /// The link against which it is driven: the ground, or a moving link (a cylinder, a motor in a joint).
    pub on: LinkId,
    /// The pair between both, which also defines the coordinate.
    pub pair: InputPair,
    /// What results call it: the link, slide or pin by which the scene says it.
    pub label: Name,
    /// Its coordinate over time; `None`: it is the coordinate of the mechanism.
    pub law: Option<TimeLaw>,
}

impl Driver {
    /// Whether the coordinate is an angle (rad); otherwise a displacement (m).
    pub fn is_angle(&self) -> bool {
        matches!(self.pair, InputPair::Pin(_))
    }

    /// Whether it drives one moving link against another; otherwise one against the ground.
    pub fn is_relative(&self) -> bool {
        self.on != GROUND
    }

    /// The pair that is driven, as the scene names it.
    pub fn pair_id(&self) -> PairId {
        match self.pair {
            InputPair::Pin(point) => PairId::Pin(point),
            InputPair::Slide(slide) => PairId::Slide(slide),
        }
    }

    /// Whether it drives the same pair of the same links as another one.
    pub fn drives_as(&self, other: &Self) -> bool {
        (self.link, self.on, self.pair) == (other.link, other.on, other.pair)
    }
}

/// The pair that is driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputPair {
    /// Pinned at this point; the coordinate is the angle of the x axis of the link, counted from that of [`Driver::on`], rad.
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
        let (range, direction) = (Range::Cycle(std::f64::consts::TAU), Sense::Ccw);
        let driver =
            Driver { link: GROUND, on: GROUND, pair: InputPair::Pin(0), label: Name::ground(), law: None };
        Self { drivers: vec![driver], is_list: false, name: None, from: 0.0, positions: 1, range, direction }
    }
}

impl Input {
    /// What the coordinate of the mechanism is.
    pub fn kind(&self) -> CoordinateKind {
        match self.sole().map(|driver| driver.pair) {
            None => CoordinateKind::Time,
            Some(InputPair::Pin(_)) => CoordinateKind::Angle,
            Some(InputPair::Slide(_)) => CoordinateKind::Length,
        }
    }

    /// The single thing that is driven, whose coordinate is that of the mechanism; `None` where that is the time.
    pub fn sole(&self) -> Option<&Driver> {
        self.drivers.first().filter(|driver| driver.law.is_none())
    }

    /// Whether the coordinate of the mechanism is the displacement of this slide between two moving links.
    pub fn is_displacement_of(&self, slide: SlideId) -> bool {
        self.sole().is_some_and(|sole| sole.is_relative() && sole.pair == InputPair::Slide(slide))
    }

    /// What is driven first in the order of the scene.
    pub fn first(&self) -> &Driver {
        &self.drivers[0]
    }

    /// Whether the coordinate of the mechanism is an angle (rad).
    pub fn is_angle(&self) -> bool {
        self.kind().is_angle()
    }

    /// The links that are driven against the ground, whose poses follow from their coordinates alone.
    pub fn placed(&self) -> impl Iterator<Item = LinkId> + '_ {
        self.drivers.iter().filter(|driver| !driver.is_relative()).map(|driver| driver.link)
    }

    /// Whether a link is driven against the ground.
    pub fn places(&self, link: LinkId) -> bool {
        self.placed().any(|placed| placed == link)
    }

    /// What drives a link against the ground, so that its pose follows from a coordinate alone: of several the first.
    pub fn placing(&self, link: LinkId) -> Option<&Driver> {
        self.drivers.iter().find(|driver| !driver.is_relative() && driver.link == link)
    }

    /// The link that is driven against the ground by the coordinate of the mechanism.
    pub fn crank(&self) -> Option<LinkId> {
        self.sole().filter(|driver| !driver.is_relative()).map(|driver| driver.link)
    }

    /// Whether a pair is driven.
    pub fn drives(&self, pair: PairId) -> bool {
        self.drivers.iter().any(|driver| driver.pair_id() == pair)
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
    /// `None` for a range of a sliding one, and over time.
    pub fn period(&self) -> Option<f64> {
        match self.range {
            Range::Cycle(cycle) => Some(cycle),
            Range::To(_) => self.is_angle().then_some(std::f64::consts::TAU),
        }
    }
}
