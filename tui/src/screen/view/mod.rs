//! Views: pure functions from the state to a frame.

mod advice;
mod ascii;
pub(crate) mod build;
mod checks;
pub(crate) mod curves;
mod drive;
mod file;
mod footer;
mod forces;
mod form;
mod header;
pub(crate) mod help;
pub(crate) mod mechanism;
mod motion;
mod page;
mod pattern;
pub(crate) mod picker;
pub(crate) mod plans;
pub(crate) mod report;
mod sheet;
pub(crate) mod structure;
mod table;
pub(crate) mod values;

use assur_figure::Figure;
use assur_words::{number, text};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};

use crate::screen::draw::{Pen, cut, wrapped};
use crate::screen::state::{Role, State, View};

/// Smallest terminal that holds the views.
pub(crate) const LEAST: (u16, u16) = (80, 24);
/// Least width of a terminal in which several views are shown beside each other.
const SEVERAL: u16 = 120;
/// Least width of the view that is chosen.
const MAIN: u16 = 80;
/// Least height of a view beside it.
const PANEL: u16 = 15;
/// Rows of a step of the tour.
const TOUR: u16 = 4;

pub(crate) fn draw(state: &State, frame: &mut Frame<'_>) {
    state.shown.borrow_mut().clear();
    let area = frame.area();
    let pen = &mut Pen { state, buffer: frame.buffer_mut() };
    if area.width < LEAST.0 || area.height < LEAST.1 {
        let [width, height] = [LEAST.0, LEAST.1].map(number);
        let [columns, rows] = [area.width, area.height].map(number);
        let text = text!("screen-too-small", width = width, height = height, columns = columns, rows = rows);
        pen.tell(area, 0, 0, text, Role::Plain);
    } else {
        let [header, body, footer] = parts(area);
        header::draw(pen, header);
        draw_body(pen, body);
        footer::draw(pen, footer);
        if state.help.is_some() {
            help::draw(pen, body);
        } else if let Some((title, fault)) = &state.fault {
            footer::draw_fault(pen, [title, fault], body);
        }
    }
    if state.look.ascii {
        ascii::replace(pen.buffer);
    }
}

fn draw_body(pen: &mut Pen<'_>, body: Rect) {
    let [body, tour] =
        Layout::vertical([Constraint::Min(0), Constraint::Length(tour_rows(pen.state))]).areas(body);
    draw_tour(pen, tour);
    let [views, list] = shared(pen.state, body);
    for (number, (view, area)) in tiles(pen.state, views).into_iter().enumerate() {
        if number == 0 {
            draw_view(pen, view, area);
        } else {
            draw_panel(pen, view, area);
        }
    }
    if list.height > 0 {
        values::draw(pen, list);
    }
    if let Some(open) = &pen.state.picker {
        picker::draw(pen, open, body);
    }
}

/// Rows that the present step of the tour takes.
fn tour_rows(state: &State) -> u16 {
    if state.tour.is_some() { TOUR } else { 0 }
}

/// The present step of the tour.
fn draw_tour(pen: &mut Pen<'_>, area: Rect) {
    let Some((_, told)) = &pen.state.tour else { return };
    let told = pen.state.told(told.clone());
    let lines = wrapped(&told, usize::from(area.width).saturating_sub(2).max(1)).into_iter();
    let lines: Vec<_> = lines.map(|line| (Role::Key, line)).take(area.height.into()).collect();
    pen.put_lines(area, 1, &lines);
}

fn parts(area: Rect) -> [Rect; 3] {
    Layout::vertical([Constraint::Length(2), Constraint::Min(0), Constraint::Length(2)]).areas(area)
}

/// The body for the views, and for the list of values below them.
fn shared(state: &State, body: Rect) -> [Rect; 2] {
    let list = if state.values_open() { values::height(body) } else { 0 };
    Layout::vertical([Constraint::Min(0), Constraint::Length(list)]).areas(body)
}

/// The chosen view with its place, then the views beside it with theirs.
fn tiles(state: &State, body: Rect) -> Vec<(View, Rect)> {
    let beside = |view: &View| *view != state.view && state.has(*view);
    let rows = usize::from(body.height / PANEL);
    let most = if state.panels.shown { rows } else { 0 };
    let others: Vec<View> = state.panels.views.iter().copied().filter(beside).take(most).collect();
    if body.width < SEVERAL || others.is_empty() || state.scene.is_none() {
        return vec![(state.view, body)];
    }
    let [main, column] =
        Layout::horizontal([Constraint::Length(MAIN.max(body.width / 2)), Constraint::Min(0)]).areas(body);
    let rows = Layout::vertical(vec![Constraint::Fill(1); others.len()]).split(column);
    std::iter::once((state.view, main)).chain(others.into_iter().zip(rows.iter().copied())).collect()
}

/// The views with their places on the terminal, the chosen one first.
pub(crate) fn areas(state: &State) -> Vec<(View, Rect)> {
    let body = parts(Rect::new(0, 0, state.size.0, state.size.1))[1];
    let body = Rect { height: body.height.saturating_sub(tour_rows(state)), ..body };
    tiles(state, shared(state, body)[0])
}

pub(crate) fn room(state: &State) -> Rect {
    areas(state)[0].1
}

pub(crate) fn figure(state: &State, view: View) -> Option<Figure> {
    let scene = state.scene.as_ref().filter(|_| state.has(view))?;
    let figure = match view.picture() {
        Some(picture) => picture.figure(scene, &state.pictured(), state.part(view)),
        None if view == View::Accuracy => {
            assur_study::chart::figure(state.measured.as_ref()?.chart.as_ref().ok()?)
        }
        None => return None,
    };
    Some(figure).filter(|figure| !figure.panels.is_empty())
}

pub(crate) fn draw_view(pen: &mut Pen<'_>, view: View, area: Rect) {
    if view == View::Build {
        return build::draw(pen, area);
    }
    let Some(scene) = &pen.state.scene else { return };
    if !pen.state.has(view) {
        return advice::draw(pen, scene, view, area);
    }
    match view {
        View::Mechanism => mechanism::draw(pen, scene, area),
        View::Curves => curves::draw(pen, scene, area),
        View::Forces => forces::draw(pen, scene, area),
        View::Plans => plans::draw(pen, scene, area),
        View::Motion => motion::draw(pen, scene, area),
        View::Drive => drive::draw(pen, scene, area),
        View::Checks => checks::draw(pen, scene, area),
        View::Accuracy | View::Working => report::draw(pen, view, area),
        View::Structure => structure::draw(pen, scene, area),
        View::Table => table::draw(pen, scene, area),
        View::Sheet => sheet::draw(pen, area),
        View::Results => checks::draw_results(pen, scene, area),
        View::Values | View::Probe | View::Build => {}
    }
}

/// Draws a view beside the chosen one: its figure alone if it has one, under the name of the view.
fn draw_panel(pen: &mut Pen<'_>, view: View, area: Rect) {
    let state = pen.state;
    let [title, inside] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(Rect {
        x: area.x + 1,
        width: area.width.saturating_sub(1),
        ..area
    });
    for row in 0..area.height {
        pen.put(area, 0, row, "│", Role::Dim);
    }
    let figure = figure(state, view);
    let heading = match (&figure, &state.scene) {
        // The title of the scene stands in the header already.
        (Some(_), Some(scene)) if view == View::Mechanism => state.told(scene.place(state.position)),
        (Some(figure), _) => state.told(&figure.title),
        (None, _) => String::new(),
    };
    let heading = format!("{} {}  {heading}", state.keys.first(view.command()), state.told(view.name()));
    pen.put(title, 0, 0, &cut(heading.trim_end(), usize::from(title.width)), Role::Header);
    match figure {
        Some(figure) => pen.paint(&figure, inside),
        None => draw_view(pen, view, inside),
    }
}
