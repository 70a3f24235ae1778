//! Errors of the library as exceptions.

use pyo3::exceptions::{PyException, PyKeyError};
use pyo3::prelude::*;

pyo3::create_exception!(
    assur,
    Error,
    PyException,
    "What is wrong, with its place in the scene where it has one: file, line, column and key; each may be None."
);

/// An error as an exception that has its place.
pub(crate) fn raised(py: Python<'_>, error: library::Error) -> PyErr {
    let library::Error { message, file, line, column, key } = error;
    let raised = Error::new_err(message);
    let value = raised.value(py);
    let placed = value
        .setattr("file", file)
        .and_then(|()| value.setattr("line", line))
        .and_then(|()| value.setattr("column", column))
        .and_then(|()| value.setattr("key", key));
    placed.err().unwrap_or(raised)
}

/// Nothing has the name that was asked for.
pub(crate) fn unknown(error: library::Error) -> PyErr {
    PyKeyError::new_err(error.message)
}
