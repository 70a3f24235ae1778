//! The menu of shipped scenes, with the picture of the chosen one.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{mechanism, put};
use crate::screen::draw::raster::short;
use crate::screen::menu::SCENES;
use crate::screen::state::State;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Columns of the list.
const LIST: u16 = 24;

/// Draws the view.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let [title, rest] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
    let [list, picture] = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(rest);
    let theme = state.look.theme;
    let [open, help, quit] = ["open-scene", "help", "quit"].map(|name| state.keys.first(name));
    let heading = fill(state.texts.menu_title, &[&open, &help, &quit]);
    put(buffer, title, 1, 0, &heading, theme.style(Role::Header));
    let height = usize::from(list.height);
    let skip = (state.menu.chosen + 1).saturating_sub(height);
    for (row, (index, (name, _))) in SCENES.iter().enumerate().skip(skip).take(height).enumerate() {
        let chosen = index == state.menu.chosen;
        let text = format!("{} {name:<20}", if chosen { '>' } else { ' ' });
        put(buffer, list, 1, short(row), &text, theme.style(if chosen { Role::Cursor } else { Role::Plain }));
    }
    match state.menu.preview() {
        Some(Ok(study)) => {
            let [name, drawing] =
                Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(picture);
            put(buffer, name, 1, 0, &study.linkage.mechanism.title, theme.style(Role::Header));
            mechanism::picture(state, study, study.first_position(), drawing, &[], buffer);
        }
        Some(Err(text)) => {
            for (row, line) in text.lines().enumerate() {
                put(buffer, picture, 1, short(row), line, theme.style(Role::Plain));
            }
        }
        None => {
            let name = SCENES.get(state.menu.chosen).map_or("", |scene| scene.0);
            put(buffer, picture, 1, 0, &fill(state.texts.opening, &[&name]), theme.style(Role::Dim));
        }
    }
}
