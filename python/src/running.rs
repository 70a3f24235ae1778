//! Calculations beside the interpreter.

use pyo3::prelude::*;

use crate::error::raised;

/// Runs a calculation while other threads of Python go on; what it is given tells whether to go on, which a signal (Ctrl-C) denies.
pub(crate) fn run<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut dyn FnMut() -> bool) -> Result<T, library::Error> + Send,
) -> PyResult<T> {
    let (found, interrupt) = py.detach(|| {
        let mut interrupt = None;
        let mut goes_on = || {
            #[expect(
                clippy::redundant_closure_for_method_calls,
                reason = "the method itself is of one lifetime"
            )]
            let signal = Python::attach(|py| py.check_signals());
            interrupt = signal.err();
            interrupt.is_none()
        };
        let found = work(&mut goes_on);
        (found, interrupt)
    });
    match (found, interrupt) {
        (_, Some(interrupt)) => Err(interrupt),
        (found, None) => found.map_err(|error| raised(py, error)),
    }
}
