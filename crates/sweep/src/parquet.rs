//! Rows as Parquet: numbers as optional DOUBLE, texts as optional UTF-8 strings.
//!
//! A sweep is written in parts, each a whole Parquet file with one group of rows, and joined at the end: what is
//! finished survives whatever ends the program.

use std::fs::File;
use std::io::Write;
use std::sync::Arc;

use ::parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical, ZstdLevel};
use ::parquet::column::writer::ColumnCloseResult;
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use ::parquet::errors::ParquetError as Inner;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use ::parquet::file::reader::FileReader;
use ::parquet::file::serialized_reader::SerializedFileReader;
use ::parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use ::parquet::schema::types::{ColumnPath, Type, TypePtr};

use assur_report::csv::Cell;

use crate::rows::Columns;
use crate::{Rows, Sweep, Tally};

/// Most rows of one group.
const MOST_ROWS: usize = 65_536;
/// A sweep has so many groups, so that little is lost if it is ended; but groups have at least so many rows.
const GROUPS: usize = 64;

/// Keys of a part's own data.
const TALLY: &str = "assur.tally";
const LAST: &str = "assur.last";

/// The table can't be written as Parquet.
#[derive(Debug, thiserror::Error)]
#[error("Parquet: {0}")]
pub struct ParquetError(#[from] Inner);

/// Rows of each part of a sweep of so many points, except the last one.
pub fn rows_of_part(points: usize) -> usize {
    points.div_ceil(GROUPS).clamp(GROUPS, MOST_ROWS)
}

/// Rows as a whole file with one group. It keeps what [`Part`] reads back.
///
/// # Errors
///
/// [`ParquetError`] if the writer fails.
pub fn part(rows: &Rows) -> Result<Vec<u8>, ParquetError> {
    let tally = Tally::of(rows);
    let first = tally.first.map_or_else(String::new, |first| first.to_string());
    let data = vec![
        KeyValue::new(TALLY.to_owned(), format!("{} {} {first}", tally.failures, tally.hopeless)),
        KeyValue::new(LAST.to_owned(), last(rows)),
    ];
    let mut writer = SerializedFileWriter::new(
        Vec::new(),
        schema(&rows.columns)?,
        properties(&rows.columns, Some(data))?,
    )?;
    let mut group = writer.next_row_group()?;
    let mut column = 0;
    while let Some(out) = group.next_column()? {
        write(rows, column, out)?;
        column += 1;
    }
    group.close()?;
    Ok(writer.into_inner()?)
}

/// A part that was written earlier.
#[derive(Debug)]
pub struct Part {
    /// How its points ended.
    pub tally: Tally,
    /// Its last row as CSV.
    pub last: String,
}

impl Part {
    /// Reads a part; `None` if the file is none of this sweep.
    pub fn read(file: File, sweep: &Sweep) -> Option<Self> {
        let reader = SerializedFileReader::new(file).ok()?;
        let metadata = reader.metadata().file_metadata();
        if *metadata.schema() != *schema(&sweep.columns).ok()? {
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
///
/// # Errors
///
/// [`ParquetError`] if a part can't be read, or the writer fails.
pub fn join(
    sweep: &Sweep,
    parts: impl IntoIterator<Item = std::io::Result<File>>,
    out: impl Write + Send,
) -> Result<(), ParquetError> {
    let mut writer =
        SerializedFileWriter::new(out, schema(&sweep.columns)?, properties(&sweep.columns, None)?)?;
    for part in parts {
        let part = part.map_err(Inner::from)?;
        let reader = SerializedFileReader::new(part.try_clone().map_err(Inner::from)?)?;
        for old in reader.metadata().row_groups() {
            let mut group = writer.next_row_group()?;
            for column in old.columns() {
                let close = ColumnCloseResult {
                    bytes_written: column.compressed_size().unsigned_abs(),
                    rows_written: old.num_rows().unsigned_abs(),
                    metadata: column.clone(),
                    bloom_filter: None,
                    column_index: None,
                    offset_index: None,
                };
                group.append_column(&part, close)?;
            }
            group.close()?;
        }
    }
    writer.close()?;
    Ok(())
}

/// Numbers are split into streams of bytes and compressed, which suits numbers that change smoothly; texts repeat.
fn properties(columns: &Columns, data: Option<Vec<KeyValue>>) -> Result<WriterPropertiesPtr, Inner> {
    let mut properties = WriterProperties::builder()
        .set_created_by(concat!("assur ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(data)
        .set_compression(Compression::ZSTD(ZstdLevel::try_new(1)?))
        .set_dictionary_enabled(false)
        .set_encoding(Encoding::BYTE_STREAM_SPLIT)
        .set_statistics_enabled(EnabledStatistics::None);
    let texts = columns.names().iter().enumerate().filter(|(column, _)| columns.is_text(*column));
    for (_, name) in texts {
        let path = ColumnPath::new(vec![name.clone()]);
        properties = properties.set_column_encoding(path.clone(), Encoding::PLAIN);
        properties = properties.set_column_dictionary_enabled(path, true);
    }
    Ok(Arc::new(properties.build()))
}

fn schema(columns: &Columns) -> Result<TypePtr, Inner> {
    let field = |(column, name): (usize, &String)| {
        let (physical, logical) = if columns.is_text(column) {
            (Physical::BYTE_ARRAY, Some(LogicalType::String))
        } else {
            (Physical::DOUBLE, None)
        };
        let field = Type::primitive_type_builder(name, physical).with_logical_type(logical);
        field.with_repetition(Repetition::OPTIONAL).build().map(Arc::new)
    };
    let fields = columns.names().iter().enumerate().map(field).collect::<Result<Vec<_>, _>>()?;
    Type::group_type_builder("sweep").with_fields(fields).build().map(Arc::new)
}

fn write(rows: &Rows, column: usize, mut out: SerializedColumnWriter<'_>) -> Result<(), Inner> {
    let cells = || (0..rows.len()).map(|row| rows.cell(row, column));
    // Level 1: there is a value; level 0: the cell is empty.
    let levels: Vec<i16> = cells().map(|cell| i16::from(cell != Cell::Empty)).collect();
    if rows.is_text(column) {
        let texts: Vec<ByteArray> = cells()
            .filter_map(|cell| if let Cell::Text(text) = cell { Some(ByteArray::from(text)) } else { None })
            .collect();
        out.typed::<ByteArrayType>().write_batch(&texts, Some(&levels), None)?;
    } else {
        let numbers: Vec<f64> = cells()
            .filter_map(|cell| if let Cell::Number(value) = cell { Some(value) } else { None })
            .collect();
        out.typed::<DoubleType>().write_batch(&numbers, Some(&levels), None)?;
    }
    out.close()
}
