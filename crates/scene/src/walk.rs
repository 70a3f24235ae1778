//! Tables and values of the file, each with its place and the name that messages use for it.
//!
//! A reader takes keys from a [`Section`] and values of a given kind from an [`Entry`]. A wrong value is noted as a
//! fault and returned as `None`; the reader continues with a default, and the result is discarded together with the
//! faults.

use std::ops::Range;
use std::sync::Arc;

use assur_mechanism::{Mechanism, Name, Solve};
use assur_words::{Text, joined, name, text};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{Fault, Faults};
use crate::known::Known;
use crate::reference::{self, KeyDefault, KeyTable, SceneKey, ValueKind};
use crate::text::{did_you_mean, in_quotes, is_unprintable, nearest, row, shown};
use crate::units::Dimension;

/// A table of the file with a known set of keys.
#[derive(Debug, Clone)]
pub struct Section<'a> {
    table: &'a DeTable<'a>,
    /// Its kind with an article: "a spring".
    pub(crate) what: Text,
    /// Its header; for an inline table the whole table.
    pub(crate) span: Range<usize>,
    known: Known,
    pub(crate) faults: &'a Faults,
}

/// A value of the file.
#[derive(Debug, Clone)]
pub struct Entry<'a> {
    /// Its key, or another name for messages.
    pub name: String,
    /// Place of the key; for an element of a list, place of the element.
    pub key: Range<usize>,
    pub(crate) value: &'a DeValue<'a>,
    /// Place of the value.
    pub span: Range<usize>,
    pub(crate) faults: &'a Faults,
}

impl<'a> Section<'a> {
    /// The whole file.
    pub(crate) fn root(table: &'a DeTable<'a>, what: Text, known: Known, faults: &'a Faults) -> Self {
        let section = Self { table, what, span: 0..0, known, faults };
        section.refuse_unknown();
        section
    }

    /// What is allowed, but probably not meant, as far as it was read.
    pub(crate) fn mistakes(&self) -> Vec<assur_mechanism::Warning> {
        self.faults.mistakes(self.table)
    }

    pub(crate) fn table(&self) -> &'a DeTable<'a> {
        self.table
    }

    fn refuse_unknown(&self) {
        let known = self.known.names();
        for entry in self.entries() {
            if !known.contains(&entry.name.as_str()) {
                entry.faults.note(|| {
                    let message =
                        text!("scene-unknown", what = text!("scene-key"), name = shown(&entry.name));
                    let label = self.known.meant(&entry.name, &known);
                    Fault::new(entry.key.clone(), message).label(label).help(self.knows())
                });
            }
        }
    }

    fn knows(&self) -> Text {
        text!("scene-knows", what = &self.what, keys = name(self.known.names().join(", ")))
    }

    /// The value of a key, if it is present.
    pub fn get(&self, key: &str) -> Option<Entry<'a>> {
        let (name, value) = self.table.get_key_value(key)?;
        Some(Entry::new(name.get_ref().to_string(), name.span(), value, self.faults))
    }

    /// What the reference says of a key.
    fn known(&self, key: &str) -> Option<&'static SceneKey> {
        let Known::Table(table, _) = self.known else { return None };
        table.key(key)
    }

    /// The table that is the value of a key.
    fn table_of(&self, key: &str) -> Option<&'static KeyTable> {
        let header =
            |kind: &ValueKind| if let ValueKind::Table(header) = kind { Some(*header) } else { None };
        self.known(key)?.kinds.iter().find_map(header).map(reference::table)
    }

    /// The table of a key, if it is present.
    pub(crate) fn inner(&self, key: &str) -> Option<Self> {
        self.get(key)?.section(self.table_of(key)?)
    }

    /// The list of tables of a key, `[[key]]`.
    pub(crate) fn inners(&self, key: &str) -> Vec<Self> {
        let Some((entry, table)) = self.get(key).zip(self.table_of(key)) else { return Vec::new() };
        if entry.value.is_table() {
            entry.wrong(text!("scene-list-of-tables"), text!("scene-write-list", key = shown(key)));
            return Vec::new();
        }
        entry.list(text!("scene-list-of-tables")).iter().filter_map(|item| item.section(table)).collect()
    }

    /// The number of a key, a quantity and within limits as the reference says; where it is left out, its default. `None` if it is
    /// wrong, or if there is none.
    pub(crate) fn number(&self, key: &str) -> Option<f64> {
        self.by_input(key, None)
    }

    /// The number of a key whose quantity depends on what the input coordinate is; where that is not known, any unit is right.
    pub(crate) fn by_input(&self, key: &str, coordinate: Option<Dimension>) -> Option<f64> {
        let known = self.known(key)?;
        let entry = if known.default == KeyDefault::Needed { self.need(key) } else { self.get(key) };
        match (entry, known.default) {
            (Some(entry), _) => entry.bounded(known.dimension(coordinate), known.limits),
            (None, KeyDefault::Is(default)) => default.parse().ok(),
            (None, _) => None,
        }
    }

    /// The number of a key, or its word: then it is to be found. `None` as of [`by_input`](Self::by_input).
    pub(crate) fn solved(&self, key: &str, coordinate: Option<Dimension>) -> Option<Solve> {
        if let (Some(entry), Some(known)) = (self.get(key), self.known(key)) {
            let (text, word) = (entry.value.as_str().unwrap_or_default(), known.words().next()?);
            if text == word {
                entry.may_be(known.dimension(coordinate), known.limits);
                return Some(Solve::Wanted);
            }
            if text.starts_with(char::is_alphabetic) {
                let quantity = known.dimension(coordinate.or(Some(Dimension::Angle)))?.with_units();
                let wanted = text!("scene-word-or", word = name(word), quantity);
                entry.wants(wanted, in_quotes(text), did_you_mean(text, nearest(text, [word])));
                return None;
            }
            let dimension = known.dimension(coordinate);
            return entry.bounded_or(dimension, known.limits, Some(word)).map(Solve::Given);
        }
        self.by_input(key, coordinate).map(Solve::Given)
    }

    /// Tells where in a mechanism the numbers of its keys stand, by key (`value.axis`), and with which sign. Only numbers that may
    /// have any value within their limits whatever the others are have such a place.
    pub(crate) fn sets(
        &self,
        sign: f64,
        slot: impl for<'m> Fn(&'m mut Mechanism, &str) -> Option<&'m mut f64> + Send + Sync + 'static,
    ) {
        self.faults.tell(|told| told.slots(self.table, "", sign, &Arc::new(slot)));
    }

    /// Its key `name`, or else the default name, with its labels; `taken`: the identity of what is said of a name that something else has.
    pub(crate) fn name(
        &self,
        default: impl FnOnce() -> Text,
        taken: impl FnOnce(&Name) -> Option<&'static str>,
    ) -> Name {
        let entry = self.get("name");
        let given = entry.as_ref().and_then(|entry| entry.text(text!("scene-a-name")));
        let name = given.map_or_else(|| default().into(), Name::from);
        if let Some(entry) = &entry {
            self.faults.check_name(&entry.span, &name);
        }
        if let Some(message) = taken(&name) {
            let at = entry.map_or(self.span.clone(), |entry| entry.span);
            self.faults.add(at, text!(message, name = shown(&name)), text!("scene-own-name"));
        }
        self.labelled(name)
    }

    /// Notes those of some keys that are there, though they have no effect; `message`: its identity.
    pub(crate) fn refuse(&self, keys: &[&str], message: &'static str, label: &Text) {
        for entry in keys.iter().filter_map(|key| self.get(key)) {
            self.faults.add(entry.key, text!(message, key = shown(&entry.name)), label.clone());
        }
    }

    /// The value of a required key; a missing one is noted as a fault.
    pub(crate) fn need(&self, key: &str) -> Option<Entry<'a>> {
        self.get(key).or_else(|| {
            self.missing(key, Text::default());
            None
        })
    }

    /// Notes a missing key, and why it is needed.
    pub(crate) fn missing(&self, key: &str, why: Text) {
        let label = if why.is_empty() { text!("scene-add-key", key = shown(key)) } else { why };
        let message = text!("scene-needs-key", what = &self.what, key = shown(key));
        self.faults.push(Fault::new(self.span.clone(), message).label(label).help(self.knows()));
    }

    /// Every key with its value, in the order of the file.
    pub(crate) fn entries(&self) -> Vec<Entry<'a>> {
        entries(self.table, self.faults)
    }
}

/// Keys and values of a table in the order of the file.
fn entries<'a>(table: &'a DeTable<'a>, faults: &'a Faults) -> Vec<Entry<'a>> {
    let mut all: Vec<Entry<'a>> = table
        .iter()
        .map(|(name, value)| Entry::new(name.get_ref().to_string(), name.span(), value, faults))
        .collect();
    all.sort_by_key(|entry| entry.key.start);
    all
}

impl<'a> Entry<'a> {
    fn new(name: String, key: Range<usize>, value: &'a Spanned<DeValue<'a>>, faults: &'a Faults) -> Self {
        Self { name, key, value: value.get_ref(), span: value.span(), faults }
    }

    /// Notes a fault of the value.
    pub fn fault(&self, message: impl Into<Text>, label: impl Into<Text>) {
        self.faults.add(self.span.clone(), message.into(), label.into());
    }

    /// Notes a fault of the value that is said behind the name of its key.
    pub fn problem(&self, problem: impl Into<Text>, label: impl Into<Text>) {
        self.fault(text!("scene-problem-of-key", key = shown(&self.name), problem = problem.into()), label);
    }

    pub(crate) fn wants(&self, wanted: Text, got: Text, label: impl Into<Text>) {
        self.problem(text!("scene-wants", wanted, got), label);
    }

    /// Notes a fault.
    pub fn note(&self, fault: Fault) {
        self.faults.push(fault);
    }

    /// Notes an unknown key, described as a `what`, with the known key of nearly the same spelling.
    pub fn unknown<'k>(
        &self,
        what: Text,
        known: impl IntoIterator<Item = &'k str>,
        help: impl FnOnce() -> Text,
    ) {
        self.faults.note(|| {
            let near = nearest(&self.name, known);
            let message = text!("scene-unknown", what, name = shown(&self.name));
            Fault::new(self.key.clone(), message).label(did_you_mean(&self.name, near)).help(help())
        });
    }

    /// Whether it is a list.
    pub fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// Notes that the value is of the wrong kind.
    pub(crate) fn wrong(&self, wanted: Text, label: impl Into<Text>) {
        self.wants(wanted, kind(self.value), label);
    }

    /// A table whose keys are names chosen by the user.
    pub fn named(&self, wanted: Text, label: Text) -> Vec<Self> {
        if let DeValue::Table(table) = self.value {
            return entries(table, self.faults);
        }
        self.wrong(wanted, label);
        Vec::new()
    }

    /// A table of the reference.
    pub(crate) fn section(&self, table: &'static KeyTable) -> Option<Section<'a>> {
        self.section_as(text!(table.what), Known::Table(table, None))
    }

    /// A table with these keys; `what`: its kind with an article.
    pub(crate) fn section_as(&self, what: Text, known: Known) -> Option<Section<'a>> {
        let DeValue::Table(table) = self.value else {
            let hint = text!("scene-write-once", key = shown(&self.name));
            let hint = if self.value.is_array() { hint } else { Text::default() };
            self.wrong(text!("scene-one-table"), hint);
            return None;
        };
        let section = Section { table, what, span: self.span.clone(), known, faults: self.faults };
        section.refuse_unknown();
        Some(section)
    }

    /// The elements of a list; messages name each by the list.
    pub fn list(&self, wanted: Text) -> Vec<Self> {
        let DeValue::Array(array) = self.value else {
            self.wrong(wanted, Text::default());
            return Vec::new();
        };
        array.iter().map(|item| Self::new(self.name.clone(), item.span(), item, self.faults)).collect()
    }

    /// The two elements of a list of two.
    pub(crate) fn pair(&self, wanted: &Text) -> Option<[Self; 2]> {
        let list = self.list(wanted.clone());
        let count = list.len();
        let pair = <[Self; 2]>::try_from(list).ok();
        if pair.is_none() && self.is_list() {
            // 0,15 is two numbers.
            let label = if count > 2 { text!("scene-decimal-comma") } else { Text::default() };
            self.wants(wanted.clone(), text!("scene-list-of-so-many", count), label);
        }
        pair
    }

    /// A text on one line that is not empty.
    pub fn text(&self, wanted: Text) -> Option<&'a str> {
        let DeValue::String(text) = self.value else {
            self.wrong(wanted, text!("scene-in-quotes"));
            return None;
        };
        let text = text.as_ref();
        if text.trim().is_empty() || text.chars().any(is_unprintable) {
            let empty = text.trim().is_empty();
            let got = if empty { text!("scene-an-empty-text") } else { text!("scene-an-invisible-text") };
            self.wants(wanted, got, Text::default());
            return None;
        }
        Some(text)
    }

    /// A text for a header; it may be empty.
    pub(crate) fn line(&self) -> Option<String> {
        let text = self.value.as_str();
        if text.is_none() {
            self.wrong(text!("scene-a-text"), text!("scene-in-quotes"));
        }
        text.map(|text| text.chars().map(|c| if is_unprintable(c) { ' ' } else { c }).collect())
    }

    /// One of several given words.
    pub fn choice<T: Copy>(&self, words: &[(&str, T)]) -> Option<T> {
        let wanted = || text!("scene-one-of", words = row(words.iter().map(|word| word.0)));
        let text = self.text(wanted())?;
        let found = words.iter().find(|word| word.0 == text);
        if found.is_none() {
            let near = nearest(text, words.iter().map(|word| word.0));
            self.wants(wanted(), quoted(text), did_you_mean(text, near));
        }
        found.map(|word| word.1)
    }

    /// `true` or `false`.
    pub fn flag(&self) -> Option<bool> {
        self.value.as_bool().or_else(|| {
            self.wrong(text!("scene-true-or-false"), Text::default());
            None
        })
    }
}

/// The kind of a value, with an article.
pub(crate) fn kind(value: &DeValue<'_>) -> Text {
    match value {
        DeValue::String(_) => text!("scene-a-text"),
        DeValue::Integer(_) => text!("scene-an-integer"),
        DeValue::Float(_) => text!("scene-a-number"),
        DeValue::Boolean(_) => text!("scene-a-boolean"),
        DeValue::Datetime(_) => text!("scene-a-date"),
        DeValue::Array(_) => text!("scene-a-list"),
        DeValue::Table(_) => text!("scene-a-table"),
    }
}

/// A piece of the scene between the signs of a quotation.
pub(crate) fn quoted(piece: &str) -> Text {
    joined("", [name("`"), shown(piece), name("`")])
}
