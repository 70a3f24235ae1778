//! The results that are asked for first, of which one is chosen.

use assur_book::{Cell, Column, Table};
use assur_words::{Text, text};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::page;
use crate::screen::state::{Role, Scene, State};

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let heads = [text!("fact-quantity"), text!("fact-value"), text!("fact-place")].map(Column::of);
    let facts = found.results.iter().map(|(_, fact)| fact);
    let rows = facts.map(|fact| [fact.what(), fact.with_unit(), fact.place()].map(Cell::Text));
    let table = Table::list(Text::default(), heads).rows(rows);
    let lines = page::told(state, area.width.saturating_sub(2), |page| {
        page.table(table);
        page.paragraph(text!("report-between"));
    });
    page::draw_chosen(state, &lines, (state.chosen.result, 1), &|_| Role::Plain, area, buffer);
}
