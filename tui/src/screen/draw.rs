//! Drawing into cells: text, and figures in the styles of the theme.

use std::ops::Range;

pub(crate) use assur_figure::cells::{cut, short};

use assur_figure::cells::{self, Look};
use assur_figure::{Figure, Frame, Ink};
use assur_words::Text;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use textwrap::Options;

use crate::screen::state::{Role, State, Zoom};
use crate::screen::view::LEAST;

/// Rows of the header of the screen.
const HEADER: u16 = 2;
/// Rows of a chart that is not low.
const LOW: u16 = 12;

/// How a figure is drawn in cells now, in the whole or zoomed.
pub(crate) fn cells(state: &State, zoom: Zoom) -> Look {
    Look { marker: state.look.marker, ratio: state.look.ratio, zoom, language: state.language() }
}

/// What a view is drawn with: the state that it shows, and the cells that it fills.
pub(crate) struct Pen<'a> {
    pub(crate) state: &'a State,
    pub(crate) buffer: &'a mut Buffer,
}

impl Pen<'_> {
    pub(crate) fn paint(&mut self, figure: &Figure, area: Rect) {
        self.paint_zoomed(figure, Zoom::WHOLE, area);
    }

    pub(crate) fn paint_zoomed(&mut self, figure: &Figure, zoom: Zoom, area: Rect) {
        let state = self.state;
        if zoom == Zoom::WHOLE && state.shows_pictures() && area.width > 0 && area.height > 0 {
            let mut figure = figure.clone();
            for panel in &mut figure.panels {
                if let Frame::Plane { scales, .. } = &mut panel.frame {
                    // A millimeter of a screen is not known.
                    for scale in scales {
                        scale.symbol = "";
                    }
                }
            }
            return state.shown.borrow_mut().push((figure, area));
        }
        let height = height(state, figure, area);
        for spot in cells::draw(figure, [area.width, height], cells(state, zoom)) {
            self.put(area, spot.column, spot.row, &spot.text, role(spot.ink));
        }
    }

    /// Writes a text into an area; an ellipsis at the right edge shows that the rest is missing. Does nothing outside.
    pub(crate) fn put(&mut self, area: Rect, column: u16, row: u16, text: &str, role: Role) {
        if row < area.height && column < area.width {
            let (room, style) = (usize::from(area.width - column), self.state.look.theme.style(role));
            self.buffer.set_stringn(area.x + column, area.y + row, cut(text, room), room, style);
        }
    }

    /// Writes a text in the language of the screen.
    pub(crate) fn tell(&mut self, area: Rect, column: u16, row: u16, text: impl Into<Text>, role: Role) {
        self.put(area, column, row, &self.state.told(text), role);
    }

    pub(crate) fn put_lines<'l>(
        &mut self,
        area: Rect,
        column: u16,
        lines: impl IntoIterator<Item = &'l (Role, String)>,
    ) {
        for (row, (role, line)) in lines.into_iter().enumerate() {
            let is_small = self.buffer.area.width < LEAST.0 || self.buffer.area.height < LEAST.1;
            debug_assert!(is_small || row < usize::from(area.height), "a line is lost: {line}");
            self.put(area, column, short(row), line, *role);
        }
    }
}

/// What shows that rows are out of sight.
impl Pen<'_> {
    /// Marks an area in which some of so many rows are in sight: a bar at its right edge, and which of how many. Nothing where all are.
    pub(crate) fn mark_rows(&mut self, area: Rect, seen: Range<usize>, all: usize) {
        if seen.len() >= all || area.width == 0 || area.height == 0 {
            return;
        }
        let height = usize::from(area.height);
        let [top, end] = [seen.start * height / all, (seen.end * height).div_ceil(all)];
        for row in 0..height {
            let (sign, role) =
                if (top..end).contains(&row) { ("█", Role::Key) } else { ("│", Role::Dim) };
            self.put(area, area.width - 1, short(row), sign, role);
        }
        let count = format!(" {}-{} / {all}", seen.start + 1, seen.end);
        let width = short(count.len()).min(area.width - 1);
        let (left, style) = (area.right() - 1 - width, self.state.look.theme.style(Role::Key));
        // Where nothing is written, at best above.
        let is_free = |row: &u16| {
            (left..left + width).all(|column| [" ", "─"].contains(&self.buffer[(column, *row)].symbol()))
        };
        let above = area.y.checked_sub(1).filter(|row| *row >= self.buffer.area.y + HEADER);
        if let Some(row) = above.into_iter().chain(area.y..area.bottom()).find(is_free) {
            self.buffer.set_stringn(left, row, count, width.into(), style);
        }
    }
}

/// Rows for a figure: each chart is at least twice as wide as high, or has [`LOW`] rows.
fn height(state: &State, figure: &Figure, area: Rect) -> u16 {
    let charts = figure.panels.iter().all(|panel| matches!(panel.frame, Frame::Axes { .. }));
    let columns = figure.columns.clamp(1, figure.panels.len().max(1));
    let rows = short(figure.panels.len().div_ceil(columns));
    let width = f64::from(area.width) / columns as f64;
    let most = (0..area.height).rev().find(|rows| 2.0 * state.look.ratio * f64::from(*rows) <= width);
    if charts { area.height.min(rows.saturating_mul(most.unwrap_or(0).max(LOW))) } else { area.height }
}

fn role(ink: Ink) -> Role {
    match ink {
        Ink::Text => Role::Plain,
        Ink::Title => Role::Header,
        Ink::Dim => Role::Dim,
        Ink::Marked => Role::Chosen,
        Ink::Cursor => Role::Key,
        own => Role::Drawn(own),
    }
}

/// Indent of the continuation lines of a line that is too long, in columns.
const HANGING: usize = 4;

/// A text in lines of at most this many columns, broken at spaces where possible.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    textwrap::wrap(text, Options::new(width).break_words(false)).into_iter().map(Into::into).collect()
}

/// A line broken at spaces into as many rows as needed; all after the first are indented further.
pub(crate) fn folded(line: &str, width: usize) -> Vec<String> {
    let text = line.trim_start_matches(' ');
    let indent = line.len() - text.len();
    let (first, rest) = (" ".repeat(indent), " ".repeat(indent + HANGING));
    let options = Options::new(width).break_words(false).initial_indent(&first).subsequent_indent(&rest);
    textwrap::wrap(text, options).into_iter().map(Into::into).collect()
}
