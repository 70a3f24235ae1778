//! What a call says, as the library takes it.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use library::{Numbering, PointTable};

/// One text or several: a text, texts, or a mapping, of which `KEY: VALUE` is `KEY=VALUE`.
#[derive(Debug, Default)]
pub(crate) struct Texts(pub(crate) Vec<String>);

impl<'py> FromPyObject<'_, 'py> for Texts {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(text) = given.cast::<PyString>() {
            return Ok(Self(vec![text.extract()?]));
        }
        if let Ok(pairs) = given.cast::<PyDict>() {
            let each = pairs.iter().map(|(key, value)| Ok(format!("{}={}", key.str()?, value.str()?)));
            return each.collect::<PyResult<_>>().map(Self);
        }
        given
            .extract()
            .map(Self)
            .map_err(|_| PyTypeError::new_err("one text, a list of texts, or a dict of texts is expected"))
    }
}

impl Texts {
    /// Names, of which a text may have several with commas between.
    pub(crate) fn names(&self) -> Vec<String> {
        self.0.iter().flat_map(|text| text.split(',')).map(|name| name.trim().to_owned()).collect()
    }
}

/// Points row by row: columns by the keys of the scene, of a dict or a data frame.
pub(crate) struct Points(pub(crate) PointTable);

impl<'py> FromPyObject<'_, 'py> for Points {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let cells =
            |column: Bound<'_, PyAny>| column.try_iter()?.map(|cell| value(&cell?)).collect::<PyResult<_>>();
        let each = given.call_method0("items")?.try_iter()?.map(|pair| {
            let (name, column): (String, Bound<'_, PyAny>) = pair?.extract()?;
            Ok((name, cells(column)?))
        });
        let columns: Vec<(String, Vec<String>)> = each.collect::<PyResult<_>>()?;
        let mut table = PointTable::new("points", Numbering::Rows, columns.iter().map(|(name, _)| &**name));
        let rows = columns.iter().map(|(_, cells)| cells.len()).max().unwrap_or(0);
        for row in 0..rows {
            let cells = columns.iter().filter_map(|(_, cells)| cells.get(row).map(String::as_str));
            table.push(row, cells).map_err(|error| PyValueError::new_err(error.to_string()))?;
        }
        Ok(Self(table))
    }
}

/// A value of a scene as it is written there: a text with a unit, or a number in SI.
pub(crate) fn value(given: &Bound<'_, PyAny>) -> PyResult<String> {
    match given.cast::<PyString>() {
        Ok(text) => text.extract(),
        Err(_) => given.extract::<f64>().map(|number| number.to_string()),
    }
}

/// Part I of N.
pub(crate) fn part(
    given: Option<(usize, usize)>,
) -> PyResult<Option<(std::num::NonZeroUsize, std::num::NonZeroUsize)>> {
    let Some((part, parts)) = given else { return Ok(None) };
    let both = std::num::NonZeroUsize::new(part).zip(std::num::NonZeroUsize::new(parts));
    let both = both.filter(|(part, parts)| part <= parts);
    both.map(Some).ok_or_else(|| PyValueError::new_err("shard is (I, N), I from 1 to N"))
}
