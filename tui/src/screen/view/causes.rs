//! The chosen reaction by cause: the shares of weight, inertia and each load, which sum to the total; and what all panes of the
//! forces have: columns of tables, curves.

use assur_book::{Cell, Column, Table, Unit};
use assur_diagram::{JointForce, Share, Split};
use assur_figure::{Figure, Ink, Panel};
use assur_report::topic::{direction, force_heads};
use assur_words::{Text, joined, name, number, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{page, plans};
use crate::screen::draw::{paint, put, short};
use crate::screen::state::{Found, Reaction, Role, Scene, State};
use assur_picture::plots::{self, Vector};

/// A share this small compared with the greatest one counts as zero.
const ROUNDING: f64 = 1e-13;

/// The share of one cause in the chosen reaction.
struct CauseShare {
    cause: Text,
    /// Projections, N; `None` for the balancing load.
    force: Option<[f64; 2]>,
    /// Moment of a slide, or the balancing load.
    scalar: Option<f64>,
}

pub(super) fn draw(state: &State, scene: &Scene, found: &Found, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return };
    let plans = found.plans.at(state.position);
    let split = plans.sheet.as_ref().ok().and_then(|sheet| sheet.by_cause.as_ref());
    let Some(split) = split.filter(|_| plans::has_forces(state, found)) else {
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
    let panels = panels(state, scene, found);
    paint(state, &Figure { panels, columns: 2, ..Figure::default() }, below, buffer);
}

/// The modulus of the chosen reaction, and its causes head to tail.
pub(super) fn panels(state: &State, scene: &Scene, found: &Found) -> Vec<Panel> {
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return Vec::new() };
    let plans = found.plans.at(state.position);
    let split = plans.sheet.as_ref().ok().and_then(|sheet| sheet.by_cause.as_ref());
    let parts = split.map(|split| parts(split, reaction)).unwrap_or_default();
    let mut panels = curves(state, scene, found, &[usize::MAX]);
    panels.extend(sum_of(&parts));
    panels
}

fn parts(split: &Split, reaction: &Reaction) -> Vec<CauseShare> {
    split.shares.iter().map(|share| part(share, reaction)).collect()
}

fn part(share: &Share, reaction: &Reaction) -> CauseShare {
    let cause = share.cause.clone();
    let Some((pair, link)) = &reaction.of else {
        return CauseShare { cause, force: None, scalar: Some(share.balancing) };
    };
    let here = |force: &&JointForce| force.joint.id == pair.id && force.on.id == link.id;
    let found = share.reactions.iter().find(here);
    CauseShare { cause, force: found.map(|found| found.force), scalar: found.and_then(|found| found.moment) }
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

fn sum(parts: &[CauseShare], cause: Text) -> CauseShare {
    let mut sum = CauseShare { cause, force: None, scalar: None };
    for part in parts {
        if let Some([x, y]) = part.force {
            let [sx, sy] = sum.force.unwrap_or_default();
            sum.force = Some([sx + x, sy + y]);
        }
        if let Some(scalar) = part.scalar {
            sum.scalar = Some(sum.scalar.unwrap_or_default() + scalar);
        }
    }
    sum
}

/// The shares head to tail, and the total from the first corner to the last one.
fn sum_of(parts: &[CauseShare]) -> Option<Panel> {
    let mut at = [0.0; 2];
    let mut vectors = Vec::new();
    for (number, part) in parts.iter().enumerate() {
        let Some([x, y]) = part.force.filter(|[x, y]| *x != 0.0 || *y != 0.0) else { continue };
        let to = [at[0] + x, at[1] + y];
        vectors.push(Vector::arrow(at, to, name((number + 1).to_string()), Ink::Second));
        at = to;
    }
    vectors.push(Vector::arrow([0.0; 2], at, text!("forces-sum"), Ink::First));
    (vectors.len() > 1).then(|| plots::vectors(Text::default(), &vectors, ("N", "F"), None))
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

/// Curves of the chosen reaction, with the given series; for one that it does not have, the last one.
pub(super) fn curves(state: &State, scene: &Scene, found: &Found, which: &[usize]) -> Vec<Panel> {
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return Vec::new() };
    let mut wanted: Vec<usize> =
        which.iter().map(|i| (*i).min(reaction.series.len() - 1)).map(|i| reaction.series[i]).collect();
    wanted.dedup();
    super::curves::stack(state, scene, found, scene.other.as_deref(), &wanted)
}
