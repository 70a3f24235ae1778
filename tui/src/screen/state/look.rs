//! How things are drawn.

use std::ops::RangeInclusive;

use super::theme::Theme;

/// The characters for the dots of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marker {
    /// 2 x 4 dots per cell.
    Braille,
    /// 1 x 2 dots per cell.
    HalfBlock,
    /// One character per cell, chosen by the direction of the stroke.
    Ascii,
}

impl Marker {
    /// All kinds, in the order of the key that changes them.
    pub(crate) const ALL: [Self; 3] = [Self::Braille, Self::HalfBlock, Self::Ascii];

    /// Its name for `:set marker` and the configuration.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Braille => "braille",
            Self::HalfBlock => "half-block",
            Self::Ascii => "ascii",
        }
    }
}

/// How things are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Look {
    /// Characters beyond ASCII are replaced.
    pub(crate) ascii: bool,
    pub(crate) marker: Marker,
    pub(crate) theme: Theme,
    /// Ratio of a cell's height to its width.
    pub(crate) ratio: f64,
    /// Frames per second of the animation.
    pub(crate) fps: u8,
}

impl Look {
    /// Allowed frames per second of the animation.
    pub(crate) const FPS: RangeInclusive<u8> = 1..=60;
    /// Allowed ratios of a cell's height to its width.
    pub(crate) const RATIO: RangeInclusive<f64> = 0.5..=5.0;
}

impl Default for Look {
    fn default() -> Self {
        Self { ascii: false, marker: Marker::Braille, theme: Theme::Default, ratio: 2.0, fps: 10 }
    }
}
