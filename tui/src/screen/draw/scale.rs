//! From the plane of the mechanism to cells, with one scale for both axes.

use ratatui::layout::Rect;

use super::raster::whole;
use crate::number::plain;
use crate::screen::state::{Bounds, Zoom};

/// Plane to cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scale {
    center: [f64; 2],
    middle: [f64; 2],
    /// Width of a cell, m.
    pub(crate) meters: f64,
    /// Ratio of a cell's height to its width.
    ratio: f64,
}

/// Columns left free at each side for names, and rows for hatching.
///
/// The eighth keeps a line on the edge from taking another cell.
const MARGIN: [f64; 2] = [4.125, 1.125];

impl Scale {
    /// The largest scale that shows all of `bounds` in `area`.
    pub(crate) fn fit(bounds: Bounds, area: Rect, ratio: f64, zoom: Zoom) -> Self {
        let room = |cells: u16, margin: f64| (f64::from(cells) - 2.0 * margin).max(1.0);
        let [width, height] = bounds.size();
        let meters =
            (width / room(area.width, MARGIN[0])).max(height / (room(area.height, MARGIN[1]) * ratio));
        let meters = if meters.is_finite() && meters > 0.0 { meters } else { 1.0 };
        let center = bounds.center();
        let center = [0, 1].map(|axis| center[axis] + zoom.shift[axis] * width.max(height));
        let center = center.map(|x| if x.is_finite() { x } else { 0.0 });
        let middle = [f64::from(area.width) / 2.0, f64::from(area.height) / 2.0];
        Self { center, middle, meters: meters / zoom.factor, ratio }
    }

    /// A point of the plane in cells of the area, y down.
    pub(crate) fn cell(&self, at: [f64; 2]) -> [f64; 2] {
        [
            self.middle[0] + (at[0] - self.center[0]) / self.meters,
            self.middle[1] - (at[1] - self.center[1]) / (self.meters * self.ratio),
        ]
    }

    /// A vector of the plane with this length in cell widths, in the direction `along` (a unit vector).
    pub(crate) fn arm(&self, along: [f64; 2], widths: f64) -> [f64; 2] {
        [along[0] * widths, -along[1] * widths / self.ratio]
    }

    /// A bar of a round length of at most this many cell widths: `|----| 100 mm`; `factor` is the number of units per
    /// unit of the plane.
    pub(crate) fn bar(&self, widths: f64, factor: f64, unit: &str) -> String {
        let length = round_length(widths * self.meters);
        let dashes = "-".repeat(whole((length / self.meters).round().clamp(2.0, 40.0)) - 1);
        format!("|{dashes}| {} {unit}", plain(factor * length))
    }
}

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
pub(crate) fn round_length(most: f64) -> f64 {
    if !(most.is_finite() && most > 0.0) {
        return 1.0;
    }
    let power = 10.0_f64.powf(most.log10().floor());
    let times = [5.0, 2.0, 1.0].into_iter().find(|times| times * power <= most);
    times.unwrap_or(1.0) * power
}
