//! Cost and accuracy of the methods on this scene, with its stability.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::screen::draw::{folded, put, short};
use crate::screen::state::{Role, State};

/// Draws the view.
pub(super) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    if let Some(running) = state.measuring() {
        let count = if running.count.is_empty() { "measuring ..." } else { &running.count };
        let text = format!("{count}   ({} stops)", state.keys.first("close"));
        put(buffer, area, 1, 0, &text, theme.style(Role::Header));
    } else if state.measured.is_none() {
        let measure = state.keys.first("measure");
        let text = format!("{measure} measures every method here: speed, accuracy, stability (some seconds)");
        put(buffer, area, 1, 1, &text, theme.style(Role::Plain));
    }
    let top = top(state);
    let height = usize::from(area.height.saturating_sub(top));
    let lines = lines(state, area.width);
    let skip = state.chosen.line.min(lines.len().saturating_sub(height));
    for (row, line) in lines.iter().skip(skip).take(height).enumerate() {
        put(buffer, area, 1, short(row) + top, line, theme.style(Role::Plain));
    }
}

/// Rows of the progress of a measurement.
fn top(state: &State) -> u16 {
    u16::from(state.measuring().is_some())
}

/// Visible rows of the report.
pub(crate) fn page(state: &State) -> usize {
    usize::from(super::room(state).height.saturating_sub(top(state)))
}

/// The first line of the last page.
pub(crate) fn last_line(state: &State) -> usize {
    lines(state, super::room(state).width).len().saturating_sub(page(state))
}

/// The report in lines of the width of the screen.
pub(crate) fn lines(state: &State, width: u16) -> Vec<String> {
    let Some(measured) = &state.measured else { return Vec::new() };
    // A column stays free at each side.
    let width = usize::from(width.max(40)) - 2;
    measured.text(state.look.ascii, width).lines().flat_map(|line| folded(line, width)).collect()
}
