//! A plot in cells, with its axes.

use assur_words::{Language, number};
use unicode_width::UnicodeWidthStr;

use super::raster::{short, whole};
use super::{Look, Spot, draw_marks, headed, heading};
use crate::axis::{Axis, AxisKind};
use crate::model::{Cursor, Frame, Ink, Item, Panel, Point, Stroke};
use crate::number::plain;
use crate::trace::{Paper, stars};

/// Columns of the vertical axis with its labels.
const LABELS: u16 = 11;
/// Rows of the horizontal axis: numbers, and the name.
pub(super) const BELOW: u16 = 2;
/// Columns for each number of the horizontal axis.
const TICK: u16 = 9;
/// An end of the axis that is this small compared with the other is shown as zero.
const ROUNDING: f64 = 1e-12;

/// Panel to cells of its plot.
struct Map<'a> {
    x: &'a Axis,
    y: &'a Axis,
    size: [u16; 2],
}

impl Map<'_> {
    fn column(&self, x: f64) -> f64 {
        self.x.part(x) * f64::from(self.size[0].saturating_sub(1)) + 0.5
    }

    /// The row of a value; the ends stay a little inside.
    fn row(&self, y: f64) -> f64 {
        (1.0 - self.y.part(y)) * (f64::from(self.size[1]) - 0.25) + 0.1
    }
}

/// Columns of the plot of a panel: one stays free at its right.
fn columns(width: u16) -> u16 {
    width.saturating_sub(LABELS + 1)
}

pub(super) fn draw(panel: &Panel, shows_axis: bool, [width, height]: [u16; 2], look: Look) -> Vec<Spot> {
    let Frame::Axes { x, y, cursor } = &panel.frame else { return Vec::new() };
    let below = if shows_axis { BELOW } else { 0 };
    if width <= LABELS + 2 || height < below + 2 {
        return Vec::new();
    }
    let value = cursor.as_ref().map(|cursor| cursor.value.render(look.language)).unwrap_or_default();
    let title = heading(&panel.title.render(look.language), &value, width - 1, height - below);
    let above = short(title.len());
    let size = [columns(width), height - above - below];
    let map = Map { x, y, size };
    // Widths of a cell, as the marks want it.
    let place = |at: Point| [map.column(at[0]), map.row(at[1]) * look.ratio];
    let paper = Paper { place, em: look.ratio, gap: 0.4 };
    let zero = (y.range[0] < 0.0 && y.range[1] > 0.0)
        .then(|| Item::line(x.range.map(|at| [at, 0.0]), Stroke::Chain, Ink::Dim));
    let stars = panel.items.iter().flat_map(stars);
    let marks: Vec<_> = zero.iter().chain(&panel.items).flat_map(|item| paper.marks(item)).collect();
    let stars: Vec<_> = stars.flat_map(|item| paper.marks(&item)).collect();
    let (raster, labels) = draw_marks(&[marks, stars].concat(), size, look);
    let mut spots: Vec<Spot> = raster.spots().collect();
    if let Some(Cursor { at, .. }) = cursor {
        // A line where nothing else is drawn, so that it is seen without color.
        let column = map.column(*at);
        for row in (0..size[1]).filter(|_| column >= 0.0 && column < f64::from(size[0])) {
            let symbol = raster.symbol(whole(column), usize::from(row)).map_or('│', |(symbol, _)| symbol);
            let text = symbol.to_string();
            spots.push(Spot { column: short(whole(column)), row, text, ink: Ink::Cursor });
        }
    }
    spots.extend(labels.into_spots());
    let plot =
        spots.into_iter().map(|spot| Spot { column: spot.column + LABELS, row: spot.row + above, ..spot });
    let mut spots: Vec<Spot> = plot.collect();
    // A long title begins above the labels of the axis.
    let longest = title.iter().map(|line| short(line.width())).max().unwrap_or(0);
    spots.extend(headed(title, LABELS.min((width - 1).saturating_sub(longest))));
    let labels = vertical(&map, look.language).into_iter();
    spots.extend(labels.map(|spot| Spot { row: spot.row + above, ..spot }));
    if shows_axis {
        spots.extend(horizontal(&map, width, height, look.language));
    }
    spots
}

/// Rows of the plot: the greatest value in the first one, the least in the last one, zero between them; or powers of ten.
fn vertical(map: &Map<'_>, language: &Language) -> Vec<Spot> {
    let rows = map.size[1];
    let [low, high] = map.y.range;
    let row = |value: f64| short(whole(map.row(value).max(0.0)));
    let least = ROUNDING * low.abs().max(high.abs());
    let plain = |value: f64| number(plain(if value.abs() <= least { 0.0 } else { value }));
    let mut labels = vec![(0, plain(high)), (rows.saturating_sub(1), plain(low))];
    let zero = row(0.0);
    if matches!(map.y.kind, AxisKind::Logarithmic | AxisKind::Unmarked) {
        let ticks = map.y.ticks(usize::from(rows / 2)).into_iter();
        labels = ticks.map(|(at, text)| (row(at).min(rows.saturating_sub(1)), text)).collect();
    } else if low < 0.0 && high > 0.0 && zero > 0 && zero + 1 < rows {
        labels.push((zero, plain(0.0)));
    }
    let line = (0..rows).map(|row| Spot { column: LABELS - 1, row, text: "│".to_owned(), ink: Ink::Text });
    let numbers = labels.into_iter().map(|(row, number)| {
        let text = number.render(language);
        let column = LABELS.saturating_sub(short(text.width()) + 1);
        Spot { column, row, text, ink: Ink::Text }
    });
    line.chain(numbers).collect()
}

/// Round values under their columns, the ends where there is no round one, and the name of the axis.
fn horizontal(map: &Map<'_>, width: u16, height: u16, language: &Language) -> Vec<Spot> {
    let mut ticks = map.x.ticks(usize::from(map.size[0] / TICK).max(1));
    if map.x.kind == AxisKind::Linear && ticks.len() < 2 {
        ticks = map.x.range.map(|at| (at, number(plain(at)))).to_vec();
    }
    let mut spots = Vec::new();
    let mut end = 0;
    for (at, text) in ticks {
        let text = text.render(language);
        let column = LABELS + short(whole(map.column(at)));
        let column = column.min(width.saturating_sub(short(text.width())));
        if column >= end {
            end = column + short(text.width()) + 1;
            spots.push(Spot { column, row: height - 2, text, ink: Ink::Text });
        }
    }
    spots.push(Spot { column: LABELS, row: height - 1, text: map.x.label.render(language), ink: Ink::Dim });
    spots
}

pub(super) fn value_at(panel: &Panel, width: u16, column: u16) -> Option<f64> {
    let Frame::Axes { x, .. } = &panel.frame else { return None };
    let columns = columns(width);
    let inside = column.checked_sub(LABELS).filter(|column| *column < columns)?;
    Some(x.value(f64::from(inside) / f64::from(columns.saturating_sub(1).max(1))))
}
