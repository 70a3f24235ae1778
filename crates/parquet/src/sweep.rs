//! Rows of a sweep as Parquet: numbers as optional DOUBLE, texts as optional UTF-8 strings.
//!
//! A sweep is written in parts, each a whole Parquet file with one group of rows, and joined at the end: what is
//! finished survives whatever ends the program.

use std::fs::File;
use std::io::Write;
use std::sync::Arc;

use ::parquet::basic::Type;
use ::parquet::column::reader::ColumnReaderImpl;
use ::parquet::data_type::DoubleType;
use ::parquet::file::metadata::{ColumnChunkMetaData, ParquetMetaDataReader};
use ::parquet::file::serialized_reader::SerializedPageReader;
use assur_sweep::{Columns, Origin, Rows, Sweep, Tally};

use crate::{Column, File as Written, ParquetError, schema};

/// Keys of a part's own data.
const TALLY: &str = "assur.tally";
const LAST: &str = "assur.last";

/// What the keys of the origin begin with.
const ORIGIN: &str = "assur.";

/// Rows as a whole file with one group. It keeps what [`FilePart`] reads back.
pub fn part(rows: &Rows, origin: &Origin) -> Result<Vec<u8>, ParquetError> {
    let tally = Tally::of(rows);
    let first = tally.first.map_or_else(String::new, |first| first.to_string());
    let mut data = told(origin);
    data.push((TALLY.to_owned(), format!("{} {} {first}", tally.failures, tally.hopeless)));
    data.push((LAST.to_owned(), last(rows)));
    let mut all = columns(&rows.columns);
    for (index, column) in all.iter_mut().enumerate() {
        (0..rows.len()).for_each(|row| column.push(rows.cell(row, index)));
    }
    let mut file = Written::new(&all, data, true, Vec::new())?;
    file.write_group(&mut all)?;
    file.finish()
}

/// A part that was written earlier.
#[derive(Debug)]
pub struct FilePart {
    /// How its points ended.
    pub tally: Tally,
    /// Its last row as CSV.
    pub last: String,
    /// What its rows are made of.
    pub origin: Origin,
}

impl FilePart {
    /// Reads a part; `None` if the file is none of this sweep.
    pub fn read(file: &File, sweep: &Sweep) -> Option<Self> {
        let metadata = ParquetMetaDataReader::new().parse_and_finish(file).ok()?;
        let metadata = metadata.file_metadata();
        if *metadata.schema() != *schema(&columns(&sweep.columns)).ok()? {
            return None;
        }
        let data = metadata.key_value_metadata()?.iter();
        let mut origin: Origin = data
            .filter_map(|data| Some((data.key.strip_prefix(ORIGIN)?.to_owned(), data.value.clone()?)))
            .collect();
        let mut own = |key: &str| origin.remove(key.strip_prefix(ORIGIN)?);
        let (counts, last) = (own(TALLY)?, own(LAST)?);
        let mut numbers = counts.split(' ').map(|number| number.parse::<usize>().ok());
        let tally = Tally {
            points: usize::try_from(metadata.num_rows()).ok()?,
            failures: numbers.next()??,
            hopeless: numbers.next()??,
            first: numbers.next()?,
        };
        Some(Self { tally, last, origin })
    }
}

/// The last row as CSV.
fn last(rows: &Rows) -> String {
    let text = rows.to_csv(false).unwrap_or_default();
    text.lines().next_back().unwrap_or_default().to_owned()
}

/// Writes the groups of all parts, in their order, as one file.
pub fn join(
    sweep: &Sweep,
    origin: &Origin,
    parts: impl IntoIterator<Item = std::io::Result<File>>,
    out: impl Write + Send,
) -> Result<(), ParquetError> {
    let mut file = Written::new(&columns(&sweep.columns), told(origin), true, out)?;
    for part in parts {
        file.append(&part?)?;
    }
    file.finish().map(drop)
}

/// What rows are made of, as the file's own data.
fn told(origin: &Origin) -> Vec<(String, String)> {
    origin.iter().map(|(key, value)| (format!("{ORIGIN}{key}"), value.clone())).collect()
}

/// The columns of the file, without rows.
fn columns(columns: &Columns) -> Vec<Column> {
    let of = |(index, name): (usize, &String)| {
        if columns.is_text(index) {
            Column::of_texts(name.clone())
        } else {
            Column::of_numbers(name.clone(), true)
        }
    };
    columns.names.iter().enumerate().map(of).collect()
}

/// The parameters of a row of a file with rows of a sweep: the columns before `status`. `None` without such a row or column.
pub fn parameters(file: File, row: usize) -> Result<Option<Vec<(String, f64)>>, ParquetError> {
    let metadata = ParquetMetaDataReader::new().parse_and_finish(&file)?;
    let (file, mut row) = (Arc::new(file), row);
    for group in metadata.row_groups() {
        let rows = usize::try_from(group.num_rows()).unwrap_or(0);
        if row < rows {
            let before = group.columns().iter().take_while(|column| column.column_descr().name() != "status");
            return before.map(|column| parameter(&file, column, rows, row)).collect();
        }
        row -= rows;
    }
    Ok(None)
}

/// The name of a column and its number in a row of a group of so many rows; `None` where there is no number.
fn parameter(
    file: &Arc<File>,
    column: &ColumnChunkMetaData,
    rows: usize,
    row: usize,
) -> Result<Option<(String, f64)>, ParquetError> {
    if column.column_type() != Type::DOUBLE {
        return Ok(None);
    }
    let pages = SerializedPageReader::new(Arc::clone(file), column, rows, None)?;
    let mut reader = ColumnReaderImpl::<DoubleType>::new(column.column_descr_ptr(), Box::new(pages));
    let (mut levels, mut numbers) = (Vec::new(), Vec::new());
    reader.skip_records(row)?;
    reader.read_records(1, Some(&mut levels), None, &mut numbers)?;
    Ok(numbers.first().map(|number| (column.column_descr().name().to_owned(), *number)))
}
