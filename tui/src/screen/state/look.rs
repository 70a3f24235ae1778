//! How things are drawn.

use std::ops::RangeInclusive;

use assur_figure::cells::Marker;

use super::kinds::View;
use super::theme::Theme;

/// The views that are shown beside the chosen one where there is room.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Panels {
    /// Whether they are shown.
    pub(crate) shown: bool,
    /// The views, the most wanted first.
    pub(crate) views: Vec<View>,
}

impl Default for Panels {
    fn default() -> Self {
        Self { shown: true, views: vec![View::Mechanism, View::Curves, View::Plans, View::Table] }
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
