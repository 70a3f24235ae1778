//! The mechanism to scale, with the numbers of the position beside it.

use assur_picture::mechanism::figure;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::panel;
use crate::screen::draw::{cells, paint_zoomed};
use crate::screen::state::{Scene, State};

/// Columns of the numbers next to the drawing.
const PANEL: u16 = 26;

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let [drawing, beside] = parts(area);
    let figure = figure(scene, &state.pictured(), &[]);
    paint_zoomed(state, &figure, state.zoom, drawing, buffer);
    panel::draw(state, scene, &figure, drawing, beside, buffer);
}

fn parts(area: Rect) -> [Rect; 2] {
    Layout::horizontal([Constraint::Min(0), Constraint::Length(PANEL)]).areas(area)
}

/// The place of the plane (m) under a cell of the view; `None` beside the drawing.
pub(crate) fn place_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<[f64; 2]> {
    let figure = figure(state.scene.as_ref()?, &state.pictured(), &[]);
    let [drawing, _] = parts(area);
    let cell = [column.checked_sub(drawing.x)?, row.checked_sub(drawing.y)?];
    let size = [drawing.width, drawing.height];
    assur_figure::cells::point_at(figure.panels.first()?, size, cells(state, state.zoom), cell)
}
