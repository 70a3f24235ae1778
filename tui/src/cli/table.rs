//! Tables that are read: points of a sweep, and the parameters in its rows.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

use assur_report::csv;
use assur_sweep::Numbering;
use assur_words::{name, text, text_of};

use super::fault::Fault;
use crate::files::{self, FileError};

/// The column behind the parameters in rows of a sweep.
const STATUS: &str = "status";

/// The line of CSV or the row of Parquet, from 0, and its cells.
type Row = (usize, Vec<String>);

/// A table; of rows of a sweep no column behind `status`.
pub(super) struct Table {
    pub(super) header: Vec<String>,
    pub(super) numbering: Numbering,
    pub(super) rows: Box<dyn Iterator<Item = Result<Row, Fault>>>,
}

impl Table {
    /// Begins to read a file, as Parquet where its name says so, else as CSV.
    pub(super) fn open(path: &Path) -> Result<Self, Fault> {
        if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("parquet")) {
            return Self::of_parquet(opened(path)?);
        }
        if files::is_standard_input(path) {
            return Self::of_csv(path, Cursor::new(files::read_bytes(path)?));
        }
        Self::of_csv(path, opened(path)?)
    }

    /// Whether it has rows of a sweep.
    pub(super) fn is_result(&self) -> bool {
        self.header.last().is_some_and(|last| last == STATUS)
    }

    fn of_parquet(file: File) -> Result<Self, Fault> {
        let mut is_before = true;
        let wanted = |name: &str| {
            let is_wanted = is_before;
            is_before &= name != STATUS;
            is_wanted
        };
        let table = assur_parquet::Rows::of(file, wanted).map_err(Fault::told)?;
        let header = table.header.clone();
        let row = |(number, row): (usize, Result<_, _>)| Ok((number, row.map_err(Fault::told)?));
        Ok(Self { header, numbering: Numbering::Rows, rows: Box::new(table.enumerate().map(row)) })
    }

    fn of_csv(path: &Path, input: impl Read + 'static) -> Result<Self, Fault> {
        let file = path.to_owned();
        let unread = move |problem: String| Fault::from(FileError::read(&file, name(problem)));
        let mut records =
            csv::records(input).map(move |record| record.map_err(|error| unread(error.to_string())));
        let (_, header) = records.next().transpose()?.unwrap_or_default();
        if header.len() == 1 && header.iter().any(|cell| cell.contains(';')) {
            return Err(FileError::read(path, text!("cli-semicolons")).into());
        }
        let status = header.iter().position(|column| column == STATUS);
        let most = status.map_or(usize::MAX, |status| status + 1);
        let row = move |record: Result<(usize, csv::StringRecord), Fault>| {
            let (line, record) = record?;
            Ok((line, record.iter().take(most).map(str::to_owned).collect()))
        };
        let header = header.iter().take(most).map(str::to_owned).collect();
        Ok(Self { header, numbering: Numbering::Lines, rows: Box::new(records.map(row)) })
    }
}

fn opened(path: &Path) -> Result<File, Fault> {
    File::open(path).map_err(|error| FileError::read(path, text_of(&error)).into())
}
