//! CSV: one header row with the unit in the name, comma separated, numbers with all their digits.

mod analysis;
mod geometry;

use std::{borrow::Cow, collections::BTreeSet, io::Read};

pub use ::csv::StringRecord;
use ::csv::{ReaderBuilder, Writer};
use assur_words::{Describe, Text, errors, name, text, to_ascii};

pub use analysis::{CsvTable, FILES, INDEX, columns_of_positions, of_positions, of_trajectory};
pub use geometry::{geometry, shaking};

/// A table can't be written as CSV.
pub enum CsvError {
    /// The writer fails.
    Write(::csv::Error),
    /// A number of a table is not finite.
    NotFinite {
        /// The column.
        column: String,
        /// The row, counted from 1 below the header.
        row: usize,
    },
}

errors!(CsvError; Write(::csv::Error));

impl Describe for CsvError {
    fn describe(&self) -> Text {
        match self {
            Self::Write(error) => text!("report-no-csv", problem = name(error.to_string())),
            Self::NotFinite { column, row } => {
                text!("report-cell-not-finite", column = name(column.clone()), row = assur_words::number(row))
            }
        }
    }
}

/// The records of a table, the header among them, each with its line; they may have different numbers of cells.
pub fn records(input: impl Read) -> impl Iterator<Item = Result<(usize, StringRecord), ::csv::Error>> {
    let reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(input);
    reader.into_records().map(|record| {
        let record = record?;
        let line = record.position().map_or(0, ::csv::Position::line);
        Ok((usize::try_from(line).unwrap_or(usize::MAX), record))
    })
}

/// One cell of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CsvCell<'a> {
    /// Does not apply.
    Empty,
    /// A number, SI.
    Number(f64),
    /// A text.
    Text(&'a str),
}

/// Writes a table; `ascii`: no character beyond ASCII. Columns of one name are distinguished by numbers, and a text
/// that a spreadsheet would take for a formula (`=`, `+`, `-` or `@` in front) gets an underscore in front.
pub fn write<'a>(
    header: &[impl AsRef<str>],
    rows: impl IntoIterator<Item = impl IntoIterator<Item = CsvCell<'a>>>,
    ascii: bool,
) -> Result<String, CsvError> {
    Ok(self::header(header, ascii)? + &self::rows(header, rows, ascii)?)
}

/// Writes the rows of a table without its header, as [`write`](fn@write) does.
pub fn rows<'a>(
    header: &[impl AsRef<str>],
    rows: impl IntoIterator<Item = impl IntoIterator<Item = CsvCell<'a>>>,
    ascii: bool,
) -> Result<String, CsvError> {
    let mut text = Vec::new();
    let mut writer = Writer::from_writer(Vec::new());
    for (index, row) in rows.into_iter().enumerate() {
        for (cell, name) in row.into_iter().zip(header) {
            match cell {
                CsvCell::Empty => writer.write_field("")?,
                CsvCell::Number(value) if value.is_finite() => {
                    text.clear();
                    number(value, &mut text);
                    writer.write_field(&text)?;
                }
                CsvCell::Number(_) => {
                    return Err(CsvError::NotFinite { column: name.as_ref().to_owned(), row: index + 1 });
                }
                CsvCell::Text(text) => writer.write_field(&*harmless(text, ascii))?,
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    finished(writer)
}

/// What a writer has written.
pub fn finished(writer: Writer<Vec<u8>>) -> Result<String, CsvError> {
    let bytes = writer.into_inner().map_err(|error| ::csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The names, each only once: repeated names get a number.
pub fn unique(names: impl IntoIterator<Item = String>) -> Vec<String> {
    let mut used = BTreeSet::new();
    let unique = |name: String| {
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        let mut names = std::iter::once(name.clone()).chain(numbered);
        names.find(|name| used.insert(name.clone())).unwrap_or_default()
    };
    names.into_iter().map(unique).collect()
}

/// What begins a formula in a spreadsheet: some take the signs of full and small width for the common ones.
const FORMULA: [char; 16] = [
    '=', '+', '-', '@', '\t', '\r', '\n', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}', '\u{fe66}',
    '\u{fe62}', '\u{fe63}', '\u{fe6b}', '\u{2212}',
];

/// A text that no spreadsheet takes for a formula.
fn harmless(text: &str, ascii: bool) -> Cow<'_, str> {
    let text = if ascii { to_ascii(text) } else { Cow::Borrowed(text) };
    if text.starts_with(FORMULA) { format!("_{text}").into() } else { text }
}

/// The header row; columns of one name are distinguished by numbers.
pub fn header(names: &[impl AsRef<str>], ascii: bool) -> Result<String, CsvError> {
    let mut writer = Writer::from_writer(Vec::new());
    if !names.is_empty() {
        writer.write_record(unique(names.iter().map(|name| harmless(name.as_ref(), ascii).into_owned())))?;
    }
    finished(writer)
}

/// The shortest text that reads back as the same number; whole numbers without a point.
pub(crate) fn number(value: f64, out: &mut Vec<u8>) {
    // There is no sign before the exponent, and large whole numbers have one.
    if value.abs() >= 1e15 {
        out.extend_from_slice(format!("{value:e}").as_bytes());
        return;
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(value);
    out.extend_from_slice(text.strip_suffix(".0").unwrap_or(text).as_bytes());
}
