//! A grid of dots that is converted to characters: Braille, half blocks, or ASCII strokes.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::screen::state::Marker;

/// The style of a stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stroke {
    /// A line.
    Solid,
    /// One dot out of this many.
    Dotted(usize),
}

/// A piece of a chain longer than this many dots is beyond any screen.
const MOST_DOTS: f64 = 1e5;

#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    bits: u8,
    letter: char,
    style: Style,
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
    pub(crate) fn new(area: Rect, marker: Marker) -> Self {
        let (columns, rows) = (usize::from(area.width), usize::from(area.height));
        Self { marker, columns, rows, cells: vec![Cell::default(); columns * rows] }
    }

    /// Sets the dot at a place; outside is ignored.
    pub(crate) fn dot(&mut self, at: [f64; 2], letter: char, style: Style) {
        let (across, down) = dots(self.marker);
        let (x, y) = ((at[0] * across as f64).floor(), (at[1] * down as f64).floor());
        if !(x >= 0.0 && y >= 0.0 && x < (self.columns * across) as f64 && y < (self.rows * down) as f64) {
            return;
        }
        let (x, y) = (whole(x), whole(y));
        let cell = &mut self.cells[(y / down) * self.columns + x / across];
        cell.bits |= bit(self.marker, x % across, y % down);
        cell.letter = letter;
        cell.style = style;
    }

    /// Draws a straight line.
    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: Stroke, style: Style) {
        let Some([from, to]) = self.clipped(from, to) else { return };
        let (across, down) = dots(self.marker);
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let steps = (dx.abs() * across as f64).max(dy.abs() * down as f64).ceil().max(1.0);
        let letter = match stroke {
            Stroke::Solid => slope(dx, dy),
            Stroke::Dotted(_) => '.',
        };
        let every = if let Stroke::Dotted(every) = stroke { every.max(1) } else { 1 };
        for step in (0..=whole(steps)).step_by(every) {
            let part = step as f64 / steps;
            self.dot([from[0] + part * dx, from[1] + part * dy], letter, style);
        }
    }

    /// Draws a chain of lines.
    pub(crate) fn polyline(&mut self, points: &[[f64; 2]], stroke: Stroke, style: Style) {
        let Stroke::Dotted(every) = stroke else {
            points.windows(2).for_each(|two| self.line(two[0], two[1], stroke, style));
            return;
        };
        // Dots at equal distances along the whole chain, whatever the length of its pieces.
        let (across, down) = dots(self.marker);
        let gap = if self.marker == Marker::Braille { every as f64 } else { 1.0 };
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
                self.dot([two[0][0] + t * dx, two[0][1] + t * dy], '.', style);
                part += gap;
            }
            travelled = gap - (part - length);
        }
    }

    /// Whether nothing is drawn in a cell.
    pub(crate) fn is_free(&self, column: usize, row: usize) -> bool {
        column < self.columns && row < self.rows && self.cells[row * self.columns + column].bits == 0
    }

    /// Writes the dots into a buffer; cells without dots are unchanged.
    pub(crate) fn paint(&self, area: Rect, buffer: &mut Buffer) {
        for row in 0..self.rows {
            for column in 0..self.columns {
                let cell = &self.cells[row * self.columns + column];
                if cell.bits == 0 {
                    continue;
                }
                let (x, y) = (area.x.saturating_add(short(column)), area.y.saturating_add(short(row)));
                if let Some(target) = buffer.cell_mut((x, y)) {
                    target.set_char(symbol(self.marker, cell)).set_style(cell.style);
                }
            }
        }
    }

    /// The part of a line near the area: a line to a far end would take too long.
    fn clipped(&self, from: [f64; 2], to: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        let limits = [self.columns as f64, self.rows as f64];
        let (mut low, mut high) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let d = to[axis] - from[axis];
            if !d.is_finite() {
                return None;
            }
            let (a, b) = (-1.0 - from[axis], limits[axis] + 1.0 - from[axis]);
            if d.abs() < 1e-12 {
                if a > 0.0 || b < 0.0 {
                    return None;
                }
                continue;
            }
            let (a, b) = ((a / d).min(b / d), (a / d).max(b / d));
            (low, high) = (low.max(a), high.min(b));
        }
        let at = |t: f64| [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
        (low <= high).then(|| [at(low), at(high)])
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
pub(crate) fn short(x: usize) -> u16 {
    u16::try_from(x).unwrap_or(u16::MAX)
}

/// Dots of a cell: across, down.
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
