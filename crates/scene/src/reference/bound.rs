//! The limits of a number.

use std::f64::consts::TAU;
use std::ops::Bound as End;

use assur_words::{Describe, Text, text};

/// The greatest angle of a direction, rad, 1000 turns: a greater one would lose more than four of its 16 digits.
const MOST_DIRECTION: f64 = 1000.0 * TAU;

/// The range of a number, besides being finite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// Anything.
    Any,
    /// 0 or greater.
    NotNegative,
    /// Greater than 0.
    Positive,
    /// An angle that is a direction: at most 1000 turns either way.
    Direction,
}

impl Bound {
    /// Both ends of the range.
    pub(crate) fn ends(self) -> (End<f64>, End<f64>) {
        match self {
            Self::Any => (End::Unbounded, End::Unbounded),
            Self::NotNegative => (End::Included(0.0), End::Unbounded),
            Self::Positive => (End::Excluded(0.0), End::Unbounded),
            Self::Direction => (End::Included(-MOST_DIRECTION), End::Included(MOST_DIRECTION)),
        }
    }

    /// Reads limits as the reference writes them.
    pub(super) fn read(text: &str) -> Option<Self> {
        Some(match text {
            "" => Self::Any,
            ">= 0" => Self::NotNegative,
            "> 0" => Self::Positive,
            "direction" => Self::Direction,
            _ => return None,
        })
    }
}

impl Describe for Bound {
    fn describe(&self) -> Text {
        match self {
            Self::Any => Text::default(),
            Self::NotNegative => text!("scene-limit-not-negative"),
            Self::Positive => text!("scene-limit-positive"),
            Self::Direction => text!("scene-limit-direction"),
        }
    }
}
