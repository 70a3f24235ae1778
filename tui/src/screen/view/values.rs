//! The list of the scene's numbers, below the view, which follows their changes.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::widgets::{Block, Borders, Widget};
use unicode_width::UnicodeWidthStr;

use super::results;
use crate::number::plain;
use crate::screen::draw::{put, short};
use crate::screen::state::{Role, State};

/// Least and greatest height, with the title.
const HEIGHT: [u16; 2] = [7, 16];
/// Greatest width of the keys.
const KEYS: usize = 46;
/// Columns that a value and its change need beside the key.
const VALUE: usize = 24;
/// Columns of the results before and after a change.
const RESULTS: u16 = 42;

/// Number of rows of the list in a body of this height.
pub(crate) fn height(body: Rect) -> u16 {
    (body.height / 3).clamp(HEIGHT[0], HEIGHT[1]).min(body.height)
}

/// Draws the list, and beside it what has changed in the results.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let beside = if results::rows(state).is_empty() { 0 } else { RESULTS.min(area.width / 2) };
    let [list, beside] = Layout::horizontal([Constraint::Min(0), Constraint::Length(beside)]).areas(area);
    draw_list(state, list, buffer);
    results::draw(state, beside, buffer);
}

fn draw_list(state: &State, area: Rect, buffer: &mut Buffer) {
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
    let widest = what.values.iter().map(|value| value.key.width()).max().unwrap_or(0);
    let widest = widest.min(KEYS).min(usize::from(area.width).saturating_sub(VALUE));
    let rows = usize::from(inner.height);
    let skip = what.chosen.saturating_sub(rows / 2).min(what.values.len().saturating_sub(rows));
    for (row, (index, value)) in what.values.iter().enumerate().skip(skip).take(rows).enumerate() {
        let chosen = index == what.chosen;
        let sign = [' ', '>'][usize::from(chosen)];
        let mark = [' ', '*'][usize::from(what.is_changed(index))];
        let (key, shown) = (tail(&value.key, widest), what.shown(index));
        let room = usize::from(area.width).saturating_sub(widest + 5);
        // Where both don't fit, the new value is more informative than the old one.
        let shown = match shown.split_once(" -> ") {
            Some((_, new)) if shown.width() > room => format!("-> {new}"),
            _ => shown,
        };
        let text = format!("{sign}{mark} {key:<widest$}  {shown}");
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
