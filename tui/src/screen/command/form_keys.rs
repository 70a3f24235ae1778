//! The keys of a form.

use crossterm::event::KeyCode;

use super::choices;
use super::form::{close, end, fill, leave, leave_for, open_within, take_back, typed};
use crate::screen::state::{FormTask, Key, RowKind, State};

/// Fields by which a key of pages goes on.
const PAGE: usize = 6;

pub(super) fn press(state: &mut State, key: Key) {
    let Some(form) = state.build.form_mut() else { return };
    let typing = form.entry.is_some();
    match key.code {
        KeyCode::Enter => enter(state),
        KeyCode::Down | KeyCode::Tab => leave(state, 1),
        KeyCode::Up | KeyCode::BackTab => leave(state, -1),
        KeyCode::Left | KeyCode::Right if !typing => {
            choices::turn(state, if key.code == KeyCode::Right { 1 } else { -1 });
        }
        KeyCode::Char(' ') if !typing => choices::offer(state),
        // What stands is changed at its end.
        KeyCode::Backspace if !typing => {
            let now = form.row().filter(|row| row.stands).map_or_else(String::new, |row| match &row.kind {
                RowKind::Value(field) => field.shown(),
                RowKind::Name(_) => row.value.clone(),
            });
            typed(state, |entry| {
                *entry = now.as_str().into();
                entry.press(key)
            });
        }
        KeyCode::Home => leave_for(state, |_| 0),
        KeyCode::End => leave_for(state, last),
        KeyCode::PageDown => leave_for(state, |form| (form.chosen + PAGE).min(last(form))),
        KeyCode::PageUp => leave_for(state, |form| form.chosen.saturating_sub(PAGE)),
        KeyCode::Delete if typing => drop(take_back(state)),
        KeyCode::Delete => choices::remove(state),
        KeyCode::Insert if end(state) => choices::insert(state),
        _ => typed(state, |entry| entry.press(key)),
    }
}

/// The last field.
fn last(form: &FormTask) -> usize {
    form.rows.len().saturating_sub(1)
}

/// Enter: the next field; of a table its own form; behind the last field the form is done.
fn enter(state: &mut State) {
    fill(state);
    let typing = state.build.form().is_some_and(|form| form.entry.is_some());
    if !end(state) {
        return;
    }
    let Some(form) = state.build.form() else { return };
    let within = form.field().filter(|_| !typing).and_then(|field| choices::within(state, field));
    let is_last = form.chosen + 1 >= form.rows.len();
    match within {
        Some(source) => open_within(state, source),
        None if is_last => close(state),
        None => leave(state, 1),
    }
}
