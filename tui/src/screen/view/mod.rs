//! Views: pure functions from the state to a frame.

pub(crate) mod accuracy;
mod advice;
mod arrows;
mod ascii;
mod causes;
mod checks;
pub(crate) mod curves;
mod drive;
mod footer;
mod forces;
mod header;
pub(crate) mod help;
mod mechanism;
mod menu;
mod motion;
mod panel;
mod plans;
mod plots;
mod reactions;
mod regime;
mod structure;
mod table;
pub(crate) mod values;
pub(crate) mod vectors;

use assur_figure::Figure;
use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;

pub(crate) use advice::text as advice;

use crate::screen::draw::put;
use crate::screen::state::{State, View};

/// Smallest terminal that holds the views.
const LEAST: (u16, u16) = (80, 24);

/// Draws the whole frame.
pub(crate) fn draw(state: &State, frame: &mut Frame<'_>) {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    if area.width < LEAST.0 || area.height < LEAST.1 {
        let text = format!("needs {} x {}, has {} x {}", LEAST.0, LEAST.1, area.width, area.height);
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

/// The figure of the view that is shown; `None` where it has none.
pub(crate) fn figure(state: &State) -> Option<Figure> {
    let scene = state.scene.as_ref().filter(|_| state.has(state.view))?;
    let figure = match state.view {
        View::Mechanism => mechanism::figure(state, scene, state.position, &[]),
        View::Curves => curves::figure(state, scene),
        View::Forces => forces::figure(state, scene),
        View::Plans => plans::figure(state, scene),
        View::Motion => motion::figure(state, scene, usize::MAX),
        View::Drive => drive::figure(state, scene, 1),
        View::Structure => structure::figure(state, scene),
        View::Accuracy => accuracy::figure(state.measured.as_ref()?.chart.as_ref().ok()?),
        View::Menu | View::Checks | View::Table | View::Values => return None,
    };
    Some(figure).filter(|figure| !figure.panels.is_empty())
}

/// Draws what is between header and footer.
pub(crate) fn draw_view(state: &State, area: Rect, buffer: &mut Buffer) {
    if let Some(scene) = state.scene.as_ref().filter(|_| !state.has(state.view)) {
        return advice::draw(state, scene, area, buffer);
    }
    match (state.view, &state.scene) {
        (View::Mechanism, Some(scene)) => mechanism::draw(state, scene, area, buffer),
        (View::Curves, Some(scene)) => curves::draw(state, scene, area, buffer),
        (View::Forces, Some(scene)) => forces::draw(state, scene, area, buffer),
        (View::Plans, Some(scene)) => plans::draw(state, scene, area, buffer),
        (View::Motion, Some(scene)) => motion::draw(state, scene, area, buffer),
        (View::Drive, Some(scene)) => drive::draw(state, scene, area, buffer),
        (View::Checks, Some(scene)) => checks::draw(state, scene, area, buffer),
        (View::Accuracy, Some(_)) => accuracy::draw(state, area, buffer),
        (View::Structure, Some(scene)) => structure::draw(state, scene, area, buffer),
        (View::Table, Some(scene)) => table::draw(state, scene, area, buffer),
        (View::Menu | View::Values, _) | (_, None) => menu::draw(state, area, buffer),
    }
}
