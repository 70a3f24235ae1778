//! Rows of a sweep as Parquet: numbers as optional DOUBLE, texts as optional UTF-8 strings.
//!
//! A sweep is written in parts, each a whole Parquet file with one group of rows, and joined at the end: what is
//! finished survives whatever ends the program.

use std::fs::File;
use std::io::Write;

use ::parquet::file::metadata::ParquetMetaDataReader;
use assur_sweep::{Best, Columns, Judged, Origin, ReadRow, Rows, Sweep, Tally};

use crate::{Column, File as Written, ParquetError, Rows as Table, schema};

/// Keys of a part's own data.
const TALLY: &str = "assur.tally";
const LAST: &str = "assur.last";

/// What the keys of the origin begin with.
const ORIGIN: &str = "assur.";

/// Rows as a whole file with one group, or none where no row is written. It keeps what [`FilePart`] reads back.
pub fn part(rows: &Rows, origin: &Origin) -> Result<Vec<u8>, ParquetError> {
    let mut data = told(origin);
    data.push((TALLY.to_owned(), Tally::of(rows).line()));
    data.push((LAST.to_owned(), last(rows)));
    let mut all = columns(&rows.columns);
    for (index, column) in all.iter_mut().enumerate() {
        rows.written().for_each(|row| column.push(rows.cell(row, index)));
    }
    let mut file = Written::new(&all, data, true, Vec::new())?;
    if rows.written().next().is_some() {
        file.write_group(&mut all)?;
    }
    file.finish()
}

/// The last row as CSV, written or not.
pub fn last(rows: &Rows) -> String {
    let text = rows.len().checked_sub(1).and_then(|last| rows.row_to_csv(last, false).ok());
    text.unwrap_or_default().trim_end().to_owned()
}

/// A part that was written earlier.
#[derive(Debug)]
pub struct FilePart {
    /// How its points ended.
    pub tally: Tally,
    /// Its last row as CSV, written or not.
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
        let (tally, last) = (Tally::parse(&own(TALLY)?)?, own(LAST)?);
        let rows = usize::try_from(metadata.num_rows()).ok()?;
        (tally.written == rows).then_some(Self { tally, last, origin })
    }
}

/// The best of the rows of a part, by the numbers of a column.
pub fn best(
    file: File,
    columns: &Columns,
    (best, column): (&Best, usize),
) -> Result<Option<Judged>, ParquetError> {
    let names = [0, columns.status(), column].map(|index| columns.names[index].as_str());
    let rows = Table::of(file, |name| names.contains(&name))?;
    let places = names.map(|name| rows.header.iter().position(|own| own == name));
    let mut found = None;
    for row in rows {
        let row = row?;
        let [point, status, value] = places.map(|place| place.map_or("", |place| row[place].as_str()));
        if let (Ok(point), Ok(status)) = (point.parse(), status.parse()) {
            let read = ReadRow { point, status, value: value.parse().ok() };
            found = best.better(found, Best::judged(&read));
        }
    }
    Ok(found)
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
        } else if columns.is_whole(index) {
            Column::of_whole(name.clone())
        } else {
            Column::of_numbers(name.clone(), true)
        }
    };
    columns.names.iter().enumerate().map(of).collect()
}
