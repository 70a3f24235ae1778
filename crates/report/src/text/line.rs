//! A line of a page, and what it takes to write one.

use std::borrow::Cow;

use assur_words::{Language, Text, to_ascii};
use textwrap::{Options, WordSeparator::AsciiSpace, WordSplitter::NoHyphenation};

/// How a text is written.
#[derive(Debug, Clone, Copy)]
pub struct Style {
    /// Its language.
    pub language: &'static Language,
    /// No character beyond ASCII.
    pub ascii: bool,
}

/// What a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// A heading, or the caption of a table.
    Heading,
    /// The heads of the columns of a table, and their units.
    Head,
    /// A rule below a heading or below the heads of columns.
    Rule,
    /// Words, or facts.
    Words,
    /// The row of a table of this number, from 0; a row may have several lines.
    Row(usize),
}

/// A line of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// What it is.
    pub kind: LineKind,
    /// Its characters.
    pub text: String,
}

pub(super) fn joined(lines: &[Line]) -> String {
    lines.iter().flat_map(|line| [line.text.as_str(), "\n"]).collect()
}

impl Style {
    /// English, with all characters.
    pub fn english() -> Self {
        Self { language: Language::english(), ascii: false }
    }

    /// A text in the language.
    pub fn line(self, text: &Text) -> String {
        let line = text.render(self.language);
        if self.ascii { to_ascii(&line).into_owned() } else { line }
    }
}

/// Words broken into lines; the first is indented by `first` columns, those after it by `rest`.
pub(super) fn wrap(words: &str, first: usize, rest: usize, width: usize) -> Vec<String> {
    // A space that does not break keeps the digits of a number together.
    let words: Vec<_> = words.split_ascii_whitespace().collect();
    let indents = [first, rest].map(|columns| " ".repeat(columns));
    let options = Options::new(width).initial_indent(&indents[0]).subsequent_indent(&indents[1]);
    let whole = options.break_words(false).word_separator(AsciiSpace).word_splitter(NoHyphenation);
    textwrap::wrap(&words.join(" "), whole).into_iter().map(Cow::into_owned).collect()
}
