//! Tables and values of the file, each with its place and the name that messages use for it.
//!
//! A reader takes keys from a [`Section`] and values of a given kind from an [`Entry`]. A wrong value is noted as a
//! fault and returned as `None`; the reader continues with a default, and the result is discarded together with the
//! faults.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{Fault, Faults};
use crate::text::{did_you_mean, is_unprintable, nearest, row, shown};

/// A table of the file with a known set of keys.
#[derive(Debug, Clone)]
pub struct Section<'a> {
    table: &'a DeTable<'a>,
    /// Its kind with an article: "a spring".
    pub(crate) what: &'static str,
    /// Its header; for an inline table the whole table.
    pub(crate) span: Range<usize>,
    known: &'static [&'static str],
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
    pub(crate) fn root(
        table: &'a DeTable<'a>,
        what: &'static str,
        known: &'static [&'static str],
        faults: &'a Faults,
    ) -> Self {
        let section = Self { table, what, span: 0..0, known, faults };
        section.refuse_unknown();
        section
    }

    fn refuse_unknown(&self) {
        for entry in self.entries() {
            if !self.known.contains(&entry.name.as_str()) {
                entry.unknown("key", self.known.iter().copied(), || self.knows());
            }
        }
    }

    fn knows(&self) -> String {
        format!("{} knows: {}", self.what, self.known.join(", "))
    }

    /// The value of a key, if it is present.
    pub fn get(&self, key: &str) -> Option<Entry<'a>> {
        let (name, value) = self.table.get_key_value(key)?;
        Some(Entry::new(name.get_ref().to_string(), name.span(), value, self.faults))
    }

    /// The value of a required key; a missing one is noted as a fault.
    pub(crate) fn need(&self, key: &str) -> Option<Entry<'a>> {
        let entry = self.get(key);
        if entry.is_none() {
            self.missing(key, "");
        }
        entry
    }

    /// Notes a missing key, and why it is needed.
    pub(crate) fn missing(&self, key: &str, why: &str) {
        let label = if why.is_empty() { format!("add `{key} = ...`") } else { why.to_owned() };
        let message = format!("{} needs `{key}`", self.what);
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
    pub fn fault(&self, message: impl Into<String>, label: impl Into<String>) {
        self.faults.push(Fault::new(self.span.clone(), message).label(label));
    }

    /// Notes a fault.
    pub fn note(&self, fault: Fault) {
        self.faults.push(fault);
    }

    /// Notes an unknown key, described as a `what`, with the known key of nearly the same spelling.
    pub fn unknown<'k>(
        &self,
        what: &str,
        known: impl IntoIterator<Item = &'k str>,
        help: impl FnOnce() -> String,
    ) {
        self.faults.note(|| {
            let near = nearest(&self.name, known);
            let message = format!("unknown {what} `{}`", shown(&self.name));
            Fault::new(self.key.clone(), message).label(did_you_mean(near)).help(help())
        });
    }

    /// Whether it is a list.
    pub fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// Notes that the value is of the wrong kind.
    pub(crate) fn wrong(&self, wanted: &str, label: impl Into<String>) {
        let message = format!("`{}` wants {wanted}, got {}", shown(&self.name), kind(self.value));
        self.fault(message, label);
    }

    /// A table whose keys are names chosen by the user.
    pub fn named(&self, wanted: &str, label: &str) -> Vec<Self> {
        if let DeValue::Table(table) = self.value {
            return entries(table, self.faults);
        }
        self.wrong(wanted, label);
        Vec::new()
    }

    /// A table with these keys.
    pub(crate) fn section(&self, what: &'static str, known: &'static [&'static str]) -> Option<Section<'a>> {
        let DeValue::Table(table) = self.value else {
            let hint =
                if self.value.is_array() { format!("write [{}] once", self.name) } else { String::new() };
            self.wrong("one table", hint);
            return None;
        };
        let section = Section { table, what, span: self.span.clone(), known, faults: self.faults };
        section.refuse_unknown();
        Some(section)
    }

    /// A list of tables, `[[name]]`, each with these keys.
    pub(crate) fn sections(&self, what: &'static str, known: &'static [&'static str]) -> Vec<Section<'a>> {
        if self.value.is_table() {
            self.wrong("a list of tables", format!("write [[{}]]", self.name));
            return Vec::new();
        }
        self.list("a list of tables").iter().filter_map(|item| item.section(what, known)).collect()
    }

    /// The elements of a list; messages name each by the list.
    pub fn list(&self, wanted: &str) -> Vec<Self> {
        let DeValue::Array(array) = self.value else {
            self.wrong(wanted, "");
            return Vec::new();
        };
        array.iter().map(|item| Self::new(self.name.clone(), item.span(), item, self.faults)).collect()
    }

    /// The two elements of a list of two.
    pub(crate) fn pair(&self, wanted: &str) -> Option<[Self; 2]> {
        let list = if self.value.is_array() { self.list(wanted) } else { Vec::new() };
        let count = list.len();
        let pair: Result<[Self; 2], _> = list.try_into();
        if pair.is_err() {
            let got = if self.value.is_array() {
                format!("a list of {count}")
            } else {
                kind(self.value).to_owned()
            };
            self.fault(format!("`{}` wants {wanted}, got {got}", shown(&self.name)), "");
        }
        pair.ok()
    }

    /// A text on one line that is not empty.
    pub fn text(&self, wanted: &str) -> Option<&'a str> {
        let DeValue::String(text) = self.value else {
            self.wrong(wanted, "in quotes");
            return None;
        };
        let text = text.as_ref();
        if text.trim().is_empty() || text.chars().any(is_unprintable) {
            let got =
                if text.trim().is_empty() { "an empty text" } else { "a text with invisible characters" };
            self.fault(format!("`{}` wants {wanted}, got {got}", shown(&self.name)), "");
            return None;
        }
        Some(text)
    }

    /// A text for a header; it may be empty.
    pub(crate) fn line(&self) -> Option<String> {
        let text = self.value.as_str();
        if text.is_none() {
            self.wrong("a text", "in quotes");
        }
        text.map(|text| text.chars().map(|c| if is_unprintable(c) { ' ' } else { c }).collect())
    }

    /// One of several given words.
    pub fn choice<T: Copy>(&self, words: &[(&str, T)]) -> Option<T> {
        let list = row(words.iter().map(|word| word.0));
        let text = self.text(&format!("one of: {list}"))?;
        let found = words.iter().find(|word| word.0 == text);
        if found.is_none() {
            let near = nearest(text, words.iter().map(|word| word.0));
            let message = format!("`{}` wants one of: {list}, got `{}`", self.name, shown(text));
            self.fault(message, did_you_mean(near));
        }
        found.map(|word| word.1)
    }

    /// `true` or `false`.
    pub fn flag(&self) -> Option<bool> {
        let flag = self.value.as_bool();
        if flag.is_none() {
            self.wrong("true or false", "");
        }
        flag
    }
}

/// The kind of a value, with an article.
pub(crate) fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) => "an integer",
        DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a boolean",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
