//! A mechanism at one coordinate.

use std::sync::Arc;

use pyo3::prelude::*;

use crate::error::unknown;

/// A mechanism at one coordinate of its input. Derivatives are by that coordinate.
#[pyclass(frozen, module = "assur")]
pub(crate) struct Position {
    scene: Arc<library::Scene>,
    /// The coordinate, rad, m or s.
    #[pyo3(get)]
    coordinate: f64,
}

impl Position {
    pub(crate) fn of(scene: Arc<library::Scene>, coordinate: f64) -> Result<Self, library::Error> {
        scene.at(coordinate)?;
        Ok(Self { scene, coordinate })
    }

    /// What is asked of the position, which is solved for it: that takes less than a call from Python.
    fn ask<T>(&self, of: impl FnOnce(&library::Position<'_>) -> Result<T, library::Error>) -> PyResult<T> {
        self.scene.at(self.coordinate).and_then(|position| of(&position)).map_err(unknown)
    }
}

#[pymethods]
impl Position {
    /// The place of a point, m.
    fn point(&self, name: &str) -> PyResult<(f64, f64)> {
        self.ask(|position| position.point(name)).map(Into::into)
    }

    /// The transfer functions of a point: its place, and the first and second derivative.
    fn transfer(&self, name: &str) -> PyResult<[(f64, f64); 3]> {
        self.ask(|position| position.transfer(name)).map(|all| all.map(Into::into))
    }

    /// The angle of a link in (-pi, pi], rad, and its first and second derivative.
    fn link(&self, name: &str) -> PyResult<(f64, f64, f64)> {
        self.ask(|position| position.link(name)).map(Into::into)
    }

    /// The place of the origin of a link, m.
    fn origin(&self, name: &str) -> PyResult<(f64, f64)> {
        self.ask(|position| position.origin(name)).map(Into::into)
    }
}
