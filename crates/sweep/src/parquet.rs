//! The table as Parquet: numbers as optional DOUBLE, texts as optional UTF-8 strings, in groups of rows.

use std::sync::Arc;

use ::parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use ::parquet::errors::ParquetError as Inner;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use ::parquet::schema::types::{Type, TypePtr};

use assur_report::csv::Cell;

use crate::Table;

/// Rows of one group.
const GROUP: usize = 65_536;

/// The table can't be written as Parquet.
#[derive(Debug, thiserror::Error)]
#[error("the table can't be written as Parquet: {0}")]
pub struct ParquetError(#[from] Inner);

/// The table as Parquet, not compressed.
///
/// # Errors
///
/// [`ParquetError`] if the writer fails.
pub fn to_parquet(table: &Table) -> Result<Vec<u8>, ParquetError> {
    let properties = WriterProperties::builder().set_compression(Compression::UNCOMPRESSED);
    let created_by = concat!("assur ", env!("CARGO_PKG_VERSION")).to_owned();
    let properties = Arc::new(properties.set_created_by(created_by).build());
    let mut writer = SerializedFileWriter::new(Vec::new(), schema(table)?, properties)?;
    for start in (0..table.len()).step_by(GROUP) {
        let rows = start..table.len().min(start + GROUP);
        let mut group = writer.next_row_group()?;
        let mut column = 0;
        while let Some(out) = group.next_column()? {
            write(table, rows.clone(), column, out)?;
            column += 1;
        }
        group.close()?;
    }
    Ok(writer.into_inner()?)
}

fn schema(table: &Table) -> Result<TypePtr, Inner> {
    let field = |(column, name): (usize, &String)| {
        let (physical, logical) = if table.is_text(column) {
            (Physical::BYTE_ARRAY, Some(LogicalType::String))
        } else {
            (Physical::DOUBLE, None)
        };
        let field = Type::primitive_type_builder(name, physical).with_logical_type(logical);
        field.with_repetition(Repetition::OPTIONAL).build().map(Arc::new)
    };
    let fields = table.header().iter().enumerate().map(field).collect::<Result<Vec<_>, _>>()?;
    Type::group_type_builder("sweep").with_fields(fields).build().map(Arc::new)
}

fn write(
    table: &Table,
    rows: std::ops::Range<usize>,
    column: usize,
    mut out: SerializedColumnWriter<'_>,
) -> Result<(), Inner> {
    let cells = || rows.clone().map(|row| table.cell(row, column));
    // Level 1: there is a value; level 0: the cell is empty.
    let levels: Vec<i16> = cells().map(|cell| i16::from(cell != Cell::Empty)).collect();
    if table.is_text(column) {
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
