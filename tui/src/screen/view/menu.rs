//! The menu of shipped scenes, with the picture of the chosen one.

use assur_fixtures::SCENES;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::mechanism;
use crate::screen::draw::{first_shown, paint, put, short};
use crate::screen::state::{Role, State};

/// Columns of the list.
const LIST: u16 = 24;

/// Draws the view.
pub(super) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let [title, rest] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
    let [list, picture] = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(rest);
    let theme = state.look.theme;
    let [open, help, quit] = ["open-scene", "help", "quit"].map(|name| state.keys.first(name));
    let heading =
        format!("Shipped scenes: {open} opens one, :open FILE your own, {help} all keys, {quit} leaves");
    put(buffer, title, 1, 0, &heading, theme.style(Role::Header));
    let height = usize::from(list.height);
    let shown = SCENES.iter().enumerate().skip(first_shown(state.shipped, height)).take(height);
    for (row, (index, (name, _))) in shown.enumerate() {
        let (sign, role) = if index == state.shipped { ('>', Role::Cursor) } else { (' ', Role::Plain) };
        let text = format!("{sign} {:<20}", format!("{name}.toml"));
        put(buffer, list, 1, short(row), &text, theme.style(role));
    }
    match state.previews.get(&state.shipped) {
        Some(Ok(scene)) => {
            let [name, drawing] =
                Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(picture);
            put(buffer, name, 1, 0, &scene.linkage.mechanism.title, theme.style(Role::Header));
            let figure = mechanism::figure(state, scene, scene.first_position(), &[]);
            paint(state, &figure, drawing, buffer);
        }
        Some(Err(text)) => {
            for (row, line) in text.lines().enumerate() {
                put(buffer, picture, 1, short(row), line, theme.style(Role::Plain));
            }
        }
        None => {
            let name = SCENES.get(state.shipped).map_or("", |scene| scene.0);
            put(buffer, picture, 1, 0, &format!("reading {name}.toml ..."), theme.style(Role::Dim));
        }
    }
}
