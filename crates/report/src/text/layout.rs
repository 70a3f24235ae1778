//! Lines, sections and tables of at most [`WIDTH`] columns.

use std::borrow::Cow;

use textwrap::Options;
use textwrap::WordSeparator::AsciiSpace;
use textwrap::WordSplitter::NoHyphenation;
use unicode_width::UnicodeWidthStr;

use super::number;
use super::units::Unit;
use crate::to_ascii;

/// Columns of the report.
const WIDTH: usize = 100;
/// Blanks between the columns of a table.
const GAP: usize = 2;

/// Rows of a list that are shown.
const MOST_ROWS: usize = 4096;
/// Lines of a table of numbers that are shown, all its blocks together: sixteen blocks of the most positions that are kept.
const MOST_LINES: usize = 16 * MOST_ROWS;

/// One column of a table of numbers.
#[derive(Debug, Clone)]
pub(super) struct Column {
    head: String,
    unit: &'static str,
    cells: Cells,
}

#[derive(Debug, Clone)]
enum Cells {
    /// Text as it is.
    Text(Vec<String>),
    /// Numbers, whose digits are set when the other columns of their unit are known; `None` is a dash.
    Numbers(Vec<Option<f64>>),
}

impl Column {
    /// A quantity of each row, converted from SI.
    pub(super) fn of<'r, T: 'r>(
        rows: impl IntoIterator<Item = &'r T>,
        head: impl Into<String>,
        unit: Unit,
        value: impl Fn(&T) -> Option<f64>,
    ) -> Self {
        Self::numbers(head, unit, rows.into_iter().map(value))
    }

    /// Numbers, converted from SI.
    pub(super) fn numbers(
        head: impl Into<String>,
        unit: Unit,
        values: impl IntoIterator<Item = Option<f64>>,
    ) -> Self {
        let values = values.into_iter().map(|value| value.map(|value| value * unit.factor));
        Self { head: head.into(), unit: unit.name, cells: Cells::Numbers(values.collect()) }
    }

    /// Texts under a head.
    pub(super) fn texts(head: &str, cells: Vec<String>) -> Self {
        Self { head: head.to_owned(), unit: "", cells: Cells::Text(cells) }
    }

    /// The largest number.
    fn largest(&self) -> f64 {
        match &self.cells {
            Cells::Text(_) => 0.0,
            Cells::Numbers(values) => {
                values.iter().flatten().fold(0.0, |largest, value| largest.max(value.abs()))
            }
        }
    }

    /// The formatted cells; `largest`: of all columns of this unit.
    fn ready(self, largest: f64, ascii: bool) -> Ready {
        let cells = match self.cells {
            Cells::Text(cells) => cells,
            Cells::Numbers(values) => number::column(&values, largest),
        };
        let (head, unit) = (fold(&self.head, ascii).into_owned(), fold(self.unit, ascii).into_owned());
        let all = cells.iter().chain([&head, &unit]);
        Ready { width: all.map(|text| text.width()).max().unwrap_or(0), head, unit, cells }
    }
}

/// A column of texts.
#[derive(Debug)]
struct Ready {
    head: String,
    unit: String,
    cells: Vec<String>,
    width: usize,
}

fn fold(text: &str, ascii: bool) -> Cow<'_, str> {
    if ascii { to_ascii(text) } else { Cow::Borrowed(text) }
}

/// A report that is being written.
#[derive(Debug)]
pub(super) struct Page {
    text: String,
    ascii: bool,
    sections: usize,
}

impl Page {
    pub(super) fn new(ascii: bool) -> Self {
        Self { text: String::new(), ascii, sections: 0 }
    }

    pub(super) fn finish(self) -> String {
        self.text
    }

    pub(super) fn title(&mut self, title: &str) {
        self.underlined(title, "=");
    }

    fn underlined(&mut self, line: &str, with: &str) {
        let line = fold(line, self.ascii);
        self.lines(&[&line, &with.repeat(line.width())]);
    }

    fn lines(&mut self, lines: &[&str]) {
        for line in lines {
            self.text += line;
            self.text.push('\n');
        }
    }

    /// A numbered heading.
    pub(super) fn section(&mut self, name: &str) {
        self.sections += 1;
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.underlined(&format!("{}. {name}", self.sections), "-");
    }

    /// A line that names the table below it.
    pub(super) fn caption(&mut self, caption: &str) {
        self.lines(&["", &fold(caption, self.ascii)]);
    }

    /// Words, broken into lines.
    pub(super) fn paragraph(&mut self, words: &str) {
        self.text += &wrap(&fold(words, self.ascii), 0, 2);
    }

    /// Text that is already formatted.
    pub(super) fn text(&mut self, text: &str) {
        self.text += text;
    }

    /// Rows of words in aligned columns below their heads.
    pub(super) fn rows(&mut self, head: &[&str], rows: &[Vec<String>]) {
        self.text += &columns(head, &rows[..rows.len().min(MOST_ROWS)], self.ascii);
        self.shortened(MOST_ROWS, rows.len(), "rows");
    }

    /// A table of numbers in blocks of the page's width, each with the key columns in front; nothing without groups.
    /// Columns of one group stay together where they fit.
    pub(super) fn table(&mut self, caption: &str, keys: &[Column], groups: Vec<Vec<Column>>) {
        if groups.is_empty() {
            return;
        }
        if !caption.is_empty() {
            self.caption(caption);
        }
        let ready = |key: &Column| key.clone().ready(key.largest(), self.ascii);
        let keys: Vec<_> = keys.iter().map(ready).collect();
        let room = WIDTH - total(&keys).min(WIDTH);
        let mut blocks: Vec<Vec<Ready>> = Vec::new();
        for group in pieces(groups, room, self.ascii) {
            match blocks.last_mut().filter(|block| total(block) + total(&group) <= room) {
                Some(block) => block.extend(group),
                None => blocks.push(group),
            }
        }
        let rows = keys.iter().map(|key| key.cells.len()).max().unwrap_or(0);
        let most = (MOST_LINES / rows.max(1)).max(1);
        let count = |blocks: &[Vec<Ready>]| blocks.iter().map(Vec::len).sum::<usize>();
        let (all, shown) = (count(&blocks), count(&blocks[..blocks.len().min(most)]));
        let blocks: Vec<_> = blocks.iter().take(most).map(|block| block_text(&keys, block)).collect();
        self.text += &blocks.join("\n");
        self.shortened(shown, all, "columns");
    }

    /// Says how many of all rows or columns are shown, where not all are.
    fn shortened(&mut self, shown: usize, all: usize, what: &str) {
        if shown < all {
            let line = format!("... {shown} of {all} {what} shown; all are in the other forms (`--format`)");
            self.lines(&[&line]);
        }
    }
}

/// Key columns and columns of a block, all flush right.
fn block_text(keys: &[Ready], columns: &[Ready]) -> String {
    let all: Vec<_> = keys.iter().chain(columns).collect();
    let mut heads: Vec<Vec<&str>> = vec![all.iter().map(|column| column.head.as_str()).collect()];
    if all.iter().any(|column| !column.unit.is_empty()) {
        heads.push(all.iter().map(|column| column.unit.as_str()).collect());
    }
    let count = all.iter().map(|column| column.cells.len()).max().unwrap_or(0);
    let cell = |column: &Ready, row: usize| -> String { column.cells.get(row).cloned().unwrap_or_default() };
    let rows: Vec<Vec<String>> =
        (0..count).map(|row| all.iter().map(|column| cell(column, row)).collect()).collect();
    grid(&heads, &rows, &vec![true; all.len()])
}

/// Width of columns with the gaps in front of them.
fn total(columns: &[Ready]) -> usize {
    columns.iter().map(|column| column.width + GAP).sum()
}

/// Groups of columns, those that are wider than a page cut into single columns.
fn pieces(groups: Vec<Vec<Column>>, room: usize, ascii: bool) -> Vec<Vec<Ready>> {
    // The largest number of each unit.
    let mut scales: Vec<(&str, f64)> = Vec::new();
    for column in groups.iter().flatten() {
        match scales.iter_mut().find(|(unit, _)| *unit == column.unit) {
            Some((_, scale)) => *scale = scale.max(column.largest()),
            None => scales.push((column.unit, column.largest())),
        }
    }
    let largest = |unit: &str| scales.iter().find(|(known, _)| *known == unit).map_or(0.0, |found| found.1);
    let ready = |column: Column| {
        let largest = largest(column.unit);
        column.ready(largest, ascii)
    };
    let mut pieces = Vec::new();
    for group in groups {
        let group: Vec<_> = group.into_iter().map(ready).collect();
        if total(&group) <= room {
            pieces.push(group);
        } else {
            pieces.extend(group.into_iter().map(|column| vec![column]));
        }
    }
    pieces
}

/// Rows of words in aligned columns below their heads and a line; columns of numbers are flush right.
pub fn columns(head: &[&str], rows: &[Vec<String>], ascii: bool) -> String {
    let head: Vec<_> = head.iter().map(|cell| fold(cell, ascii)).collect();
    let fold_row = |row: &Vec<String>| row.iter().map(|cell| fold(cell, ascii).into_owned()).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(fold_row).collect();
    let number = |cell: &String| cell == "-" || cell.is_empty() || cell.parse::<f64>().is_ok();
    let is_numeric = |column: usize| rows.iter().filter_map(|row| row.get(column)).all(number);
    let right: Vec<bool> = (0..head.len()).map(is_numeric).collect();
    grid(&[head.iter().map(|cell| &**cell).collect()], &rows, &right)
}

/// Heads, a line, and rows; each column as wide as its widest cell, flush `right` or left.
fn grid(heads: &[Vec<&str>], rows: &[Vec<String>], right: &[bool]) -> String {
    let rows: Vec<Vec<&str>> = rows.iter().map(|row| row.iter().map(String::as_str).collect()).collect();
    let width = |column: usize| {
        heads
            .iter()
            .chain(&rows)
            .filter_map(|row| row.get(column))
            .map(|cell| cell.width())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..right.len()).map(width).collect();
    let rule: Vec<_> = widths.iter().map(|width| "-".repeat(*width)).collect();
    let rule: Vec<_> = rule.iter().map(String::as_str).collect();
    let mut text = String::new();
    for row in heads.iter().chain([&rule]).chain(&rows) {
        let mut line = String::new();
        for (column, cell) in row.iter().enumerate() {
            let blanks = " ".repeat(widths[column] - cell.width());
            let gap = " ".repeat(if column == 0 { 0 } else { GAP });
            let (before, after) = if right[column] { (&*blanks, "") } else { ("", &*blanks) };
            line.extend([&gap, before, cell, after]);
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// Words broken into lines; the first is indented by `first` columns, those after it by `rest`.
pub(crate) fn wrap(words: &str, first: usize, rest: usize) -> String {
    let words: Vec<_> = words.split_whitespace().collect();
    let indents = [first, rest].map(|columns| " ".repeat(columns));
    let options = Options::new(WIDTH).initial_indent(&indents[0]).subsequent_indent(&indents[1]);
    let whole = options.break_words(false).word_separator(AsciiSpace).word_splitter(NoHyphenation);
    textwrap::fill(&words.join(" "), whole) + "\n"
}
