//! From the plane of the mechanism to cells, with one scale for both axes.

use ratatui::layout::Rect;

/// A rectangle of the plane, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: [f64; 2],
    pub(crate) high: [f64; 2],
}

impl Bounds {
    pub(crate) const EMPTY: Self = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    pub(crate) fn add(&mut self, at: [f64; 2]) {
        for ((low, high), x) in self.low.iter_mut().zip(&mut self.high).zip(at).filter(|(_, x)| x.is_finite())
        {
            *low = low.min(x);
            *high = high.max(x);
        }
    }

    pub(crate) fn size(&self) -> [f64; 2] {
        [(self.high[0] - self.low[0]).max(0.0), (self.high[1] - self.low[1]).max(0.0)]
    }

    fn center(&self) -> [f64; 2] {
        [0.5 * (self.low[0] + self.high[0]), 0.5 * (self.low[1] + self.high[1])]
    }
}

/// Zoom and pan of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Zoom {
    /// How many times larger than the whole.
    pub(crate) factor: f64,
    /// Shift of the middle in parts of the drawn size.
    pub(crate) shift: [f64; 2],
}

impl Zoom {
    pub(crate) const WHOLE: Self = Self { factor: 1.0, shift: [0.0; 2] };
}

/// Plane to cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scale {
    center: [f64; 2],
    middle: [f64; 2],
    /// Meters a cell is wide.
    pub(crate) meters: f64,
    /// Height of a cell in its widths.
    ratio: f64,
}

/// Cells left free at each side for names, and rows for hatching.
///
/// The eighth keeps what touches the edge out of one more cell.
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
        let center =
            [center[0] + zoom.shift[0] * width.max(height), center[1] + zoom.shift[1] * width.max(height)]
                .map(|x| if x.is_finite() { x } else { 0.0 });
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

    /// A vector of the plane whose length is so many widths of a cell, turned as `along` (a unit vector).
    pub(crate) fn arm(&self, along: [f64; 2], widths: f64) -> [f64; 2] {
        [along[0] * widths, -along[1] * widths / self.ratio]
    }
}
