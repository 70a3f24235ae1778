//! The table as CSV: one header row, comma separated, numbers with all their digits.

use ::csv::Writer;

use crate::{Cell, Table};

/// The table can't be written as CSV.
#[derive(Debug, thiserror::Error)]
#[error("the table can't be written as CSV: {0}")]
pub struct CsvError(#[from] ::csv::Error);

/// The table as CSV.
///
/// # Errors
///
/// [`CsvError`] where the writer refuses.
pub fn to_csv(table: &Table) -> Result<String, CsvError> {
    let mut writer = Writer::from_writer(Vec::new());
    writer.write_record(table.header())?;
    for row in 0..table.len() {
        for column in 0..table.header().len() {
            match table.cell(row, column) {
                Cell::Empty => writer.write_field("")?,
                Cell::Number(value) => writer.write_field(number(value))?,
                Cell::Text(text) => writer.write_field(text)?,
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    let bytes = writer.into_inner().map_err(|error| ::csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The shortest text that reads back as the same number; whole numbers without a point.
fn number(value: f64) -> String {
    if value != 0.0 && !(1e-5..1e15).contains(&value.abs()) {
        format!("{value:e}")
    } else {
        format!("{value}")
    }
}
