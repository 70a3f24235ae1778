//! The fields of a form as the text has them: labels, values, what may be chosen.

use std::sync::Arc;

use assur_draft::Part;
use assur_form::{Field, field, masses, rows, table};
use assur_mechanism::{Key as SceneKey, Step};
use assur_words::{Text, name, text};

use crate::screen::state::{FormSource, Row, RowKind, State};

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
pub(super) fn motors(at: &SceneKey) -> Vec<(&'static str, Vec<assur_form::Choice>)> {
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

pub(super) fn row_of(state: &State, label: String, field: Field) -> Row {
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
pub(super) fn sort_of(part: &Part) -> Text {
    text!(match part {
        Part::Link(_) => "build-a-link",
        Part::Point(_) => "build-a-point",
        Part::Slide(_) => "build-a-slide",
        Part::Load(..) => "build-tables",
    })
}

/// The name of a field outside of its table: `B on rod`, `angle of rod/ground`.
pub(super) fn label_of(state: &State, key: &SceneKey) -> String {
    let steps: Vec<&str> = key.steps().iter().filter_map(Step::name).collect();
    let (of, own) = match steps[..] {
        ["link", link, "points", own] => (link, own),
        ["ground", "points", own] => ("ground", own),
        ["slide", slide, own] => (slide, own),
        _ => return key.to_string(),
    };
    state.told(text!("build-of", own = name(own.to_owned()), of = name(of.to_owned())))
}

pub(super) fn name_of(part: &Part) -> String {
    match part {
        Part::Link(name) | Part::Point(name) | Part::Slide(name) => name.clone(),
        Part::Load(table, index) => format!("{table}[{index}]"),
    }
}

/// Keys of which those of both coordinates of a place are one.
pub(super) fn whole(keys: Vec<SceneKey>) -> Vec<SceneKey> {
    let mut unique: Vec<SceneKey> = Vec::new();
    for key in keys.into_iter().map(|key| key.of_list()) {
        if !unique.contains(&key) {
            unique.push(key);
        }
    }
    unique
}
