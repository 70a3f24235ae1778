//! Tables, and their columns as arrays of numpy.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyIterator, PyList};

use crate::arrow;
use crate::error::unknown;

/// The column with the numbers of the positions.
const INDEX: &str = "index";

/// The rows of a table, which stay where they are while anybody has a column of them.
#[derive(Clone)]
pub(crate) enum Rows {
    Positions(Arc<library::Results>),
    Motion(Arc<library::Results>),
    Sweep(Arc<library::SweepRows>),
}

/// The cells of a column.
pub(crate) enum Cells<'a> {
    /// Numbers of positions.
    Whole(&'a [usize]),
    /// Numbers in SI; NaN is an empty cell.
    Numbers(&'a [f64]),
    /// Texts; an empty one is an empty cell.
    Texts(&'a [String]),
}

impl Rows {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Positions(results) => results.positions.len(),
            Self::Motion(results) => results.motion.len(),
            Self::Sweep(rows) => rows.len(),
        }
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        let (first, names) = match self {
            Self::Positions(results) => (Some(INDEX), results.positions.names()),
            Self::Motion(results) => (None, results.motion.names()),
            Self::Sweep(rows) => (None, rows.names()),
        };
        first.into_iter().chain(names.iter().map(String::as_str))
    }

    pub(crate) fn cells(&self, name: &str) -> Result<Cells<'_>, library::Error> {
        match self {
            Self::Positions(results) if name == INDEX => Ok(Cells::Whole(results.positions.numbers())),
            Self::Positions(results) => results.positions.column(name).map(Cells::Numbers),
            Self::Motion(results) => results.motion.column(name).map(Cells::Numbers),
            Self::Sweep(rows) if rows.is_text(name)? => rows.texts(name).map(Cells::Texts),
            Self::Sweep(rows) => rows.column(name).map(Cells::Numbers),
        }
    }

    /// A column as an array of numpy.
    pub(crate) fn array<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        match self.cells(name).map_err(unknown)? {
            Cells::Whole(numbers) => view(py, self.clone(), numbers),
            Cells::Numbers(numbers) => view(py, self.clone(), numbers),
            Cells::Texts(texts) => numpy(py)?.call_method1("array", (PyList::new(py, texts)?, "U")),
        }
    }
}

/// Rows and columns with names: of positions, of a motion over time, of a sweep.
#[pyclass(frozen, mapping, module = "assur")]
pub(crate) struct Table {
    rows: Rows,
}

impl Table {
    pub(crate) fn of(rows: Rows) -> Self {
        Self { rows }
    }
}

#[pymethods]
impl Table {
    /// The names of the columns: those of the CSV, with their units.
    #[getter]
    fn names(&self) -> Vec<&str> {
        self.rows.names().collect()
    }

    /// The names of the columns, for `dict(table)`.
    fn keys(&self) -> Vec<&str> {
        self.names()
    }

    /// A column by its name: numbers in SI as an array of numpy that shows them where they are, NaN where a row has none; texts as an array
    /// of texts, which are copied.
    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.rows.array(py, name)
    }

    fn __contains__(&self, name: &str) -> bool {
        self.rows.names().any(|own| own == name)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.rows.names())?.try_iter()
    }

    /// How many rows there are.
    fn __len__(&self) -> usize {
        self.rows.len()
    }

    /// The table for what reads Arrow, such as `pyarrow.table(table)` and `polars.DataFrame(table)`; empty cells are null.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let _ = requested_schema;
        arrow::stream(py, &self.rows)
    }

    fn __repr__(&self) -> String {
        format!("<assur.Table of {} rows, {} columns>", self.rows.len(), self.rows.names().count())
    }
}

/// Numbers that numpy shows without a copy, and the rows to which they belong.
#[pyclass(frozen)]
struct Numbers {
    kind: String,
    address: usize,
    length: usize,
    /// Keeps the numbers where they are.
    _rows: Rows,
}

#[pymethods]
impl Numbers {
    /// What numpy asks for: where the numbers are; they can't be written.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("typestr", &self.kind)?;
        interface.set_item("shape", (self.length,))?;
        interface.set_item("data", (self.address, true))?;
        Ok(interface)
    }
}

/// What numpy calls a number: its kind and its size.
pub(crate) trait Shown {
    const KIND: char;
}

impl Shown for f64 {
    const KIND: char = 'f';
}

impl Shown for usize {
    /// Numbers of positions are far below the greatest number with a sign.
    const KIND: char = 'i';
}

/// An array of numpy over numbers of `rows`, which stay while the array is there.
pub(crate) fn view<'py, T: Shown>(py: Python<'py>, rows: Rows, numbers: &[T]) -> PyResult<Bound<'py, PyAny>> {
    let order = if cfg!(target_endian = "little") { '<' } else { '>' };
    let numbers = Numbers {
        kind: format!("{order}{}{}", T::KIND, size_of::<T>()),
        address: numbers.as_ptr().addr(),
        length: numbers.len(),
        _rows: rows,
    };
    numpy(py)?.call_method1("asarray", (numbers,))
}

/// numpy, which is looked for where it is needed.
pub(crate) fn numpy(py: Python<'_>) -> PyResult<Bound<'_, PyModule>> {
    py.import("numpy")
}
