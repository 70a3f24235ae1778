//! Where the tables and keys of a text stand.

use std::ops::Range;

use assur_mechanism::Step;
use assur_scene::{SceneError, document, reference};
use assur_words::{Text, text};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The greatest text with faults of its syntax that is looked at, in bytes: it can't make so many tables that they fill the memory.
const MOST_RECOVERED: usize = 200_000;

/// A text without faults of its syntax.
#[derive(Debug)]
pub(crate) struct Layout<'t> {
    pub(crate) text: &'t str,
    pub(crate) root: DeTable<'t>,
    /// In the order of the text; the first is what stands before all headers.
    pub(crate) sections: Vec<Section>,
}

/// A header with the keys below it.
#[derive(Debug)]
pub(crate) struct Section {
    /// The key of its table; elements of a list by their number.
    pub(crate) path: Vec<Step>,
    /// The bytes of `[...]`.
    pub(crate) header: Range<usize>,
    pub(crate) entries: Vec<Entry>,
}

/// A key with its value, as it stands below a header.
#[derive(Debug)]
pub(crate) struct Entry {
    /// Its key from the scene as a whole.
    pub(crate) path: Vec<Step>,
    /// The bytes of its last name.
    pub(crate) key: Range<usize>,
    pub(crate) value: Range<usize>,
}

/// The text from a value on.
fn at<'t>(text: &'t str, value: &Spanned<DeValue<'_>>) -> &'t str {
    text.get(value.span().start..).unwrap_or_default()
}

/// Whether a value is written in one piece: not as headers, and not spread over longer keys.
pub(crate) fn in_one_piece(text: &str, value: &Spanned<DeValue<'_>>) -> bool {
    match value.get_ref() {
        DeValue::Table(_) => at(text, value).starts_with('{'),
        DeValue::Array(array) => {
            array.first().is_none_or(|item| !item.get_ref().is_table() || in_one_piece(text, item))
        }
        _ => true,
    }
}

impl<'t> Layout<'t> {
    /// The layout of a text.
    ///
    /// # Errors
    ///
    /// The first fault of the syntax in the reader's words.
    pub(crate) fn of(text: &'t str) -> Result<Self, Text> {
        check(text).map(|()| Self::recovered(text))
    }

    /// The layout of those parts of a text that are TOML; of a text without faults, or of few bytes.
    fn recovered(text: &'t str) -> Self {
        let root = DeTable::parse_recoverable(text).0.into_inner();
        let start = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let mut collector = Collector { text, sections: Vec::new(), entries: Vec::new() };
        collector.section(&[], start..start);
        collector.table(&root, &mut Vec::new());
        let Collector { mut sections, mut entries, .. } = collector;
        sections.sort_by_key(|section| section.header.start);
        entries.sort_by_key(|entry| entry.value.start);
        for entry in entries {
            let after = sections.partition_point(|section| section.header.end <= entry.key.start);
            if let Some(section) = sections.get_mut(after.saturating_sub(1)) {
                section.entries.push(entry);
            }
        }
        Self { text, root, sections }
    }

    /// The layout of a text that may have faults of its syntax; `None` if it is too large for one with faults.
    pub(crate) fn of_any(text: &'t str) -> Option<Self> {
        (text.len() <= MOST_RECOVERED || check(text).is_ok()).then(|| Self::recovered(text))
    }

    /// The section with this header.
    pub(crate) fn section(&self, path: &[Step]) -> Option<usize> {
        (1..self.sections.len()).find(|&index| self.sections[index].path == path)
    }

    /// Where the last line of a section's keys ends.
    pub(crate) fn content_end(&self, index: usize) -> usize {
        let section = &self.sections[index];
        let end = section.entries.last().map_or(section.header.end, |entry| entry.value.end);
        let is_empty = index == 0 && section.entries.is_empty();
        if is_empty { end } else { line_end(self.text, end) }
    }

    /// Where the comment lines directly above a header begin.
    pub(crate) fn lead(&self, index: usize) -> usize {
        let least = if index == 0 { 0 } else { self.content_end(index - 1) };
        let mut start = line_start(self.text, self.sections[index].header.start);
        while start > least {
            let above = line_start(self.text, start - 1);
            if !is_comment(&self.text[above..start]) {
                break;
            }
            start = above;
        }
        start.max(least)
    }

    /// Where the comment lines end that stand directly below a section's keys, and not above the next header.
    pub(crate) fn tail(&self, index: usize) -> usize {
        let end = self.content_end(index);
        let next = if index + 1 < self.sections.len() { self.lead(index + 1) } else { self.text.len() };
        let mut tail = end;
        while tail < next && is_comment(&self.text[tail..line_end(self.text, tail)]) {
            tail = line_end(self.text, tail);
        }
        tail
    }

    /// How a line ends.
    pub(crate) fn newline(&self) -> &'static str {
        if self.text.contains("\r\n") { "\r\n" } else { "\n" }
    }
}

/// Refuses a text that is not TOML, in the reader's words.
pub(crate) fn check(text: &str) -> Result<(), Text> {
    slip(text).map_or(Ok(()), |fault| Err(fault.message))
}

/// The first fault of the syntax of a text.
pub(crate) fn slip(text: &str) -> Option<SceneError> {
    let what = reference::TABLES.first().map(|table| text!(table.what)).unwrap_or_default();
    let mut is_toml = false;
    let read = document::read("", text, what, &[], |_| is_toml = true);
    read.err().filter(|_| !is_toml)?.errors.into_iter().next()
}

/// Where the line begins in which a place is.
pub(crate) fn line_start(text: &str, at: usize) -> usize {
    text[..at].rfind('\n').map_or(0, |newline| newline + 1)
}

/// Where the line after that of a place begins.
pub(crate) fn line_end(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |newline| at + newline + 1)
}

fn is_comment(line: &str) -> bool {
    line.trim_start_matches('\u{feff}').trim_start().starts_with('#')
}

/// Collects what stands below headers, and the headers.
struct Collector<'t> {
    text: &'t str,
    sections: Vec<Section>,
    entries: Vec<Entry>,
}

impl Collector<'_> {
    fn section(&mut self, path: &[Step], header: Range<usize>) {
        self.sections.push(Section { path: path.to_vec(), header, entries: Vec::new() });
    }

    fn table(&mut self, table: &DeTable<'_>, path: &mut Vec<Step>) {
        for (key, value) in table {
            path.push(Step::Name(key.get_ref().to_string()));
            self.value(&key.span(), value, path);
            path.pop();
        }
    }

    fn value(&mut self, key: &Range<usize>, value: &Spanned<DeValue<'_>>, path: &mut Vec<Step>) {
        match value.get_ref() {
            DeValue::Table(table) if !in_one_piece(self.text, value) => {
                if at(self.text, value).starts_with('[') {
                    self.section(path, value.span());
                }
                self.table(table, path);
            }
            DeValue::Array(array) if !in_one_piece(self.text, value) => {
                for (index, item) in array.iter().enumerate() {
                    path.push(Step::Index(index));
                    self.value(key, item, path);
                    path.pop();
                }
            }
            _ => self.entries.push(Entry { path: path.clone(), key: key.clone(), value: value.span() }),
        }
    }
}
