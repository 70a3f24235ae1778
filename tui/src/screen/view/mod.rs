//! Views: pure functions from the state to a frame.

pub(crate) mod accuracy;
pub(crate) mod advice;
pub(crate) mod arrows;
pub(crate) mod ascii;
pub(crate) mod causes;
pub(crate) mod checks;
pub(crate) mod curves;
pub(crate) mod drive;
pub(crate) mod footer;
pub(crate) mod forces;
pub(crate) mod header;
pub(crate) mod help;
pub(crate) mod mechanism;
pub(crate) mod menu;
pub(crate) mod motion;
pub(crate) mod panel;
pub(crate) mod plans;
pub(crate) mod regime;
pub(crate) mod structure;
pub(crate) mod table;
pub(crate) mod values;

use crossterm::event::{MouseButton, MouseEvent, MouseEventKind};
use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;

use super::state::{State, View};
use super::text::fill;

/// Smallest terminal that holds the views.
const LEAST: (u16, u16) = (80, 24);

/// Draws the whole frame.
pub(crate) fn draw(state: &State, frame: &mut Frame<'_>) {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    if area.width < LEAST.0 || area.height < LEAST.1 {
        let text = fill(state.texts.needs, &[&LEAST.0, &LEAST.1, &area.width, &area.height]);
        put(buffer, area, 0, 0, &text, Style::new());
    } else {
        let [header, body, footer] = parts(area);
        header::draw(state, header, buffer);
        let [view, list] = shared(state, body);
        draw_view(state, view, buffer);
        if list.height > 0 {
            values::draw(state, list, buffer);
        }
        footer::draw(state, footer, buffer);
        if state.help.is_some() {
            help::draw(state, body, buffer);
        } else if let Some((title, fault)) = &state.fault {
            footer::draw_fault(state, title, fault, body, buffer);
        }
    }
    if state.look.ascii {
        ascii::replace(buffer);
    }
}

/// Header, body, footer.
fn parts(area: Rect) -> [Rect; 3] {
    Layout::vertical([Constraint::Length(2), Constraint::Min(0), Constraint::Length(2)]).areas(area)
}

/// The body for the view, and for the list of values below it.
fn shared(state: &State, body: Rect) -> [Rect; 2] {
    let list = if state.values_open() { values::height(body) } else { 0 };
    Layout::vertical([Constraint::Min(0), Constraint::Length(list)]).areas(body)
}

/// Where the view is drawn on the terminal.
pub(crate) fn room(state: &State) -> Rect {
    shared(state, parts(Rect::new(0, 0, state.size.0, state.size.1))[1])[0]
}

/// Draws what is between header and footer.
pub(crate) fn draw_view(state: &State, area: Rect, buffer: &mut Buffer) {
    if let Some(study) = state.study.as_ref().filter(|_| !state.has(state.view)) {
        return advice::draw(state, study, area, buffer);
    }
    match (state.view, &state.study) {
        (View::Mechanism, Some(study)) => mechanism::draw(state, study, area, buffer),
        (View::Curves, Some(study)) => curves::draw(state, study, area, buffer),
        (View::Forces, Some(study)) => forces::draw(state, study, area, buffer),
        (View::Plans, Some(study)) => plans::draw(state, study, area, buffer),
        (View::Motion, Some(study)) => motion::draw(state, study, area, buffer),
        (View::Drive, Some(study)) => drive::draw(state, study, area, buffer),
        (View::Checks, Some(study)) => checks::draw(state, study, area, buffer),
        (View::Accuracy, Some(_)) => accuracy::draw(state, area, buffer),
        (View::Structure, Some(study)) => structure::draw(state, study, area, buffer),
        (View::Table, Some(study)) => table::draw(state, study, area, buffer),
        (View::Menu | View::Values, _) | (_, None) => menu::draw(state, area, buffer),
    }
}

/// A click chooses a position on a chart; tells whether the frame may differ.
pub(crate) fn click(state: &mut State, mouse: MouseEvent) -> bool {
    let pressed = matches!(
        mouse.kind,
        MouseEventKind::Down(MouseButton::Left) | MouseEventKind::Drag(MouseButton::Left)
    );
    if !pressed || state.view != View::Curves {
        return false;
    }
    match curves::position_at(state, room(state), mouse.column) {
        Some(position) => std::mem::replace(&mut state.position, position) != position,
        None => false,
    }
}

/// Writes a text into an area, cut at its right edge; outside nothing happens.
pub(crate) fn put(buffer: &mut Buffer, area: Rect, column: u16, row: u16, text: &str, style: Style) {
    if row < area.height && column < area.width {
        buffer.set_stringn(area.x + column, area.y + row, text, usize::from(area.width - column), style);
    }
}
