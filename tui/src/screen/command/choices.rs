//! What is chosen rather than typed in a form: words, tables and rows as values, tables that are opened or added.

use assur_form::{Field, added, deleted, inserted, made, put, rows, sections};
use assur_mechanism::Key as SceneKey;
use assur_words::{list, name, text};

use super::fields::name_of;
use super::form::{changed, leave, open, open_within};
use crate::screen::state::{Choice, FormSource, FormTask, Picker, PickerKind, Role, RowKind, State, round};

/// Before the number of a table that may stand in a field, in the name of a choice.
const OPENING: &str = "table:";
/// The name of the choice of rows in place of a number.
const ROWS: &str = "rows";
/// Before the header of a table that is added, in the name of a choice.
const ADD: &str = "+";
/// The name of the choice of all masses.
const MASSES: &str = "masses";

/// The form of what stands in a field: of its table, or of its rows.
pub(super) fn within(state: &State, field: &Field) -> Option<FormSource> {
    let is_list = field.value.as_ref().is_some_and(|value| value.starts_with('['));
    if is_list && rows(state.draft.text(), &field.key).is_some() {
        return Some(FormSource::Rows(field.key.clone()));
    }
    field.is_table().then(|| FormSource::Table(field.key.clone()))
}

/// The next or previous choice of a field.
pub(super) fn turn(state: &mut State, by: isize) {
    let Some(field) = state.build.form().and_then(FormTask::field).cloned() else { return };
    if field.choices.is_empty() {
        return;
    }
    let now = field.choices.iter().position(|choice| Some(&choice.toml) == field.value.as_ref());
    let next = now.map_or(0, |now| round(now, by, field.choices.len()));
    take(state, &field, &field.choices[next].toml);
}

/// Lists what the field may be: words, names, tables.
pub(super) fn offer(state: &mut State) {
    let Some(field) = state.build.form().and_then(FormTask::field).cloned() else { return };
    let words = field.choices.iter().map(|choice| (choice.toml.clone(), choice.label.clone()));
    let tables = field
        .opens
        .iter()
        .enumerate()
        .map(|(index, opening)| (format!("{OPENING}{index}"), opening.label.clone()));
    let rows = rows(state.draft.text(), &field.key).map(|_| (ROWS.to_owned(), text!("build-as-rows")));
    let all = words.chain(tables).chain(rows).map(|(name, label)| Choice { name, text: state.told(label) });
    let all: Vec<Choice> = all.collect();
    if all.is_empty() {
        return state.say(Role::Plain, text!("build-no-choices", values = field.values.clone()));
    }
    let mut picker = Picker::new(PickerKind::Choices, field.about.clone(), all);
    picker.filter.typing = true;
    state.picker = Some(picker);
}

/// Takes a choice of the list; one that is a table is opened.
pub(super) fn choose(state: &mut State, chosen: &str) {
    let Some(field) = state.build.form().and_then(FormTask::field).cloned() else { return };
    let opening =
        chosen.strip_prefix(OPENING).and_then(|index| field.opens.get(index.parse::<usize>().ok()?));
    match opening {
        None if chosen == ROWS => {
            let empty = rows(state.draft.text(), &field.key).is_some_and(|rows| rows.rows.is_empty());
            if empty {
                let change = inserted(state.draft.text(), &field.key, 0);
                changed(state, change);
            }
        }
        Some(opening) => {
            let change = made(state.draft.text(), &field.key, opening);
            changed(state, change);
        }
        None => take(state, &field, chosen),
    }
    let within = state.build.form().and_then(FormTask::field).and_then(|field| within(state, field));
    match within {
        Some(within) => open_within(state, within),
        None => leave(state, 1),
    }
}

pub(super) fn take(state: &mut State, field: &Field, toml: &str) {
    let change = put(state.draft.text(), field, &assur_scene::edit::bare(toml));
    changed(state, change);
}

/// Adds a row behind the chosen one, or a point to a link.
pub(super) fn insert(state: &mut State) {
    match state.build.form().map(|form| (form.source.clone(), form.chosen)) {
        Some((FormSource::Rows(at), chosen)) => {
            let change = inserted(state.draft.text(), &at, chosen / 2 + 1);
            if changed(state, change) {
                leave(state, 2);
            }
        }
        _ => state.say(Role::Plain, text!("build-no-rows")),
    }
}

/// Removes the chosen row, or the value of the chosen field.
pub(super) fn remove(state: &mut State) {
    let Some(form) = state.build.form() else { return };
    if let FormSource::Rows(at) = &form.source {
        let change = deleted(state.draft.text(), at, form.chosen / 2);
        changed(state, change);
    } else if let Some(field) = form.field().cloned() {
        take(state, &field, "");
    }
}

/// Lists the tables of the scene: those that stand, and those that can be added.
pub(super) fn tables(state: &mut State) {
    let mut all = vec![Choice { name: MASSES.to_owned(), text: state.told(text!("build-masses")) }];
    for section in sections(state.draft.text()) {
        for instance in &section.instances {
            let told = list(
                [section.what.clone(), instance.label.clone()].into_iter().filter(|text| !text.is_empty()),
            );
            let key = instance.key.to_string();
            let row = format!("{key:<24} {}", state.told(told));
            all.push(Choice { name: key, text: row });
        }
        if section.can_add {
            let add = state.told(text!("build-add-table", header = name(section.header)));
            let row = format!("{add:<24} {}", state.told(section.about.clone()));
            all.push(Choice { name: format!("{ADD}{}", section.header), text: row });
        }
    }
    let mut picker = Picker::new(PickerKind::Tables, text!("build-tables"), all);
    picker.filter.typing = true;
    state.picker = Some(picker);
}

/// Adds a table, with what is chosen in the picture in the first field that may be it.
fn add(state: &mut State, header: &str) {
    let change = added(state.draft.text(), header);
    let at = change.at.clone();
    if !changed(state, change) {
        return;
    }
    open(state, FormSource::Table(at));
    let chosen = state.build.chosen.as_ref().map(name_of);
    let is_chosen = |choice: &assur_form::Choice| Some(assur_scene::edit::bare(&choice.toml)) == chosen;
    let rows = state.build.form().map_or(&[][..], |form| &form.rows);
    let field = rows.iter().find_map(|row| match &row.kind {
        RowKind::Value(field) => {
            Some((field.clone(), field.choices.iter().find(|choice| is_chosen(choice))?.clone()))
        }
        RowKind::Name(_) => None,
    });
    if let Some((field, choice)) = field {
        take(state, &field, &choice.toml);
    }
}

/// Opens the table that was chosen, or adds it.
pub(super) fn of_table(state: &mut State, taken: &str) {
    if taken == MASSES {
        return open(state, FormSource::Masses);
    }
    let at = match taken.strip_prefix(ADD) {
        Some(header) => return add(state, header),
        None if taken.is_empty() => Some(SceneKey::from(&[][..])),
        None => SceneKey::parse(taken).ok(),
    };
    if let Some(at) = at {
        open(state, FormSource::Table(at));
    }
}
