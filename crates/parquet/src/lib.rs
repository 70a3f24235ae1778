//! Tables as Parquet: numbers as DOUBLE, whole numbers as INT64, texts as UTF-8 strings.
//!
//! Numbers are split into streams of bytes and compressed by zstd, which suits numbers that change smoothly; the columns of
//! a group of rows are compressed by all threads. What the metadata says of each column of each group is kept in memory
//! until the file ends, and is as little as readers need: no index of pages, and statistics of sweeps alone, whose rows are searched. A crate of its own, for which
//! nothing but the program has to wait in a build.

mod positions;
mod read;
pub mod sweep;

use std::fs;
use std::io::Write;
use std::sync::Arc;

use ::parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical, ZstdLevel};
use ::parquet::column::page::PageWriter;
use ::parquet::column::writer::{ColumnCloseResult, ColumnWriterImpl};
use ::parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use ::parquet::errors::ParquetError as Inner;
use ::parquet::file::metadata::{KeyValue, ParquetMetaDataReader};
use ::parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use ::parquet::file::writer::{SerializedFileWriter, SerializedPageWriter, TrackedWrite};
use ::parquet::schema::types::{ColumnDescPtr, ColumnPath, Type, TypePtr};
use bytes::Bytes;
use rayon::prelude::*;

use assur_report::csv::CsvCell;
use assur_words::{Describe, Text, errors, name, text};

pub use positions::Writer;
pub use read::Rows;

/// A table can't be written as Parquet.
pub struct ParquetError(Inner);

impl Describe for ParquetError {
    fn describe(&self) -> Text {
        text!("parquet-failed", problem = name(self.0.to_string()))
    }
}

errors!(ParquetError);

impl From<Inner> for ParquetError {
    fn from(error: Inner) -> Self {
        Self(error)
    }
}

impl From<std::io::Error> for ParquetError {
    fn from(error: std::io::Error) -> Self {
        Self(error.into())
    }
}

/// A column, and what of it is not written yet.
#[derive(Debug)]
pub struct Column {
    name: String,
    values: Values,
    /// Of a column that some rows lack: 1 where a row has a value, else 0.
    levels: Option<Vec<i16>>,
}

#[derive(Debug)]
enum Values {
    Whole(Vec<i64>),
    Numbers(Vec<f64>),
    Texts(Vec<ByteArray>),
}

impl Column {
    /// A column of whole numbers, which every row has.
    pub fn of_whole(name: String) -> Self {
        Self { name, values: Values::Whole(Vec::new()), levels: None }
    }

    /// A column of numbers; `optional`: some rows may have none.
    pub fn of_numbers(name: String, optional: bool) -> Self {
        Self { name, values: Values::Numbers(Vec::new()), levels: optional.then(Vec::new) }
    }

    /// A column of texts, of which some rows may have none.
    pub fn of_texts(name: String) -> Self {
        Self { name, values: Values::Texts(Vec::new()), levels: Some(Vec::new()) }
    }

    /// Adds the cell of a row; one that does not suit the column is empty.
    pub fn push(&mut self, cell: CsvCell<'_>) {
        let has = match (&mut self.values, cell) {
            (Values::Numbers(numbers), CsvCell::Number(number)) => {
                numbers.push(number);
                true
            }
            (Values::Whole(numbers), cell) => {
                #[expect(clippy::cast_possible_truncation, reason = "a whole number below 2^53")]
                numbers.push(if let CsvCell::Number(number) = cell { number as i64 } else { 0 });
                true
            }
            (Values::Texts(texts), CsvCell::Text(text)) => {
                texts.push(text.into());
                true
            }
            _ => false,
        };
        self.levels.iter_mut().for_each(|levels| levels.push(i16::from(has)));
    }

    fn field(&self) -> Result<TypePtr, Inner> {
        let (physical, logical) = match self.values {
            Values::Whole(_) => (Physical::INT64, None),
            Values::Numbers(_) => (Physical::DOUBLE, None),
            Values::Texts(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let repetition = if self.levels.is_some() { Repetition::OPTIONAL } else { Repetition::REQUIRED };
        let field = Type::primitive_type_builder(&self.name, physical).with_logical_type(logical);
        field.with_repetition(repetition).build().map(Arc::new)
    }

    /// The values, compressed; the column is empty then.
    fn compressed(
        &mut self,
        of: (ColumnDescPtr, WriterPropertiesPtr),
    ) -> Result<(Bytes, ColumnCloseResult), Inner> {
        let mut bytes = TrackedWrite::new(Vec::new());
        let pages = Box::new(SerializedPageWriter::new(&mut bytes));
        let levels = self.levels.as_deref();
        let close = match &mut self.values {
            Values::Whole(values) => chunk::<Int64Type>(of, pages, values, levels),
            Values::Numbers(values) => chunk::<DoubleType>(of, pages, values, levels),
            Values::Texts(values) => chunk::<ByteArrayType>(of, pages, values, levels),
        }?;
        self.levels.iter_mut().for_each(Vec::clear);
        Ok((bytes.into_inner()?.into(), close))
    }
}

/// Writes values as one chunk and takes them away. The writer is of their type alone: `get_column_writer` would link those
/// of all types.
fn chunk<T: DataType>(
    (description, properties): (ColumnDescPtr, WriterPropertiesPtr),
    pages: Box<dyn PageWriter + '_>,
    values: &mut Vec<T::T>,
    levels: Option<&[i16]>,
) -> Result<ColumnCloseResult, Inner> {
    let mut writer = ColumnWriterImpl::<T>::new(description, properties, pages);
    writer.write_batch(values, levels, None)?;
    values.clear();
    writer.close()
}

/// The schema of a file with these columns.
pub fn schema(columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let fields = columns.iter().map(Column::field).collect::<Result<_, _>>()?;
    Ok(Arc::new(Type::group_type_builder("assur").with_fields(fields).build()?))
}

/// A file that is written, group of rows by group of rows.
pub struct File<W: Write + Send> {
    file: SerializedFileWriter<W>,
    properties: WriterPropertiesPtr,
}

impl<W: Write + Send> File<W> {
    /// Begins a file with these columns; `data`: keys and values of its own; `searchable`: its groups tell the extremes of their
    /// columns, so that readers leave groups out.
    pub fn new(
        columns: &[Column],
        data: Vec<(String, String)>,
        searchable: bool,
        out: W,
    ) -> Result<Self, ParquetError> {
        let statistics = if searchable { EnabledStatistics::Chunk } else { EnabledStatistics::None };
        let data: Vec<_> = data.into_iter().map(|(key, value)| KeyValue::new(key, value)).collect();
        let mut properties = WriterProperties::builder()
            .set_created_by(concat!("assur ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(data).filter(|data| !data.is_empty()))
            .set_compression(Compression::ZSTD(ZstdLevel::try_new(1)?))
            .set_dictionary_enabled(false)
            .set_encoding(Encoding::BYTE_STREAM_SPLIT)
            .set_offset_index_disabled(true)
            .set_statistics_enabled(statistics);
        // The same texts occur in many rows, so they are stored once, in a dictionary.
        for column in columns.iter().filter(|column| matches!(column.values, Values::Texts(_))) {
            let path = ColumnPath::new(vec![column.name.clone()]);
            properties = properties.set_column_encoding(path.clone(), Encoding::PLAIN);
            properties = properties.set_column_dictionary_enabled(path, true);
        }
        let properties = Arc::new(properties.build());
        let file = SerializedFileWriter::new(out, schema(columns)?, Arc::clone(&properties))?;
        Ok(Self { file, properties })
    }

    /// Writes the rows of all columns as a group; the columns are empty then.
    pub fn write_group(&mut self, columns: &mut [Column]) -> Result<(), ParquetError> {
        let descriptions = self.file.schema_descr().columns().to_vec();
        let mut group = self.file.next_row_group()?;
        // Only some columns are kept compressed at a time.
        let together = 2 * rayon::current_num_threads();
        for (columns, descriptions) in columns.chunks_mut(together).zip(descriptions.chunks(together)) {
            let each = columns.par_iter_mut().zip(descriptions);
            let compressed = each.map(|(column, description)| {
                column.compressed((Arc::clone(description), Arc::clone(&self.properties)))
            });
            for column in compressed.collect::<Vec<_>>() {
                let (bytes, close) = column?;
                group.append_column(&bytes, close)?;
            }
        }
        group.close()?;
        Ok(())
    }

    /// Appends the groups of a complete file with the same columns.
    pub fn append(&mut self, part: &fs::File) -> Result<(), ParquetError> {
        for old in ParquetMetaDataReader::new().parse_and_finish(part)?.row_groups() {
            let mut group = self.file.next_row_group()?;
            for column in old.columns() {
                let close = ColumnCloseResult {
                    bytes_written: column.compressed_size().unsigned_abs(),
                    rows_written: old.num_rows().unsigned_abs(),
                    metadata: column.clone(),
                    bloom_filter: None,
                    column_index: None,
                    offset_index: None,
                };
                group.append_column(part, close)?;
            }
            group.close()?;
        }
        Ok(())
    }

    /// Ends the file, and returns what it was written to.
    pub fn finish(self) -> Result<W, ParquetError> {
        Ok(self.file.into_inner()?)
    }
}

assur_words::resources!();

#[cfg(test)]
mod tests;
