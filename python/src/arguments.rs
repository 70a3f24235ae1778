//! What a call says, as the library takes it.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

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
