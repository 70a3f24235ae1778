//! Reactions of the position as a table, with their curves.

use assur_book::{Cell, Column, Table, Unit};
use assur_picture::forces::{difference, figure, heading};
use assur_words::{Text, name, number, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{causes, page};
use crate::screen::draw::{paint, put, short};
use crate::screen::state::{Found, Reaction, Role, Scene, State, View, ViewPart};

/// Rows of a chart below the table.
const BELOW: u16 = 9;
/// Rows that a chart needs at least.
const LEAST: u16 = 5;

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let theme = state.look.theme;
    let [title, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    put(
        buffer,
        title,
        1,
        0,
        &state.told(heading(scene, &state.pictured(), found)),
        theme.style(Role::Header),
    );
    match state.part(View::Forces) {
        ViewPart::Overview => {
            let rows = short(found.reactions.len()) + 2;
            let below = rest.height.saturating_sub(rows + 1);
            // In a low area the numbers go before the charts.
            let below = if rest.height > 2 * BELOW { below.max(BELOW) } else { below };
            let [table, below] =
                Layout::vertical([Constraint::Min(0), Constraint::Length(below)]).areas(rest);
            draw_table(state, scene, found, table, buffer);
            if below.height >= LEAST {
                paint(state, &figure(scene, &state.pictured(), state.part(View::Forces)), below, buffer);
            }
        }
        ViewPart::Causes => causes::draw(state, scene, found, rest, buffer),
        _ => paint(state, &figure(scene, &state.pictured(), state.part(View::Forces)), rest, buffer),
    }
}

fn draw_table(state: &State, scene: &Scene, found: &Found, area: Rect, buffer: &mut Buffer) {
    let (letter, of) = if scene.other.is_some() { ("|dF|", Unit::FORCE) } else { ("M", Unit::MOMENT) };
    let last = Column::short(name(letter), of);
    let rows = found.reactions.iter().map(|reaction| cells(state, scene, found, reaction));
    let table = Table::list(Text::default(), causes::heads(text!("forces-pair"), last)).rows(rows);
    let lines = page::told(state, area.width.saturating_sub(2), |page| page.table(table));
    // The balancing load, the last one, stays in sight below the reactions.
    let pinned = usize::from(found.balancing().is_some());
    page::draw_chosen(state, &lines, (state.chosen.reaction, pinned), &|_| Role::Plain, area, buffer);
}

fn cells(state: &State, scene: &Scene, found: &Found, reaction: &Reaction) -> [Cell; 6] {
    let value = |index: usize| found.series[index].clean(state.position);
    let apart = scene.other.as_ref().map(|other| {
        let apart = difference(found, other, reaction, state.position);
        apart.map_or(Cell::None, |apart| Cell::Text(number(format_args!("{apart:.1e}"))))
    });
    let own = reaction.name.clone();
    if let [index] = reaction.series[..] {
        let series = &found.series[index];
        let load = apart.unwrap_or_else(|| Cell::Text(series.show(state.position)));
        return causes::row(own.short(), None, load);
    }
    let force = value(reaction.series[0]).zip(value(reaction.series[1])).map(|(x, y)| [x, y]);
    let moment = || reaction.moment.map_or_else(|| Text::default().into(), |index| value(index).into());
    causes::row(own, Some(force.unwrap_or([f64::NAN; 2])), apart.unwrap_or_else(moment))
}
