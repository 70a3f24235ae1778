//! A scatter drawn with characters.

use super::scatter::{Scatter, letter};
use super::units;

/// Width of the labels left of the plot.
const MARGIN: usize = 7;

/// Characters of a drawing.
struct Strokes {
    line: char,
    grid: char,
    upright: char,
    level: char,
    corner: char,
    tick: char,
}

const ASCII: Strokes = Strokes { line: '.', grid: ' ', upright: '|', level: '-', corner: '+', tick: '+' };
const UNICODE: Strokes =
    Strokes { line: '·', grid: ' ', upright: '│', level: '─', corner: '└', tick: '┴' };

/// Draws a scatter in about `width` columns and `height` lines, legend apart.
pub(crate) fn draw(scatter: &Scatter, width: usize, height: usize, ascii: bool) -> String {
    let strokes = if ascii { &ASCII } else { &UNICODE };
    let canvas = Canvas::new(scatter, width.saturating_sub(MARGIN + 1).max(20), height.max(6), strokes);
    canvas.text(ascii)
}

/// The methods by letter, wrapped.
pub(crate) fn legend(scatter: &Scatter, width: usize, ascii: bool) -> String {
    let mut lines = vec![String::new()];
    for (index, name) in scatter.methods.iter().enumerate() {
        let entry = format!("  {} {name}", letter(index));
        let full = lines.last().is_some_and(|line| !line.is_empty() && line.len() + entry.len() > width);
        if full {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            *line += &entry;
        }
    }
    let dots = if ascii { "..." } else { "···" };
    lines.push(format!("  {dots} Pareto front: no other method is both faster and more exact"));
    lines.join("\n") + "\n"
}

struct Canvas<'a> {
    scatter: &'a Scatter,
    strokes: &'a Strokes,
    cells: Vec<Vec<char>>,
}

impl<'a> Canvas<'a> {
    fn new(scatter: &'a Scatter, columns: usize, rows: usize, strokes: &'a Strokes) -> Self {
        let cells = vec![vec![strokes.grid; columns]; rows];
        let mut canvas = Self { scatter, strokes, cells };
        canvas.join_front();
        // Marks of the front last, so that they are on top.
        for front in [false, true] {
            for mark in scatter.marks.iter().filter(|mark| mark.front == front) {
                let (column, row) = canvas.cell(mark.seconds, mark.error);
                canvas.cells[row][column] = letter(mark.method);
            }
        }
        canvas
    }

    fn cell(&self, seconds: f64, error: f64) -> (usize, usize) {
        let (columns, rows) = (self.cells[0].len(), self.cells.len());
        let column = place(seconds.log10(), self.scatter.time_decades, columns);
        let row = place(error.log10(), self.scatter.error_decades, rows);
        (column, rows - 1 - row)
    }

    /// Dots between the marks of the front.
    fn join_front(&mut self) {
        let cells: Vec<_> =
            self.scatter.front().iter().map(|mark| self.cell(mark.seconds, mark.error)).collect();
        for two in cells.windows(2) {
            let ((x0, y0), (x1, y1)) = (two[0], two[1]);
            let steps = x0.abs_diff(x1).max(y0.abs_diff(y1)).max(1);
            for step in 0..=steps {
                let part = step as f64 / steps as f64;
                let (x, y) = (between(x0, x1, part), between(y0, y1, part));
                self.cells[y][x] = self.strokes.line;
            }
        }
    }

    fn text(&self, ascii: bool) -> String {
        let rows = self.cells.len();
        let [low, high] = self.scatter.error_decades;
        let mut labels = vec![String::new(); rows];
        let every = spacing(high - low, rows / 2);
        for exponent in (low..=high).filter(|exponent| (exponent - low) % every == 0) {
            labels[rows - 1 - place(f64::from(exponent), [low, high], rows)] = format!("1e{exponent}");
        }
        let mut text = String::from("  relative error\n");
        for (label, cells) in labels.iter().zip(&self.cells) {
            let line: String = cells.iter().collect();
            let line = format!("{label:>MARGIN$} {}{line}", self.strokes.upright);
            text += line.trim_end();
            text.push('\n');
        }
        text + &self.axis(ascii)
    }

    /// The axis of time with its decades.
    fn axis(&self, ascii: bool) -> String {
        let columns = self.cells[0].len();
        let [low, high] = self.scatter.time_decades;
        let mut line = vec![self.strokes.level; columns];
        let mut labels = String::new();
        let every = spacing(high - low, columns / 10);
        for exponent in (low..=high).filter(|exponent| (exponent - low) % every == 0) {
            let at = place(f64::from(exponent), [low, high], columns);
            line[at] = self.strokes.tick;
            let label = units::decade(exponent, ascii);
            let wide = label.chars().count();
            let start = (MARGIN + 2 + at).saturating_sub(wide / 2);
            let gap = start.saturating_sub(labels.chars().count());
            labels += &" ".repeat(gap);
            labels += &label;
        }
        let line: String = line.into_iter().collect();
        let unit = self.scatter.stage.unit_words();
        format!("{:MARGIN$} {}{line}\n{labels}\n{:MARGIN$}  time of {unit}\n", "", self.strokes.corner, "")
    }
}

/// Index of the cell of a logarithm.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the cells")]
fn place(logarithm: f64, [low, high]: [i32; 2], cells: usize) -> usize {
    let part = (logarithm - f64::from(low)) / f64::from(high - low);
    let last = (cells - 1) as f64;
    (part * last).round().clamp(0.0, last) as usize
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lies between two indices")]
fn between(a: usize, b: usize, part: f64) -> usize {
    (a as f64 + (b as f64 - a as f64) * part).round() as usize
}

/// Decades from one label to the next, so that at most `most` are written.
fn spacing(decades: i32, most: usize) -> i32 {
    let most = i32::try_from(most.max(1)).unwrap_or(i32::MAX);
    (decades + most - 1) / most.max(1)
}
