//! Every check in a line: name, largest residual, limit, place, and in words whether it passes.

use assur_analysis::results::{Check, Quantity};
use assur_figure::{Figure, Ink, Stroke};
use assur_words::{self as words, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::plots::over_positions;
use crate::number::number;
use crate::screen::draw::{cut, first_shown, paint, put, short};
use crate::screen::state::{Role, Scene, State};

const TITLES: [&str; 5] = [
    "check-column-name",
    "check-column-residual",
    "check-column-limit",
    "check-column-where",
    "check-column-position",
];
/// Columns of the texts in 80 columns; more room goes to the place.
const WIDTHS: [u16; 6] = [30, 11, 11, 13, 6, 7];
/// Rows that the curve of a residual below the table needs.
const CURVE: u16 = 10;

/// Draws the view: the table, and below it the residuals over the positions.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let rows = short(found.analysis.checks.len()) + 2;
    let below = if area.height >= rows + CURVE { area.height - rows } else { 0 };
    let [area, below] = Layout::vertical([Constraint::Min(0), Constraint::Length(below)]).areas(area);
    let titles = columns(area.width).into_iter().zip(TITLES);
    for ((column, _), title) in titles {
        put(buffer, area, column, 0, &state.told(text!(title)), state.look.theme.style(Role::Dim));
    }
    let height = usize::from(area.height.saturating_sub(1));
    let skip = first_shown(state.chosen.check, height);
    for (row, (index, check)) in found.analysis.checks.iter().enumerate().skip(skip).take(height).enumerate()
    {
        let line = Rect { y: area.y + 1 + short(row), height: 1, ..area };
        draw_row(state, check, index == state.chosen.check, line, buffer);
    }
    let residuals =
        found.series.iter().filter(|series| matches!(series.column.quantity, Quantity::Residual(_)));
    let panels = residuals.take(usize::from(below.height / CURVE)).map(|series| {
        let value = words::number(number(series.at(state.position)));
        over_positions(
            state,
            scene,
            [series.of.clone(), value],
            &[(series, Stroke::Solid, Ink::First)],
            Vec::new(),
        )
    });
    let figure = Figure { panels: panels.collect(), columns: 1, ..Figure::default() };
    paint(state, &figure, below, buffer);
}

/// Where the columns begin, and how wide they are.
fn columns(width: u16) -> [(u16, u16); 6] {
    let mut widths = WIDTHS;
    widths[3] += width.saturating_sub(2 + WIDTHS.iter().sum::<u16>());
    let mut at = 2;
    widths.map(|width| {
        at += width;
        (at - width, width)
    })
}

fn draw_row(state: &State, check: &Check, chosen: bool, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let style = theme.style(if chosen { Role::Cursor } else { Role::Plain });
    if chosen {
        put(buffer, area, 0, 0, ">", style);
    }
    let at = check.at.map_or_else(|| "-".to_owned(), |at| at.to_string());
    let [residual, limit] =
        [check.residual, check.limit].map(|size| state.told(words::number(format_args!("{size:.2e}"))));
    let [name, place] = [&check.name, &check.place].map(|text| state.told(text.clone()));
    let cells = [&name, &residual, &limit, &place, &at];
    let columns = columns(area.width);
    for (text, (column, width)) in cells.into_iter().zip(columns) {
        put(buffer, area, column, 0, &cut(text, usize::from(width - 1)), style);
    }
    let (word, role) = match check.verdict() {
        Some(false) => (text!("check-fails"), Role::Bad),
        Some(true) => (text!("check-holds"), Role::Good),
        None => (text!("check-unknown"), Role::Dim),
    };
    put(buffer, area, columns[5].0, 0, &state.told(word), theme.style(role));
}
