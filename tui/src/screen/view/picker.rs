//! A list to choose from, over the body, with a picture of what is chosen beside it.

use assur_figure::{Figure, Ink, Stroke};
use assur_picture::{mechanism, plots};
use assur_words::{Text, name, number, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::widgets::{Clear, Widget};

use crate::screen::draw::{cut, paint, put, put_lines, short};
use crate::screen::state::{Choice, Picker, PickerKind, Role, Scene, Series, State};

/// Columns of the list of scenes.
const SCENE: u16 = 26;
/// Columns of the list of quantities.
const QUANTITY: u16 = 44;

pub(super) fn draw(state: &State, picker: &Picker, area: Rect, buffer: &mut Buffer) {
    Clear.render(area, buffer);
    let [title, rest] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
    let width = match picker.kind {
        PickerKind::Scenes => SCENE,
        PickerKind::Quantities => QUANTITY,
        PickerKind::Motors => rest.width,
    };
    let [list, picture] = Layout::horizontal([Constraint::Length(width), Constraint::Min(0)]).areas(rest);
    put(buffer, title, 1, 0, &state.told(&picker.heading), state.style(Role::Header));
    let left = picker.left();
    let [some, all] = [left.len(), picker.rows.len()].map(number);
    let count = state.told(text!("picker-count", left = some, all = all));
    put(buffer, title, 1, 1, &format!("/{}  ({count})", picker.filter.text), state.style(Role::Key));
    let height = usize::from(list.height);
    // The chosen row is the last at most.
    let shown = left.iter().enumerate().skip((picker.chosen + 1).saturating_sub(height)).take(height);
    for (row, (index, choice)) in shown.enumerate() {
        let (sign, role) = if index == picker.chosen { ('>', Role::Cursor) } else { (' ', Role::Plain) };
        let mark = if picker.marked.contains(&choice.name) { '*' } else { ' ' };
        let text = cut(&choice.text, usize::from(list.width.saturating_sub(4)));
        put(buffer, list, 1, short(row), &format!("{sign}{mark}{text}"), state.style(role));
    }
    match (picker.kind, picker.choice()) {
        (PickerKind::Scenes, Some(choice)) => preview(state, choice, picture, buffer),
        (PickerKind::Quantities, Some(choice)) => curve(state, choice, picture, buffer),
        _ => {}
    }
}

fn preview(state: &State, choice: &Choice, area: Rect, buffer: &mut Buffer) {
    match state.previews.get(choice.name.as_str()) {
        Some(Ok(scene)) => {
            let [head, drawing] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
            put(buffer, head, 1, 0, &scene.linkage.mechanism.title, state.style(Role::Header));
            paint(state, &mechanism::still(scene), drawing, buffer);
        }
        Some(Err(text)) => {
            let text = state.told(text);
            let lines: Vec<_> = text.lines().map(|line| (Role::Plain, line.to_owned())).collect();
            put_lines(buffer, area, 1, state, &lines);
        }
        None => {
            let text = state.told(text!("picker-reading", scene = name(choice.text.clone())));
            put(buffer, area, 1, 0, &text, state.style(Role::Dim));
        }
    }
}

fn curve(state: &State, choice: &Choice, area: Rect, buffer: &mut Buffer) {
    let Some(scene) = &state.scene else { return };
    let Some(series) = scene.named(&choice.name) else { return };
    paint(state, &figure(state, scene, series), area, buffer);
}

pub(crate) fn figure(state: &State, scene: &Scene, series: &Series) -> Figure {
    let (curves, heading) =
        ([(series, Stroke::Solid, Ink::First)], [Text::default(), series.show(state.position)]);
    Figure::of(plots::over_positions(&scene.linkage, &state.pictured(), heading, &curves, Vec::new()))
}
