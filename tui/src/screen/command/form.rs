//! Forms: the fields of a table of the scene are filled in; what is typed makes another text at once, or is told to be wrong.

use std::sync::Arc;

use assur_draft::{Part, rename};
use assur_form::{Change, Field, put, rod, rows, table};
use assur_mechanism::{Key as SceneKey, Step};
use assur_words::text;

use super::{draft, fields};
use crate::screen::state::{Entry, FormSource, FormTask, Role, Row, RowKind, State, Task, round};

/// Opens a form in place of the task in hand.
pub(super) fn open(state: &mut State, source: FormSource) {
    let form = FormTask { source, ..FormTask::default() };
    state.build.task = Task::Form(Box::new(form));
    fields::renew(state);
}

/// Opens a form from a field of the one that is open.
pub(super) fn open_within(state: &mut State, source: FormSource) {
    let Some(form) = state.build.form_mut() else { return open(state, source) };
    form.above.push((form.source.clone(), form.chosen));
    (form.source, form.chosen) = (source, 0);
    (form.entry, form.fault, form.begun) = (None, None, false);
    fields::renew(state);
}

/// Opens the form of a part: its table, or of a point its places on all links.
pub(super) fn of_part(state: &mut State, part: &Part) {
    let source = match part {
        Part::Link(link) => FormSource::Table(SceneKey::of("link").at(&**link)),
        Part::Slide(slide) => FormSource::Table(SceneKey::of("slide").at(&**slide)),
        Part::Point(point) => {
            let Some(sketch) = state.build.sketch() else { return };
            let mechanism = &sketch.mechanism;
            let places = mechanism.points.iter().find(|own| *own.name == **point).map(|own| &own.places);
            let table = |link: usize| match link {
                assur_mechanism::GROUND => SceneKey::of("ground"),
                link => SceneKey::of("link").at(&mechanism.links[link].name),
            };
            let keys = places.into_iter().flatten().map(|place| table(place.link).at("points").at(&**point));
            FormSource::Made(vec![part.clone()], keys.collect())
        }
        Part::Load(table, index) => FormSource::Table(SceneKey::of(*table).at(*index)),
    };
    open(state, source);
}

/// Opens the form in which a key stands, at its field: that of the innermost table around it, or of its rows.
pub(super) fn at(state: &mut State, key: &SceneKey) {
    // Elements of lists by their number, as fields have them.
    let key = table(state.draft.text(), key, &[]).at;
    let steps = key.steps();
    for depth in (0..=steps.len()).rev() {
        let around = SceneKey::from(&steps[..depth]);
        if stands_alone(state.draft.text(), &around) {
            continue;
        }
        let is_of_rows = rows(state.draft.text(), &around).is_some_and(|rows| !rows.rows.is_empty());
        open(state, if is_of_rows { FormSource::Rows(around) } else { FormSource::Table(around) });
        let Some(form) = state.build.form_mut() else { return };
        let is_field =
            |row: &Row| matches!(&row.kind, RowKind::Value(field) if steps.starts_with(field.key.steps()));
        if !form.rows.is_empty() {
            form.chosen = form.rows.iter().position(is_field).unwrap_or(0);
            return;
        }
    }
}

/// Whether a number or a text stands at a key where a table could: it is a field of the table around it.
fn stands_alone(text: &str, key: &SceneKey) -> bool {
    let Some((_, around)) = key.steps().split_last() else { return false };
    let form = table(text, &SceneKey::from(around), &[]);
    let own = form.fields.iter().find(|field| field.key.steps() == key.steps());
    own.and_then(|field| field.value.as_deref()).is_some_and(|value| !value.starts_with(['{', '[']))
}

/// Changes what is typed, and takes it into the text if it may stand there.
pub(super) fn typed(state: &mut State, change: impl FnOnce(&mut Entry) -> bool) {
    let Some(form) = state.build.form_mut() else { return };
    let mut entry = form.entry.clone().unwrap_or_default();
    // A key that writes nothing leaves the value as it is.
    if form.row().is_none() || !change(&mut entry) {
        return;
    }
    let words = pieces(form, &entry).first().map_or_else(String::new, |piece| (*piece).to_owned());
    form.entry = Some(entry);
    let Some(RowKind::Value(field)) = form.row().map(|row| row.kind.clone()) else {
        // Whether a name is taken is asked at its end.
        form.fault = None;
        return;
    };
    // A step that has begun with this field is typed on from the text before it.
    let begun = form.begun;
    let before = if begun { state.draft.before().cloned() } else { None };
    let before = before.unwrap_or_else(|| Arc::clone(state.draft.text()));
    let words = completed(state, &field, &words);
    let change = put(&before, &field, &words);
    let Some(form) = state.build.form_mut() else { return };
    form.fault = change.here.map(|fault| fault.message);
    if form.fault.is_some() {
        return;
    }
    let differs = if begun { state.draft.amend(&change.text) } else { state.draft.take(&change.text) };
    if let Some(form) = state.build.form_mut() {
        form.begun = begun || differs;
    }
    if differs {
        draft::ask(state);
    }
}

/// The choice that begins with what is typed, if there is one alone; else what is typed.
fn completed(state: &State, field: &Field, words: &str) -> String {
    let wanted = words.to_lowercase();
    let mut fit = field.choices.iter().filter(|choice| {
        let label = state.told(choice.label.clone()).to_lowercase();
        !wanted.is_empty() && (label == wanted || label.starts_with(&wanted))
    });
    match (fit.next(), fit.next()) {
        (Some(choice), None) => assur_scene::edit::bare(&choice.toml),
        _ => words.to_owned(),
    }
}

/// Ends what is typed; returns whether it was taken.
pub(super) fn end(state: &mut State) -> bool {
    let Some(form) = state.build.form() else { return true };
    let Some(typed) = form.entry.as_ref().map(|entry| entry.trim().to_owned()) else { return true };
    let (fault, kind) = (form.fault.clone(), form.row().map(|row| row.kind.clone()));
    if let Some(fault) = fault.filter(|_| !rod_of(state, &typed)) {
        state.say(Role::Bad, fault);
        return false;
    }
    if let (Some(RowKind::Name(part)), false) = (kind, typed.is_empty()) {
        match rename(state.draft.text(), &part, &typed) {
            Ok(text) => {
                renamed(state, &part, &typed);
                draft::take(state, Ok(text));
            }
            Err(problem) => {
                state.build.form_mut().into_iter().for_each(|form| form.fault = Some(problem.clone()));
                state.say(Role::Bad, problem);
                return false;
            }
        }
    }
    if let Some(form) = state.build.form_mut() {
        (form.entry, form.fault, form.begun) = (None, None, false);
    }
    fields::renew(state);
    true
}

/// The form follows a part that has another name.
fn renamed(state: &mut State, part: &Part, new: &str) {
    let next = match part {
        Part::Link(_) => Part::Link(new.to_owned()),
        Part::Point(_) => Part::Point(new.to_owned()),
        Part::Slide(_) => Part::Slide(new.to_owned()),
        load @ Part::Load(..) => load.clone(),
    };
    if state.build.chosen.as_ref() == Some(part) {
        state.build.chosen = Some(next.clone());
    }
    let Some(FormSource::Made(parts, keys)) = state.build.form_mut().map(|form| &mut form.source) else {
        return;
    };
    parts.iter_mut().filter(|own| *own == part).for_each(|own| *own = next.clone());
    for key in keys {
        *key = assur_draft::renamed_key(key, part, new);
    }
}

/// Goes so many fields on, from the last to the first one, once what is typed is taken.
pub(super) fn leave(state: &mut State, by: isize) {
    leave_for(state, |form| round(form.chosen, by, form.rows.len()));
}

/// Goes to another field, once what is typed is taken.
pub(super) fn leave_for(state: &mut State, next: impl FnOnce(&FormTask) -> usize) {
    fill(state);
    if !end(state) {
        return;
    }
    if let Some(form) = state.build.form_mut() {
        form.chosen = next(form);
    }
}

/// What is typed, field by field: `4 kg; O; 0.04` fills three fields. In a text such as a title a semicolon is one of its letters.
fn pieces<'e>(form: &FormTask, entry: &'e str) -> Vec<&'e str> {
    if form.field().is_some_and(Field::is_text) {
        vec![entry.trim()]
    } else {
        entry.split(';').map(str::trim).collect()
    }
}

/// Fills the chosen field and those behind it with what is typed for several of them; stops at one that is not taken.
pub(super) fn fill(state: &mut State) {
    let Some((form, entry)) = state.build.form().and_then(|form| Some((form, form.entry.clone()?))) else {
        return;
    };
    let (all, room) = (pieces(form, &entry), form.rows.len() - form.chosen);
    let Some((last, before)) = all.split_last().filter(|(_, before)| !before.is_empty()) else { return };
    if all.len() > room {
        let problem = text!("build-too-many-values", given = all.len(), room);
        state.build.form_mut().into_iter().for_each(|form| form.fault = Some(problem.clone()));
        return state.say(Role::Bad, problem);
    }
    for piece in before {
        put_in(state, piece);
        if !end(state) {
            return;
        }
        leave(state, 1);
    }
    put_in(state, last);
}

/// Types a text in place of what is typed.
fn put_in(state: &mut State, piece: &str) {
    typed(state, |entry| {
        *entry = piece.into();
        true
    });
}

/// Takes back what is typed and was not ended; returns whether it was refused, or `None` where nothing is typed.
pub(super) fn take_back(state: &mut State) -> Option<bool> {
    let form = state.build.form_mut()?;
    form.entry.take()?;
    let refused = form.fault.take().is_some();
    if std::mem::take(&mut form.begun) {
        draft::undo(state);
    }
    fields::renew(state);
    Some(refused)
}

/// Takes back what is typed; or else, and where that is refused, goes back to the form from which this one was opened, or to the picture.
pub(super) fn close(state: &mut State) {
    if take_back(state) == Some(false) {
        return;
    }
    let Some(form) = state.build.form_mut() else { return };
    if let Some((source, chosen)) = form.above.pop() {
        (form.source, form.chosen) = (source, chosen);
        return fields::renew(state);
    }
    let made = matches!(form.source, FormSource::Made(..));
    state.build.task = Task::Choose;
    if made {
        settle(state);
    }
}

/// The lengths that were typed have moved points of the new group: `[assembly]` follows, as a part of the last step.
fn settle(state: &mut State) {
    super::reading::refresh(state);
    let Some(sketch) = state.build.sketch() else { return };
    let settled = assur_sketch::settled(state.draft.text(), sketch);
    if settled.is_ok_and(|text| state.draft.amend(&text)) {
        draft::ask(state);
    }
}

/// Takes what a step of a form has made; a fault at its own key leaves the text as it is.
pub(super) fn changed(state: &mut State, change: Change) -> bool {
    let is_taken = change.here.is_none();
    if let Some(fault) = change.here {
        state.say(Role::Bad, fault.message);
    } else {
        draft::take(state, Ok(change.text));
        if let Some(fault) = change.elsewhere.into_iter().next() {
            state.say(Role::Bad, fault.message);
        }
    }
    fields::renew(state);
    is_taken
}

/// The chosen link as a rod of so much mass per meter, which is typed into the field of its mass: `3 kg/m`.
pub(super) fn rod_of(state: &mut State, typed: &str) -> bool {
    let per_meter =
        typed.strip_suffix("kg/m").and_then(|number| number.trim().replace(',', ".").parse::<f64>().ok());
    let link = state.build.form().and_then(FormTask::field).and_then(|field| match field.key.steps() {
        [first, Step::Name(link), mass] if *first == "link".into() && *mass == "mass".into() => {
            Some(link.clone())
        }
        _ => None,
    });
    let (Some(per_meter), Some(link)) = (per_meter, link) else { return false };
    let change = rod(state.draft.text(), &link, per_meter);
    changed(state, change)
}
