//! Rows of a file as texts.

use std::fs::File;
use std::sync::Arc;

use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::record::{Field, Row, reader::RowIter};
use ::parquet::schema::types::Type;

use crate::ParquetError;

/// The rows of some columns of a file, in its order: numbers with all their digits, an empty text where a row has no value.
pub struct Rows {
    /// The names of these columns.
    pub header: Vec<String>,
    rows: RowIter<'static>,
}

impl Rows {
    /// Begins to read the columns whose names are wanted; `wanted` is asked in their order.
    pub fn of(file: File, mut wanted: impl FnMut(&str) -> bool) -> Result<Self, ParquetError> {
        let reader = SerializedFileReader::new(file)?;
        let schema = reader.metadata().file_metadata().schema();
        let mut fields: Vec<Arc<Type>> = schema.get_fields().to_vec();
        fields.retain(|field| wanted(field.name()));
        let header = fields.iter().map(|field| field.name().to_owned()).collect();
        let projected = Type::group_type_builder(schema.name()).with_fields(fields).build()?;
        Ok(Self { header, rows: RowIter::from_file_into(Box::new(reader)).project(Some(projected))? })
    }
}

impl Iterator for Rows {
    type Item = Result<Vec<String>, ParquetError>;

    fn next(&mut self) -> Option<Self::Item> {
        let cells = |row: Row| row.get_column_iter().map(|(_, field)| cell(field)).collect();
        Some(self.rows.next()?.map(cells).map_err(ParquetError::from))
    }
}

fn cell(field: &Field) -> String {
    match field {
        Field::Null => String::new(),
        Field::Str(text) => text.clone(),
        Field::Double(number) => number.to_string(),
        Field::Float(number) => number.to_string(),
        other => other.to_string(),
    }
}
