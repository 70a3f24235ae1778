//! One curve or more over the positions, with a cursor and marks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::label::Labels;
use super::raster::{Raster, Stroke, short, whole};
use crate::screen::number::plain;
use crate::screen::series::{axis_range, extent};
use crate::screen::state::Look;
use crate::screen::theme::Role;
use crate::screen::view::panel::cut;
use crate::screen::view::put;

/// What is marked on a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    Extreme,
    Zero,
    Inflection,
}

impl Mark {
    fn sign(self) -> &'static str {
        match self {
            Self::Extreme => "o",
            Self::Zero => "x",
            Self::Inflection => "+",
        }
    }
}

/// A chart.
#[derive(Debug)]
pub(crate) struct Chart<'a> {
    pub(crate) title: String,
    /// Values by position, the first curve is the one with the marks.
    pub(crate) curves: Vec<(&'a [f64], Style)>,
    /// Places as position numbers (also between two), and what is there.
    pub(crate) marks: Vec<(f64, Mark)>,
    pub(crate) cursor: usize,
    /// Sizes below this are rounding.
    pub(crate) floor: f64,
    /// Where each value lies on the axis, 0 to 1; `None`: equally spaced.
    pub(crate) places: Option<&'a [f64]>,
}

/// An end of the axis that is this small beside the other is rounding.
const ROUNDING: f64 = 1e-12;

/// Stars on a curve at most.
const MOST_STARS: usize = 24;

/// Column of a position in so many columns.
pub(crate) fn column_of(position: usize, count: usize, width: u16) -> u16 {
    short(whole(column(position as f64, count, width)))
}

fn column(position: f64, count: usize, width: u16) -> f64 {
    let last = count.saturating_sub(1).max(1) as f64;
    position / last * f64::from(width.saturating_sub(1)) + 0.5
}

/// The position nearest to a column.
pub(crate) fn position_of(at: u16, count: usize, width: u16) -> usize {
    let last = count.saturating_sub(1);
    let part = f64::from(at) / f64::from(width.saturating_sub(1).max(1));
    whole((part * last as f64).round()).min(last)
}

impl Chart<'_> {
    /// Draws the chart; `labels` columns at the left are for the axis.
    pub(crate) fn draw(&self, area: Rect, labels: u16, look: Look, buffer: &mut Buffer) {
        if area.width <= labels + 2 || area.height < 2 {
            return;
        }
        let plain_style = look.theme.style(Role::Plain);
        // A column stays free at the right; a long title begins above the labels of the axis.
        let room = area.width - 1;
        let column = labels.min(room.saturating_sub(short(self.title.chars().count())));
        let title = cut(&self.title, usize::from(room - column));
        put(buffer, area, column, 0, &title, look.theme.style(Role::Header));
        let plot = Rect {
            x: area.x + labels,
            y: area.y + 1,
            width: area.width - labels - 1,
            height: area.height - 1,
        };
        let Some([low, high]) = self.range() else { return };
        let count = self.curves.iter().map(|c| c.0.len()).max().unwrap_or(0);
        let frame = Frame { plot, low, high, count, places: self.places };
        let mut raster = Raster::new(plot, look.marker);
        if low < 0.0 && high > 0.0 {
            let zero = frame.row(0.0);
            let ends = [[0.0, zero], [f64::from(plot.width), zero]];
            raster.line(ends[0], ends[1], Stroke::Dotted(4), look.theme.style(Role::Dim));
        }
        for (number, (values, style)) in self.curves.iter().enumerate() {
            // The first is a line, another one a row of stars: told apart without color.
            curve(&frame, values, number == 0, *style, &mut raster);
        }
        raster.paint(plot, buffer);
        self.draw_stars(&frame, &raster, buffer);
        self.draw_marks(&frame, &raster, plain_style, buffer);
        self.draw_cursor(&frame, look, buffer);
        frame.axis(area, labels, plain_style, buffer);
    }

    /// Range of all curves, never empty.
    fn range(&self) -> Option<[f64; 2]> {
        let each = self.curves.iter().filter_map(|(values, _)| extent(values));
        let all = each.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])?;
        Some(axis_range(all, self.floor))
    }

    /// Stars on the curves after the first: dots alone are hard to tell from a line that is near.
    fn draw_stars(&self, frame: &Frame<'_>, raster: &Raster, buffer: &mut Buffer) {
        let mut labels = Labels::new(frame.plot);
        for (values, style) in self.curves.iter().skip(1) {
            let step = values.len().div_ceil(MOST_STARS).max(1);
            for (position, value) in values.iter().enumerate().step_by(step).filter(|(_, v)| v.is_finite()) {
                labels.put([frame.column(position as f64), frame.row(*value)], "*", *style);
            }
        }
        labels.write(raster, buffer);
    }

    fn draw_marks(&self, frame: &Frame<'_>, raster: &Raster, style: Style, buffer: &mut Buffer) {
        let Some((values, _)) = self.curves.first() else { return };
        let mut labels = Labels::new(frame.plot);
        for &(at, mark) in &self.marks {
            let value = if mark == Mark::Zero { 0.0 } else { between(values, at) };
            labels.put(
                [frame.column(at.min(values.len().saturating_sub(1) as f64)), frame.row(value)],
                mark.sign(),
                style,
            );
        }
        labels.write(raster, buffer);
    }

    /// The cursor: a reversed column, so that it is seen without color.
    fn draw_cursor(&self, frame: &Frame<'_>, look: Look, buffer: &mut Buffer) {
        let x = frame.plot.x + short(whole(frame.column(self.cursor as f64)));
        for y in frame.plot.y..frame.plot.bottom() {
            if let Some(cell) = buffer.cell_mut((x, y)) {
                if cell.symbol() == " " {
                    cell.set_char('│');
                }
                cell.set_style(look.theme.style(Role::Key));
            }
        }
    }
}

/// Value between two positions, linear.
fn between(values: &[f64], at: f64) -> f64 {
    let count = values.len().max(1);
    let i = whole(at.floor().max(0.0)) % count;
    let part = at - at.floor();
    let (a, b) = (
        values.get(i).copied().unwrap_or(f64::NAN),
        values.get((i + 1) % count).copied().unwrap_or(f64::NAN),
    );
    if part > 0.0 { a + part * (b - a) } else { a }
}

fn curve(frame: &Frame<'_>, values: &[f64], joined: bool, style: Style, raster: &mut Raster) {
    let at = |i: usize| [frame.column(i as f64), frame.row(values[i])];
    for i in 0..values.len() {
        if joined && i + 1 < values.len() && values[i + 1].is_finite() && values[i].is_finite() {
            raster.line(at(i), at(i + 1), Stroke::Solid, style);
        } else if values[i].is_finite() {
            raster.dot(at(i), '*', style);
        }
    }
}

/// The plotted area and its ranges.
#[derive(Debug)]
struct Frame<'a> {
    plot: Rect,
    low: f64,
    high: f64,
    count: usize,
    places: Option<&'a [f64]>,
}

impl Frame<'_> {
    fn column(&self, position: f64) -> f64 {
        match self.places.and_then(|places| places.get(whole(position.max(0.0)))) {
            Some(part) => part * f64::from(self.plot.width.saturating_sub(1)) + 0.5,
            None => column(position, self.count, self.plot.width),
        }
    }

    fn row(&self, value: f64) -> f64 {
        let part = (self.high - value) / (self.high - self.low);
        part * (f64::from(self.plot.height) - 0.25) + 0.1
    }

    /// The least and the greatest value at the left, zero between them.
    fn axis(&self, area: Rect, labels: u16, style: Style, buffer: &mut Buffer) {
        let mut rows = vec![(0, self.high), (self.plot.height - 1, self.low)];
        if self.low < 0.0 && self.high > 0.0 {
            let row = short(whole(self.row(0.0)));
            if row > 0 && row + 1 < self.plot.height {
                rows.push((row, 0.0));
            }
        }
        let least = ROUNDING * self.low.abs().max(self.high.abs());
        for (row, value) in rows {
            let text = plain(if value.abs() <= least { 0.0 } else { value });
            let column = labels.saturating_sub(short(text.len()) + 1);
            put(buffer, area, column, row + 1, &text, style);
        }
        for row in 0..self.plot.height {
            put(buffer, area, labels - 1, row + 1, "│", style);
        }
    }
}
