//! Lists to choose from: opened, searched, taken.

use assur_fixtures::SCENES;
use assur_words::{name, text};
use crossterm::event::KeyCode;

use super::{begin, draft, motors, tour};
use crate::screen::state::{Choice, Key, Picker, PickerKind, Series, Source, State, View, Wanted};

const PAGE: isize = 10;
/// The row that begins a scene from nothing: no name of a scene.
const NEW: &str = "+";
/// The row that begins the tour.
const TOUR: &str = "++";

pub(crate) fn scenes(state: &mut State) {
    state.playing = false;
    let row = |(scene, _): &(&str, &str)| Choice { name: (*scene).to_owned(), text: format!("{scene}.toml") };
    let new = Choice { name: NEW.to_owned(), text: state.told(text!("picker-new")) };
    let tour = Choice { name: TOUR.to_owned(), text: state.told(text!("picker-tour")) };
    let rows = [new, tour].into_iter().chain(SCENES.iter().map(row)).collect();
    let line = state.keys.first("command");
    let heading = text!("picker-scenes", line = name(line));
    state.picker = Some(Picker::new(PickerKind::Scenes, heading, rows));
}

/// Opens the list for the view: motors for the drive, otherwise quantities for the chart.
pub(super) fn pick(state: &mut State) {
    if state.view == View::Drive {
        return motors::list(state);
    }
    let Some(scene) = &state.scene else { return };
    let row = |series: &Series| Choice { name: series.short.clone(), text: state.told(series.title()) };
    let rows = scene.columns().skip(1).map(row).collect();
    let heading = text!("picker-quantities");
    let mut picker = Picker::new(PickerKind::Quantities, heading, rows);
    picker.filter.typing = true;
    state.picker = Some(picker);
}

pub(super) fn press(state: &mut State, key: Key) {
    let Some(picker) = &mut state.picker else { return };
    match key.code {
        KeyCode::Down => picker.step(1),
        KeyCode::Up => picker.step(-1),
        KeyCode::PageDown => picker.step(PAGE),
        KeyCode::PageUp => picker.step(-PAGE),
        KeyCode::Home => picker.chosen = 0,
        KeyCode::End => picker.chosen = picker.left().len().saturating_sub(1),
        KeyCode::Tab if picker.kind == PickerKind::Quantities => {
            picker.mark();
            picker.step(1);
        }
        KeyCode::Enter => take(state),
        _ => {
            if picker.filter.press(key) {
                picker.chosen = 0;
            }
        }
    }
}

fn take(state: &mut State) {
    let Some(picker) = &state.picker else { return };
    let (kind, taken) = (picker.kind, picker.taken());
    let Some(first) = taken.first() else { return };
    match kind {
        PickerKind::Scenes => {
            match &**first {
                NEW => return begin::new(state),
                TOUR => return tour::begin(state),
                _ => {}
            }
            if let Some((name, _)) = SCENES.iter().find(|(name, _)| name == first) {
                draft::open(state, Source::Shipped(name));
            }
            // The list stays until the scene is there.
            return;
        }
        PickerKind::Quantities => {
            state.picked = taken;
            state.view = View::Curves;
        }
        PickerKind::Motors => {
            let designation = first.clone();
            motors::take(state, &designation);
        }
        kind => {
            let first = first.clone();
            state.picker = None;
            return begin::take(state, kind, &first);
        }
    }
    state.picker = None;
}

pub(super) fn preview(state: &mut State) {
    let picker = state.picker.as_ref().filter(|picker| picker.kind == PickerKind::Scenes);
    let Some(chosen) = picker.and_then(Picker::choice) else { return };
    if let Some((name, _)) = SCENES.iter().find(|(name, _)| *name == chosen.name)
        && !state.previews.contains_key(name)
    {
        state.read(Wanted::Preview(name));
    }
}
