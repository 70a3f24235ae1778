//! Curves given by points of both axes, distinguished by dashes and by a number on them, not by color alone.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::axis::{LABELS, ValueAxis};
use super::label::Labels;
use super::raster::{Raster, Stroke, short};
use super::text::put;
use crate::number::plain;
use crate::screen::state::{Look, Role, axis_range, extent};

/// Strokes and styles of the curves in their order.
const STYLES: [(Stroke, Role); 3] =
    [(Stroke::Solid, Role::First), (Stroke::Dotted(3), Role::Third), (Stroke::Dotted(6), Role::Second)];

/// A plot.
#[derive(Debug)]
pub(crate) struct Lines<'a> {
    pub(crate) title: &'a str,
    /// At most three, each with its name.
    pub(crate) curves: Vec<(&'a str, Vec<[f64; 2]>)>,
    /// Name of the horizontal axis, with its unit.
    pub(crate) axis: &'a str,
    /// Where the cursor is on the horizontal axis.
    pub(crate) cursor: Option<f64>,
}

impl Lines<'_> {
    /// Draws the plot with its legend and axes.
    pub(crate) fn draw(&self, area: Rect, look: Look, buffer: &mut Buffer) {
        if area.width <= LABELS + 2 || area.height < 4 {
            return;
        }
        let heading = self.heading(usize::from(area.width));
        put(buffer, area, 1, 0, &heading, look.theme.style(Role::Header));
        let plot = Rect {
            x: area.x + LABELS,
            y: area.y + 1,
            width: area.width - LABELS - 1,
            height: area.height - 3,
        };
        let (Some([left, right]), Some(values)) = (self.range(0), self.range(1)) else { return };
        let vertical = ValueAxis::new(values, plot.height);
        let cell = |at: [f64; 2]| {
            [(at[0] - left) / (right - left) * f64::from(plot.width - 1) + 0.5, vertical.row(at[1])]
        };
        let mut raster = Raster::new(plot, look.marker);
        let mut labels = Labels::new(plot);
        if let Some(at) = self.cursor {
            let ends = [cell([at, vertical.low]), cell([at, vertical.high])];
            raster.line(ends[0], ends[1], Stroke::Dotted(2), look.theme.style(Role::Dim));
        }
        for (number, ((_, points), (stroke, role))) in self.curves.iter().zip(STYLES).enumerate() {
            let cells: Vec<[f64; 2]> =
                points.iter().filter(|at| at[1].is_finite()).map(|at| cell(*at)).collect();
            raster.polyline(&cells, stroke, look.theme.style(role));
            // Each number at its own part of the curve, so that the numbers of curves that meet are still seen.
            if let Some(at) = cells.get((2 * number + 1) * cells.len() / (2 * self.curves.len()).max(1))
                && self.curves.len() > 1
            {
                labels.put(*at, ["1", "2", "3"][number], look.theme.style(Role::Header));
            }
        }
        raster.paint(plot, buffer);
        labels.write(&raster, buffer);
        vertical.draw(area, look, false, buffer);
        self.horizontal_axis([left, right], area, look, buffer);
    }

    /// `moments, N m: 1 drive  2 resistance`; if that is too long, the names alone, because they explain the numbers.
    fn heading(&self, width: usize) -> String {
        let names = self.curves.iter().enumerate().map(|(i, line)| format!("{} {}", i + 1, line.0));
        let names = names.collect::<Vec<_>>().join("  ");
        let whole = format!("{}: {names}", self.title);
        match self.curves.len() {
            0 | 1 => self.title.to_owned(),
            _ if whole.chars().count() + 1 < width => whole,
            _ => format!("{}: {names}", self.title.rsplit(", ").next().unwrap_or_default()),
        }
    }

    /// Least and greatest coordinate of the points that have a value, never equal.
    fn range(&self, axis: usize) -> Option<[f64; 2]> {
        let points = self.curves.iter().flat_map(|(_, points)| points).filter(|at| at[1].is_finite());
        extent(&points.map(|at| at[axis]).collect::<Vec<_>>()).map(|extent| axis_range(extent, 0.0))
    }

    fn horizontal_axis(&self, [left, right]: [f64; 2], area: Rect, look: Look, buffer: &mut Buffer) {
        let style = look.theme.style(Role::Plain);
        let (row, end) = (area.height - 2, plain(right));
        put(buffer, area, LABELS, row, &plain(left), style);
        put(buffer, area, area.width.saturating_sub(short(end.len()) + 1), row, &end, style);
        put(buffer, area, LABELS, row + 1, self.axis, look.theme.style(Role::Dim));
    }
}
