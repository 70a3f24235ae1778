//! A list to choose from, over the body, with a picture of what is chosen beside it.

use assur_figure::{Figure, Ink, Stroke};
use assur_picture::{mechanism, plots};
use assur_words::{Text, name, number, text};
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::widgets::{Clear, Widget};

use crate::screen::draw::{Pen, cut, short};
use crate::screen::state::{Choice, Picker, PickerKind, Role, Scene, Series, State};

/// Columns of the list of scenes.
const SCENE: u16 = 26;
/// Columns of the list of quantities.
const QUANTITY: u16 = 44;
/// Columns of the list of groups that can be added.
const ADDITION: u16 = 54;

pub(super) fn draw(pen: &mut Pen<'_>, picker: &Picker, area: Rect) {
    Clear.render(area, pen.buffer);
    let [title, rest] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
    let width = match picker.kind {
        PickerKind::Scenes => SCENE,
        PickerKind::Quantities => QUANTITY,
        PickerKind::Additions => ADDITION,
        PickerKind::Motors
        | PickerKind::Starts
        | PickerKind::Tables
        | PickerKind::Drives
        | PickerKind::Choices => rest.width,
    };
    let [list, picture] = Layout::horizontal([Constraint::Length(width), Constraint::Min(0)]).areas(rest);
    pen.tell(title, 1, 0, &picker.heading, Role::Header);
    let left = picker.left();
    let [some, all] = [left.len(), picker.rows.len()].map(number);
    let count = pen.state.told(text!("picker-count", left = some, all = all));
    pen.put(title, 1, 1, &format!("/{}  ({count})", &*picker.filter.text), Role::Key);
    let height = usize::from(list.height);
    // The chosen row is the last at most.
    let shown = left.iter().enumerate().skip((picker.chosen + 1).saturating_sub(height)).take(height);
    for (row, (index, choice)) in shown.enumerate() {
        let (sign, role) = if index == picker.chosen { ('>', Role::Cursor) } else { (' ', Role::Plain) };
        let mark = if picker.marked.contains(&choice.name) { '*' } else { ' ' };
        let text = cut(&choice.text, usize::from(list.width.saturating_sub(4)));
        pen.put(list, 1, short(row), &format!("{sign}{mark}{text}"), role);
    }
    match (picker.kind, picker.choice()) {
        (PickerKind::Scenes, Some(choice)) => preview(pen, choice, picture),
        (PickerKind::Quantities, Some(choice)) => curve(pen, choice, picture),
        (PickerKind::Additions, Some(choice)) => pattern(pen, choice, picture),
        _ => {}
    }
}

fn preview(pen: &mut Pen<'_>, choice: &Choice, area: Rect) {
    match pen.state.previews.get(choice.name.as_str()) {
        Some(Ok(scene)) => {
            let [head, drawing] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
            let title = pen.state.told(&scene.linkage.mechanism.title);
            pen.put(head, 1, 0, &title, Role::Header);
            pen.paint(&mechanism::still(scene), drawing);
        }
        Some(Err(text)) => {
            let text = pen.state.told(text);
            let lines: Vec<_> = text.lines().map(|line| (Role::Plain, line.to_owned())).collect();
            pen.put_lines(area, 1, &lines);
        }
        None => {
            let text = pen.state.told(text!("picker-reading", scene = name(choice.text.clone())));
            pen.put(area, 1, 0, &text, Role::Dim);
        }
    }
}

fn pattern(pen: &mut Pen<'_>, choice: &Choice, area: Rect) {
    let found = assur_sketch::additions()
        .unwrap_or_default()
        .into_iter()
        .find(|addition| addition.name == choice.name);
    if let Some(addition) = found {
        pen.paint(&super::pattern::figure(&addition), area);
    }
}

fn curve(pen: &mut Pen<'_>, choice: &Choice, area: Rect) {
    let Some(scene) = &pen.state.scene else { return };
    let Some(series) = scene.named(&choice.name) else { return };
    pen.paint(&figure(pen.state, scene, series), area);
}

pub(crate) fn figure(state: &State, scene: &Scene, series: &Series) -> Figure {
    let (curves, heading) =
        ([(series, Stroke::Solid, Ink::First)], [Text::default(), series.show(state.position)]);
    Figure::of(plots::over_positions(scene.base(&state.pictured()), heading, &curves, Vec::new()))
}
