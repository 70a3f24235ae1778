//! The library `assur` as a module of Python.
//!
//! A table keeps what the library found, and its columns are views of that: numpy gets the address of a column with what keeps it
//! alive (`__array_interface__`), Arrow the same buffers by its C interface (`__arrow_c_stream__`). So no number is copied, and all
//! arrays can only be read. Calculations let go of the interpreter, and end at Ctrl-C.

mod arguments;
mod arrow;
mod error;
mod position;
mod results;
mod running;
mod scene;
mod table;

/// Planar linkages by Assur groups: positions, transfer functions, reactions, sweeps.
///
/// All numbers are in SI, angles in rad, counter-clockwise. A column has the name that it has in CSV.
#[pyo3::pymodule]
mod assur {
    use std::path::PathBuf;

    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::error::Error;
    #[pymodule_export]
    use crate::position::Position;
    #[pymodule_export]
    use crate::results::{Reaction, Results};
    #[pymodule_export]
    use crate::scene::Scene;
    #[pymodule_export]
    use crate::table::Table;

    /// Reads a scene from a file.
    #[pyfunction]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Scene> {
        let read = py.detach(|| library::Scene::read(&path));
        read.map(Scene::of).map_err(|error| crate::error::raised(py, error))
    }

    /// Reads a scene from its text; `file` is only repeated in errors.
    #[pyfunction]
    #[pyo3(signature = (text, file = "<text>"))]
    fn loads(py: Python<'_>, text: &str, file: &str) -> PyResult<Scene> {
        let read = py.detach(|| library::Scene::parse(file, text));
        read.map(Scene::of).map_err(|error| crate::error::raised(py, error))
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
