//! The axis of values at the left of a plot.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::raster::{short, whole};
use super::text::put;
use crate::number::plain;
use crate::screen::state::{Look, Role};

/// Columns of the axis with its labels.
pub(crate) const LABELS: u16 = 11;
/// An end of the axis that is this small compared with the other is shown as zero.
const ROUNDING: f64 = 1e-12;

/// Maps values to rows of a plot.
#[derive(Debug, Clone, Copy)]
pub(super) struct ValueAxis {
    pub(super) low: f64,
    pub(super) high: f64,
    rows: u16,
}

impl ValueAxis {
    pub(super) fn new([low, high]: [f64; 2], rows: u16) -> Self {
        Self { low, high, rows }
    }

    pub(super) fn crosses_zero(&self) -> bool {
        self.low < 0.0 && self.high > 0.0
    }

    /// Row of a value in the plot; the ends stay a little inside.
    pub(super) fn row(&self, value: f64) -> f64 {
        let part = (self.high - value) / (self.high - self.low);
        part * (f64::from(self.rows) - 0.25) + 0.1
    }

    /// The greatest value in the second row of the area, the least in the last one of the plot; `zero` between them.
    pub(super) fn draw(&self, area: Rect, look: Look, zero: bool, buffer: &mut Buffer) {
        let style = look.theme.style(Role::Plain);
        let mut labels = vec![(0, self.high), (self.rows.saturating_sub(1), self.low)];
        let row = short(whole(self.row(0.0).max(0.0)));
        if zero && self.crosses_zero() && row > 0 && row + 1 < self.rows {
            labels.push((row, 0.0));
        }
        let least = ROUNDING * self.low.abs().max(self.high.abs());
        for (row, value) in labels {
            let text = plain(if value.abs() <= least { 0.0 } else { value });
            let column = LABELS.saturating_sub(short(text.len()) + 1);
            put(buffer, area, column, row + 1, &text, style);
        }
        for row in 0..self.rows {
            put(buffer, area, LABELS - 1, row + 1, "│", style);
        }
    }
}
