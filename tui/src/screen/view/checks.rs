//! Every check in a line: name, largest residual, limit, place, and in words whether it passes.

use assur_analysis::results::Check;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::screen::draw::{cut, first_shown, put, short};
use crate::screen::state::{Role, Scene, State};

const TITLES: [&str; 5] = ["check", "residual", "limit", "where", "pos."];
/// Columns at which the texts begin.
const COLUMNS: [u16; 5] = [2, 32, 42, 52, 66];
/// Column at which the verdict begins.
const WORD: u16 = 73;

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let theme = state.look.theme;
    for (title, column) in TITLES.into_iter().zip(COLUMNS) {
        put(buffer, area, column, 0, title, theme.style(Role::Dim));
    }
    let height = usize::from(area.height.saturating_sub(1));
    let skip = first_shown(state.chosen.check, height);
    for (row, (index, check)) in found.analysis.checks.iter().enumerate().skip(skip).take(height).enumerate()
    {
        let line = Rect { y: area.y + 1 + short(row), height: 1, ..area };
        draw_row(state, check, index == state.chosen.check, line, buffer);
    }
}

fn draw_row(state: &State, check: &Check, chosen: bool, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let style = theme.style(if chosen { Role::Cursor } else { Role::Plain });
    if chosen {
        put(buffer, area, 0, 0, ">", style);
    }
    let at = check.at.map_or_else(|| "-".to_owned(), |at| at.to_string());
    let residual = format!("{:.2e}", check.residual);
    let limit = format!("{:.2e}", check.limit);
    let cells = [check.name, &residual, &limit, check.place.as_str(), &at];
    let ends = COLUMNS.iter().skip(1).chain([&WORD]);
    for ((text, &column), &end) in cells.into_iter().zip(&COLUMNS).zip(ends) {
        let text = cut(text, usize::from(end - column - 1));
        put(buffer, area, column, 0, &text, style);
    }
    let (word, role) = match (check.failed(), check.judged) {
        (true, _) => ("FAILED", Role::Bad),
        (false, true) => ("ok", Role::Good),
        (false, false) => ("unknown", Role::Dim),
    };
    put(buffer, area, WORD, 0, word, theme.style(role));
}
