//! What the methods cost and how exact they are on this scene, with its stability.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::put;
use crate::screen::draw::raster::short;
use crate::screen::state::State;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Columns by which what a line has more than fits is indented beyond it.
const HANGING: usize = 4;

/// Draws the view.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let top = top(state);
    if let Some(progress) = &state.accuracy.progress {
        let stops = fill(state.texts.cancel_hint, &[&state.keys.first("close")]);
        put(buffer, area, 1, 0, &format!("{progress}   {stops}"), theme.style(Role::Header));
    } else if state.accuracy.measured.is_none() {
        let hint = fill(state.texts.measure_hint, &[&state.keys.first("measure")]);
        put(buffer, area, 1, 1, &hint, theme.style(Role::Plain));
    }
    let height = usize::from(area.height.saturating_sub(top));
    let lines = lines(state, area.width);
    let skip = state.chosen.line.min(lines.len().saturating_sub(height));
    for (row, line) in lines.iter().skip(skip).take(height).enumerate() {
        put(buffer, area, 1, short(row) + top, line, theme.style(Role::Plain));
    }
}

/// Rows that the count of a measurement takes.
fn top(state: &State) -> u16 {
    u16::from(state.accuracy.progress.is_some())
}

/// Rows of the report that are seen at once.
pub(crate) fn page(state: &State) -> usize {
    usize::from(super::room(state).height.saturating_sub(top(state)))
}

/// The first line of the last page.
pub(crate) fn last_line(state: &State) -> usize {
    lines(state, super::room(state).width).len().saturating_sub(page(state))
}

/// The report in lines that fit.
pub(crate) fn lines(state: &State, width: u16) -> Vec<String> {
    let Some(measured) = &state.accuracy.measured else { return Vec::new() };
    // A column stays free at each side.
    let width = usize::from(width.max(40)) - 2;
    measured.text(state.look.ascii, width).lines().flat_map(|line| folded(line, width)).collect()
}

/// A line in as many as it needs, broken at spaces; all after the first are indented further.
pub(crate) fn folded(line: &str, width: usize) -> Vec<String> {
    let indent = line.chars().take_while(|c| *c == ' ').count() + HANGING;
    let (mut lines, mut rest) = (Vec::new(), line.to_owned());
    while rest.chars().count() > width {
        let begins = if lines.is_empty() { indent - HANGING } else { indent };
        let fits = rest.char_indices().take(width + 1).enumerate();
        let space = fits.filter(|(column, (_, c))| *c == ' ' && *column > begins).last();
        let Some((_, (at, _))) = space else { break };
        let next = format!("{:indent$}{}", "", rest[at..].trim_start());
        rest.truncate(at);
        lines.push(std::mem::replace(&mut rest, next).trim_end().to_owned());
    }
    lines.push(rest);
    lines
}
