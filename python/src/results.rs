//! What was found of a scene.

use std::sync::Arc;

use pyo3::prelude::*;

use crate::error::unknown;
use crate::table::{Rows, Table, view};

/// The results of a scene.
#[pyclass(frozen, module = "assur")]
pub(crate) struct Results {
    found: Arc<library::Results>,
}

impl Results {
    pub(crate) fn of(found: library::Results) -> Self {
        Self { found: Arc::new(found) }
    }
}

#[pymethods]
impl Results {
    /// One row for each position that has a solution.
    #[getter]
    fn positions(&self) -> Table {
        Table::of(Rows::Positions(Arc::clone(&self.found)))
    }

    /// One row for each sample of the motion over time, where the scene has one.
    #[getter]
    fn motion(&self) -> Table {
        Table::of(Rows::Motion(Arc::clone(&self.found)))
    }

    /// The positions without a solution: number, and what is missing, where and by how much.
    #[getter]
    fn failures(&self) -> Vec<(usize, String)> {
        self.found.failures.clone()
    }

    /// What in the scene is probably not meant, and what had to be left out.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.found.warnings.clone()
    }

    /// A column of the positions by its name in CSV, such as `B_x_m`.
    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        Rows::Positions(Arc::clone(&self.found)).array(py, name)
    }

    /// The force of a pair by its name, under the loads and the motion of the scene, on the link on which tables show it; `on`: on that link.
    #[pyo3(signature = (pair, on = None))]
    fn reaction(&self, py: Python<'_>, pair: &str, on: Option<&str>) -> PyResult<Reaction> {
        let found = match on {
            None => self.found.reaction(pair),
            Some(link) => self.found.positions.reaction_on(pair, link),
        };
        let found = found.map_err(unknown)?;
        let array = |numbers| view(py, Rows::Positions(Arc::clone(&self.found)), numbers).map(Bound::unbind);
        Ok(Reaction {
            on: found.on.to_owned(),
            x: array(found.x)?,
            y: array(found.y)?,
            moment: found.moment.map(array).transpose()?,
        })
    }

    fn __repr__(&self) -> String {
        format!("<assur.Results of {} positions>", self.found.positions.len())
    }
}

/// The force of a pair, row by row.
#[pyclass(frozen, module = "assur", get_all)]
pub(crate) struct Reaction {
    /// The link on which the force acts.
    on: String,
    /// Its projection on the x axis of the ground, N.
    x: Py<PyAny>,
    /// Its projection on the y axis, N.
    y: Py<PyAny>,
    /// The moment of a slide, N m, about its point, counter-clockwise on the link that slides; None of a pin.
    moment: Option<Py<PyAny>>,
}
