//! What the methods cost and how exact they are on this scene, with its stability.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{panel, put};
use crate::screen::draw::raster::short;
use crate::screen::state::State;
use crate::screen::text::fill;
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
            &format!("{progress}   {}", fill(state.texts.cancel_hint, &[&state.keys.first("close")])),
            theme.style(Role::Header),
        );
        top = 1;
    } else if found.lines.is_empty() {
        let hint = fill(state.texts.measure_hint, &[&state.keys.first("measure")]);
        put(buffer, area, 1, 1, &hint, theme.style(Role::Plain));
    }
    let height = usize::from(area.height.saturating_sub(top));
    let lines: Vec<String> = found.lines.iter().flat_map(|line| fitted(line, area.width)).collect();
    let skip = state.chosen.line.min(lines.len().saturating_sub(height));
    for (row, line) in lines.iter().skip(skip).take(height).enumerate() {
        put(buffer, area, 1, short(row) + top, line, theme.style(Role::Plain));
    }
}

/// A sentence in as many lines as it needs; a row of a table as it is.
fn fitted(line: &str, width: u16) -> Vec<String> {
    let width = usize::from(width.max(12)) - 2;
    let sentence = !line.trim_start().contains("  ") && !line.contains('│') && !line.contains('|');
    if sentence && line.chars().count() > width { panel::wrapped(line, width) } else { vec![line.to_owned()] }
}
