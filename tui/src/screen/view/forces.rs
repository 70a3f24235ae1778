//! Reactions: a table of the position, the curves of one pair, its hodograph, the difference of two analyzers.

use assur_book::{Cell, Column, Table, Unit};
use assur_figure::{Bounds, Figure, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use assur_picture::friction;
use assur_words::{Text, list, name, number, quantity, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::causes::{self, curves};
use super::curves::together;
use super::page;
use crate::screen::draw::{paint, put, short};
use crate::screen::state::{Found, Purpose, Reaction, Role, Scene, Series, State, View, ViewPart};

/// Rows of a chart below the table.
const BELOW: u16 = 9;
/// Rows that a chart needs at least.
const LEAST: u16 = 5;

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let theme = state.look.theme;
    let [title, rest] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    put(buffer, title, 1, 0, &state.told(heading(state, scene, found)), theme.style(Role::Header));
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
                paint(state, &figure(state, scene), below, buffer);
            }
        }
        ViewPart::Causes => causes::draw(state, scene, found, rest, buffer),
        _ => paint(state, &figure(state, scene), rest, buffer),
    }
}

/// The chosen reaction: its modulus beside its hodograph, its projections, its hodograph, or its causes.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let part = state.part(View::Forces);
    let panels = match part {
        ViewPart::Causes => causes::panels(state, scene, found),
        // The curves of a second analyzer or scene need frames of their own.
        ViewPart::Curves if scene.other.is_none() && state.compared.is_none() => {
            let all = chosen(state, found).map_or(&[][..], |reaction| &reaction.series);
            let all: Vec<&Series> = all.iter().map(|index| &found.series[*index]).collect();
            return Figure { title: heading(state, scene, found), ..together(state, scene, &all) };
        }
        ViewPart::Curves => curves(state, scene, found, &[0, 1, 2]),
        ViewPart::Hodograph => {
            let mut panels: Vec<Panel> = hodograph(state, found).into_iter().collect();
            let touching = |reaction| beside_friction(found, state.position, reaction);
            panels.extend(chosen(state, found).and_then(touching));
            panels
        }
        _ => curves(state, scene, found, &[usize::MAX]).into_iter().chain(hodograph(state, found)).collect(),
    };
    let columns = match part {
        ViewPart::Causes => 2,
        ViewPart::Curves => 1,
        _ => panels.len().max(1),
    };
    let name = chosen(state, found).map(|reaction| reaction.name.clone()).unwrap_or_default();
    Figure { title: list([name, heading(state, scene, found)]), panels, columns, legend: Vec::new() }
}

/// The reaction of a pair with friction in a position, as the textbooks draw it; `None` without friction or force.
pub(crate) fn beside_friction(found: &Found, position: usize, reaction: &Reaction) -> Option<Panel> {
    let (pair, link) = reaction.of.as_ref()?;
    friction::panel(found, position, (pair.id, link.id), &reaction.name)
}

fn heading(state: &State, scene: &Scene, found: &Found) -> Text {
    let own = name(found.analyzer.clone());
    let calculating = state.running.iter().any(|running| running.purpose == Purpose::Difference);
    match &scene.other {
        // One method has no difference to itself.
        Some(other) if other.analyzer != found.analyzer => {
            let difference = format!("{:.1e}", largest_difference(scene, found, other));
            let (theirs, difference) = (name(other.analyzer.clone()), quantity(difference, "N"));
            text!("forces-two-analyzers", one = own, other = theirs, difference = difference)
        }
        _ if calculating => text!("forces-calculating", method = own),
        _ => text!("forces-analyzer", method = own),
    }
}

fn chosen<'a>(state: &State, found: &'a Found) -> Option<&'a Reaction> {
    found.reactions.get(state.chosen.reaction)
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

/// Modulus of the difference of a reaction by two analyzers in a position; `None` if one of them does not have it.
fn difference(found: &Found, other: &Found, reaction: &Reaction, position: usize) -> Option<f64> {
    let same = other.reactions.iter().find(|other| other.of == reaction.of)?;
    // Both projections, or the balancing load.
    let parts = reaction.series.iter().zip(&same.series).take(2);
    let apart = |(own, theirs): (&usize, &usize)| {
        found.series[*own].at(position) - other.series[*theirs].at(position)
    };
    Some(parts.map(apart).map(|part| part * part).sum::<f64>().sqrt()).filter(|size| size.is_finite())
}

/// Greatest modulus of the difference of a reaction over all positions, N.
fn largest_difference(scene: &Scene, found: &Found, other: &Found) -> f64 {
    let reactions = found.reactions.iter().filter(|reaction| reaction.of.is_some());
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
