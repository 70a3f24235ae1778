//! A plane in cells, with one scale for both directions.

use assur_words::Language;

use super::raster::{short, whole};
use super::{Look, Spot, draw_marks, headed, heading};
use crate::bounds::Bounds;
use crate::model::{Frame, Ink, Panel, Point};
use crate::scale::Scale;
use crate::trace::Paper;

/// Columns left free at each side for names, and rows for hatching.
///
/// The eighth keeps a line on the edge from taking another cell.
const MARGIN: [f64; 2] = [4.125, 1.125];
/// Greatest length of the scale bar, in cell widths.
const BAR: f64 = 12.0;
/// Columns of a scale with its bar.
const SCALE: u16 = 24;
/// Least size of a plane that is drawn.
const LEAST: [u16; 2] = [12, 4];

/// Panel to widths of a cell.
struct Map {
    center: Point,
    middle: Point,
    /// Width of a cell in the units of the plane.
    unit: f64,
}

impl Map {
    fn fit(bounds: &Bounds, [columns, rows]: [u16; 2], look: Look) -> Self {
        let room = |cells: u16, margin: f64| (f64::from(cells) - 2.0 * margin).max(1.0);
        let [width, height] = bounds.size();
        let unit = (width / room(columns, MARGIN[0])).max(height / (room(rows, MARGIN[1]) * look.ratio));
        let unit = if unit.is_finite() && unit > 0.0 { unit } else { 1.0 };
        let center = bounds.center();
        let center = [0, 1].map(|axis| center[axis] + look.zoom.shift[axis] * width.max(height));
        let center = center.map(|x| if x.is_finite() { x } else { 0.0 });
        let middle = [f64::from(columns) / 2.0, f64::from(rows) * look.ratio / 2.0];
        Self { center, middle, unit: unit / look.zoom.factor }
    }

    fn place(&self, at: Point) -> Point {
        let [x, y] = [0, 1].map(|axis| (at[axis] - self.center[axis]) / self.unit);
        [self.middle[0] + x, self.middle[1] - y]
    }

    fn point(&self, [x, y]: Point) -> Point {
        [self.center[0] + (x - self.middle[0]) * self.unit, self.center[1] - (y - self.middle[1]) * self.unit]
    }
}

/// Rows of a panel above and below its drawing: the heading, the scales.
fn around(panel: &Panel, size: [u16; 2], look: Look) -> [u16; 2] {
    let Frame::Plane { scales, .. } = &panel.frame else { return [0; 2] };
    [title(panel, size, look).len(), scales.len().div_ceil(scales_of_row(size[0]))].map(short)
}

/// How many scales stand beside each other.
fn scales_of_row(width: u16) -> usize {
    usize::from((width / SCALE).max(1))
}

fn title(panel: &Panel, [width, height]: [u16; 2], look: Look) -> Vec<String> {
    let title = panel.title.render(look.language);
    if title.is_empty() { Vec::new() } else { heading(&title, "", width, height) }
}

/// The point of the plane in the middle of a cell of a panel of so many columns and rows; `None` outside its drawing.
pub fn point_at(panel: &Panel, size: [u16; 2], look: Look, [column, row]: [u16; 2]) -> Option<Point> {
    let Frame::Plane { bounds, .. } = &panel.frame else { return None };
    let ([width, height], [above, below]) = (size, around(panel, size, look));
    let rows = height.checked_sub(above + below)?;
    let row = row.checked_sub(above).filter(|row| *row < rows && column < width)?;
    let map = Map::fit(bounds, [width, rows], look);
    Some(map.point([f64::from(column) + 0.5, (f64::from(row) + 0.5) * look.ratio]))
}

pub(super) fn draw(panel: &Panel, [width, height]: [u16; 2], look: Look) -> Vec<Spot> {
    let Frame::Plane { bounds, scales } = &panel.frame else { return Vec::new() };
    let [above, below] = around(panel, [width, height], look);
    let Some(rows) = height.checked_sub(above + below).filter(|_| width >= LEAST[0] && height >= LEAST[1])
    else {
        return Vec::new();
    };
    let size = [width, rows];
    let map = Map::fit(bounds, size, look);
    let paper = Paper { place: |at| map.place(at), em: look.ratio, gap: 0.4 };
    let marks: Vec<_> = panel.items.iter().flat_map(|item| paper.marks(item)).collect();
    let (raster, labels) = draw_marks(&marks, size, look);
    let spots = raster.spots().chain(labels.into_spots());
    let mut spots: Vec<_> = spots.map(|spot| Spot { row: spot.row + above, ..spot }).collect();
    spots.extend(headed(title(panel, [width, height], look), 0));
    if bounds.size().iter().any(|side| *side != 0.0) {
        let beside = scales_of_row(width);
        spots.extend(scales.iter().enumerate().map(|(index, scale)| {
            let text = bar(scale, map.unit, look.language);
            let (column, row) = (SCALE * short(index % beside), above + rows + short(index / beside));
            Spot { column, row, text, ink: Ink::Dim }
        }));
    }
    spots
}

/// A bar of a round length: `|----| 100 mm`.
fn bar(scale: &Scale, width: f64, language: &Language) -> String {
    let (length, told) = scale.bar(BAR * width);
    let dashes = "-".repeat(usize::from(short(whole((length / width).round().clamp(2.0, 40.0)))) - 1);
    format!("|{dashes}| {}", told.render(language))
}
