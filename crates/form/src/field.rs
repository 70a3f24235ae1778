//! A key of a table with all that a form shows of it.

use assur_mechanism::Key;
use assur_scene::Dimension;
use assur_scene::edit::{bare, split};
use assur_scene::reference::{Bound, KeyDefault, SceneKey, ValueKind, either, table};
use assur_words::{Describe, Text, joined, name, text};
use toml::de::DeValue;

use crate::choices::{Choice, Offers, choices};
use crate::rows::rows;
use crate::sort::openings;
use crate::tables::{Tables, key_of, last, owner};

/// A key of a table, whether it stands there or not.
#[derive(Debug, Clone)]
pub struct Field {
    /// Its key in the scene, elements of lists by number.
    pub key: Key,
    /// Its name as it is written in the file; of an element of a list empty.
    pub label: String,
    /// A sentence that says what it is.
    pub about: Text,
    /// What its value may be, with units.
    pub values: Text,
    /// The limits of its number; empty where there are none.
    pub limits: Text,
    /// The SI unit of a number that is written without one; empty where there is none.
    pub unit: &'static str,
    /// Its value (TOML) as it is written; `{ ... }` for a table that stands under a header; `None`: it is left out.
    pub value: Option<String>,
    /// What holds where it is left out.
    pub default: KeyDefault,
    /// What may be chosen for it by name: words, parts of the scene, what the caller offers. Other values may be possible.
    pub choices: Vec<Choice>,
    /// Tables that may be its value, one for each sort; a form for one that stands is at the same key.
    pub opens: Vec<Opening>,
    pub(crate) kinds: Vec<ValueKind>,
}

/// A table that may stand as the value of a key: of one sort where there are several.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Opening {
    /// How the reference writes the table: `value = { ... }`.
    pub header: &'static str,
    /// Its sort: `angle`, `stroke`, `formula`; `None` where there is only one.
    pub sort: Option<&'static str>,
    /// What it is, in words.
    pub label: Text,
    /// Whether it is what stands there.
    pub stands: bool,
}

impl Field {
    /// The field of a key of the reference.
    pub(crate) fn of(tables: &Tables<'_>, key: Key, known: &SceneKey, offers: Offers<'_>) -> Self {
        let coordinate = tables.coordinate(&key);
        let kinds: Vec<ValueKind> = known.kinds.iter().map(|kind| resolved(kind, coordinate)).collect();
        Self {
            about: text!(known.about),
            limits: limits(known.limits),
            default: known.default,
            choices: choices(tables, &key, &kinds, offers),
            // The tables of points are the values of those.
            opens: if known.kinds.contains(&ValueKind::Points) {
                Vec::new()
            } else {
                openings(tables, &key, known)
            },
            ..Self::bare(tables, key, kinds)
        }
    }

    /// A field of which nothing is known but its kinds of values.
    pub(crate) fn bare(tables: &Tables<'_>, key: Key, kinds: Vec<ValueKind>) -> Self {
        let unit = kinds.iter().find_map(quantity_of).map_or("", Dimension::si);
        let written = |written: &str| if written.starts_with('[') { "{ ... }" } else { written }.to_owned();
        let is_table = tables.table(&key).is_some();
        let value = tables.written(&key);
        let value = value
            .map(|value| if is_table && !value.starts_with('{') { written("[") } else { value.to_owned() });
        Self {
            label: last(&key).to_owned(),
            about: Text::default(),
            values: either(kinds.iter().map(Describe::describe).collect()),
            limits: Text::default(),
            unit,
            value,
            default: KeyDefault::Absent,
            choices: Vec::new(),
            opens: Vec::new(),
            kinds,
            key,
        }
    }

    /// Whether its table is refused without it.
    pub fn is_needed(&self) -> bool {
        self.default == KeyDefault::Needed
    }

    /// Whether it may be a text of any words.
    pub fn is_text(&self) -> bool {
        self.kinds.contains(&ValueKind::Text)
    }

    /// Whether a table stands there, which has a form of its own.
    pub fn is_table(&self) -> bool {
        self.value.as_deref().is_some_and(|value| value.starts_with('{'))
    }

    /// Its value for editing: a text without its quotes, anything else as it is written; empty where it is left out.
    pub fn shown(&self) -> String {
        let value = self.value.clone().unwrap_or_default();
        let text = DeValue::parse(&value).ok().and_then(|toml| toml.get_ref().as_str().map(str::to_owned));
        text.unwrap_or(value)
    }

    /// The unit in which its number is written: the SI unit of a number without one; empty where it is no number, or has no unit.
    pub fn own_unit(&self) -> String {
        let (number, own) = (self.shown(), || self.unit.to_owned());
        match split(&number) {
            Some((_, unit)) if unit.is_empty() => own(),
            Some((_, unit)) => unit,
            None if self.value.is_none() => own(),
            None => String::new(),
        }
    }

    /// What holds where it is left out, with its unit; empty where that is nothing, or where it is needed.
    pub fn default_shown(&self) -> Text {
        let KeyDefault::Is(value) = self.default else { return Text::default() };
        if value.parse::<f64>().is_ok() {
            name(format!("{value} {}", self.unit).trim_end().to_owned())
        } else {
            name(bare(value))
        }
    }
}

/// A kind of value; where the coordinate of the input decides what it measures, what that is.
fn resolved(kind: &ValueKind, coordinate: Option<Dimension>) -> ValueKind {
    match (kind, coordinate) {
        (ValueKind::ByInput(turning, _), Some(Dimension::Angle)) => ValueKind::Quantity(*turning),
        (ValueKind::ByInput(_, sliding), Some(_)) => ValueKind::Quantity(*sliding),
        (ValueKind::Two(kind), _) => ValueKind::Two(Box::new(resolved(kind, coordinate))),
        _ => kind.clone(),
    }
}

/// What a number of a kind measures.
pub(crate) fn quantity_of(kind: &ValueKind) -> Option<Dimension> {
    match kind {
        ValueKind::Quantity(dimension) => Some(*dimension),
        ValueKind::Place | ValueKind::Points => Some(Dimension::Length),
        ValueKind::Two(kind) => quantity_of(kind),
        _ => None,
    }
}

fn limits(bound: Bound) -> Text {
    match bound {
        Bound::Any => Text::default(),
        Bound::NotNegative => text!("form-not-negative"),
        Bound::Positive => text!("form-positive"),
        Bound::Direction => text!("form-direction"),
    }
}

/// What a table of the reference is, with its sort.
pub(crate) fn what(header: &str, sort: Option<&'static str>) -> Text {
    let what = text!(table(header).what);
    sort.map_or_else(|| what.clone(), |sort| joined(": ", [what.clone(), name(sort)]))
}

/// The field of one key: of a table, of a point of a link, or of a number in a row. `None` of a key that no form has.
pub fn field(text: &str, at: &Key, offers: Offers<'_>) -> Option<Field> {
    let tables = Tables::of(text);
    let key = tables.numbered(at);
    if let Some(known) = key_of(key.steps()) {
        return Some(Field::of(&tables, key, known, offers));
    }
    if let Some(points) = key_of(owner(&key).steps()).filter(|list| list.kinds.contains(&ValueKind::Points)) {
        return Some(point(&tables, key, points));
    }
    let rows = rows(text, &key.of_list())?;
    rows.rows.into_iter().flatten().find(|field| field.key == key)
}

/// The field of a point among those of a link or of the ground.
pub(crate) fn point(tables: &Tables<'_>, key: Key, points: &SceneKey) -> Field {
    // A place of a link is no other point of it.
    let mut kinds = vec![
        ValueKind::Quantity(Dimension::Length),
        ValueKind::Two(Box::new(ValueKind::Quantity(Dimension::Length))),
    ];
    kinds.extend(points.kinds.iter().filter(|kind| matches!(kind, ValueKind::Table(_))).cloned());
    let opens = openings(tables, &key, points);
    Field {
        about: text!(points.about),
        default: KeyDefault::Absent,
        opens,
        ..Field::bare(tables, key, kinds)
    }
}
