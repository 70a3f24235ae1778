//! Curves given by points of both axes, told apart by dashes and by a number at their ends, not by color alone.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::label::Labels;
use super::raster::{Raster, Stroke, short};
use crate::screen::number::plain;
use crate::screen::series::axis_range;
use crate::screen::state::Look;
use crate::screen::theme::Role;
use crate::screen::view::put;

/// Columns for the axis labels.
const LABELS: u16 = 11;
/// Strokes and roles of the curves in their order.
const STYLES: [(Stroke, Role); 3] =
    [(Stroke::Solid, Role::First), (Stroke::Dotted(3), Role::Third), (Stroke::Dotted(6), Role::Second)];

/// A curve with its name.
pub(crate) type Line<'a> = (&'a str, Vec<[f64; 2]>);

/// A plot.
#[derive(Debug)]
pub(crate) struct Lines<'a> {
    pub(crate) title: &'a str,
    /// At most three.
    pub(crate) curves: Vec<Line<'a>>,
    /// What the horizontal axis is, with its unit.
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
        let points = || self.curves.iter().flat_map(|line| &line.1).filter(|at| at[1].is_finite());
        let (Some([left, right]), Some([low, high])) =
            (range(points().map(|at| at[0])), range(points().map(|at| at[1])))
        else {
            return;
        };
        let cell = |at: [f64; 2]| {
            [
                (at[0] - left) / (right - left) * f64::from(plot.width - 1) + 0.5,
                (high - at[1]) / (high - low) * (f64::from(plot.height) - 0.25) + 0.1,
            ]
        };
        let mut raster = Raster::new(plot, look.marker);
        let mut labels = Labels::new(plot);
        if let Some(at) = self.cursor {
            let ends = [cell([at, low]), cell([at, high])];
            raster.line(ends[0], ends[1], Stroke::Dotted(2), look.theme.style(Role::Dim));
        }
        for (number, ((_, points), (stroke, role))) in self.curves.iter().zip(STYLES).enumerate() {
            let cells: Vec<[f64; 2]> =
                points.iter().filter(|at| at[1].is_finite()).map(|at| cell(*at)).collect();
            raster.polyline(&cells, stroke, look.theme.style(role));
            // Each number at its own part of the curve, so that curves that meet still show theirs.
            if let Some(at) = cells.get((2 * number + 1) * cells.len() / (2 * self.curves.len()).max(1))
                && self.curves.len() > 1
            {
                labels.put(*at, ["1", "2", "3"][number], look.theme.style(Role::Header));
            }
        }
        raster.paint(plot, buffer);
        labels.write(&raster, buffer);
        self.axes(area, [left, right], [low, high], look, buffer);
    }

    /// `moments, N m: 1 drive  2 resistance`; where that is too long, the names alone: what the numbers mean must be seen.
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

    fn axes(
        &self,
        area: Rect,
        [left, right]: [f64; 2],
        [low, high]: [f64; 2],
        look: Look,
        buffer: &mut Buffer,
    ) {
        let style = look.theme.style(Role::Plain);
        for (row, value) in [(1, high), (area.height - 3, low)] {
            let text = plain(value);
            put(buffer, area, LABELS.saturating_sub(short(text.len()) + 1), row, &text, style);
        }
        for row in 1..area.height - 2 {
            put(buffer, area, LABELS - 1, row, "│", style);
        }
        put(buffer, area, LABELS, area.height - 2, &plain(left), style);
        let end = plain(right);
        put(buffer, area, area.width.saturating_sub(short(end.len()) + 1), area.height - 2, &end, style);
        put(buffer, area, LABELS, area.height - 1, self.axis, look.theme.style(Role::Dim));
    }
}

/// Least and greatest, never the same.
fn range(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let finite = values.filter(|value| value.is_finite()).map(|value| [value, value]);
    finite.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).map(|extent| axis_range(extent, 0.0))
}
