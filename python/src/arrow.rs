//! Tables by the C interface of Arrow.

use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::Float64Type;
use arrow_array::{
    ArrayRef, Int64Array, LargeStringArray, PrimitiveArray, RecordBatch, RecordBatchIterator,
    RecordBatchOptions,
};
use arrow_buffer::{BooleanBuffer, Buffer, NullBuffer, ScalarBuffer};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use bytes::Bytes;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::error::unknown;
use crate::table::{Cells, Rows};

/// The name that the interface asks for.
const NAME: &std::ffi::CStr = c"arrow_array_stream";

/// A table as a stream of one batch.
pub(crate) fn stream<'py>(py: Python<'py>, rows: &Rows) -> PyResult<Bound<'py, PyCapsule>> {
    let (mut fields, mut columns) = (Vec::new(), Vec::new());
    for name in rows.names() {
        let column = column(rows, name).map_err(unknown)?;
        let has_all = matches!(column.data_type(), DataType::Int64);
        fields.push(Field::new(name, column.data_type().clone(), !has_all));
        columns.push(column);
    }
    let schema = Arc::new(Schema::new(fields));
    let count = RecordBatchOptions::new().with_row_count(Some(rows.len()));
    let batch = RecordBatch::try_new_with_options(Arc::clone(&schema), columns, &count);
    let batch = batch.map_err(|error| PyValueError::new_err(error.to_string()))?;
    let batches = RecordBatchIterator::new([Ok::<_, ArrowError>(batch)], schema);
    PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(batches)), NAME)
}

/// A column as an array; numbers in SI are not copied.
fn column(rows: &Rows, name: &str) -> Result<ArrayRef, library::Error> {
    Ok(match rows.cells(name)? {
        Cells::Whole(numbers) => {
            let whole = |number: &usize| i64::try_from(*number).unwrap_or(i64::MAX);
            Arc::new(Int64Array::new(numbers.iter().map(whole).collect(), None))
        }
        Cells::Numbers(numbers) => {
            let owner = Numbers { rows: rows.clone(), name: name.to_owned() };
            let buffer = ScalarBuffer::new(Buffer::from(Bytes::from_owner(owner)), 0, numbers.len());
            Arc::new(PrimitiveArray::<Float64Type>::new(buffer, nulls(numbers)))
        }
        Cells::Texts(texts) => {
            let each = texts.iter().map(|text| Some(text.as_str()).filter(|text| !text.is_empty()));
            Arc::new(each.collect::<LargeStringArray>())
        }
    })
}

/// Which rows have a number; `None`: all have.
fn nulls(numbers: &[f64]) -> Option<NullBuffer> {
    let has = |numbers: &[f64]| numbers.iter().map(|number| !number.is_nan()).collect::<BooleanBuffer>();
    numbers.iter().any(|number| number.is_nan()).then(|| NullBuffer::new(has(numbers)))
}

/// A column of numbers, with the rows to which it belongs.
struct Numbers {
    rows: Rows,
    name: String,
}

impl AsRef<[u8]> for Numbers {
    fn as_ref(&self) -> &[u8] {
        match self.rows.cells(&self.name) {
            Ok(Cells::Numbers(numbers)) => bytemuck::cast_slice(numbers),
            _ => &[],
        }
    }
}
