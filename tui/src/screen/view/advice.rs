//! The text where a view has nothing to show: why, and what to add to the scene.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::footer::calculating;
use crate::screen::draw::{put, short, wrapped};
use crate::screen::state::{Role, Scene, State, View};

const ADD_MOTION: &str = "\
This scene has no motion, and no masses to reduce. Add to the scene, for example:

    [motion]
    speed = \"60 rpm\"

or kind = \"transient\" (from an initial state), or kind = \"steady\" (the periodic regime).";

const ADD_DRIVE: &str = "\
This scene has no steady regime of a drive. Add to the scene, for example:

    [motion]
    kind = \"steady\"
    mean_speed = \"60 rpm\"
    unevenness = 0.05

    [drive]
    motor = \"auto\"
    ratio = \"solve\"
    flywheel = \"solve\"

";

const ADD_LOADS: &str = "\
This scene has no loads, so that there are no forces. Add to the scene, for example:

    [[force]]
    link = \"ram\"
    at = \"K\"
    angle = \"180 deg\"
    value = \"1500 N\"

or gravity = \"9.81 m/s^2\" and masses.";

const OVER_TIME: &str = "\
In a motion from an initial state forces belong to its instants, not to the positions: assur analyze SCENE tells them over \
time.";

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
    let again = format!("Then {} reads it again.", state.keys.first("reload"));
    match (state.view, reason) {
        (View::Motion | View::Drive, Some(reason)) => not_found(reason),
        (View::Forces | View::Plans, None) if is_transient => OVER_TIME.to_owned(),
        (View::Forces | View::Plans, Some(reason)) => {
            format!("There are no forces, since the motion that the scene asks for is not found:\n{reason}")
        }
        (View::Motion, None) => format!("{ADD_MOTION} {again}"),
        (View::Drive, None) => format!("{ADD_DRIVE}{again}"),
        (View::Forces | View::Plans, None) => format!("{ADD_LOADS} {again}"),
        _ => "this scene has nothing for this view".to_owned(),
    }
}

/// Why there is no motion.
pub(super) fn not_found(reason: &str) -> String {
    format!("The motion that the scene asks for is not found:\n{reason}")
}
