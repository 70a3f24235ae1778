//! Faults of a scene: collected with byte ranges, returned with lines and columns.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::ops::Range;

use assur_mechanism::{Key, LONGEST_NAME, Warning};
use assur_words::{Text, text};
use toml::de::DeTable;

use crate::reading::{Told, keys};
use crate::text::shown;

/// One fault of a scene file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneError {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Bytes of the file that are wrong.
    pub span: Range<usize>,
    /// What is wrong, one line.
    pub message: Text,
    /// A correction, shown beside the place; may be empty.
    pub label: Text,
    /// What is allowed there.
    pub help: Option<Text>,
    /// Bytes of the line of the file.
    pub(crate) source: Range<usize>,
}

/// All the faults of a scene, or of another file, in the order of the file; never empty.
#[derive(Clone, PartialEq, Eq)]
pub struct SceneErrors {
    /// The name of the file as given by the caller.
    pub file: String,
    /// The faults, the first ones if there are very many.
    pub errors: Vec<SceneError>,
    /// Number of further faults.
    pub more: usize,
    /// The text of the file.
    pub(crate) text: String,
}

/// Greatest number of faults that are kept; the rest are counted. A file of many megabytes may have one in every
/// word.
const MOST_FAULTS: usize = 1000;

/// A fault while reading.
#[derive(Debug, Clone)]
pub struct Fault {
    span: Range<usize>,
    message: Text,
    label: Text,
    help: Option<Text>,
}

impl Fault {
    /// What is wrong in these bytes of the file, one line.
    pub fn new(span: Range<usize>, message: impl Into<Text>) -> Self {
        Self { span, message: message.into(), label: Text::default(), help: None }
    }

    /// A correction, shown beside the place.
    #[must_use]
    pub fn label(mut self, label: impl Into<Text>) -> Self {
        self.label = label.into();
        self
    }

    /// What is allowed there.
    #[must_use]
    pub fn help(mut self, help: impl Into<Text>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// Finds lines and columns of places, which must come in the order of the file.
struct Lines<'t> {
    text: &'t str,
    /// Start and number of the line found last.
    line: (usize, usize),
    /// The place found last, and its column.
    last: (usize, usize),
}

impl<'t> Lines<'t> {
    fn of(text: &'t str) -> Self {
        // A byte order mark does not belong to the first line.
        let mark = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Self { text, line: (mark, 1), last: (mark, 1) }
    }

    fn locate(&mut self, fault: Fault) -> SceneError {
        let text = self.text;
        let start = floor(text, fault.span.start).max(self.last.0);
        let end = floor(text, fault.span.end).max(start);
        let passed = &text[self.line.0..start];
        if let Some(newline) = passed.rfind('\n') {
            self.line = (self.line.0 + newline + 1, self.line.1 + passed.matches('\n').count());
            self.last = (self.line.0, 1);
        }
        self.last = (start, self.last.1 + text[self.last.0..start].chars().count());
        let until = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
        let source = text[self.line.0..until].trim_end_matches('\r');
        SceneError {
            line: self.line.1,
            column: self.last.1,
            span: start..end,
            message: fault.message,
            label: fault.label,
            help: fault.help,
            source: self.line.0..self.line.0 + source.len(),
        }
    }
}

/// The nearest character boundary at or before `at`.
fn floor(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Collects faults while reading continues.
#[derive(Debug, Default)]
pub(crate) struct Faults {
    kept: RefCell<Vec<Fault>>,
    more: Cell<usize>,
    /// What is allowed, but probably not meant: its place and what it says.
    mistakes: RefCell<Vec<(Range<usize>, Text)>>,
    /// What is reported of the numbers, where somebody asks.
    pub(crate) told: Option<RefCell<Told>>,
}

impl Faults {
    /// Notes a fault; `make` is called only while faults are kept.
    pub(crate) fn note(&self, make: impl FnOnce() -> Fault) {
        if self.kept.borrow().len() < MOST_FAULTS {
            let fault = make();
            self.kept.borrow_mut().push(fault);
        } else {
            self.more.set(self.more.get() + 1);
        }
    }

    /// Faults of a reader that tells of its numbers as well.
    pub(crate) fn telling() -> Self {
        Self { told: Some(RefCell::default()), ..Self::default() }
    }

    /// Tells something of the numbers, if somebody asks.
    pub(crate) fn tell(&self, tell: impl FnOnce(&mut Told)) {
        if let Some(told) = &self.told {
            tell(&mut told.borrow_mut());
        }
    }

    pub(crate) fn push(&self, fault: Fault) {
        self.note(|| fault);
    }

    /// Notes what is wrong in these bytes of the file, and a correction.
    pub(crate) fn add(&self, span: Range<usize>, message: Text, label: Text) {
        self.push(Fault::new(span, message).label(label));
    }

    /// Notes a name or title that is too long; `span`: where it stands.
    pub(crate) fn check_name(&self, span: &Range<usize>, name: &str) {
        let count = name.chars().count();
        if count > LONGEST_NAME {
            let message = text!("scene-long-name", name = shown(name), count, most = LONGEST_NAME);
            self.add(span.clone(), message, text!("scene-take-shorter"));
        }
    }

    /// Notes what is allowed, but probably not meant.
    pub(crate) fn mistake(&self, span: Range<usize>, text: Text) {
        let mut mistakes = self.mistakes.borrow_mut();
        if mistakes.len() < MOST_FAULTS {
            mistakes.push((span, text));
        }
    }

    /// What is allowed, but probably not meant, at its key in the tables of the file: once for each key, in the order of the file.
    pub(crate) fn mistakes(&self, tables: &DeTable<'_>) -> Vec<Warning> {
        let mut mistakes = self.mistakes.borrow().clone();
        mistakes.sort_by_key(|(span, _)| span.start);
        let mut warnings: Vec<Warning> = Vec::new();
        let keys = if mistakes.is_empty() { HashMap::new() } else { keys(tables) };
        for (span, text) in mistakes {
            let key = keys.get(&span.start).map(Key::of_list);
            let same = |one: &Warning| one.key == key && one.text.identity() == text.identity();
            if !warnings.iter().any(same) {
                warnings.push(Warning::mistake(key, text));
            }
        }
        warnings
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.kept.borrow().is_empty()
    }

    /// All faults in the order of the file; empty if there were none.
    pub(crate) fn into_errors(self, file: &str, text: &str) -> SceneErrors {
        let mut faults = self.kept.into_inner();
        faults.sort_by_key(|fault| fault.span.start);
        let mut lines = Lines::of(text);
        let errors = faults.into_iter().map(|fault| lines.locate(fault)).collect();
        SceneErrors { file: file.to_owned(), errors, more: self.more.get(), text: text.to_owned() }
    }
}
