//! Faults as text.

use assur_words::{Describe, Text, joined, name, text};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::error::{SceneError, SceneErrors};
use crate::text::is_unprintable;

/// Greatest number of faults that are printed; the rest are counted.
const MOST: usize = 20;
/// Greatest number of columns of a source line that are printed.
const WIDEST: usize = 100;
/// Columns that are kept before the place where a long line is cut.
const BEFORE: usize = 40;

assur_words::errors!(SceneErrors);

impl Describe for SceneErrors {
    /// The faults, each with its line of the file.
    fn describe(&self) -> Text {
        let shown = self.errors.iter().take(MOST).map(|error| one(self, error));
        let more = (self.errors.len() + self.more).saturating_sub(MOST);
        let more = (more > 0).then(|| lines([text!("scene-more-faults", more)]));
        joined("\n", shown.chain(more))
    }
}

fn one(errors: &SceneErrors, error: &SceneError) -> Text {
    let gutter = error.line.to_string().len();
    let (line, before, marked) = excerpt(&errors.text, error);
    let (file, row, column) = (name(printable(&errors.file)), error.line, error.column);
    let place = text!("scene-place", file, line = row, column);
    let carets = name(format!("{:gutter$} | {:before$}{}", "", "", "^".repeat(marked.max(1))));
    let marked = [carets, error.label.clone()].into_iter().filter(|part| !part.is_empty());
    let help = error.help.iter().map(|help| joined(" ", [name(format!("{:gutter$} =", "")), help.clone()]));
    let rows = [
        text!("scene-fault", message = &error.message),
        joined("", [name("  "), place]),
        name(format!("{:gutter$} |", "")),
        name(format!("{row} | {line}").trim_end().to_owned()),
        joined(" ", marked),
    ];
    lines(rows.into_iter().chain(help))
}

/// Texts each on a line of its own.
fn lines(rows: impl IntoIterator<Item = Text>) -> Text {
    joined("\n", rows.into_iter().chain([Text::default()]))
}

/// The source line as it is printed, the columns before the marked part, and the columns of the marked part.
fn excerpt(text: &str, error: &SceneError) -> (String, usize, usize) {
    let line = error.source.clone();
    let (start, end) = (error.span.start.min(line.end), error.span.end.min(line.end));
    let [head, mark, tail] =
        [line.start..start, start..end, end..line.end].map(|part| printable(&text[part]));
    if head.width() + mark.width() + tail.width() <= WIDEST {
        let (before, marked) = (head.width(), mark.width());
        return (head + &mark + &tail, before, marked);
    }
    let kept = last_columns(&head, BEFORE);
    let head = if kept.len() < head.len() { format!("...{kept}") } else { head };
    let room = WIDEST - head.width();
    let mark = first_columns(&mark, room).to_owned();
    let tail = first_columns(&tail, room - mark.width());
    let (before, marked) = (head.width(), mark.width());
    (format!("{head}{mark}{tail}..."), before, marked)
}

/// Replaces tabs by four spaces, and characters that are invisible or change the text beside them by a question mark.
fn printable(piece: &str) -> String {
    let piece = piece.replace('\t', "    ");
    piece.chars().map(|c| if is_unprintable(c) { '?' } else { c }).collect()
}

fn first_columns(text: &str, columns: usize) -> &str {
    let mut used = 0;
    let end = text.char_indices().find(|(_, c)| {
        used += c.width().unwrap_or(0);
        used > columns
    });
    end.map_or(text, |(at, _)| &text[..at])
}

fn last_columns(text: &str, columns: usize) -> &str {
    let mut used = 0;
    let cut = text.char_indices().rev().find(|(_, c)| {
        used += c.width().unwrap_or(0);
        used > columns
    });
    cut.map_or(text, |(at, c)| &text[at + c.len_utf8()..])
}
