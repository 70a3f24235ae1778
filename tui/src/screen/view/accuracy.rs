//! What the methods cost and how exact they are on this scene, with its stability.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::put;
use crate::screen::draw::raster::short;
use crate::screen::state::State;
use crate::screen::theme::Role;

/// Draws the view.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let found = &state.accuracy;
    let mut top = 0;
    if let Some(progress) = &found.progress {
        put(
            buffer,
            area,
            1,
            0,
            &format!("{progress}   {}", state.texts.cancel_hint),
            theme.style(Role::Header),
        );
        top = 1;
    } else if found.lines.is_empty() {
        put(buffer, area, 1, 1, state.texts.measure_hint, theme.style(Role::Plain));
    }
    let height = usize::from(area.height.saturating_sub(top));
    let skip = state.chosen.line.min(found.lines.len().saturating_sub(height));
    for (row, line) in found.lines.iter().skip(skip).take(height).enumerate() {
        put(buffer, area, 1, short(row) + top, line, theme.style(Role::Plain));
    }
}
