//! Lists of which one row is chosen: the results that are asked for first; the checks as the report tells them, with the residuals
//! over the positions.

use assur_book::{Fact, Table};
use assur_picture::curves::residuals;
use assur_report::topic;
use assur_words::{Text, name, text};
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::screen::draw::{Pen, short};
use crate::screen::state::{Role, Scene};

/// Rows that the curve of a residual needs.
const CURVE: u16 = 10;

/// Draws the view: the table, and below it the residuals where there is room.
pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let Some(found) = &scene.found else { return };
    let checks = &found.analysis.checks;
    let lines = page::told(pen.state, area.width.saturating_sub(2), |page| topic::checks(checks, page));
    let rows = short(lines.len()) + 1;
    let below = if area.height >= rows + CURVE { area.height - rows } else { 0 };
    let [table, below] = Layout::vertical([Constraint::Min(0), Constraint::Length(below)]).areas(area);
    let of_row = |row: usize| match checks.get(row).and_then(|check| check.finding.holds) {
        Some(true) => Role::Good,
        Some(false) => Role::Bad,
        None => Role::Plain,
    };
    page::draw_chosen(pen, &lines, (pen.state.chosen.check, 0), &of_row, table);
    let mut figure = residuals(scene, &pen.state.pictured());
    figure.panels.truncate(usize::from(below.height / CURVE));
    pen.paint(&figure, below);
}

/// Draws the results that are asked for first, of which one is chosen.
pub(super) fn draw_results(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let Some(found) = &scene.found else { return };
    let table =
        Table::each(Text::default(), &found.results).column(text!("fact-quantity"), |(_, fact)| fact.what());
    let table = match pen.state.second().and_then(|second| second.results.found.as_deref()) {
        Some(other) => {
            let same = |fact: &Fact| {
                let mut others = other.results.iter().map(|(_, other)| other);
                others.find(|other| (other.id, &other.of) == (fact.id, &fact.of))
            };
            table
                .column(name("1"), |(_, fact)| fact.with_unit())
                .column(name("2"), |(_, fact)| same(fact).map(Fact::with_unit))
                .column(name("1 - 2"), |(_, fact)| fact.minus(same(fact)?).map(|apart| apart.with_unit()))
        }
        None => table
            .column(text!("fact-value"), |(_, fact)| fact.with_unit())
            .column(text!("fact-place"), |(_, fact)| fact.place()),
    };
    let lines = page::told(pen.state, area.width.saturating_sub(2), |page| {
        page.table(table.table());
        page.paragraph(text!(if scene.samples().is_some() { "results-sampled" } else { "report-between" }));
    });
    page::draw_chosen(pen, &lines, (pen.state.chosen.result, 1), &|_| Role::Plain, area);
}
