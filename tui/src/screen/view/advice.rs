//! The text where a view has nothing to show: why, and what to add to the scene.

use assur_mechanism::Motion;
use assur_picture::{Look, Picture, Results, ViewPart, motion, plans};
use assur_words::{Text, joined, name, text};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::footer::calculating;
use crate::screen::draw::{put, short, wrapped};
use crate::screen::state::{Keymap, Role, Scene, State, View};

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

pub(super) fn text(state: &State, scene: &Scene, view: View) -> Text {
    if let Some(fault) = &scene.fault {
        return text!("no-analysis", reason = fault);
    }
    if let Some(running) = state.analyzing() {
        return calculating(state, running);
    }
    missing(scene, view.picture(), &state.pictured(), state.part(view), &state.keys)
}

/// What results lack of which there is no picture, and what to add to the scene before it is read again.
pub(crate) fn missing(
    results: &Results,
    picture: Option<Picture>,
    look: &Look<'_>,
    part: ViewPart,
    keys: &Keymap,
) -> Text {
    let (Some(picture), Some(found)) = (picture, &results.found) else { return text!("nothing-here") };
    let is_transient = matches!(results.linkage.mechanism.motion, Some(Motion::Transient { .. }));
    let has_loads = found.plans.calculation().plan.forces;
    let key = || name(keys.first("reload"));
    match (picture, &found.analysis.no_motion) {
        (Picture::Motion | Picture::Drive, Some(reason)) => motion::not_found(reason, "\n"),
        (Picture::Forces | Picture::Plans, None) if is_transient => text!("forces-over-time"),
        (Picture::Forces | Picture::Plans, Some(reason)) => {
            joined("\n", [text!("no-forces-found"), reason.clone()])
        }
        (Picture::Motion, None) => text!("add-motion", key = key()),
        (Picture::Drive, None) if found.analysis.dynamics.is_some() => text!("drive-no-motor"),
        (Picture::Drive, None) => text!("add-drive", key = key()),
        (Picture::Forces, None) if has_loads => text!("forces-not-determined"),
        (Picture::Plans, None) if has_loads => {
            plans::missing(found, look, part).unwrap_or_else(|| text!("forces-not-determined"))
        }
        (Picture::Forces | Picture::Plans, None) => text!("add-loads", key = key()),
        _ => text!("nothing-here"),
    }
}
