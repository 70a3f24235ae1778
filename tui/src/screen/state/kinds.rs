//! What can be shown, and how: the small kinds of the state.

use std::ops::RangeInclusive;

use crate::screen::draw::raster::Marker;
use crate::screen::theme::Theme;

/// What is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum View {
    Menu,
    Mechanism,
    Curves,
    Forces,
    Plans,
    Motion,
    Drive,
    Checks,
    Accuracy,
    Structure,
    Table,
    /// The list of the scene's numbers below any of the others but the menu.
    Values,
}

impl View {
    /// All.
    pub(crate) const ALL: [Self; 12] = [
        Self::Menu,
        Self::Mechanism,
        Self::Curves,
        Self::Forces,
        Self::Plans,
        Self::Motion,
        Self::Drive,
        Self::Checks,
        Self::Accuracy,
        Self::Structure,
        Self::Table,
        Self::Values,
    ];
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

/// Which plan is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PlanKind {
    Forces,
    Velocity,
    Acceleration,
    Construction,
}

/// What a view with several parts shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pane {
    Table,
    /// Of the forces alone.
    Causes,
    Curves,
    Hodograph,
}

/// Which arrows the drawing has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Arrows {
    None,
    Velocity,
    Acceleration,
    Both,
}

/// Which paths the drawing has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Traces {
    All,
    Chosen,
    None,
}

/// The help screen.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Help {
    pub(crate) scroll: usize,
    pub(crate) filter: String,
}

/// What is chosen in each view.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Chosen {
    /// Index in [`crate::screen::study::Study::transfers`].
    pub(crate) transfer: usize,
    pub(crate) group: usize,
    /// Index in [`crate::screen::found::Found::reactions`].
    pub(crate) reaction: usize,
    pub(crate) check: usize,
    /// Group whose force polygon is drawn; the last is the input link.
    pub(crate) polygon: usize,
    /// First vector in the list of a plan of velocities or accelerations.
    pub(crate) vector: usize,
    /// Last step of the construction that is drawn.
    pub(crate) step: usize,
    /// First quantity of the motion view.
    pub(crate) motion: usize,
    /// First line of the accuracy view.
    pub(crate) line: usize,
    /// Column of the table.
    pub(crate) column: usize,
}
