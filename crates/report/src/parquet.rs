//! Positions as Parquet: one column each, DOUBLE, optional where some positions have no number, in groups of rows.
//!
//! Numbers are split into streams of bytes and compressed by zstd, which suits smooth numbers; the columns of a group are
//! compressed by all threads.

use std::io::Write;
use std::sync::Arc;

use ::parquet::basic::{Compression, Encoding, Repetition, Type as Physical, ZstdLevel};
use ::parquet::column::writer::ColumnCloseResult;
use ::parquet::data_type::{DoubleType, Int64Type};
use ::parquet::errors::ParquetError as Inner;
use ::parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{Type, TypePtr};
use assur_analysis::results::{Analysis, Section, Table};
use bytes::Bytes;
use rayon::prelude::*;

use crate::csv::unique;

/// Numbers of one group of rows: 32 MB, kept until they are compressed.
const NUMBERS: usize = 1 << 22;

/// Positions can't be written as Parquet.
#[derive(Debug, thiserror::Error)]
#[error("Parquet: {0}")]
pub struct ParquetError(#[from] Inner);

impl From<std::io::Error> for ParquetError {
    fn from(error: std::io::Error) -> Self {
        Self(error.into())
    }
}

/// A column of the file, and its numbers that are not written yet.
struct Column {
    /// Schema of a file with this column alone.
    schema: TypePtr,
    /// Its column in the table; `None`: the number of the position.
    source: Option<usize>,
    numbers: Vec<i64>,
    values: Vec<f64>,
    /// Of a column that some rows lack: 1 where a row has a number.
    levels: Option<Vec<i16>>,
}

/// Writes the positions of an analysis, block by block.
pub struct Writer<W: Write + Send> {
    file: SerializedFileWriter<W>,
    properties: WriterPropertiesPtr,
    columns: Vec<Column>,
    rows: usize,
}

impl<W: Write + Send> Writer<W> {
    /// Begins a file with the columns that CSV has, under the same names.
    ///
    /// # Errors
    ///
    /// [`ParquetError`] if the writer fails.
    pub fn new(analysis: &Analysis, out: W) -> Result<Self, ParquetError> {
        let schema = analysis.positions.schema();
        let all =
            (0..schema.columns().len()).filter(|column| analysis.survey.has(schema.section_of(*column)));
        let named =
            all.filter_map(|column| Some((column, crate::csv::name(schema, schema.columns()[column])?)));
        let (sources, names): (Vec<usize>, Vec<String>) = named.unzip();
        let names = unique(std::iter::once("index".to_owned()).chain(names));
        let sources = std::iter::once(None).chain(sources.into_iter().map(Some));
        let column = |(name, source): (&String, Option<usize>)| {
            let optional = source.is_some_and(|source| schema.section_of(source) != Section::ALWAYS);
            let physical = if source.is_some() { Physical::DOUBLE } else { Physical::INT64 };
            let repetition = if optional { Repetition::OPTIONAL } else { Repetition::REQUIRED };
            let field = Type::primitive_type_builder(name, physical).with_repetition(repetition).build()?;
            let schema = group(vec![Arc::new(field)])?;
            let levels = optional.then(Vec::new);
            Ok(Column { schema, source, numbers: Vec::new(), values: Vec::new(), levels })
        };
        let columns = names.iter().zip(sources).map(column).collect::<Result<Vec<_>, Inner>>()?;
        let properties = WriterProperties::builder()
            .set_created_by(concat!("assur ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_compression(Compression::ZSTD(ZstdLevel::try_new(1)?))
            .set_dictionary_enabled(false)
            .set_encoding(Encoding::BYTE_STREAM_SPLIT)
            .set_statistics_enabled(EnabledStatistics::None);
        let properties = Arc::new(properties.build());
        let fields = columns.iter().flat_map(|column| column.schema.get_fields().to_vec());
        let file = SerializedFileWriter::new(out, group(fields.collect())?, Arc::clone(&properties))?;
        Ok(Self { file, properties, columns, rows: 0 })
    }

    /// Adds the rows of a table.
    ///
    /// # Errors
    ///
    /// [`ParquetError`] if the writer fails.
    pub fn add(&mut self, table: &Table) -> Result<(), ParquetError> {
        self.columns.iter_mut().for_each(|column| column.add(table));
        self.rows += table.len();
        if self.rows * self.columns.len() >= NUMBERS { self.write_group() } else { Ok(()) }
    }

    /// Ends the file.
    ///
    /// # Errors
    ///
    /// [`ParquetError`] if the writer fails.
    pub fn finish(mut self) -> Result<(), ParquetError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.file.close()?;
        Ok(())
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        let properties = &self.properties;
        let encoded: Vec<_> = self.columns.par_iter_mut().map(|column| column.encoded(properties)).collect();
        let mut group = self.file.next_row_group()?;
        for column in encoded {
            let (bytes, close) = column?;
            group.append_column(&bytes, close)?;
        }
        group.close()?;
        self.rows = 0;
        Ok(())
    }
}

fn group(fields: Vec<TypePtr>) -> Result<TypePtr, Inner> {
    Type::group_type_builder("positions").with_fields(fields).build().map(Arc::new)
}

impl Column {
    fn add(&mut self, table: &Table) {
        let Some(source) = self.source else {
            self.numbers
                .extend(table.numbers().iter().map(|number| i64::try_from(*number).unwrap_or(i64::MAX)));
            return;
        };
        let (values, schema) = (table.values(source), table.schema());
        match &mut self.levels {
            None => self.values.extend_from_slice(values),
            Some(levels) => {
                let present = table.present(schema.section_of(source));
                levels.extend(present.iter().map(|present| i16::from(*present)));
                let known = values.iter().zip(present).filter(|(_, present)| **present);
                self.values.extend(known.map(|(value, _)| *value));
            }
        }
    }

    /// The numbers as a file with this column alone, and where they are in it; they are forgotten.
    fn encoded(&mut self, properties: &WriterPropertiesPtr) -> Result<(Bytes, ColumnCloseResult), Inner> {
        let mut bytes = Vec::new();
        let mut writer =
            SerializedFileWriter::new(&mut bytes, Arc::clone(&self.schema), Arc::clone(properties))?;
        let mut group = writer.next_row_group()?;
        if let Some(mut out) = group.next_column()? {
            let levels = self.levels.as_deref();
            if self.source.is_some() {
                out.typed::<DoubleType>().write_batch(&self.values, levels, None)?;
            } else {
                out.typed::<Int64Type>().write_batch(&self.numbers, levels, None)?;
            }
            out.close()?;
        }
        let metadata = group.close()?;
        let column = metadata.column(0).clone();
        let rows = metadata.num_rows().unsigned_abs();
        writer.close()?;
        self.numbers.clear();
        self.values.clear();
        if let Some(levels) = &mut self.levels {
            levels.clear();
        }
        let close = ColumnCloseResult {
            bytes_written: column.compressed_size().unsigned_abs(),
            rows_written: rows,
            metadata: column,
            bloom_filter: None,
            column_index: None,
            offset_index: None,
        };
        Ok((bytes.into(), close))
    }
}
