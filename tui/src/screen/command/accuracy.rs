//! Commands of the view of the methods: speed, accuracy and stability are measured on request.

use super::jobs;
use crate::screen::state::{Purpose, Role, State};
use crate::screen::view::accuracy as view;

/// Starts a measurement, or stops the one in progress.
pub(super) fn measure(state: &mut State) {
    if state.measuring().is_some() {
        stop(state);
    } else {
        jobs::ask(state, Purpose::Measurement);
    }
}

/// Stops the measurement in progress; finished measurements are shown.
pub(super) fn stop(state: &mut State) {
    if let Some(running) = state.measuring() {
        running.cancel.stop();
        state.say(Role::Plain, "stopping ...");
    }
}

/// Scrolls the report by this many lines, within its limits.
pub(super) fn scroll(state: &mut State, by: isize) {
    let last = view::last_line(state);
    state.chosen.line = state.chosen.line.min(last).saturating_add_signed(by).min(last);
}

/// Scrolls the report by a page, less one line.
pub(super) fn page(state: &mut State, sense: isize) {
    let page = isize::from(i16::try_from(view::page(state)).unwrap_or(i16::MAX));
    scroll(state, sense * (page - 1).max(1));
}

/// Scrolls to the end of the report.
pub(super) fn end(state: &mut State) {
    state.chosen.line = view::last_line(state);
}
