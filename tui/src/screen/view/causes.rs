//! The chosen reaction by cause: the shares of weight, inertia and each load, which sum to the total; and what all panes of the
//! forces have: rows of tables, directions, curves.

use std::fmt::Write;

use assur_diagram::{JointForce, Share, Split};
use assur_figure::{Figure, Ink, Panel};
use assur_words::{self as words, Text, list, name, quantity, text, unit};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::plans;
use super::plots::{self, Vector};
use crate::number::number;
use crate::screen::draw::{paint, put, short};
use crate::screen::state::{Found, Reaction, Role, Scene, State};

/// A share this small compared with the greatest one counts as zero.
const ROUNDING: f64 = 1e-13;

/// The share of one cause in the chosen reaction.
struct Part {
    cause: Text,
    /// Projections, N; `None` for the balancing load.
    force: Option<[f64; 2]>,
    /// Moment of a slide, or the balancing load.
    scalar: Option<f64>,
}

/// Draws the pane.
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
    let rows = short(parts.len()) + 4;
    let below = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    let [table, below] =
        Layout::vertical([Constraint::Length(rows.min(below.height)), Constraint::Min(0)]).areas(below);
    draw_table(state, found, split, reaction, &parts, table, buffer);
    let panels = figure_panels(state, scene, found, &parts);
    paint(state, &Figure { panels, columns: 2, ..Figure::default() }, below, buffer);
}

/// The modulus of the chosen reaction, and its causes head to tail.
pub(super) fn panels(state: &State, scene: &Scene, found: &Found) -> Vec<Panel> {
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return Vec::new() };
    let plans = found.plans.at(state.position);
    let split = plans.sheet.as_ref().ok().and_then(|sheet| sheet.by_cause.as_ref());
    let parts = split.map(|split| parts(split, reaction)).unwrap_or_default();
    figure_panels(state, scene, found, &parts)
}

fn figure_panels(state: &State, scene: &Scene, found: &Found, parts: &[Part]) -> Vec<Panel> {
    let mut panels = curves(state, scene, found, &[usize::MAX]);
    panels.extend(sum_of(parts));
    panels
}

fn parts(split: &Split, reaction: &Reaction) -> Vec<Part> {
    split.shares.iter().map(|share| part(share, reaction)).collect()
}

fn part(share: &Share, reaction: &Reaction) -> Part {
    let cause = share.cause.clone();
    if reaction.pair.is_empty() {
        return Part { cause, force: None, scalar: Some(share.balancing) };
    }
    let here = |force: &&JointForce| force.joint == reaction.pair && force.on == reaction.link;
    let found = share.reactions.iter().find(here);
    Part { cause, force: found.map(|found| found.force), scalar: found.and_then(|found| found.moment) }
}

/// A row for each cause, their sum, and the total of the analyzer.
fn draw_table(
    state: &State,
    found: &Found,
    split: &Split,
    reaction: &Reaction,
    parts: &[Part],
    area: Rect,
    buffer: &mut Buffer,
) {
    let theme = state.look.theme;
    let scalar = if reaction.pair.is_empty() { found.series[reaction.series[0]].unit.as_str() } else { "" };
    let last = if scalar.is_empty() { symbol("M", "N m") } else { unit(scalar.to_owned()) };
    put(
        buffer,
        area,
        0,
        0,
        &table_row(' ', head(state, text!("forces-cause"), last)),
        theme.style(Role::Dim),
    );
    let sum = sum(parts, text!("forces-sum"));
    let whole = part(&split.whole, reaction);
    let whole = Part { cause: text!("forces-whole", method = name(found.analyzer.clone())), ..whole };
    let least = ROUNDING * parts.iter().chain([&whole]).map(size).fold(0.0, f64::max);
    // Header, sum and total are always shown; causes without room are summarized.
    let room = usize::from(area.height).saturating_sub(3);
    let single = if parts.len() > room { room.saturating_sub(1) } else { parts.len() };
    for (number, part) in parts.iter().enumerate().take(single) {
        let text = row_of(state, &format!("{} {}", number + 1, state.told(&part.cause)), part, least);
        put(buffer, area, 0, short(number) + 1, &text, theme.style(Role::Plain));
    }
    let mut below = short(single) + 1;
    if single < parts.len() {
        let rest = self::sum(&parts[single..], text!("forces-more-causes", count = parts.len() - single));
        let text = row_of(state, &state.told(&rest.cause), &rest, least);
        put(buffer, area, 0, below, &text, theme.style(Role::Plain));
        below += 1;
    }
    let [sum, whole] = [sum, whole].map(|part| row_of(state, &state.told(&part.cause), &part, least));
    put(buffer, area, 0, below, &sum, theme.style(Role::Header));
    put(buffer, area, 0, below + 1, &whole, theme.style(Role::Plain));
}

/// The greatest number of a share.
fn size(part: &Part) -> f64 {
    part.force.map_or_else(|| part.scalar.map_or(0.0, f64::abs), |[x, y]| x.hypot(y))
}

fn sum(parts: &[Part], cause: Text) -> Part {
    let mut sum = Part { cause, force: None, scalar: None };
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

fn row_of(state: &State, cause: &str, part: &Part, least: f64) -> String {
    let shown = |value: f64| {
        if value.abs() <= least { "0".to_owned() } else { state.told(words::number(number(value))) }
    };
    let force = part.force.map(|[x, y]| {
        let [x, y] = [x, y].map(|v| if v.abs() <= least { 0.0 } else { v });
        [shown(x), shown(y), shown(x.hypot(y)), state.told(direction_text(x, y))]
    });
    let [fx, fy, f, direction] = force.unwrap_or_default();
    let scalar = part.scalar.map(shown).unwrap_or_default();
    table_row(' ', [cause.to_owned(), fx, fy, f, direction, scalar])
}

/// The shares head to tail, and the total from the first corner to the last one.
fn sum_of(parts: &[Part]) -> Option<Panel> {
    let mut at = [0.0; 2];
    let mut vectors = Vec::new();
    for (number, part) in parts.iter().enumerate() {
        let Some([x, y]) = part.force.filter(|[x, y]| *x != 0.0 || *y != 0.0) else { continue };
        let to = [at[0] + x, at[1] + y];
        vectors.push(Vector { from: at, to, name: name((number + 1).to_string()), ink: Ink::Second });
        at = to;
    }
    vectors.push(Vector { from: [0.0; 2], to: at, name: text!("forces-sum"), ink: Ink::First });
    (vectors.len() > 1).then(|| plots::vectors(Text::default(), &vectors, ("N", "F"), None))
}

/// Columns of the table: where each ends.
const ENDS: [u16; 5] = [35, 46, 57, 69, 79];

/// A row of a table of forces: a sign, the name at the left, the other cells right-aligned in their columns.
pub(super) fn table_row(sign: char, [name, cells @ ..]: [String; 6]) -> String {
    let mut text = format!("{sign}{name}");
    for (cell, end) in cells.into_iter().zip(ENDS) {
        let width = usize::from(end).saturating_sub(text.chars().count()).max(cell.chars().count() + 1);
        let _ = write!(text, "{cell:>width$}");
    }
    text
}

/// Direction of a force in words; a dash where there is none.
pub(super) fn direction_text(fx: f64, fy: f64) -> Text {
    if fx == 0.0 && fy == 0.0 { name("-") } else { quantity(format_args!("{:.2}", direction(fx, fy)), "deg") }
}

/// A symbol with its unit: `F, N`.
fn symbol(letters: &'static str, of: &'static str) -> Text {
    list([name(letters), unit(of)])
}

/// The heads of a table of forces.
pub(super) fn head(state: &State, first: Text, last: Text) -> [String; 6] {
    let [x, y, size] = ["Fx", "Fy", "F"].map(|letters| symbol(letters, "N"));
    [first, x, y, size, text!("forces-direction"), last].map(|text| state.told(text))
}

/// Direction of a force in (-180, 180], degrees; components that are rounding compared with the modulus do not change
/// it.
fn direction(fx: f64, fy: f64) -> f64 {
    let least = 1e-12 * fx.hypot(fy);
    let part = |v: f64| if v.abs() <= least { 0.0 } else { v };
    part(fy).atan2(part(fx)).to_degrees()
}

/// Curves of the chosen reaction, with the given series; for one that it does not have, the last one.
pub(super) fn curves(state: &State, scene: &Scene, found: &Found, which: &[usize]) -> Vec<Panel> {
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return Vec::new() };
    let mut wanted: Vec<usize> =
        which.iter().map(|i| (*i).min(reaction.series.len() - 1)).map(|i| reaction.series[i]).collect();
    wanted.dedup();
    super::curves::stack(state, scene, found, scene.other.as_deref(), &wanted)
}
