//! A list to choose from, over the body, with a picture of what is chosen beside it.

use assur_figure::{Figure, Ink, Stroke};
use assur_picture::{mechanism, plots};
use assur_sketch::{Addition, additions};
use assur_words::{Text, name, number, text};
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::widgets::{Clear, Widget};
use unicode_width::UnicodeWidthStr;

use super::pattern;
use crate::screen::draw::{Pen, cut, short, wrapped};
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
    let room = usize::from(width.min(rest.width).saturating_sub(4));
    let at = usize::from(rest.width.saturating_sub(2)).max(20);
    let added = if picker.kind == PickerKind::Additions { additions() } else { Ok(Vec::new()) };
    let added = added.unwrap_or_default();
    let rows = picker.rows.iter().map(|choice| whole(pen.state, &added, choice, [room, at]).len());
    let rows = short(rows.max().unwrap_or(0)).min(rest.height / 4);
    let [rest, foot] = Layout::vertical([Constraint::Min(0), Constraint::Length(rows)]).areas(rest);
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
        let text = cut(&choice.text, room);
        pen.put(list, 1, short(row), &format!("{sign}{mark}{text}"), role);
    }
    match (picker.kind, picker.choice()) {
        (PickerKind::Scenes, Some(choice)) => preview(pen, choice, picture),
        (PickerKind::Quantities, Some(choice)) => curve(pen, choice, picture),
        (PickerKind::Additions, Some(choice)) => {
            if let Some(addition) = added.iter().find(|addition| addition.name == choice.name) {
                pen.paint(&pattern::figure(addition), picture);
            }
        }
        _ => {}
    }
    if let Some(choice) = picker.choice() {
        let lines = whole(pen.state, &added, choice, [room, at]);
        let lines: Vec<_> = lines.into_iter().take(rows.into()).map(|line| (Role::Key, line)).collect();
        pen.put_lines(foot, 1, &lines);
    }
}

/// What a row of the list has no room for: all of its text where that is cut, of what can be added the sorts of its pairs.
fn whole(state: &State, added: &[Addition], choice: &Choice, [room, width]: [usize; 2]) -> Vec<String> {
    let text = Some(choice.text.as_str()).filter(|text| text.width() > room);
    let addition = added.iter().find(|addition| addition.name == choice.name);
    let pairs = addition.map(|addition| pattern::pairs_of(addition).map(|text| state.told(text)).join("; "));
    let all = text.into_iter().map(str::to_owned).chain(pairs);
    all.flat_map(|text| wrapped(&text, width)).collect()
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
