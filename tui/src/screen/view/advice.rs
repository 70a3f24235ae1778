//! The text where a view has nothing to show: why, and what to add to the scene.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::footer::calculating;
use crate::screen::draw::{put, short, wrapped};
use crate::screen::state::{Role, Scene, State, View};

/// Draws the advice.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width.max(12)) - 4;
    for (row, line) in rows(&text(state, scene), width).iter().enumerate() {
        put(buffer, area, 2, short(row) + 1, line, state.look.theme.style(Role::Plain));
    }
}

/// An advice in rows that fit; an example is shown exactly as it is to be written.
pub(super) fn rows(text: &str, width: usize) -> Vec<String> {
    let of_line =
        |line: &str| if line.starts_with(' ') { vec![line.to_owned()] } else { wrapped(line, width) };
    text.lines().flat_map(of_line).collect()
}

/// The advice as lines.
pub(crate) fn text(state: &State, scene: &Scene) -> String {
    if let Some(fault) = &scene.fault {
        return format!("no analysis: {fault}");
    }
    if let Some(running) = state.analyzing() {
        return calculating(state, running);
    }
    let motion = &scene.linkage.mechanism.motion;
    let is_transient = matches!(motion, Some(assur_mechanism::Motion::Transient { .. }));
    let reason = state.found().and_then(|found| found.analysis.no_motion.as_ref());
    let words = state.words();
    let add = |id: &str| words.with(id, &[("key", state.keys.first("reload"))]);
    match (state.view, reason) {
        (View::Motion | View::Drive, Some(reason)) => not_found(state, &reason.to_string()),
        (View::Forces | View::Plans, None) if is_transient => words.get("forces-over-time"),
        (View::Forces | View::Plans, Some(reason)) => format!("{}\n{reason}", words.get("no-forces-found")),
        (View::Motion, None) => add("add-motion"),
        (View::Drive, None) => add("add-drive"),
        (View::Forces | View::Plans, None) => add("add-loads"),
        _ => words.get("nothing-here"),
    }
}

/// Why there is no motion.
pub(super) fn not_found(state: &State, reason: &str) -> String {
    format!("{}\n{reason}", state.words().get("no-motion-found"))
}
