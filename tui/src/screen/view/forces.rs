//! Reactions of the position as a table, with their curves; and the chosen one by cause.

use assur_book::{Cell, Column, Table, Unit, zero_if_rounding};
use assur_diagram::Split;
use assur_picture::causes::{CauseShare, part, parts, sum};
use assur_picture::forces::{difference, figure, heading};
use assur_picture::plans::has_forces;
use assur_report::topic::{direction, force_heads};
use assur_words::{Text, joined, name, number, quantity, text};
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::number::digits;
use crate::screen::draw::{Pen, short};
use crate::screen::state::{Found, Reaction, Role, Scene, State, View, ViewPart};

/// Rows of a chart below the table.
const BELOW: u16 = 9;
/// Rows that a chart needs at least.
const LEAST: u16 = 5;

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    let Some(found) = &scene.found else { return };
    let [title, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    pen.tell(title, 1, 0, heading(scene, &state.pictured(), found), Role::Header);
    match state.part(View::Forces) {
        ViewPart::Overview => {
            let rows = short(found.reactions.len()) + 2;
            let below = rest.height.saturating_sub(rows + 1);
            // In a low area the numbers go before the charts.
            let below = if rest.height > 2 * BELOW { below.max(BELOW) } else { below };
            let [table, below] =
                Layout::vertical([Constraint::Min(0), Constraint::Length(below)]).areas(rest);
            draw_table(pen, scene, found, table);
            if below.height >= LEAST {
                pen.paint(&figure(scene, &state.pictured(), state.part(View::Forces)), below);
            }
        }
        ViewPart::Causes => draw_causes(pen, scene, found, rest),
        _ => pen.paint(&figure(scene, &state.pictured(), state.part(View::Forces)), rest),
    }
}

fn draw_table(pen: &mut Pen<'_>, scene: &Scene, found: &Found, area: Rect) {
    let (letter, of) = if scene.other.is_some() { ("|dF|", Unit::FORCE) } else { ("M", Unit::MOMENT) };
    let last = Column::short(name(letter), of);
    let rows = found.reactions.iter().map(|reaction| cells(pen.state, scene, found, reaction));
    let table = Table::list(Text::default(), heads(text!("forces-pair"), last)).rows(rows);
    let second = pen.state.second().and_then(|second| second.results.found.as_deref());
    let table = second.map_or(table, |other| two(pen.state, found, other));
    let lines = page::told(pen.state, area.width.saturating_sub(2), |page| page.table(table));
    // The balancing load, the last one, stays in sight below the reactions.
    let pinned = usize::from(found.balancing().is_some());
    page::draw_chosen(pen, &lines, (pen.state.chosen.reaction, pinned), &|_| Role::Plain, area);
}

/// The modulus of each reaction in this position in two scenes, and that of their difference.
fn two(state: &State, found: &Found, other: &Found) -> Table {
    let shown = |found: &Found, reaction: &Reaction| {
        let found_in = found.reactions.iter().find(|one| one.name == reaction.name);
        found_in.map(|one| found.series[one.series[one.series.len() - 1]].show(state.position))
    };
    let apart = |reaction: &Reaction| {
        let unit = found.series[reaction.series[0]].unit.name;
        difference(found, other, reaction, state.position).map(|apart| quantity(digits(apart, 5), unit))
    };
    let table = Table::each(Text::default(), &found.reactions)
        .column(text!("forces-pair"), |reaction| reaction.name.clone().short())
        .column(name("|F1|"), |reaction| shown(found, reaction))
        .column(name("|F2|"), |reaction| shown(other, reaction))
        .column(name("|F1 - F2|"), |reaction| apart(reaction));
    table.table()
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
        return row(own.short(), None, load);
    }
    let force = value(reaction.series[0]).zip(value(reaction.series[1])).map(|(x, y)| [x, y]);
    let moment = || reaction.moment.map_or_else(|| Text::default().into(), |index| value(index).into());
    row(own, Some(force.unwrap_or([f64::NAN; 2])), apart.unwrap_or_else(moment))
}

/// The chosen reaction by cause.
fn draw_causes(pen: &mut Pen<'_>, scene: &Scene, found: &Found, area: Rect) {
    let state = pen.state;
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return };
    let plans = found.plans.at(state.position);
    let Some(split) = plans.by_cause().filter(|_| has_forces(found, state.position)) else {
        pen.tell(area, 1, 0, text!("forces-not-determined"), Role::Plain);
        return;
    };
    let title = text!("forces-by-cause", reaction = &reaction.name);
    pen.tell(area, 1, 0, title, Role::Header);
    let parts = parts(split, reaction);
    let below = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    // Header, sum and total are always shown.
    let room = usize::from(below.height).saturating_sub(4);
    let table = causes(found, split, reaction, &parts, room);
    let lines = page::told(state, area.width.saturating_sub(2), |page| page.table(table));
    let rows = Constraint::Length(short(lines.len() + 1).min(below.height));
    let [rows, below] = Layout::vertical([rows, Constraint::Min(0)]).areas(below);
    page::draw(pen, &lines, 0, &|_| Role::Plain, rows);
    pen.paint(&figure(scene, &state.pictured(), ViewPart::Causes), below);
}

/// A row for each cause, their sum, and the total of the analyzer. Causes without room in so many rows are summarized.
fn causes(found: &Found, split: &Split, reaction: &Reaction, parts: &[CauseShare], room: usize) -> Table {
    let head = if reaction.of.is_some() { name("M") } else { Text::default() };
    let is_moment = reaction.of.is_some() || found.analysis.input.balancing_is_moment;
    let last = Column::short(head, Unit::load(is_moment));
    let sum_of_all = sum(parts, text!("forces-sum"));
    let whole = part(&split.whole, reaction);
    let whole = CauseShare { cause: text!("forces-whole", method = name(found.analyzer.clone())), ..whole };
    let greatest = parts.iter().chain([&whole]).map(size).fold(0.0, f64::max);
    let clean = |value: f64| zero_if_rounding(value, greatest);
    let cells = |part: CauseShare| {
        let force = part.force.map(|force| force.map(clean));
        let scalar = part.scalar.map_or_else(|| Text::default().into(), |value| clean(value).into());
        row(part.cause, force, scalar)
    };
    let single = if parts.len() > room { room.saturating_sub(1) } else { parts.len() };
    let numbered = parts.iter().enumerate().take(single).map(|(index, part)| CauseShare {
        cause: joined(" ", [number(index + 1), part.cause.clone()]),
        ..*part
    });
    let rest = &parts[single..];
    let more = (!rest.is_empty()).then(|| sum(rest, text!("forces-more-causes", count = rest.len())));
    let all = numbered.chain(more).chain([sum_of_all, whole]);
    Table::list(Text::default(), heads(text!("forces-cause"), last)).rows(all.map(cells))
}

fn size(part: &CauseShare) -> f64 {
    part.force.map_or_else(|| part.scalar.map_or(0.0, f64::abs), |[x, y]| x.hypot(y))
}

/// The columns of a table of forces: whose it is, projections, modulus and direction, and one of its own.
fn heads(first: Text, last: Column) -> [Column; 6] {
    let [x, y, size] = force_heads();
    let direction = Column::short(text!("forces-direction"), Unit::ANGLE);
    [Column::of(first), x, y, size, direction, last]
}

/// A row of it; nothing in the columns of a force where there is no vector.
fn row(first: Text, force: Option<[f64; 2]>, last: Cell) -> [Cell; 6] {
    let none = || Cell::Text(Text::default());
    let [x, y, size, direction] = force.map_or_else(
        || [none(), none(), none(), none()],
        |force| [force[0].into(), force[1].into(), force[0].hypot(force[1]).into(), direction(force).into()],
    );
    [first.into(), x, y, size, direction, last]
}
