//! What stands where a view has nothing to show: why, and what to add to the scene.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::panel::wrapped;
use super::put;
use crate::screen::draw::raster::short;
use crate::screen::state::{State, View};
use crate::screen::study::Study;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Draws the advice.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width.max(12)) - 4;
    for (row, line) in rows(&text(state, study), width).iter().enumerate() {
        put(buffer, area, 2, short(row) + 1, line, state.look.theme.style(Role::Plain));
    }
}

/// An advice in rows that fit; an example stands as it is to be written.
pub(crate) fn rows(text: &str, width: usize) -> Vec<String> {
    let of_line =
        |line: &str| if line.starts_with(' ') { vec![line.to_owned()] } else { wrapped(line, width) };
    text.lines().flat_map(of_line).collect()
}

fn is_transient(study: &Study) -> bool {
    matches!(study.linkage.mechanism.motion, Some(assur_mechanism::Motion::Transient { .. }))
}

/// The advice as lines.
pub(crate) fn text(state: &State, study: &Study) -> String {
    let texts = state.texts;
    if let Some(fault) = &study.fault {
        return fill(texts.no_analysis, &[fault]);
    }
    if let Some(running) = state.running.first() {
        return running.words(state);
    }
    let reason = study.found.as_ref().and_then(|found| found.analysis.no_motion.as_ref());
    let again = state.keys.first("reload");
    match (state.view, reason) {
        (View::Motion | View::Drive, Some(reason)) => fill(texts.motion_not_found, &[reason]),
        (View::Forces | View::Plans, None) if is_transient(study) => texts.forces_over_time.to_owned(),
        (View::Forces | View::Plans, Some(reason)) => fill(texts.forces_not_found, &[reason]),
        (View::Motion, None) => fill(texts.add_motion, &[&again]),
        (View::Drive, None) => fill(texts.add_drive, &[&again]),
        (View::Forces | View::Plans, None) => fill(texts.add_loads, &[&again]),
        _ => texts.nothing_here.to_owned(),
    }
}
