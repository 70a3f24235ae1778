//! The first two rows: where one is, and the views.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::put;
use crate::screen::command::{COMMANDS, Group};
use crate::screen::draw::raster::short;
use crate::screen::number::digits;
use crate::screen::quantities::coordinate_unit;
use crate::screen::state::{State, View};
use crate::screen::study::Study;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Name of a view.
pub(crate) fn name(state: &State, view: View) -> &'static str {
    match view {
        View::Menu => state.texts.menu,
        View::Mechanism => state.texts.mechanism,
        View::Curves => state.texts.curves,
        View::Forces => state.texts.forces,
        View::Plans => state.texts.plans,
        View::Motion => state.texts.motion,
        View::Drive => state.texts.drive,
        View::Checks => state.texts.checks,
        View::Accuracy => state.texts.accuracy,
        View::Structure => state.texts.structure,
        View::Table => state.texts.table,
    }
}

const TABS: &[(&str, View)] = &[
    ("mechanism", View::Mechanism),
    ("curves", View::Curves),
    ("forces", View::Forces),
    ("plans", View::Plans),
    ("motion", View::Motion),
    ("drive", View::Drive),
    ("checks", View::Checks),
    ("accuracy", View::Accuracy),
    ("structure", View::Structure),
    ("table", View::Table),
];

/// Draws the header.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let style = state.look.theme.style(Role::Header);
    let Some(study) = &state.study else {
        put(buffer, area, 0, 0, concat!("assur ", env!("CARGO_PKG_VERSION")), style);
        return;
    };
    let place = place(state, study);
    put(buffer, area, 1, 0, &place, style);
    let title = &study.linkage.mechanism.title;
    let column = short(place.width() + 4);
    put(buffer, area, column, 0, title, state.look.theme.style(Role::Plain));
    draw_tabs(state, area, buffer);
}

/// `position 12 of 48   90.00 deg`.
fn place(state: &State, study: &Study) -> String {
    let position = fill(state.texts.position, &[&state.position, &study.positions()]);
    let (unit, factor) = coordinate_unit(&study.linkage);
    let coordinate = digits(factor * study.linkage.mechanism.input.coordinate(state.position), 6);
    let playing = if state.playing { " >" } else { "" };
    format!("{position}  {coordinate} {unit}{playing}")
}

fn draw_tabs(state: &State, area: Rect, buffer: &mut Buffer) {
    let mut column = 0;
    for (command, view) in TABS.iter().filter(|(_, view)| state.has(*view)) {
        let key = COMMANDS.iter().find(|c| c.name == *command && c.group == Group::Views);
        let key = key.and_then(|c| c.keys.first()).map(|key| key.name()).unwrap_or_default();
        let text = format!("{key} {}", name(state, *view));
        let role = if *view == state.view { Role::Tab } else { Role::Dim };
        put(buffer, area, column, 1, &text, state.look.theme.style(role));
        column += short(text.width()) + 1;
    }
}
