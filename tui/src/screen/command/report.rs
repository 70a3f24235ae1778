//! Commands of the views that show a long text: the report on the methods, and the working of the position.

use assur_picture::find;

use super::{act, jobs};
use crate::screen::state::{Purpose, State, View, ViewPart};
use crate::screen::view::{report as view, room};

pub(super) fn measure(state: &mut State) {
    if state.measuring().is_some() {
        jobs::stop_measuring(state);
    } else {
        jobs::ask(state, Purpose::Measurement);
    }
}

pub(super) fn scroll(state: &mut State, by: isize) {
    let last = view::last_line(state);
    let line = state.line();
    *line = (*line).min(last).saturating_add_signed(by).min(last);
}

/// The next or previous quantity of the motion, or line of its page.
pub(super) fn motion(state: &mut State, by: isize) {
    if state.part(View::Motion) == ViewPart::Iteration {
        scroll(state, by);
    } else {
        act::choose(state, View::Motion, by);
    }
}

pub(super) fn page(state: &mut State, sense: isize) {
    let page = isize::from(i16::try_from(view::page(state)).unwrap_or(i16::MAX));
    scroll(state, sense * (page - 1).max(1));
}

/// Scrolls to the next line that begins with a text, as a heading does, or if none does, that contains it; `None` if there is none.
pub(super) fn find(state: &mut State, wanted: &str) -> Option<()> {
    let lines = view::lines(state, state.view, room(state).width);
    let now = *state.line();
    let line = |index: usize| lines[index].to_lowercase();
    let begins = |index: usize| line(index).trim_start_matches(['=', ' ']).starts_with(wanted);
    let is_heading = (0..lines.len()).any(begins);
    let fits = |index| if is_heading { begins(index) } else { line(index).contains(wanted) };
    *state.line() = find::next(now, lines.len(), fits)?;
    Some(())
}
