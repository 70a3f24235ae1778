//! Lines, sections and tables of at most [`WIDTH`] columns.

use std::borrow::Cow;

use unicode_width::UnicodeWidthStr;

use super::number;
use crate::to_ascii;

/// Columns of the report.
const WIDTH: usize = 100;
/// Blanks between the columns of a table.
const GAP: usize = 2;

/// One column of a table of numbers.
#[derive(Debug, Clone)]
pub(super) struct Column {
    /// What it shows.
    pub(super) head: String,
    /// Its unit; may be empty.
    pub(super) unit: String,
    /// One cell a row.
    pub(super) cells: Cells,
}

/// What a column holds.
#[derive(Debug, Clone)]
pub(super) enum Cells {
    /// Text as it is.
    Text(Vec<String>),
    /// Numbers, which get their digits when it is known what stands beside them; `None` is a dash.
    Numbers(Vec<Option<f64>>),
}

/// A column whose cells are text.
#[derive(Debug)]
struct Ready {
    head: String,
    unit: String,
    cells: Vec<String>,
}

impl Ready {
    fn width(&self) -> usize {
        let cells = self.cells.iter().map(|cell| cell.width());
        cells.chain([self.head.width(), self.unit.width()]).max().unwrap_or(0)
    }
}

impl Column {
    /// The largest number.
    fn largest(&self) -> f64 {
        match &self.cells {
            Cells::Text(_) => 0.0,
            Cells::Numbers(values) => {
                values.iter().flatten().fold(0.0, |largest, value| largest.max(value.abs()))
            }
        }
    }

    /// With its digits; `largest`: of all columns of the same unit.
    fn ready(self, largest: f64, ascii: bool) -> Ready {
        let cells = match self.cells {
            Cells::Text(cells) => cells,
            Cells::Numbers(values) => number::column(&values, largest),
        };
        let fold = |text: String| if ascii { to_ascii(&text).into_owned() } else { text };
        Ready { head: fold(self.head), unit: fold(self.unit), cells }
    }
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

    fn fold<'a>(&self, text: &'a str) -> Cow<'a, str> {
        if self.ascii { to_ascii(text) } else { Cow::Borrowed(text) }
    }

    pub(super) fn title(&mut self, title: &str) {
        let title = self.fold(title).into_owned();
        self.underlined(&title, "=");
    }

    fn underlined(&mut self, line: &str, with: &str) {
        self.text += line;
        self.text += "\n";
        self.text += &with.repeat(line.width());
        self.text += "\n";
    }

    /// A numbered heading.
    pub(super) fn section(&mut self, name: &str) {
        self.sections += 1;
        let line = format!("{}. {name}", self.sections);
        let gap = if self.text.is_empty() { "" } else { "\n" };
        self.text += gap;
        self.underlined(&line, "-");
    }

    /// A line that names the table below it.
    pub(super) fn caption(&mut self, caption: &str) {
        let caption = self.fold(caption).into_owned();
        self.text += "\n";
        self.text += &caption;
        self.text += "\n";
    }

    /// Words, broken into lines.
    pub(super) fn paragraph(&mut self, words: &str) {
        let words = self.fold(words).into_owned();
        self.text += &wrap(&words, 0, 2);
    }

    /// Text that is laid out already.
    pub(super) fn text(&mut self, text: &str) {
        self.text += text;
    }

    /// Rows of words in aligned columns, the first row above a line.
    pub(super) fn rows(&mut self, rows: &[Vec<String>]) {
        self.text += &columns(rows, self.ascii);
    }

    /// A table of numbers in blocks of the page's width, each with the key columns in front. Columns of one group stay
    /// together where they fit.
    pub(super) fn table(&mut self, keys: &[Column], groups: Vec<Vec<Column>>) {
        let keys: Vec<_> = keys.iter().cloned().map(|key| (key.largest(), key)).collect();
        let keys: Vec<_> = keys.into_iter().map(|(largest, key)| key.ready(largest, self.ascii)).collect();
        let room = WIDTH - total(&keys).min(WIDTH);
        let mut block: Vec<Ready> = Vec::new();
        let mut first = true;
        for group in pieces(groups, room, self.ascii) {
            if !block.is_empty() && total(&block) + total(&group) > room {
                self.block(&keys, &block, first);
                (block, first) = (Vec::new(), false);
            }
            block.extend(group);
        }
        if !block.is_empty() {
            self.block(&keys, &block, first);
        }
    }

    fn block(&mut self, keys: &[Ready], columns: &[Ready], first: bool) {
        if !first {
            self.text.push('\n');
        }
        let all: Vec<_> = keys.iter().chain(columns).collect();
        let widths: Vec<_> = all.iter().map(|column| column.width()).collect();
        self.line(all.iter().map(|column| column.head.as_str()), &widths);
        if all.iter().any(|column| !column.unit.is_empty()) {
            self.line(all.iter().map(|column| column.unit.as_str()), &widths);
        }
        let rule: Vec<_> = widths.iter().map(|width| "-".repeat(*width)).collect();
        self.line(rule.iter().map(String::as_str), &widths);
        for row in 0..all.iter().map(|column| column.cells.len()).max().unwrap_or(0) {
            self.line(all.iter().map(|column| column.cells.get(row).map_or("", String::as_str)), &widths);
        }
    }

    /// One line of cells, flush right.
    fn line<'a>(&mut self, cells: impl Iterator<Item = &'a str>, widths: &[usize]) {
        let mut line = String::new();
        for (i, (cell, width)) in cells.zip(widths).enumerate() {
            let gap = if i == 0 { 0 } else { GAP };
            line += &" ".repeat(gap + width - cell.width());
            line += cell;
        }
        self.text += line.trim_end();
        self.text.push('\n');
    }
}

/// Width of columns with the gaps in front of them.
fn total(columns: &[Ready]) -> usize {
    columns.iter().map(|column| column.width() + GAP).sum()
}

/// Groups of columns, those that are wider than a page cut into single columns.
fn pieces(groups: Vec<Vec<Column>>, room: usize, ascii: bool) -> Vec<Vec<Ready>> {
    let scales = scales(&groups);
    let mut pieces = Vec::new();
    for group in groups {
        let group: Vec<_> = group
            .into_iter()
            .map(|column| {
                let largest =
                    scales.iter().find(|(unit, _)| *unit == column.unit).map_or(0.0, |(_, largest)| *largest);
                column.ready(largest, ascii)
            })
            .collect();
        if total(&group) <= room {
            pieces.push(group);
        } else {
            pieces.extend(group.into_iter().map(|column| vec![column]));
        }
    }
    pieces
}

/// The largest number of each unit.
fn scales(groups: &[Vec<Column>]) -> Vec<(String, f64)> {
    let mut scales: Vec<(String, f64)> = Vec::new();
    for column in groups.iter().flatten() {
        let largest = column.largest();
        match scales.iter_mut().find(|(unit, _)| *unit == column.unit) {
            Some((_, scale)) => *scale = scale.max(largest),
            None => scales.push((column.unit.clone(), largest)),
        }
    }
    scales
}

/// Rows of words in aligned columns, the first row above a line; columns of numbers are flush right.
pub fn columns(rows: &[Vec<String>], ascii: bool) -> String {
    let fold = |cell: &String| if ascii { to_ascii(cell).into_owned() } else { cell.clone() };
    let rows: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(fold).collect()).collect();
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let cells = |column: usize| rows.iter().filter_map(move |row| row.get(column));
    let widths: Vec<usize> =
        (0..count).map(|column| cells(column).map(|cell| cell.width()).max().unwrap_or(0)).collect();
    let numeric: Vec<bool> = (0..count)
        .map(|column| {
            cells(column).skip(1).all(|cell| cell == "-" || cell.is_empty() || cell.parse::<f64>().is_ok())
        })
        .collect();
    let mut text = String::new();
    for (index, row) in rows.iter().enumerate() {
        text += line_of(row, &widths, &numeric).trim_end();
        text.push('\n');
        if index == 0 {
            let rule: Vec<_> = widths.iter().map(|width| "-".repeat(*width)).collect();
            text += line_of(&rule, &widths, &numeric).trim_end();
            text.push('\n');
        }
    }
    text
}

fn line_of(row: &[String], widths: &[usize], numeric: &[bool]) -> String {
    let mut line = String::new();
    for (column, cell) in row.iter().enumerate() {
        let blanks = " ".repeat(widths[column] - cell.width());
        if column > 0 {
            line += &" ".repeat(GAP);
        }
        if numeric[column] {
            line += &blanks;
            line += cell;
        } else {
            line += cell;
            line += &blanks;
        }
    }
    line
}

/// Words broken into lines; the first is indented by `first` columns, those after it by `rest`.
pub(crate) fn wrap(words: &str, first: usize, rest: usize) -> String {
    let mut text = " ".repeat(first);
    let (mut used, mut empty) = (first, true);
    for word in words.split_whitespace() {
        let width = word.width();
        if !empty && used + 1 + width > WIDTH {
            text.push('\n');
            text += &" ".repeat(rest);
            used = rest;
        } else if !empty {
            text.push(' ');
            used += 1;
        }
        text += word;
        used += width;
        empty = false;
    }
    text.push('\n');
    text
}
