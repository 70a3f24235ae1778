//! Rows of a sweep as Parquet: numbers as optional DOUBLE, texts as optional UTF-8 strings.
//!
//! A sweep is written in parts, each a whole Parquet file with one group of rows, and joined at the end: what is
//! finished survives whatever ends the program.

use std::fs::File;
use std::io::Write;

use ::parquet::file::reader::FileReader;
use ::parquet::file::serialized_reader::SerializedFileReader;
use ::parquet::record::Field;
use assur_sweep::{Columns, Rows, Sweep, Tally};

use crate::{Column, File as Written, ParquetError, schema};

/// Keys of a part's own data.
const TALLY: &str = "assur.tally";
const LAST: &str = "assur.last";

/// Key of the text of the scene.
const SCENE: &str = "assur.scene";

/// Rows as a whole file with one group. It keeps what [`FilePart`] reads back.
pub fn part(rows: &Rows) -> Result<Vec<u8>, ParquetError> {
    let tally = Tally::of(rows);
    let first = tally.first.map_or_else(String::new, |first| first.to_string());
    let data = vec![(TALLY, format!("{} {} {first}", tally.failures, tally.hopeless)), (LAST, last(rows))];
    let mut all = columns(rows.columns());
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
}

impl FilePart {
    /// Reads a part; `None` if the file is none of this sweep.
    pub fn read(file: File, sweep: &Sweep) -> Option<Self> {
        let reader = SerializedFileReader::new(file).ok()?;
        let metadata = reader.metadata().file_metadata();
        if *metadata.schema() != *schema(&columns(sweep.columns())).ok()? {
            return None;
        }
        let value = |key: &str| {
            let found = metadata.key_value_metadata()?.iter().find(|data| data.key == key);
            found?.value.as_deref()
        };
        let mut numbers = value(TALLY)?.split(' ').map(|number| number.parse::<usize>().ok());
        let tally = Tally {
            points: usize::try_from(metadata.num_rows()).ok()?,
            failures: numbers.next()??,
            hopeless: numbers.next()??,
            first: numbers.next()?,
        };
        Some(Self { tally, last: value(LAST)?.to_owned() })
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
    parts: impl IntoIterator<Item = std::io::Result<File>>,
    out: impl Write + Send,
) -> Result<(), ParquetError> {
    let mut file = Written::new(&columns(sweep.columns()), origin(sweep), true, out)?;
    for part in parts {
        file.append(&part?)?;
    }
    file.finish().map(drop)
}

/// What the rows were made of: the scene, the ranges, the seed of a sample.
fn origin(sweep: &Sweep) -> Vec<(&'static str, String)> {
    let ranges = sweep.ranges().collect::<Vec<_>>().join("\n");
    let seed = sweep.seed().map(|seed| ("assur.seed", seed.to_string()));
    let all = [("assur.version", env!("CARGO_PKG_VERSION").to_owned()), ("assur.vary", ranges)];
    all.into_iter().chain(seed).chain([(SCENE, sweep.scene().to_owned())]).collect()
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
    columns.names().iter().enumerate().map(of).collect()
}

/// The parameters of a row of a file with rows of a sweep: the columns before `status`. `None` without such a row or column.
///
/// # Errors
///
/// [`ParquetError`] if the file can't be read.
pub fn parameters(file: File, row: usize) -> Result<Option<Vec<(String, f64)>>, ParquetError> {
    let reader = SerializedFileReader::new(file)?;
    let Some(row) = reader.get_row_iter(None)?.nth(row).transpose()? else { return Ok(None) };
    let columns = row.get_column_iter().map(|(name, field)| (name.clone(), field));
    let before = columns.take_while(|(name, _)| name != "status");
    let number = |(name, field): (String, &Field)| {
        if let Field::Double(number) = field { Some((name, *number)) } else { None }
    };
    Ok(before.map(number).collect())
}
