//! Text in cells: written, cut, wrapped.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use textwrap::Options;

use crate::screen::state::{Role, State};

/// Indent of the continuation lines of a line that is too long, in columns.
const HANGING: usize = 4;

/// Writes a text into an area, cut at its right edge; does nothing outside.
pub(crate) fn put(buffer: &mut Buffer, area: Rect, column: u16, row: u16, text: &str, style: Style) {
    if row < area.height && column < area.width {
        buffer.set_stringn(area.x + column, area.y + row, text, usize::from(area.width - column), style);
    }
}

/// Writes English lines one below the other, in the language of the screen.
pub(crate) fn put_lines<'a>(
    buffer: &mut Buffer,
    area: Rect,
    column: u16,
    state: &State,
    lines: impl IntoIterator<Item = &'a (Role, String)>,
) {
    for (row, (role, line)) in lines.into_iter().enumerate() {
        put(buffer, area, column, short(row), &state.words().shown(line), state.look.theme.style(*role));
    }
}

/// A table in lines: its head, then its rows, each column as wide as it needs.
pub(crate) fn table(head: &[&str], rows: &[Vec<String>]) -> Vec<(Role, String)> {
    let text = assur_report::text::columns(head, rows, false);
    // The second line is a rule.
    let lines = text.lines().enumerate().filter(|(number, _)| *number != 1);
    lines.map(|(number, line)| (if number == 0 { Role::Dim } else { Role::Plain }, line.to_owned())).collect()
}

/// The first item of a list that is shown in this many rows, with the chosen item as the last at most.
pub(crate) fn first_shown(chosen: usize, rows: usize) -> usize {
    (chosen + 1).saturating_sub(rows)
}

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

/// A count as a screen coordinate.
pub(crate) fn short(x: usize) -> u16 {
    u16::try_from(x).unwrap_or(u16::MAX)
}
