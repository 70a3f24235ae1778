//! Long texts that are scrolled: the report on the methods, the working of the position, and the pages of motion and drive.

use assur_note::working;
use assur_report::text::{Style, told_within};
use assur_words::{Describe, name, text};
use ratatui::layout::Rect;

use super::{drive, motion};
use crate::screen::draw::{Pen, folded, short};
use crate::screen::state::{Role, State, View};

pub(super) fn draw(pen: &mut Pen<'_>, view: View, area: Rect) {
    let state = pen.state;
    let top = u16::from(view == View::Accuracy && state.measuring().is_some());
    if view == View::Accuracy {
        progress(pen, area);
    }
    let height = usize::from(area.height.saturating_sub(top));
    let lines = lines(state, view, area.width);
    let first = if view == View::Working { state.chosen.equation } else { state.chosen.line };
    let skip = first.min(lines.len().saturating_sub(height));
    for (row, line) in lines.iter().skip(skip).take(height).enumerate() {
        pen.put(area, 1, short(row) + top, line, Role::Plain);
    }
    pen.mark_rows(area, skip..lines.len().min(skip + height), lines.len());
}

/// How far the measurement is, or what starts it.
fn progress(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    if let Some(running) = state.measuring() {
        let measuring = text!("accuracy-measuring");
        let count = if running.count.is_empty() { &measuring } else { &running.count };
        let text = text!("accuracy-stops", count = count, key = name(state.keys.first("close")));
        pen.tell(area, 1, 0, text, Role::Header);
    } else if state.measured.is_none() {
        let text = text!("accuracy-starts", key = name(state.keys.first("measure")));
        pen.tell(area, 1, 1, text, Role::Plain);
    }
}

/// Visible rows of the text.
pub(crate) fn page(state: &State) -> usize {
    // Motion and drive have a heading.
    let top = u16::from([View::Motion, View::Drive].contains(&state.view) || state.measuring().is_some());
    usize::from(super::room(state).height.saturating_sub(top))
}

/// The first line of the last page.
pub(crate) fn last_line(state: &State) -> usize {
    lines(state, state.view, super::room(state).width).len().saturating_sub(page(state))
}

/// The text of a view in lines of a width.
pub(crate) fn lines(state: &State, view: View, width: u16) -> Vec<String> {
    // A column stays free at each side.
    let width = width.max(40) - 2;
    let language = state.language();
    let page = match (view, &state.scene, state.found()) {
        (View::Drive, Some(scene), _) => drive::whole(state, scene, width + 2),
        (View::Motion, Some(scene), Some(found)) => motion::told(state, scene, found, width + 2),
        _ => Vec::new(),
    };
    if !page.is_empty() {
        return page.into_iter().map(|line| line.text).collect();
    }
    let text = match (view, &state.measured, state.found()) {
        (View::Accuracy, Some(measured), _) => {
            let style = Style { language, ascii: state.look.ascii };
            told_within(width.into(), style, |page| measured.tell(page))
        }
        (View::Working, _, Some(found)) => {
            match working::of_position(found.plans.calculation(), state.position) {
                Ok(working) => assur_worksheet::text(&working.sections, usize::from(width), language),
                Err(error) => error.describe().render(language),
            }
        }
        _ => String::new(),
    };
    text.lines().flat_map(|line| folded(line, usize::from(width))).collect()
}
