//! The first two rows: where one is, and the views.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::{put, values};
use crate::screen::draw::raster::short;
use crate::screen::number::digits;
use crate::screen::quantities::coordinate_unit;
use crate::screen::state::{State, View};
use crate::screen::study::Study;
use crate::screen::text::{Texts, fill};
use crate::screen::theme::Role;

/// Name of a view.
pub(crate) fn name(state: &State, view: View) -> &'static str {
    name_in(state.texts, view)
}

/// Name of a view in a language.
pub(crate) fn name_in(texts: &Texts, view: View) -> &'static str {
    match view {
        View::Menu => texts.menu,
        View::Mechanism => texts.mechanism,
        View::Curves => texts.curves,
        View::Forces => texts.forces,
        View::Plans => texts.plans,
        View::Motion => texts.motion,
        View::Drive => texts.drive,
        View::Checks => texts.checks,
        View::Accuracy => texts.accuracy,
        View::Structure => texts.structure,
        View::Table => texts.table,
        View::Values => texts.group_change,
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

/// The key of a view, or its name where it has none.
pub(crate) fn key(state: &State, view: View) -> String {
    let tab = TABS.iter().find(|(_, of)| *of == view);
    tab.map_or_else(|| name(state, view).to_owned(), |(command, _)| state.keys.first(command))
}

/// Draws the header.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let style = state.look.theme.style(Role::Header);
    let Some(study) = &state.study else {
        put(buffer, area, 0, 0, concat!("assur ", env!("CARGO_PKG_VERSION")), style);
        return;
    };
    let place = place(state, study);
    put(buffer, area, 1, 0, &place, style);
    let column = short(place.width() + 4);
    let room = usize::from(area.width.saturating_sub(column));
    let (role, text) = match changed(state, room) {
        Some(text) if state.what_if.refused() => (Role::Bad, text),
        Some(text) => (Role::Header, text),
        None => (Role::Plain, study.linkage.mechanism.title.clone()),
    };
    put(buffer, area, column, 0, &text, state.look.theme.style(role));
    draw_tabs(state, area, buffer);
}

/// `* link.crank.points.A 100 mm -> 101 mm`: the last change, how many others there are, and whether they were taken.
fn changed(state: &State, room: usize) -> Option<String> {
    let what = &state.what_if;
    let last = what.last()?;
    let others = what.changes() - 1;
    let more = if others > 0 { fill(state.texts.more_changes, &[&others]) } else { String::new() };
    let refused = if what.refused() { state.texts.not_taken } else { "" };
    let value = format!(" {}{more}{refused}", what.shown(last));
    let key = values::tail(&what.values[last].key, room.saturating_sub(value.width() + 2).max(6));
    Some(format!("* {key}{value}"))
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
    let theme = state.look.theme;
    let tabs: Vec<_> =
        TABS.iter().map(|(command, view)| (state.keys.first(command), name(state, *view), *view)).collect();
    let whole: usize = tabs.iter().map(|(key, name, _)| key.width() + name.width() + 2).sum();
    // Where all would not fit, the key stands close to its name.
    let gap = whole <= usize::from(area.width) + 1;
    let mut column = 0;
    for (key, name, view) in tabs {
        let here = view == state.view;
        let [key_role, role] = if here { [Role::Tab; 2] } else { [Role::Key, Role::Dim] };
        let key = format!("{key}{}", if gap || key.width() > 1 { " " } else { "" });
        put(buffer, area, column, 1, &key, theme.style(key_role));
        column += short(key.width());
        put(buffer, area, column, 1, name, theme.style(role));
        column += short(name.width()) + 1;
    }
}
