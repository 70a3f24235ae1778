//! The list of the scene's numbers, below the view, which follows their changes.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Borders, Widget};
use unicode_width::UnicodeWidthStr;

use crate::number::plain;
use crate::screen::draw::{put, short};
use crate::screen::state::{Role, State};

/// Least and greatest height, with the title.
const HEIGHT: [u16; 2] = [7, 16];
/// Greatest width of the keys.
const KEYS: usize = 46;

/// Number of rows of the list in a body of this height.
pub(crate) fn height(body: Rect) -> u16 {
    (body.height / 3).clamp(HEIGHT[0], HEIGHT[1]).min(body.height)
}

/// Draws the list.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let (what, theme) = (&state.what_if, state.look.theme);
    let place = format!(" {} / {} ", (what.chosen + 1).min(what.values.len()), what.values.len());
    let title = format!(" What if: step {} %, changed: {} ", plain(what.per_cent()), what.changes());
    let block = Block::new().borders(Borders::TOP).title(title).title_bottom("");
    let inner = block.inner(area);
    block.render(area, buffer);
    put(
        buffer,
        area,
        area.width.saturating_sub(short(place.width()) + 1),
        0,
        &place,
        theme.style(Role::Plain),
    );
    let widest = what.values.iter().map(|value| value.key.width()).max().unwrap_or(0).min(KEYS);
    let rows = usize::from(inner.height);
    let skip = what.chosen.saturating_sub(rows / 2).min(what.values.len().saturating_sub(rows));
    for (row, (index, value)) in what.values.iter().enumerate().skip(skip).take(rows).enumerate() {
        let chosen = index == what.chosen;
        let sign = [' ', '>'][usize::from(chosen)];
        let mark = [' ', '*'][usize::from(what.is_changed(index))];
        let text = format!("{sign}{mark} {:<widest$}  {}", tail(&value.key, widest), what.shown(index));
        let role = if chosen { Role::Cursor } else { Role::Plain };
        put(buffer, inner, 0, short(row), &text, theme.style(role));
    }
}

/// The end of a key that is too long: it is more informative than the beginning.
pub(crate) fn tail(key: &str, width: usize) -> String {
    let count = key.chars().count();
    if count <= width {
        return key.to_owned();
    }
    let end: String = key.chars().skip((count + 2).saturating_sub(width)).collect();
    format!("..{end}").chars().take(width).collect()
}
