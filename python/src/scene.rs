//! Scenes.

use std::num::NonZeroUsize;
use std::sync::Arc;

use pyo3::prelude::*;

use crate::arguments::{Points, Texts, part, value};
use crate::error::raised;
use crate::position::Position;
use crate::results::Results;
use crate::running::run;
use crate::table::{Rows, Table, numpy};

/// A scene that is read, with its mechanism compiled.
#[pyclass(frozen, module = "assur")]
pub(crate) struct Scene {
    scene: Arc<library::Scene>,
}

impl Scene {
    pub(crate) fn of(scene: library::Scene) -> Self {
        Self { scene: Arc::new(scene) }
    }
}

#[pymethods]
impl Scene {
    /// The text of the scene.
    #[getter]
    fn text(&self) -> &str {
        self.scene.text()
    }

    /// The formula of its structure, such as `I(ground,crank) -> II1(rod,rocker)`.
    #[getter]
    fn structure(&self) -> String {
        self.scene.structure()
    }

    /// The names of its points.
    #[getter]
    fn points(&self) -> Vec<&str> {
        self.scene.points().collect()
    }

    /// The names of its links, the ground among them.
    #[getter]
    fn links(&self) -> Vec<&str> {
        self.scene.links().collect()
    }

    /// The coordinates of the positions that the scene asks for, rad, m or s.
    #[getter]
    fn coordinates<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        numpy(py)?.call_method1("array", (self.scene.coordinates().collect::<Vec<f64>>(), "f8"))
    }

    /// The position at a coordinate (rad, m or s) of the input.
    fn at(&self, py: Python<'_>, coordinate: f64) -> PyResult<Position> {
        Position::of(Arc::clone(&self.scene), coordinate).map_err(|error| raised(py, error))
    }

    /// The scene with another value, written as in a scene ("5 kg") or a number in SI; comments and order stay.
    fn replace(&self, py: Python<'_>, key: &str, value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let value = self::value(value)?;
        py.detach(|| self.scene.with(key, &value)).map(Self::of).map_err(|error| raised(py, error))
    }

    /// All results of the positions and of the motion, as `assur analyze` has them, without its checks; `positions`: over so many
    /// positions instead of those of the scene.
    #[pyo3(signature = (*, positions = None))]
    fn analyze(&self, py: Python<'_>, positions: Option<NonZeroUsize>) -> PyResult<Results> {
        run(py, |goes_on| match positions {
            Some(count) => self.scene.with("input.positions", &count.to_string())?.analyze_while(goes_on),
            None => self.scene.analyze_while(goes_on),
        })
        .map(Results::of)
    }

    /// The scene with many values of its own numbers, as `assur sweep` has it: a row for each point.
    #[pyo3(signature = (vary = None, *, points = None, measure = None, tie = None, target = None, r#where = None, sample = None,
        seed = 0, between = false, shard = None, threads = None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments, of which a call has few")]
    fn sweep(
        &self,
        py: Python<'_>,
        vary: Option<Texts>,
        points: Option<Points>,
        measure: Option<Texts>,
        tie: Option<Texts>,
        target: Option<Texts>,
        r#where: Option<Texts>,
        sample: Option<NonZeroUsize>,
        seed: u32,
        between: bool,
        shard: Option<(usize, usize)>,
        threads: Option<NonZeroUsize>,
    ) -> PyResult<Table> {
        let vary = vary.unwrap_or_default();
        let vary: Vec<&str> = vary.0.iter().map(String::as_str).collect();
        let options = library::SweepOptions {
            measures: measure.map(|texts| texts.names()).unwrap_or_default(),
            ties: tie.unwrap_or_default().0,
            targets: target.unwrap_or_default().0,
            conditions: r#where.unwrap_or_default().0,
            points: points.map(|points| points.0),
            sample,
            seed,
            between,
            part: part(shard)?,
            threads,
        };
        let rows = run(py, |goes_on| self.scene.sweep_with(&vary, &options, goes_on))?;
        Ok(Table::of(Rows::Sweep(Arc::new(rows))))
    }

    fn __repr__(&self) -> String {
        format!("<assur.Scene {}>", self.scene.structure())
    }
}
