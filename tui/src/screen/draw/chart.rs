//! One or more curves over the positions, with a cursor and marks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::axis::{LABELS, ValueAxis};
use super::label::Labels;
use super::raster::{Raster, Stroke, short, whole};
use super::text::{cut, put};
use crate::screen::state::{Look, Role, axis_range, extent};

/// A mark on a curve.
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
#[derive(Debug, Default)]
pub(crate) struct Chart<'a> {
    pub(crate) title: String,
    /// Values by position; the first curve is the one with the marks.
    pub(crate) curves: Vec<(&'a [f64], Style)>,
    /// Marks: positions (also between two), and their kind.
    pub(crate) marks: Vec<(f64, Mark)>,
    pub(crate) cursor: usize,
    /// Values below this count as zero.
    pub(crate) floor: f64,
    /// Place of each value on the axis, 0 to 1; `None`: equally spaced.
    pub(crate) places: Option<&'a [f64]>,
}

/// Most stars on a curve.
const MOST_STARS: usize = 24;

/// Column of a position in a chart of this many columns.
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
    /// Draws the chart, with columns for the axis at the left.
    pub(crate) fn draw(&self, area: Rect, look: Look, buffer: &mut Buffer) {
        if area.width <= LABELS + 2 || area.height < 2 {
            return;
        }
        // A column stays free at the right; a long title begins above the labels of the axis.
        let room = area.width - 1;
        let column = LABELS.min(room.saturating_sub(short(self.title.chars().count())));
        let title = cut(&self.title, usize::from(room - column));
        put(buffer, area, column, 0, &title, look.theme.style(Role::Header));
        let plot = Rect {
            x: area.x + LABELS,
            y: area.y + 1,
            width: area.width - LABELS - 1,
            height: area.height - 1,
        };
        let each = self.curves.iter().filter_map(|(values, _)| extent(values));
        let Some(all) = each.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]) else { return };
        let axis = ValueAxis::new(axis_range(all, self.floor), plot.height);
        let count = self.curves.iter().map(|curve| curve.0.len()).max().unwrap_or(0);
        let frame = Frame { plot, axis, count, places: self.places };
        let mut raster = Raster::new(plot, look.marker);
        if axis.crosses_zero() {
            let zero = axis.row(0.0);
            let ends = [[0.0, zero], [f64::from(plot.width), zero]];
            raster.line(ends[0], ends[1], Stroke::Dotted(4), look.theme.style(Role::Dim));
        }
        for (number, (values, style)) in self.curves.iter().enumerate() {
            // The first curve is a line, others are rows of stars: distinguished without color.
            frame.curve(values, number == 0, *style, &mut raster);
        }
        raster.paint(plot, buffer);
        self.draw_stars(&frame, &raster, buffer);
        self.draw_marks(&frame, &raster, look.theme.style(Role::Plain), buffer);
        self.draw_cursor(&frame, look, buffer);
        axis.draw(area, look, true, buffer);
    }

    /// Stars on the curves after the first: dots alone are hard to distinguish from a nearby line.
    fn draw_stars(&self, frame: &Frame<'_>, raster: &Raster, buffer: &mut Buffer) {
        let mut labels = Labels::new(frame.plot);
        for (values, style) in self.curves.iter().skip(1) {
            let step = values.len().div_ceil(MOST_STARS).max(1);
            for (position, value) in values.iter().enumerate().step_by(step).filter(|(_, v)| v.is_finite()) {
                labels.put(frame.cell(position as f64, *value), "*", *style);
            }
        }
        labels.write(raster, buffer);
    }

    fn draw_marks(&self, frame: &Frame<'_>, raster: &Raster, style: Style, buffer: &mut Buffer) {
        let Some((values, _)) = self.curves.first() else { return };
        let mut labels = Labels::new(frame.plot);
        for &(at, mark) in &self.marks {
            let value = if mark == Mark::Zero { 0.0 } else { between(values, at) };
            let at = at.min(values.len().saturating_sub(1) as f64);
            labels.put(frame.cell(at, value), mark.sign(), style);
        }
        labels.write(raster, buffer);
    }

    /// The cursor: a line where nothing else is drawn, so that it is seen without color.
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
    let (count, part) = (values.len().max(1), at - at.floor());
    let i = whole(at.floor().max(0.0)) % count;
    let [a, b] = [i, (i + 1) % count].map(|i| values.get(i).copied().unwrap_or(f64::NAN));
    if part > 0.0 { a + part * (b - a) } else { a }
}

/// The plotted area and its axes.
#[derive(Debug)]
struct Frame<'a> {
    plot: Rect,
    axis: ValueAxis,
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

    fn cell(&self, position: f64, value: f64) -> [f64; 2] {
        [self.column(position), self.axis.row(value)]
    }

    fn curve(&self, values: &[f64], joined: bool, style: Style, raster: &mut Raster) {
        let at = |i: usize| self.cell(i as f64, values[i]);
        for i in (0..values.len()).filter(|i| values[*i].is_finite()) {
            if joined && values.get(i + 1).is_some_and(|next| next.is_finite()) {
                raster.line(at(i), at(i + 1), Stroke::Solid, style);
            } else {
                raster.dot(at(i), '*', style);
            }
        }
    }
}
