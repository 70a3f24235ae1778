//! Figures in the styles of the theme.

use assur_figure::cells::{self, Look};
use assur_figure::{Figure, Ink};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::text::put;
use crate::screen::state::{Role, State, View, Zoom};

/// How figures are drawn in cells now.
pub(crate) fn cells(state: &State) -> Look {
    let zoomed = matches!(state.view, View::Mechanism | View::Structure);
    let zoom = if zoomed { state.zoom } else { Zoom::WHOLE };
    Look { marker: state.look.marker, ratio: state.look.ratio, zoom }
}

/// Draws a figure into an area.
pub(crate) fn paint(state: &State, figure: &Figure, area: Rect, buffer: &mut Buffer) {
    for spot in cells::draw(figure, [area.width, area.height], cells(state)) {
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
