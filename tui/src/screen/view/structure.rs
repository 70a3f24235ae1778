//! Formula, groups as a tree, and the chosen group marked in the drawing.

use std::ops::Range;

use assur_book::Unit;
use assur_figure::Figure;
use assur_picture::Picture;
use assur_picture::mechanism::structure;
use assur_report::topic;
use assur_words::{self as words, Text, list, name, number, ordinal, text};
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::number::{digits, plain};
use crate::screen::draw::{Pen, cut, short, wrapped};
use crate::screen::state::{Role, Scene, State, View, ViewPart};

/// Indent of the text on a group, in columns.
const INDENT: usize = 5;
/// How a line begins that belongs to the group above it.
const NEXT: &str = "   ";
/// Rows of the axis below the bands of the events.
const AXIS: u16 = 3;
/// Rows of a drawing below the text.
const DRAWING: u16 = 24;
/// Digits of the least determinant.
const LEAST: usize = 3;

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    if state.part(View::Structure) == ViewPart::Events {
        return events(pen, scene, area);
    }
    let [top, tree, drawing] = parts(state, scene, area);
    let groups = &scene.linkage.structure;
    let head = |text: &str| cut(text, usize::from(top.width.saturating_sub(2)));
    pen.put(top, 1, 0, &head(&state.told(&groups.formula)), Role::Header);
    let w = &groups.mobility;
    let mobility = text!(
        "structure-mobility",
        links = number(w.moving_links),
        pairs = number(w.pairs),
        mobility = number(w.value),
        class = name(assur_structure::roman(groups.class())),
    );
    pen.tell(top, 1, 1, mobility, Role::Plain);
    if let Some((group, health, at)) = scene.nearest_group() {
        let (determinant, position) = (number(digits(health, LEAST)), number(at));
        let group = groups.group_name(&scene.linkage.mechanism, group).short();
        let nearest = text!("structure-nearest", determinant, position, group);
        pen.put(top, 1, 2, &head(&state.told(nearest)), Role::Plain);
    }
    let lines = lines(state, scene, tree.width.saturating_sub(2));
    let Range { start, end } = of_chosen(state, &lines);
    let height = usize::from(tree.height);
    let below = end.saturating_sub(height);
    let skip = below.min(start + state.chosen.row);
    let text = Rect { width: tree.width.saturating_sub(1), ..tree };
    pen.put_lines(text, 1, lines.iter().skip(skip).take(height));
    pen.mark_rows(tree, skip..lines.len().min(skip + height), lines.len());
    pen.paint_zoomed(&structure(scene, &state.pictured()), state.zoom, drawing);
}

/// The events of the cycle, of which one is chosen, and below them their bands.
fn events(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let (state, Some(found)) = (pen.state, &scene.found) else { return };
    let [title, area] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
    pen.tell(title, 1, 0, text!("events-title"), Role::Header);
    let unit = Unit::coordinate(scene.linkage.kind());
    let lines = page::told(state, area.width.saturating_sub(2), |page| {
        topic::list_of_events(&found.events, unit, page);
        if !found.linkage.mechanism.input.is_cycle() {
            page.paragraph(text!("events-of-turn"));
        }
        if found.analysis.friction.as_ref().is_some_and(|friction| friction.dead_angles.is_empty()) {
            page.paragraph(text!("events-no-dead-angle"));
        }
    });
    let bands = found.events.iter().map(|event| event.band).max().unwrap_or(0);
    let rows = Constraint::Length(short(lines.len()) + 1);
    let [list, below] = Layout::vertical([rows, Constraint::Min(short(bands) + AXIS)]).areas(area);
    page::draw_chosen(pen, &lines, (state.chosen.event, 0), &|_| Role::Plain, list);
    let figure = Picture::Structure.figure(scene, &state.pictured(), ViewPart::Events);
    pen.paint(&Figure { legend: Vec::new(), title: Text::default(), ..figure }, below);
}

/// What stands above, the tree, and the drawing, which in a high area has the whole width below the tree.
fn parts(state: &State, scene: &Scene, area: Rect) -> [Rect; 3] {
    let [top, rest] = Layout::vertical([Constraint::Length(4), Constraint::Min(0)]).areas(area);
    let text = lines(state, scene, rest.width.saturating_sub(2)).len();
    let [tree, drawing] = if usize::from(rest.height) >= text + usize::from(DRAWING) {
        Layout::vertical([Constraint::Length(short(text) + 1), Constraint::Min(0)]).areas(rest)
    } else {
        Layout::horizontal([Constraint::Percentage(58), Constraint::Min(0)]).areas(rest)
    };
    [top, tree, drawing]
}

/// The lines of the chosen group with all that is told of it, of the first one from the beginning of the list, of the last one to its
/// end.
fn of_chosen(state: &State, lines: &[(Role, String)]) -> Range<usize> {
    let first = lines.iter().position(|line| line.0 == Role::Cursor).unwrap_or(0);
    let is_next = |line: &(Role, String)| !line.1.starts_with(NEXT);
    let end = lines.iter().skip(first + 1).position(is_next).map_or(lines.len(), |more| first + 1 + more);
    if state.chosen.group == 0 { 0..end } else { first..end }
}

/// The lines of all groups, of which the chosen one is expanded.
#[cfg(test)]
pub(crate) fn of_groups(state: &State, scene: &Scene, area: Rect) -> Vec<String> {
    let tree = parts(state, scene, area)[1];
    lines(state, scene, tree.width.saturating_sub(2)).into_iter().map(|(_, line)| line).collect()
}

/// How many rows of the chosen group are out of sight while its first one is on top.
pub(crate) fn hidden(state: &State, scene: &Scene) -> usize {
    let tree = parts(state, scene, super::room(state))[1];
    let lines = lines(state, scene, tree.width.saturating_sub(2));
    of_chosen(state, &lines).len().saturating_sub(tree.height.into())
}

/// The tree; only the chosen group is expanded.
fn lines(state: &State, scene: &Scene, width: u16) -> Vec<(Role, String)> {
    let linkage = &scene.linkage;
    let mechanism = &linkage.mechanism;
    let input = assur_book::driven_link(mechanism);
    let drivers = mechanism.input.drivers.iter();
    let pair = words::list(drivers.map(|driver| Text::from(mechanism.pair_name(driver.pair_id()))));
    let mut lines = vec![(Role::Plain, state.told(text!("structure-input", link = input, ground = pair)))];
    if let Some(joined) = state.joined {
        let with = (1..=joined).map(|group| text!("structure-with-group", group = number(group)));
        let (with, next) = (words::joined("", with), name(state.keys.first("join")));
        lines.push((Role::Plain, state.told(text!("structure-drawn", groups = with, key = next))));
    }
    let room = usize::from(width).saturating_sub(INDENT);
    let indented = |text: Text, indent: usize| {
        let rows = wrapped(&state.told(text), room).into_iter();
        rows.map(move |line| (Role::Plain, format!("{:indent$}{line}", "")))
    };
    for (index, group) in linkage.structure.groups.iter().enumerate() {
        let chosen = index == state.chosen.group;
        let (sign, role) = if chosen { ("> ", Role::Cursor) } else { ("  ", Role::Plain) };
        let named = state.told(linkage.structure.group_name(mechanism, index));
        lines.push((role, cut(&format!("{sign}{named}"), width.into())));
        if let Some((health, at)) = scene.least_health(index) {
            let (least, at) = (number(digits(health, LEAST)), number(at));
            lines.extend(indented(text!("structure-least", determinant = least, position = at), INDENT));
        }
        if chosen {
            let details = details(state, scene, group, index).into_iter();
            lines.extend(details.flat_map(|line| indented(line, INDENT)));
        }
    }
    for passive in &linkage.misfits {
        lines.extend(indented(topic::passive_part(passive, linkage.kind()), NEXT.len()));
    }
    lines
}

fn details(state: &State, scene: &Scene, group: &assur_structure::Group, index: usize) -> Vec<Text> {
    let (linkage, mechanism, position) = (&scene.linkage, &scene.linkage.mechanism, state.position);
    let links = list(group.frame.links.iter().map(|&link| (&mechanism.links[link].name).into()));
    let pairs = |pairs: &[assur_group::Pair]| {
        list(pairs.iter().map(|pair| Text::from(linkage.structure.pair_name(mechanism, pair.id))))
    };
    let (class, order) = (name(assur_structure::roman(group.class)), number(group.order));
    let kind = match group.plugin.number {
        0 => text!("structure-kind-named", class, kind = name(group.plugin.kind), order),
        kind => text!("structure-kind", class, kind = number(kind), order),
    };
    let mut lines = vec![
        kind,
        text!("structure-view-links", links = links),
        text!("structure-inner", pairs = pairs(&group.frame.inner)),
        text!("structure-outer", pairs = pairs(&group.outer())),
    ];
    let driven: Vec<_> = group.frame.driven.iter().map(|driven| driven.pair).collect();
    if !driven.is_empty() {
        lines.push(text!("structure-driven", pairs = pairs(&driven)));
    }
    if let Some(pose) = scene.pose(position, 0.0) {
        // A mode has one number over the whole cycle: that in the first position.
        if let Some(modes) = scene.modes(index, 0) {
            let (mode, count) = (ordinal(modes.number(modes.present)), number(modes.all.len()));
            lines.push(text!("structure-mode-of", mode = mode, count = count));
            let shown = state.mode_of(index).and_then(|shown| Some((shown, modes.all.get(shown)?)));
            if let Some((shown, found)) = shown {
                let (mode, take) = (ordinal(modes.number(shown)), name(state.keys.first("take-mode")));
                let determinant = number(plain(found.health));
                lines.push(text!("structure-mode", mode = mode, determinant = determinant, key = take));
            } else if modes.all.len() > 1 && position == 0 {
                lines.push(text!("structure-modes", key = name(state.keys.first("next-mode"))));
            }
        }
        let determinant = number(plain(pose.health[index].abs()));
        lines.push(text!("structure-determinant", determinant = determinant));
    }
    let plugin = group.plugin;
    let (own, home) = (name(plugin.name), name(plugin.crate_name));
    lines.push(text!("structure-singular", places = &plugin.singular));
    lines.push(text!("structure-plugin", name = own, crate_name = home));
    lines.push(text!("structure-source", source = &plugin.source));
    lines
}
