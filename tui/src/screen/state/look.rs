//! How things are drawn.

use std::ops::RangeInclusive;

use super::theme::Theme;

/// What a dot of a drawing becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marker {
    /// 2 x 4 dots a cell.
    Braille,
    /// 1 x 2 dots a cell.
    HalfBlock,
    /// One character a cell, chosen by the direction of the stroke.
    Ascii,
}

impl Marker {
    /// All, in the order of the key that changes them.
    pub(crate) const ALL: [Self; 3] = [Self::Braille, Self::HalfBlock, Self::Ascii];

    /// As `:set marker` and the configuration name it.
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
    /// Height of a cell in its widths.
    pub(crate) ratio: f64,
    /// Frames a second of the animation.
    pub(crate) fps: u8,
}

impl Look {
    /// Frames a second that the animation may have.
    pub(crate) const FPS: RangeInclusive<u8> = 1..=60;
    /// Heights of a cell in its widths that fonts have.
    pub(crate) const RATIO: RangeInclusive<f64> = 0.5..=5.0;
}

impl Default for Look {
    fn default() -> Self {
        Self { ascii: false, marker: Marker::Braille, theme: Theme::Default, ratio: 2.0, fps: 10 }
    }
}
