//! Formula, groups as a tree, and the chosen group marked in the drawing.

use assur_figure::Figure;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::mechanism;
use crate::number::{digits, plain};
use crate::screen::draw::{cut, paint_zoomed, put, short, wrapped};
use crate::screen::state::{Role, Scene, State};

/// Indent of the text on a group, in columns.
const INDENT: usize = 5;
/// Rows of a drawing below the text.
const DRAWING: u16 = 24;
/// Digits of the least determinant.
const LEAST: usize = 3;

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let [top, rest] = Layout::vertical([Constraint::Length(4), Constraint::Min(0)]).areas(area);
    let text = lines(state, scene, rest.width.saturating_sub(2)).len();
    // In a high area the drawing has the whole width below the text.
    let [tree, drawing] = if usize::from(rest.height) >= text + usize::from(DRAWING) {
        Layout::vertical([Constraint::Length(short(text) + 1), Constraint::Min(0)]).areas(rest)
    } else {
        Layout::horizontal([Constraint::Percentage(58), Constraint::Min(0)]).areas(rest)
    };
    let theme = state.look.theme;
    let structure = &scene.linkage.structure;
    put(buffer, top, 1, 0, &structure.formula, theme.style(Role::Header));
    let w = &structure.mobility;
    let mobility = format!("mobility W = 3 n - 2 p = 3 * {} - 2 * {} = {}", w.moving_links, w.pairs, w.value);
    let class = format!("mechanism of class {}", assur_structure::roman(structure.class()));
    let words = state.words();
    put(buffer, top, 1, 1, &words.shown(&format!("{mobility};  {class}")), theme.style(Role::Plain));
    if let Some((group, health, at)) = scene.nearest_group() {
        let name = structure.group_name(&scene.linkage.mechanism, group);
        let nearest =
            words.shown(&format!("nearest to singular: {} at position {at}, {name}", digits(health, LEAST)));
        let nearest = cut(&nearest, usize::from(top.width.saturating_sub(2)));
        put(buffer, top, 1, 2, &nearest, theme.style(Role::Plain));
    }
    let lines = lines(state, scene, tree.width.saturating_sub(2));
    let first = lines.iter().position(|line| line.0).unwrap_or(0);
    let height = usize::from(tree.height);
    let skip = (first + 10).saturating_sub(height).min(lines.len().saturating_sub(height));
    for (row, (chosen, text)) in lines.iter().skip(skip).take(height).enumerate() {
        let style = theme.style(if *chosen { Role::Cursor } else { Role::Plain });
        let wide = Rect { width: tree.width.saturating_sub(1), ..tree };
        put(buffer, wide, 1, short(row), text, style);
    }
    paint_zoomed(state, &figure(state, scene), state.zoom, drawing, buffer);
}

/// The mechanism with the chosen group marked.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    let group = scene.linkage.structure.groups.get(state.chosen.group);
    let marked = group.map_or(&[][..], |group| &group.frame.links);
    mechanism::figure(state, scene, marked)
}

/// The tree; the heading of the chosen group is flagged, and only that group is expanded.
fn lines(state: &State, scene: &Scene, width: u16) -> Vec<(bool, String)> {
    let linkage = &scene.linkage;
    let mechanism = &linkage.mechanism;
    let input = &mechanism.links[mechanism.input.link].name;
    let pair = match mechanism.input.pair {
        assur_mechanism::InputPair::Pin(point) => &mechanism.points[point].name,
        assur_mechanism::InputPair::Slide(slide) => &mechanism.slides[slide].name,
    };
    let words = state.words();
    let mut lines = vec![(false, words.shown(&format!("input link {input} on {pair}")))];
    if let Some(joined) = state.joined {
        let with = (1..=joined).map(|group| format!(", with group {group}")).collect::<Vec<_>>().concat();
        let next = state.keys.first("join");
        lines.push((false, format!("drawn: input link{with} ({next}: next)")));
    }
    for (index, group) in linkage.structure.groups.iter().enumerate() {
        let chosen = index == state.chosen.group;
        let sign = if chosen { "> " } else { "  " };
        let name = words.shown(&linkage.structure.group_name(mechanism, index).to_string());
        lines.push((chosen, format!("{sign}{name}")));
        if let Some((health, at)) = scene.least_health(index) {
            let least = words.shown(&format!("least determinant {} at position {at}", digits(health, LEAST)));
            lines.push((false, format!("{:INDENT$}{least}", "")));
        }
        if chosen {
            let rows = details(state, scene, group, index).into_iter();
            let rows =
                rows.flat_map(|line| wrapped(&words.shown(&line), usize::from(width).saturating_sub(INDENT)));
            lines.extend(rows.map(|line| (false, format!("{:INDENT$}{line}", ""))));
        }
    }
    lines
}

fn details(state: &State, scene: &Scene, group: &assur_structure::Group, index: usize) -> Vec<String> {
    let linkage = &scene.linkage;
    let links: Vec<&str> =
        group.frame.links.iter().map(|&link| linkage.mechanism.links[link].name.as_str()).collect();
    let names = |pairs: &[assur_group::Pair]| {
        let names: Vec<&str> = pairs
            .iter()
            .map(|pair| linkage.structure.pair_name(&linkage.mechanism, pair.id).as_str())
            .collect();
        names.join(", ")
    };
    let mut lines = vec![
        format!(
            "class {}, type {}, order {}",
            assur_structure::roman(group.class),
            group.plugin.number,
            group.order
        ),
        format!("links: {}", links.join(", ")),
        format!("inner pairs: {}", names(&group.frame.inner)),
        format!("outer pairs: {}", names(&group.frame.outer)),
    ];
    if let Some(Some(pose)) = scene.poses.get(state.position) {
        let way = linkage.ways.at(pose.coordinate)[index];
        lines.push(format!("assembly: way {way} of {}", linkage.groups()[index].ways()));
        lines.push(format!("determinant here: {}", plain(pose.health[index].abs())));
    }
    lines.push(format!("plugin: {} ({})", group.plugin.name, group.plugin.crate_name));
    lines.push(format!("source: {}", group.plugin.source));
    lines.push(format!("singular: {}", group.plugin.singular));
    lines
}
