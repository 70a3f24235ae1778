//! Forms: the fields of a table of the scene are filled in; what is typed makes another text at once, or is told to be wrong.

use std::sync::Arc;

use assur_draft::{Part, rename};
use assur_form::{
    Change, Field, added, deleted, field, inserted, made, masses, put, rod, rows, sections, table,
};
use assur_mechanism::{Key as SceneKey, Step};
use assur_words::{Text, list, name, text};
use crossterm::event::KeyCode;

use super::draft;
use crate::screen::state::{
    Choice, Entry, FormSource, FormTask, Key, Picker, PickerKind, Role, Row, RowKind, State, Task, round,
};

/// Before the number of a table that may stand in a field, in the name of a choice.
const OPENING: &str = "table:";
/// The name of the choice of rows in place of a number.
const ROWS: &str = "rows";
/// Before the header of a table that is added, in the name of a choice.
const ADD: &str = "+";
/// The name of the choice of all masses.
const MASSES: &str = "masses";

/// Opens a form in place of the task in hand.
pub(super) fn open(state: &mut State, source: FormSource) {
    let form = FormTask { source, ..FormTask::default() };
    state.build.task = Task::Form(Box::new(form));
    renew(state);
}

/// Opens a form from a field of the one that is open.
fn open_within(state: &mut State, source: FormSource) {
    let Some(form) = state.build.form_mut() else { return open(state, source) };
    form.above.push((form.source.clone(), form.chosen));
    (form.source, form.chosen) = (source, 0);
    (form.entry, form.fault, form.begun) = (None, None, false);
    renew(state);
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

/// Opens the form in which a key stands, at its field.
pub(super) fn at(state: &mut State, key: &SceneKey) {
    let steps = key.steps();
    let depth = if steps.len() > 2 { 2 } else { 1 };
    let source = FormSource::Table(SceneKey::from(&steps[..depth.min(steps.len())]));
    open(state, source);
    let Some(form) = state.build.form_mut() else { return };
    let is_field =
        |row: &Row| matches!(&row.kind, RowKind::Value(field) if key.steps().starts_with(field.key.steps()));
    form.chosen = form.rows.iter().position(is_field).unwrap_or(0);
}

/// The fields of the form as the text has them now.
pub(super) fn renew(state: &mut State) {
    let text = Arc::clone(state.draft.text());
    let Some(form) = state.build.form() else { return };
    let name = |part: &Part| Row {
        label: state.told(sort_of(part)),
        value: name_of(part),
        stands: true,
        kind: RowKind::Name(part.clone()),
    };
    let (heading, rows): (Text, Vec<Row>) = match &form.source {
        FormSource::Table(at) => {
            let form = table(&text, at, &motors(at));
            (
                form.heading,
                form.fields.into_iter().map(|field| row_of(state, field.label.clone(), field)).collect(),
            )
        }
        FormSource::Masses => {
            let rows = masses(&text).rows.into_iter().flat_map(|row| {
                row.fields.into_iter().map(move |field| (format!("{} {}", row.link, field.label), field))
            });
            (text!("build-masses"), rows.map(|(label, field)| row_of(state, label, field)).collect())
        }
        FormSource::Rows(at) => {
            let found = rows(&text, at);
            let rows = found.map(|rows| rows.rows).unwrap_or_default().into_iter().enumerate();
            let cells =
                rows.flat_map(|(index, cells)| cells.into_iter().enumerate().map(move |cell| (index, cell)));
            let label = |index: usize, column: usize| format!("{} {}", index + 1, ["x", "y"][column]);
            let rows = cells.map(|(index, (column, field))| row_of(state, label(index, column), field));
            (text!("build-rows", key = at), rows.collect())
        }
        FormSource::Made(parts, keys) => {
            let fields = keys.iter().filter_map(|key| field(&text, key, &[]));
            let fields = fields.map(|field| row_of(state, label_of(state, &field.key), field));
            (text!("build-made"), parts.iter().map(name).chain(fields).collect())
        }
    };
    if let Some(form) = state.build.form_mut() {
        form.chosen = form.chosen.min(rows.len().saturating_sub(1));
        (form.heading, form.rows) = (heading, rows);
    }
}

/// Motors of the catalogues, for the field of the motor in the table of the drive.
fn motors(at: &SceneKey) -> Vec<(&'static str, Vec<assur_form::Choice>)> {
    if *at != SceneKey::of("drive") {
        return Vec::new();
    }
    let catalogues = assur_motor::catalogues();
    let filter = assur_motor::MotorFilter::default();
    let all = catalogues
        .as_ref()
        .ok()
        .and_then(|all| assur_motor::list_motors(all, &filter).ok())
        .unwrap_or_default();
    let motors = all.into_iter().map(|motor| assur_form::Choice::word(motor.designation.clone())).collect();
    vec![("motor", motors)]
}

fn row_of(state: &State, label: String, field: Field) -> Row {
    let stands = field.value.is_some();
    let value = if !stands {
        state.told(field.default_shown())
    } else if field.is_table() {
        field.shown()
    } else {
        let (shown, unit) = (field.shown(), field.own_unit());
        let is_bare = !unit.is_empty() && shown.parse::<f64>().is_ok();
        if is_bare { format!("{shown} {unit}") } else { shown }
    };
    Row { label, value, stands, kind: RowKind::Value(Box::new(field)) }
}

/// What a part is: a link, a point, a slide.
fn sort_of(part: &Part) -> Text {
    text!(match part {
        Part::Link(_) => "build-a-link",
        Part::Point(_) => "build-a-point",
        Part::Slide(_) => "build-a-slide",
        Part::Load(..) => "build-tables",
    })
}

/// The name of a field outside of its table: `B on rod`, `angle of rod/ground`.
fn label_of(state: &State, key: &SceneKey) -> String {
    let steps: Vec<&str> = key.steps().iter().filter_map(Step::name).collect();
    let (of, own) = match steps[..] {
        ["link", link, "points", own] => (link, own),
        ["ground", "points", own] => ("ground", own),
        ["slide", slide, own] => (slide, own),
        _ => return key.to_string(),
    };
    state.told(text!("build-of", own = name(own.to_owned()), of = name(of.to_owned())))
}

fn name_of(part: &Part) -> String {
    match part {
        Part::Link(name) | Part::Point(name) | Part::Slide(name) => name.clone(),
        Part::Load(table, index) => format!("{table}[{index}]"),
    }
}

pub(super) fn press(state: &mut State, key: Key) {
    let Some(form) = state.build.form_mut() else { return };
    let typing = form.entry.is_some();
    match key.code {
        KeyCode::Enter => enter(state),
        KeyCode::Down | KeyCode::Tab => leave(state, 1),
        KeyCode::Up | KeyCode::BackTab => leave(state, -1),
        KeyCode::Left | KeyCode::Right if !typing => {
            turn(state, if key.code == KeyCode::Right { 1 } else { -1 });
        }
        KeyCode::Char(' ') if !typing => offer(state),
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
        KeyCode::Home if end(state) => state.build.form_mut().into_iter().for_each(|form| form.chosen = 0),
        KeyCode::End if end(state) => {
            state
                .build
                .form_mut()
                .into_iter()
                .for_each(|form| form.chosen = form.rows.len().saturating_sub(1));
        }
        KeyCode::Home | KeyCode::End => {}
        KeyCode::Delete if typing => close(state),
        KeyCode::Delete => remove(state),
        KeyCode::Insert if end(state) => insert(state),
        _ => typed(state, |entry| entry.press(key)),
    }
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
    let Some(RowKind::Value(field)) = form.row().map(|row| row.kind.clone()) else { return };
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
fn end(state: &mut State) -> bool {
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
                state.say(Role::Bad, problem);
                return false;
            }
        }
    }
    if let Some(form) = state.build.form_mut() {
        (form.entry, form.fault, form.begun) = (None, None, false);
    }
    renew(state);
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

/// Goes to another field, once what is typed is taken.
fn leave(state: &mut State, by: isize) {
    fill(state);
    if !end(state) {
        return;
    }
    if let Some(form) = state.build.form_mut() {
        form.chosen = round(form.chosen, by, form.rows.len());
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
fn fill(state: &mut State) {
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

/// Enter: the next field; of a table its own form; behind the last field the form is done.
fn enter(state: &mut State) {
    fill(state);
    let typing = state.build.form().is_some_and(|form| form.entry.is_some());
    if !end(state) {
        return;
    }
    let Some(form) = state.build.form() else { return };
    let within = form.field().filter(|_| !typing).and_then(|field| within(state, field));
    let is_last = form.chosen + 1 >= form.rows.len();
    match within {
        Some(source) => open_within(state, source),
        None if is_last => close(state),
        None => leave(state, 1),
    }
}

/// The form of what stands in a field: of its table, or of its rows.
fn within(state: &State, field: &Field) -> Option<FormSource> {
    let is_list = field.value.as_ref().is_some_and(|value| value.starts_with('['));
    if is_list && rows(state.draft.text(), &field.key).is_some() {
        return Some(FormSource::Rows(field.key.clone()));
    }
    field.is_table().then(|| FormSource::Table(field.key.clone()))
}

/// Back to the form from which this one was opened, or to the picture. What is typed and was not ended is taken back.
pub(super) fn close(state: &mut State) {
    let Some(form) = state.build.form_mut() else { return };
    if form.entry.take().is_some() {
        form.fault = None;
        if std::mem::take(&mut form.begun) {
            draft::undo(state);
        }
        return renew(state);
    }
    match form.above.pop() {
        Some((source, chosen)) => {
            (form.source, form.chosen) = (source, chosen);
            renew(state);
        }
        None => state.build.task = Task::Choose,
    }
}

/// The next or previous choice of a field.
fn turn(state: &mut State, by: isize) {
    let Some(field) = state.build.form().and_then(FormTask::field).cloned() else { return };
    if field.choices.is_empty() {
        return;
    }
    let now = field.choices.iter().position(|choice| Some(&choice.toml) == field.value.as_ref());
    let next = now.map_or(0, |now| round(now, by, field.choices.len()));
    take(state, &field, &field.choices[next].toml);
}

/// Lists what the field may be: words, names, tables.
fn offer(state: &mut State) {
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

fn take(state: &mut State, field: &Field, toml: &str) {
    let change = put(state.draft.text(), field, &assur_scene::edit::bare(toml));
    changed(state, change);
}

/// Takes what a step of a form has made; a fault at its own key leaves the text as it is.
fn changed(state: &mut State, change: Change) -> bool {
    let is_taken = change.here.is_none();
    if let Some(fault) = change.here {
        state.say(Role::Bad, fault.message);
    } else {
        draft::take(state, Ok(change.text));
        if let Some(fault) = change.elsewhere.into_iter().next() {
            state.say(Role::Bad, fault.message);
        }
    }
    renew(state);
    is_taken
}

/// Adds a row behind the chosen one, or a point to a link.
fn insert(state: &mut State) {
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
fn remove(state: &mut State) {
    let Some(form) = state.build.form() else { return };
    if let FormSource::Rows(at) = &form.source {
        let change = deleted(state.draft.text(), at, form.chosen / 2);
        changed(state, change);
    } else if let Some(field) = form.field().cloned() {
        take(state, &field, "");
    }
}

/// The chosen link as a rod of so much mass per meter, which is typed into the field of its mass: `3 kg/m`.
fn rod_of(state: &mut State, typed: &str) -> bool {
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

/// Opens the table that was chosen, or adds it.
pub(super) fn of_table(state: &mut State, taken: &str) {
    if taken == MASSES {
        return open(state, FormSource::Masses);
    }
    let at = match taken.strip_prefix(ADD) {
        Some(header) => {
            let change = added(state.draft.text(), header);
            let at = change.at.clone();
            changed(state, change).then_some(at)
        }
        None if taken.is_empty() => Some(SceneKey::from(&[][..])),
        None => SceneKey::parse(taken).ok(),
    };
    if let Some(at) = at {
        open(state, FormSource::Table(at));
    }
}
