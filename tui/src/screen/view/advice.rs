//! The text where a view has nothing to show: why, and what to add to the scene.

use assur_picture::{motion, plans};
use assur_words::{Text, joined, name, text};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::footer::calculating;
use crate::screen::draw::{put, short, wrapped};
use crate::screen::state::{Role, Scene, State, View};

pub(super) fn draw(state: &State, scene: &Scene, view: View, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width.max(12)) - 4;
    for (row, line) in rows(&state.told(text(state, scene, view)), width).iter().enumerate() {
        put(buffer, area, 2, short(row) + 1, line, state.look.theme.style(Role::Plain));
    }
}

/// An advice in rows that fit; an example is shown exactly as it is to be written.
pub(super) fn rows(text: &str, width: usize) -> Vec<String> {
    let of_line =
        |line: &str| if line.starts_with(' ') { vec![line.to_owned()] } else { wrapped(line, width) };
    text.lines().flat_map(of_line).collect()
}

/// Why a view has nothing to show, and what to do about it.
pub(crate) fn text(state: &State, scene: &Scene, view: View) -> Text {
    if let Some(fault) = &scene.fault {
        return text!("no-analysis", reason = fault);
    }
    if let Some(running) = state.analyzing() {
        return calculating(state, running);
    }
    let motion = &scene.linkage.mechanism.motion;
    let is_transient = matches!(motion, Some(assur_mechanism::Motion::Transient { .. }));
    let found = state.found();
    let reason = found.and_then(|found| found.analysis.no_motion.as_ref());
    let of_plans =
        || found.and_then(|found| plans::missing(found, &state.pictured(), state.part(View::Plans)));
    let has_loads = found.is_some_and(|found| found.plans.calculation().plan.forces);
    let key = || name(state.keys.first("reload"));
    match (view, reason) {
        (View::Motion | View::Drive, Some(reason)) => motion::not_found(reason, "\n"),
        (View::Forces | View::Plans, None) if is_transient => text!("forces-over-time"),
        (View::Forces | View::Plans, Some(reason)) => {
            joined("\n", [text!("no-forces-found"), reason.clone()])
        }
        (View::Motion, None) => text!("add-motion", key = key()),
        (View::Drive, None) if found.is_some_and(|found| found.analysis.dynamics.is_some()) => {
            text!("drive-no-motor")
        }
        (View::Drive, None) => text!("add-drive", key = key()),
        (View::Forces, None) if has_loads => text!("forces-not-determined"),
        (View::Plans, None) if has_loads => of_plans().unwrap_or_else(|| text!("forces-not-determined")),
        (View::Forces | View::Plans, None) => text!("add-loads", key = key()),
        _ => text!("nothing-here"),
    }
}
