//! Faults of a scene: gathered with byte ranges, given out with lines and columns.

use std::cell::RefCell;
use std::ops::Range;

/// One fault of a scene file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneError {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Bytes of the file that are at fault.
    pub span: Range<usize>,
    /// What is wrong, one line.
    pub message: String,
    /// What to write instead, beside the place; may be empty.
    pub label: String,
    /// What is allowed.
    pub help: Option<String>,
    /// The line of the file.
    pub(crate) source: String,
    /// Bytes of `source` that are at fault.
    pub(crate) marked: Range<usize>,
}

/// All the faults of a scene, or of another file, in the order of the file; never empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneErrors {
    /// The name of the file as it was given.
    pub file: String,
    /// The faults.
    pub errors: Vec<SceneError>,
}

impl std::error::Error for SceneErrors {}

/// A fault while reading.
#[derive(Debug, Clone)]
pub struct Fault {
    span: Range<usize>,
    message: String,
    label: String,
    help: Option<String>,
}

impl Fault {
    /// What is wrong in these bytes of the file, one line.
    pub fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        Self { span, message: message.into(), label: String::new(), help: None }
    }

    /// What to write instead, shown beside the place.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// What is allowed.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    fn locate(self, text: &str) -> SceneError {
        let start = floor(text, self.span.start);
        let end = floor(text, self.span.end.max(start));
        // A byte order mark is no part of the first line.
        let mark = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let from = text[..start].rfind('\n').map_or(mark, |newline| newline + 1);
        let start = start.max(from);
        let end = end.max(start);
        let until = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
        let source = text[from..until].trim_end_matches('\r');
        SceneError {
            line: text[..from].matches('\n').count() + 1,
            column: text[from..start].chars().count() + 1,
            span: start..end,
            message: self.message,
            label: self.label,
            help: self.help,
            marked: (start - from).min(source.len())..(end - from).min(source.len()),
            source: source.to_owned(),
        }
    }
}

/// The nearest boundary of a character at or before `at`.
fn floor(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Gathers faults, so that a reader can go on and find the next one.
#[derive(Debug, Default)]
pub(crate) struct Faults(RefCell<Vec<Fault>>);

impl Faults {
    pub(crate) fn push(&self, fault: Fault) {
        self.0.borrow_mut().push(fault);
    }

    /// All of them in the order of the file; empty where there were none.
    pub(crate) fn into_errors(self, file: &str, text: &str) -> SceneErrors {
        let mut faults = self.0.into_inner();
        faults.sort_by_key(|fault| fault.span.start);
        let errors = faults.into_iter().map(|fault| fault.locate(text)).collect();
        SceneErrors { file: file.to_owned(), errors }
    }
}
