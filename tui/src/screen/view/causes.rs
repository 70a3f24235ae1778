//! The chosen reaction by cause as a table; and what all tables of forces have: their columns.

use assur_book::{Cell, Column, Table, Unit};
use assur_diagram::Split;
use assur_picture::causes::{CauseShare, part, parts, sum};
use assur_picture::forces;
use assur_picture::plans::has_forces;
use assur_report::topic::{direction, force_heads};
use assur_words::{Text, joined, name, number, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::screen::draw::{paint, put, short};
use crate::screen::state::{Found, Reaction, Role, Scene, State, ViewPart};

/// A share this small compared with the greatest one counts as zero.
const ROUNDING: f64 = 1e-13;

pub(super) fn draw(state: &State, scene: &Scene, found: &Found, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return };
    let plans = found.plans.at(state.position);
    let Some(split) = plans.by_cause().filter(|_| has_forces(found, state.position)) else {
        put(buffer, area, 1, 0, &state.told(text!("forces-not-determined")), theme.style(Role::Plain));
        return;
    };
    let title = text!("forces-by-cause", reaction = &reaction.name);
    put(buffer, area, 1, 0, &state.told(title), theme.style(Role::Header));
    let parts = parts(split, reaction);
    let below = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    // Header, sum and total are always shown.
    let room = usize::from(below.height).saturating_sub(4);
    let table = table(found, split, reaction, &parts, room);
    let lines = page::told(state, area.width.saturating_sub(2), |page| page.table(table));
    let rows = Constraint::Length(short(lines.len() + 1).min(below.height));
    let [rows, below] = Layout::vertical([rows, Constraint::Min(0)]).areas(below);
    page::draw(state, &lines, &|_| Role::Plain, rows, buffer);
    paint(state, &forces::figure(scene, &state.pictured(), ViewPart::Causes), below, buffer);
}

/// A row for each cause, their sum, and the total of the analyzer. Causes without room in so many rows are summarized.
fn table(found: &Found, split: &Split, reaction: &Reaction, parts: &[CauseShare], room: usize) -> Table {
    let head = if reaction.of.is_some() { name("M") } else { Text::default() };
    let is_moment = reaction.of.is_some() || found.analysis.input.balancing_is_moment;
    let last = Column::short(head, Unit::load(is_moment));
    let sum_of_all = sum(parts, text!("forces-sum"));
    let whole = part(&split.whole, reaction);
    let whole = CauseShare { cause: text!("forces-whole", method = name(found.analyzer.clone())), ..whole };
    let least = ROUNDING * parts.iter().chain([&whole]).map(size).fold(0.0, f64::max);
    let clean = |value: f64| if value.abs() <= least { 0.0 } else { value };
    let cells = |part: CauseShare| {
        let force = part.force.map(|force| force.map(clean));
        row(
            part.cause,
            force,
            part.scalar.map_or_else(|| Text::default().into(), |value| clean(value).into()),
        )
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
pub(super) fn heads(first: Text, last: Column) -> [Column; 6] {
    let [x, y, size] = force_heads();
    let direction = Column::short(text!("forces-direction"), Unit::ANGLE);
    [Column::of(first), x, y, size, direction, last]
}

/// A row of it; nothing in the columns of a force where there is no vector.
pub(super) fn row(first: Text, force: Option<[f64; 2]>, last: Cell) -> [Cell; 6] {
    let none = || Cell::Text(Text::default());
    let [x, y, size, direction] = force.map_or_else(
        || [none(), none(), none(), none()],
        |force| [force[0].into(), force[1].into(), force[0].hypot(force[1]).into(), direction(force).into()],
    );
    [first.into(), x, y, size, direction, last]
}
