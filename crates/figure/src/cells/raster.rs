//! A grid of dots that is converted to characters: Braille, half blocks, or ASCII strokes.

use super::{Marker, Spot};
use crate::bounds::Bounds;
use crate::model::{Ink, Stroke};

/// A piece of a chain longer than this many dots is beyond any screen.
const MOST_DOTS: f64 = 1e5;

#[derive(Debug, Clone, Copy)]
struct Cell {
    bits: u8,
    letter: char,
    ink: Ink,
}

/// The distance of the dots of a stroke; 1 for a line.
fn spacing(stroke: Stroke) -> usize {
    match stroke {
        Stroke::Solid | Stroke::Thick | Stroke::Fine => 1,
        Stroke::Dashed => 2,
        Stroke::Dotted | Stroke::Stars => 3,
        Stroke::Chain => 6,
    }
}

/// The dots of one area. Coordinates are cells from the area's upper left corner, as real numbers.
#[derive(Debug)]
pub(crate) struct Raster {
    marker: Marker,
    columns: usize,
    rows: usize,
    cells: Vec<Cell>,
}

impl Raster {
    pub(crate) fn new([columns, rows]: [u16; 2], marker: Marker) -> Self {
        let (columns, rows) = (usize::from(columns), usize::from(rows));
        let blank = Cell { bits: 0, letter: ' ', ink: Ink::Text };
        Self { marker, columns, rows, cells: vec![blank; columns * rows] }
    }

    /// Sets the dot at a place; outside is ignored.
    fn dot(&mut self, at: [f64; 2], letter: char, ink: Ink) {
        let (across, down) = dots(self.marker);
        let (x, y) = ((at[0] * across as f64).floor(), (at[1] * down as f64).floor());
        if !(x >= 0.0 && y >= 0.0 && x < (self.columns * across) as f64 && y < (self.rows * down) as f64) {
            return;
        }
        let (x, y) = (whole(x), whole(y));
        let cell = &mut self.cells[(y / down) * self.columns + x / across];
        cell.bits |= bit(self.marker, x % across, y % down);
        cell.letter = letter;
        cell.ink = ink;
    }

    fn line(&mut self, from: [f64; 2], to: [f64; 2], ink: Ink) {
        // The part near the area: a line to a far end would take too long.
        let far = [self.columns as f64 + 1.0, self.rows as f64 + 1.0];
        let near = Bounds { low: [-1.0; 2], high: far };
        let Some([from, to]) = near.cut([from, to]) else { return };
        let (across, down) = dots(self.marker);
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let steps = (dx.abs() * across as f64).max(dy.abs() * down as f64).ceil().max(1.0);
        let letter = slope(dx, dy);
        for step in 0..=whole(steps) {
            let part = step as f64 / steps;
            self.dot([from[0] + part * dx, from[1] + part * dy], letter, ink);
        }
    }

    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], stroke: Stroke, ink: Ink) {
        let every = spacing(stroke);
        if every == 1 {
            points.windows(2).for_each(|two| self.line(two[0], two[1], ink));
            return;
        }
        // Dots at equal distances along the whole chain, whatever the length of its pieces.
        let (across, down) = dots(self.marker);
        let gap = if self.marker == Marker::Braille { every as f64 } else { 1.0 };
        let letter = if stroke == Stroke::Stars { '*' } else { '.' };
        let mut travelled = gap;
        for two in points.windows(2) {
            let [dx, dy] = [two[1][0] - two[0][0], two[1][1] - two[0][1]];
            let length = (dx * across as f64).hypot(dy * down as f64);
            if !length.is_finite() || length > MOST_DOTS {
                continue;
            }
            let mut part = gap - travelled;
            while part < length {
                let t = part / length;
                self.dot([two[0][0] + t * dx, two[0][1] + t * dy], letter, ink);
                part += gap;
            }
            travelled = gap - (part - length);
        }
    }

    pub(crate) fn is_free(&self, column: usize, row: usize) -> bool {
        column < self.columns && row < self.rows && self.cells[row * self.columns + column].bits == 0
    }

    /// The character of a cell; `None` where nothing is drawn.
    pub(crate) fn symbol(&self, column: usize, row: usize) -> Option<(char, Ink)> {
        let cell = self.cells.get(row * self.columns + column).filter(|cell| cell.bits != 0)?;
        Some((symbol(self.marker, cell), cell.ink))
    }

    pub(crate) fn spots(&self) -> impl Iterator<Item = Spot> {
        (0..self.rows).flat_map(move |row| (0..self.columns).map(move |column| (column, row))).filter_map(
            |(column, row)| {
                let (symbol, ink) = self.symbol(column, row)?;
                Some(Spot { column: short(column), row: short(row), text: symbol.to_string(), ink })
            },
        )
    }
}

/// A non-negative whole number in range; others become 0.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "checked by the caller to lie in the raster"
)]
pub(crate) fn whole(x: f64) -> usize {
    x as usize
}

/// A count as a screen coordinate.
pub fn short(x: usize) -> u16 {
    u16::try_from(x).unwrap_or(u16::MAX)
}

fn dots(marker: Marker) -> (usize, usize) {
    match marker {
        Marker::Braille => (2, 4),
        Marker::HalfBlock => (1, 2),
        Marker::Ascii => (1, 1),
    }
}

fn bit(marker: Marker, x: usize, y: usize) -> u8 {
    match marker {
        Marker::Braille => [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]][x][y],
        Marker::HalfBlock => [1, 2][y],
        Marker::Ascii => 1,
    }
}

fn symbol(marker: Marker, cell: &Cell) -> char {
    match marker {
        Marker::Braille => char::from_u32(0x2800 + u32::from(cell.bits)).unwrap_or(' '),
        Marker::HalfBlock => [' ', '▀', '▄', '█'][usize::from(cell.bits & 3)],
        Marker::Ascii => cell.letter,
    }
}

/// The character that looks like a stroke; a cell is assumed to be twice as high as wide.
fn slope(dx: f64, dy: f64) -> char {
    let angle = (2.0 * dy).atan2(dx).to_degrees().rem_euclid(180.0);
    match angle {
        a if !(22.5..157.5).contains(&a) => '-',
        a if a < 67.5 => '\\',
        a if a < 112.5 => '|',
        _ => '/',
    }
}
