//! The file as it is now, with the lines that the last step has written.

use ratatui::layout::Rect;
use similar::{ChangeTag, TextDiff};

use crate::screen::draw::{Pen, cut, short};
use crate::screen::state::Role;

/// The file as it is now; the lines that the last step has written are marked.
pub(super) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    let title = format!(" {} ", state.draft.source.short_name());
    let rule: String = std::iter::repeat_n('─', area.width.into()).collect();
    pen.put(area, 0, 0, &rule, Role::Dim);
    pen.put(area, 1, 0, &title, Role::Header);
    let inner = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    let (text, before) = (state.draft.text(), state.draft.before());
    let lines: Vec<&str> = text.lines().collect();
    let written = before.map_or_else(Vec::new, |before| differing(before, text));
    let height = usize::from(inner.height);
    let last = lines.len().saturating_sub(height);
    // The first line of what was written has some of the lines above it.
    let top = written.first().copied().unwrap_or_default().saturating_sub(height / 3);
    let first = state.build.line.unwrap_or(top).min(last);
    for (row, (index, line)) in lines.iter().enumerate().skip(first).take(height).enumerate() {
        let is_written = written.contains(&index);
        let (sign, role) = if is_written { ("+", Role::Chosen) } else { (" ", Role::Plain) };
        pen.put(
            inner,
            0,
            short(row),
            &format!("{sign}{}", cut(line, usize::from(inner.width).saturating_sub(1))),
            role,
        );
    }
    pen.mark_rows(inner, first..lines.len().min(first + height), lines.len());
}

/// The lines of a text that those of the text before have not.
fn differing(before: &str, after: &str) -> Vec<usize> {
    let difference = TextDiff::from_lines(before, after);
    let inserted = difference.iter_all_changes().filter(|change| change.tag() == ChangeTag::Insert);
    inserted.filter_map(|change| change.new_index()).collect()
}
