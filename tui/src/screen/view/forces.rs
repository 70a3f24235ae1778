//! Reactions: a table of the position, the curves of one pair, its hodograph, the difference of two analyzers.

use assur_figure::{Bounds, Figure, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use assur_words::{Text, list, name, number, quantity, text, unit};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::causes;
use super::causes::{curves, direction_text, table_row};
use crate::screen::draw::{first_shown, paint, put, short};
use crate::screen::state::{Found, Part, Reaction, Role, Scene, State, View};

/// Rows of a chart below the table.
const BELOW: u16 = 9;
/// Rows that a chart needs at least.
const LEAST: u16 = 5;

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let theme = state.look.theme;
    let [title, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    put(buffer, title, 1, 0, &state.told(heading(scene, found)), theme.style(Role::Header));
    match state.part(View::Forces) {
        Part::Overview => {
            let rows = short(found.reactions.len()) + 1;
            let below = rest.height.saturating_sub(rows + 1);
            // In a low area the numbers go before the charts.
            let below = if rest.height > 2 * BELOW { below.max(BELOW) } else { below };
            let [table, below] =
                Layout::vertical([Constraint::Min(0), Constraint::Length(below)]).areas(rest);
            draw_table(state, scene, found, table, buffer);
            if below.height >= LEAST {
                paint(state, &figure(state, scene), below, buffer);
            }
        }
        Part::Causes => causes::draw(state, scene, found, rest, buffer),
        _ => paint(state, &figure(state, scene), rest, buffer),
    }
}

/// The chosen reaction: its modulus beside its hodograph, its projections, its hodograph, or its causes.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let (panels, columns) = match state.part(View::Forces) {
        Part::Causes => (causes::panels(state, scene, found), 2),
        Part::Curves => (curves(state, scene, found, &[0, 1, 2]), 1),
        Part::Hodograph => (hodograph(state, found).into_iter().collect(), 1),
        _ => {
            let mut panels = curves(state, scene, found, &[usize::MAX]);
            panels.extend(hodograph(state, found));
            let columns = panels.len().max(1);
            (panels, columns)
        }
    };
    let name = chosen(state, found).map(|reaction| reaction.name.clone()).unwrap_or_default();
    Figure { title: list([name, heading(scene, found)]), panels, columns, legend: Vec::new() }
}

fn heading(scene: &Scene, found: &Found) -> Text {
    let own = name(found.analyzer.clone());
    match &scene.other {
        Some(other) => {
            let difference = format!("{:.1e}", largest_difference(scene, found, other));
            let (theirs, difference) = (name(other.analyzer.clone()), quantity(difference, "N"));
            text!("forces-two-analyzers", one = own, other = theirs, difference = difference)
        }
        None => text!("forces-analyzer", method = own),
    }
}

/// The chosen reaction.
fn chosen<'a>(state: &State, found: &'a Found) -> Option<&'a Reaction> {
    found.reactions.get(state.chosen.reaction)
}

fn draw_table(state: &State, scene: &Scene, found: &Found, area: Rect, buffer: &mut Buffer) {
    let theme = state.look.theme;
    let (letter, of) = if scene.other.is_some() { ("|dF|", "N") } else { ("M", "N m") };
    let head = causes::head(state, text!("forces-pair"), list([name(letter), unit(of)]));
    put(buffer, area, 0, 0, &table_row(' ', head), theme.style(Role::Dim));
    let height = usize::from(area.height.saturating_sub(1));
    // The balancing load, the last one, stays in sight below the reactions.
    let last = found.reactions.len().saturating_sub(1);
    let pinned = usize::from(found.balancing().is_some() && height <= last).min(height);
    let skip = first_shown(state.chosen.reaction.min(last - pinned), height - pinned);
    let all = found.reactions.iter().enumerate();
    let shown = all.clone().skip(skip).take(height - pinned).chain(all.skip(last).take(pinned));
    for (row, (index, reaction)) in shown.enumerate() {
        let chosen = index == state.chosen.reaction;
        let style = theme.style(if chosen { Role::Cursor } else { Role::Plain });
        let [fx, fy, modulus, direction, last] = cells(state, scene, found, reaction);
        let row_cells = [reaction.name.clone(), fx, fy, modulus, direction, last];
        let row_cells = row_cells.map(|text| state.told(text));
        let text = table_row(if chosen { '>' } else { ' ' }, row_cells);
        put(buffer, area, 0, short(row) + 1, &text, style);
    }
}

fn cells(state: &State, scene: &Scene, found: &Found, reaction: &Reaction) -> [Text; 5] {
    let value = |index: usize| found.series[index].at(state.position);
    let bare = |index: usize| number(found.series[index].bare(state.position));
    let apart = scene.other.as_ref().map(|other| {
        let apart = difference(found, other, reaction, state.position);
        apart.map_or_else(|| name("-"), |apart| number(format_args!("{apart:.1e}")))
    });
    if reaction.pair.is_empty() {
        let series = &found.series[reaction.series[0]];
        let unit = series.show(state.position);
        let none = Text::default;
        return [none(), none(), unit, none(), apart.unwrap_or_default()];
    }
    let [fx, fy, modulus] = [0, 1, 2].map(|i| value(reaction.series[i]));
    let direction = if modulus > 0.0 { direction_text(fx, fy) } else { name("-") };
    let last = apart.unwrap_or_else(|| reaction.moment.map_or_else(Text::default, bare));
    [bare(reaction.series[0]), bare(reaction.series[1]), bare(reaction.series[2]), direction, last]
}

/// Modulus of the difference of a reaction by two analyzers in a position; `None` if one of them does not have it.
fn difference(found: &Found, other: &Found, reaction: &Reaction, position: usize) -> Option<f64> {
    let same = other.reactions.iter().find(|other| other.is_same(reaction))?;
    // Both projections, or the balancing load.
    let parts = reaction.series.iter().zip(&same.series).take(2);
    let apart = |(own, theirs): (&usize, &usize)| {
        found.series[*own].at(position) - other.series[*theirs].at(position)
    };
    Some(parts.map(apart).map(|part| part * part).sum::<f64>().sqrt()).filter(|size| size.is_finite())
}

/// Greatest modulus of the difference of a reaction over all positions, N.
fn largest_difference(scene: &Scene, found: &Found, other: &Found) -> f64 {
    let reactions = found.reactions.iter().filter(|reaction| !reaction.pair.is_empty());
    let all = reactions.flat_map(|reaction| {
        (0..scene.positions()).filter_map(move |position| difference(found, other, reaction, position))
    });
    all.fold(0.0, f64::max)
}

/// The path of the tip of the force over the cycle, with the force of the position.
fn hodograph(state: &State, found: &Found) -> Option<Panel> {
    let reaction = chosen(state, found).filter(|reaction| reaction.series.len() == 3)?;
    let [xs, ys] = [0, 1].map(|axis| &found.series[reaction.series[axis]]);
    let tips: Vec<Point> = xs.course.against(&ys.course);
    let bounds = Bounds::around(tips.iter().copied().chain([[0.0; 2]]));
    let tip = xs.course.get(state.position).zip(ys.course.get(state.position)).map(|(x, y)| [x, y]);
    let mut items = vec![Item::line(tips, Stroke::Dashed, Ink::Second)];
    items.extend(tip.map(|to| Item::Arrow { from: [0.0; 2], to, stroke: Stroke::Solid, ink: Ink::First }));
    items.push(Item::sign([0.0; 2], Sign::Plus, Ink::Title));
    let frame = Frame::Plane { bounds, unit: "N".into(), factor: 1.0, scale: ("F", "N".into()) };
    Some(Panel { title: text!("forces-hodograph", reaction = &reaction.name), frame, items })
}
