//! PF0, PF1, PF2 of one quantity, stacked over one axis; or the quantities that were picked, those of one unit over each other,
//! with their extremes and means.

use assur_figure::{Figure, Ink, Item, Key, Panel, Sample, Sign, Stroke};
use assur_words::{self as words, Text, joined, list, name, quantity, text, unit};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use unicode_width::UnicodeWidthStr;

use super::plots::over_positions;
use crate::number::{digits, number};
use crate::screen::draw::{cut, paint, put, put_lines, short};
use crate::screen::state::{Compared, Found, Role, Scene, Series, State, coordinate_unit};

/// What the signs on the curves are. The zeros of the first derivative mark extremes, those of the second one inflections.
const SIGNS: [(Sign, &str); 3] =
    [(Sign::Cross, "curve-zero"), (Sign::Ring, "curve-extreme"), (Sign::Plus, "curve-inflection")];

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    if !state.picked.is_empty() {
        return draw_picked(state, scene, area, buffer);
    }
    let [title, charts] = parts(area);
    let figure = figure(state, scene);
    let legend = if state.compared.is_some() { Text::default() } else { text!("curve-signs") };
    let legend = state.told(legend);
    let column = title.width.saturating_sub(short(legend.chars().count()) + 1);
    let header = cut(&state.told(&figure.title), usize::from(column.saturating_sub(2)));
    put(buffer, title, 1, 0, &header, state.look.theme.style(Role::Header));
    put(buffer, title, column, 0, &legend, state.look.theme.style(Role::Dim));
    paint(state, &figure, charts, buffer);
}

/// The heading and the charts.
fn parts(area: Rect) -> [Rect; 2] {
    Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area)
}

/// The three curves of the chosen quantity, or those of the quantities that were picked.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    if !state.picked.is_empty() {
        return figure_of_picked(state, scene);
    }
    let Some(transfer) = scene.transfers.get(state.chosen.transfer) else { return Figure::default() };
    let mut title = transfer.name.clone();
    let mut legend: Vec<Key> = Vec::new();
    if let Some(compared) = &state.compared {
        title = if compared.before {
            text!("curve-before", quantity = title)
        } else {
            let one = name(scene.source.short_name());
            text!("curve-compared", quantity = title, one = one, other = &compared.name)
        };
    } else {
        legend.extend(
            SIGNS.map(|(sign, told)| Key { sample: Sample::Sign(sign, Ink::Text), text: text!(told) }),
        );
    }
    let inks = [Ink::First, Ink::Second, Ink::Third];
    let panels =
        inks.into_iter().enumerate().map(|(order, ink)| panel(state, scene, transfer.orders, order, ink));
    Figure { title, panels: panels.collect(), columns: 1, legend }
}

fn panel(state: &State, scene: &Scene, orders: [usize; 3], order: usize, ink: Ink) -> Panel {
    let series = &scene.series[orders[order]];
    let mut value = quantity(series.bare(state.position), series.unit.clone());
    let mut curves = vec![(series, Stroke::Solid, ink)];
    if let Some(compared) = &state.compared
        && let Some(other) = compared.series(series)
    {
        curves.push((other, stroke_of(compared), Ink::Text));
        let difference = compared.difference(series, state.position).unwrap_or(f64::NAN);
        let difference = quantity(number(difference), series.unit.clone());
        value = joined("", [value, name("   1 - 2: "), difference]);
    }
    let (_, factor) = coordinate_unit(&scene.linkage);
    let mut signs = Vec::new();
    for (derivative, (sign, _)) in orders[order..].iter().zip(SIGNS) {
        for at in scene.series[*derivative].course.zeros() {
            let value = if sign == Sign::Cross { Some(0.0) } else { series.course.between(at) };
            let sign = |value| Item::sign([factor * at, series.factor * value], sign, Ink::Text);
            signs.extend(value.map(sign));
        }
    }
    over_positions(state, scene, [name(["PF0", "PF1", "PF2"][order]), value], &curves, signs)
}

/// The stroke of the curve of a second scene.
fn stroke_of(compared: &Compared) -> Stroke {
    if compared.before { Stroke::Dotted } else { Stroke::Stars }
}

/// Curves of these series of the analysis, of the corresponding ones of another analyzer, and of those of a second scene,
/// over one axis.
pub(super) fn stack(
    state: &State,
    scene: &Scene,
    found: &Found,
    other: Option<&Found>,
    wanted: &[usize],
) -> Vec<Panel> {
    let panel = |index: &usize| {
        let series = &found.series[*index];
        let same = other.and_then(|other| other.series.iter().find(|other| other.column == series.column));
        let mut curves = vec![(series, Stroke::Solid, Ink::First)];
        if let Some(compared) = &state.compared {
            curves.extend(compared.series(series).map(|same| (same, stroke_of(compared), Ink::Text)));
        }
        curves.extend(same.map(|same| (same, Stroke::Stars, Ink::Third)));
        let heading = [series.of.clone(), series.show(state.position)];
        over_positions(state, scene, heading, &curves, Vec::new())
    };
    wanted.iter().map(panel).collect()
}

/// The position under a cell of the screen.
pub(crate) fn position_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<usize> {
    let scene = state.scene.as_ref()?;
    let charts = if state.picked.is_empty() { parts(area)[1] } else { parts_of_picked(state, area)[1] };
    let cell = [column.checked_sub(charts.x)?, row.checked_sub(charts.y)?];
    let value = assur_figure::cells::value_at(&figure(state, scene), [charts.width, charts.height], cell)?;
    let distance = |position: &usize| (scene.coordinate_at(*position as f64) - value).abs();
    (0..scene.positions()).min_by(|one, other| distance(one).total_cmp(&distance(other)))
}

/// Strokes and inks of several curves, told apart without color.
const STYLES: [(Stroke, Ink); 4] = [
    (Stroke::Solid, Ink::First),
    (Stroke::Dotted, Ink::Third),
    (Stroke::Chain, Ink::Second),
    (Stroke::Dashed, Ink::Velocity),
];
/// The heads of the numbers of the table.
const HEADS: [&str; 7] =
    ["curve-now", "curve-greatest", "curve-at", "curve-least", "curve-at", "curve-mean", "curve-rms"];
/// Columns for the name of a quantity with its unit.
const NAME: usize = 27;

/// The picked quantities that the scene has.
fn picked<'a>(state: &State, scene: &'a Scene) -> Vec<&'a Series> {
    state.picked.iter().filter_map(|short| scene.named(short)).collect()
}

/// Draws the table of extremes and means, then the curves.
fn draw_picked(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let mut lines = vec![(Role::Dim, row("", HEADS.map(|head| state.told(text!(head)))))];
    for (number, series) in picked(state, scene).into_iter().enumerate() {
        let unit = state.told(unit(series.unit.clone()));
        let unit = if unit.is_empty() { unit } else { format!(", {unit}") };
        let of = cut(&state.told(&series.of), NAME.saturating_sub(unit.width() + 3));
        let name = format!("{} {of}", number + 1);
        let cells = series.summary().map_or_else(Default::default, |summary| {
            let [high, low] = [summary.greatest, summary.least].map(|extreme| extreme.number);
            let shown =
                |value: f64| if value.abs() <= series.least() { "0".to_owned() } else { digits(value, 5) };
            let shown = |value: f64| state.told(words::number(shown(value)));
            let [greatest, least, mean, rms] =
                [summary.greatest.value, summary.least.value, summary.mean, summary.rms].map(shown);
            [
                state.told(words::number(series.bare(state.position))),
                greatest,
                high.to_string(),
                least,
                low.to_string(),
                mean,
                rms,
            ]
        });
        lines.push((Role::Plain, row(&format!("{name}{unit}"), cells)));
    }
    let [table, charts] = parts_of_picked(state, area);
    put_lines(buffer, table, 1, state, &lines);
    paint(state, &figure_of_picked(state, scene), charts, buffer);
}

/// The table and the charts.
fn parts_of_picked(state: &State, area: Rect) -> [Rect; 2] {
    Layout::vertical([Constraint::Length(short(state.picked.len() + 1)), Constraint::Min(0)]).areas(area)
}

/// A row of the table: the name, the value now, greatest and least value with their positions, mean, root mean square.
fn row(name: &str, [now, greatest, high, least, low, mean, rms]: [String; 7]) -> String {
    format!("{name:<NAME$}{now:>10}{greatest:>9}{high:>4}{least:>9}{low:>4}{mean:>8}{rms:>8}")
}

/// A panel for each unit, with a ring at the greatest and the least value of each curve.
fn figure_of_picked(state: &State, scene: &Scene) -> Figure {
    let all = picked(state, scene);
    let mut units: Vec<&str> = Vec::new();
    for series in &all {
        if !units.contains(&series.unit.as_str()) {
            units.push(&series.unit);
        }
    }
    let panels = units.into_iter().map(|unit| panel_of_unit(state, scene, &all, unit)).collect();
    let title = list(all.iter().map(|series| series.of.clone()));
    Figure { title, panels, columns: 1, legend: Vec::new() }
}

/// The quantities of one unit; each has its number in the list of all.
fn panel_of_unit(state: &State, scene: &Scene, all: &[&Series], unit: &str) -> Panel {
    let (mut curves, mut signs, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (number, series) in all.iter().enumerate().filter(|(_, series)| series.unit == unit) {
        let (stroke, ink) = STYLES[curves.len() % STYLES.len()];
        let before = state.compared.as_ref().and_then(|compared| compared.series(series));
        curves.extend(before.map(|before| (before, Stroke::Dotted, Ink::Trace)));
        curves.push((*series, stroke, ink));
        if let Some(summary) = series.summary() {
            for extreme in [summary.greatest, summary.least] {
                let at = scene.coordinate_at(extreme.number as f64);
                signs.push(Item::sign([at, extreme.value], Sign::Ring, Ink::Text));
            }
            if all.len() > 1 {
                // Each number at its own part of the curve, so that the numbers of curves that meet are still seen.
                let nodes = series.course.nodes();
                let node = nodes[(2 * number + 1) * nodes.len() / (2 * all.len())];
                let place = [scene.coordinate_at(node.number as f64), series.factor * node.value];
                signs.push(Item::name(place, name((number + 1).to_string()), Ink::Title));
            }
        }
        names.push(joined(" ", [name((number + 1).to_string()), series.of.clone()]));
    }
    let title = if all.len() > 1 {
        joined("  ", names)
    } else {
        all.first().map_or_else(Text::default, |series| series.of.clone())
    };
    over_positions(state, scene, [title, Text::default()], &curves, signs)
}
