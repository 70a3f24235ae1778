//! Figures in the styles of the theme.

use assur_figure::cells::{self, Look};
use assur_figure::{Figure, Frame, Ink};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::text::put;
use crate::screen::state::{Role, State, Zoom};

/// How a figure is drawn in cells now, in the whole or zoomed.
pub(crate) fn cells(state: &State, zoom: Zoom) -> Look {
    Look { marker: state.look.marker, ratio: state.look.ratio, zoom }
}

/// Draws the whole figure into an area.
pub(crate) fn paint(state: &State, figure: &Figure, area: Rect, buffer: &mut Buffer) {
    paint_zoomed(state, figure, Zoom::WHOLE, area, buffer);
}

/// Draws the visible part of a figure into an area.
pub(crate) fn paint_zoomed(state: &State, figure: &Figure, zoom: Zoom, area: Rect, buffer: &mut Buffer) {
    let words = state.words();
    let figure = figure.translated(&|text| words.shown(text));
    if zoom == Zoom::WHOLE && state.shows_pictures() && area.width > 0 && area.height > 0 {
        let mut figure = figure;
        for panel in &mut figure.panels {
            if let Frame::Plane { scale, .. } = &mut panel.frame {
                // A millimeter of a screen is not known.
                scale.0 = "";
            }
        }
        return state.shown.borrow_mut().push((figure, area));
    }
    for spot in cells::draw(&figure, [area.width, area.height], cells(state, zoom)) {
        put(buffer, area, spot.column, spot.row, &spot.text, state.look.theme.style(role(spot.ink)));
    }
}

fn role(ink: Ink) -> Role {
    match ink {
        Ink::Text => Role::Plain,
        Ink::Title => Role::Header,
        Ink::Dim => Role::Dim,
        Ink::Ground => Role::Ground,
        Ink::Link(number) => Role::Link(number),
        Ink::Marked => Role::Chosen,
        Ink::Trace => Role::Trace,
        Ink::Velocity => Role::Velocity,
        Ink::Acceleration => Role::Acceleration,
        Ink::First => Role::First,
        Ink::Second => Role::Second,
        Ink::Third => Role::Third,
        Ink::Cursor => Role::Key,
    }
}
