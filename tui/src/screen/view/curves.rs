//! PF0, PF1, PF2 of one quantity, stacked over one axis; or the quantities that were picked, those of one unit over each other,
//! with their extremes and means.

use std::collections::BTreeSet;

use assur_analysis::results::{Means, Owner, Quantity, Turn};
use assur_book::{Cell, Column, Table, catalogue, row};
use assur_figure::{Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke};
use assur_report::text::Line;
use assur_words::{self as words, Text, joined, list, name, quantity, text, unit};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::number::{number, trimmed};
use crate::screen::draw::{cut, paint, put, short};
use crate::screen::state::{Compared, Found, Role, Scene, Series, State, coordinate_unit};
use assur_picture::plots::{self, STYLES, over_positions};

/// What the signs on the curves are. The zeros of the first derivative mark extremes, those of the second one inflections.
const SIGNS: [(Sign, &str); 3] =
    [(Sign::Cross, "curve-zero"), (Sign::Ring, "curve-extreme"), (Sign::Plus, "curve-inflection")];

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
            let one = name(scene.session.source.short_name());
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
    over_positions(&scene.linkage, state.pictured(), [catalogue::kind(series.column), value], &curves, signs)
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
        over_positions(&scene.linkage, state.pictured(), heading, &curves, Vec::new())
    };
    wanted.iter().map(panel).collect()
}

/// The position under a cell of the screen.
pub(crate) fn position_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<usize> {
    let scene = state.scene.as_ref()?;
    let charts =
        if state.picked.is_empty() { parts(area)[1] } else { parts_of_picked(state, scene, area)[1] };
    let cell = [column.checked_sub(charts.x)?, row.checked_sub(charts.y)?];
    let value = assur_figure::cells::value_at(&figure(state, scene), [charts.width, charts.height], cell)?;
    let distance = |position: &usize| (scene.coordinate_at(*position as f64) - value).abs();
    (0..scene.positions()).min_by(|one, other| distance(one).total_cmp(&distance(other)))
}

/// The heads of the table of extremes and means, behind the name and the unit.
const HEADS: [&str; 6] = ["curve-greatest", "curve-at", "curve-least", "curve-at", "curve-mean", "curve-rms"];

/// The picked quantities that the scene has.
fn picked(state: &State, scene: &Scene) -> Vec<Series> {
    state.picked.iter().filter_map(|short| scene.named(short)).map(in_radians).collect()
}

/// The angle of a link in radians, by which its derivatives are taken, so that all three have one axis; other quantities as they are
/// shown elsewhere.
fn in_radians(series: &Series) -> Series {
    let is_angle =
        matches!((series.column.quantity, series.column.owner), (Quantity::Transfer(0), Owner::Link(_)));
    let unit = if is_angle { "rad".to_owned() } else { series.unit.clone() };
    Series { unit, factor: if is_angle { 1.0 } else { series.factor }, ..series.clone() }
}

fn draw_picked(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let [table, charts] = parts_of_picked(state, scene, area);
    page::draw(state, &extremes(state, scene, area.width), &|_| Role::Plain, table, buffer);
    paint(state, &figure_of_picked(state, scene), charts, buffer);
}

/// Digits of the coordinate of an extreme.
const PLACE: usize = 5;

/// Extremes with their coordinates, and means: between the positions too, as the first results have them.
fn extremes(state: &State, scene: &Scene, width: u16) -> Vec<Line> {
    let (symbol, factor) = coordinate_unit(&scene.linkage);
    let place = |at: f64| words::number(trimmed(factor * at, PLACE));
    let heads = HEADS.map(|head| match head {
        "curve-at" => text!(head, unit = unit(symbol)),
        _ => text!(head),
    });
    let heads = std::iter::repeat_with(Text::default).take(2).chain(heads);
    let row = |(number, series): (usize, Series)| {
        let shown = |value: f64| {
            let value = series.factor * value;
            if value.abs() <= series.least() { 0.0 } else { value }
        };
        let range = scene.found.as_ref().and_then(|found| found.range(&series));
        let (greatest, least) = (range.map(|all| all.greatest), range.map(|all| all.least));
        let means = range.and_then(|all| all.means).filter(Means::are_sure);
        let value = |extreme: Option<Turn>| match extreme {
            Some(extreme) if extreme.value.is_infinite() => Cell::from(text!("curve-unlimited")),
            extreme => Cell::from(extreme.map(|extreme| shown(extreme.value))),
        };
        let at = |extreme: Option<Turn>| extreme.map(|extreme| place(extreme.at));
        row![
            plots::numbered(number, series.of.clone()),
            unit(series.unit.clone()),
            value(greatest),
            at(greatest),
            value(least),
            at(least),
            means.map(|means| shown(means.mean)),
            means.map(|means| shown(means.rms)),
        ]
    };
    let rows = picked(state, scene).into_iter().enumerate().map(row);
    let table = Table::list(Text::default(), heads.map(Column::of)).rows(rows);
    page::told(state, width.saturating_sub(2), |page| page.table(table))
}

fn parts_of_picked(state: &State, scene: &Scene, area: Rect) -> [Rect; 2] {
    let rows = short(extremes(state, scene, area.width).len());
    Layout::vertical([Constraint::Length(rows), Constraint::Min(0)]).areas(area)
}

fn figure_of_picked(state: &State, scene: &Scene) -> Figure {
    let all = picked(state, scene);
    together(state, scene, &all.iter().collect::<Vec<_>>())
}

/// Relative size of a change that is rounding.
const CONSTANT: f64 = 1e-9;

/// A panel for each unit, with a ring at the greatest and the least value of each curve.
pub(super) fn together(state: &State, scene: &Scene, all: &[&Series]) -> Figure {
    let units = different(all.iter().map(|series| without_radians(&series.unit)));
    let panels = units.into_iter().map(|unit| panel_of_unit(state, scene, all, unit)).collect();
    let legend = if all.len() > 1 { keys(state, all) } else { Vec::new() };
    Figure { panels, columns: 1, legend, ..Figure::default() }
}

/// Each of them once, in the order in which it comes first.
fn different<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = BTreeSet::new();
    all.filter(|one| seen.insert(*one)).collect()
}

/// The curves with their units and their values at the position, each under its number, in the strokes of their panels.
fn keys(state: &State, all: &[&Series]) -> Vec<Key> {
    let key = |(number, series): (usize, &&Series)| {
        let unit = without_radians(&series.unit);
        let before = all[..number].iter().filter(|other| without_radians(&other.unit) == unit).count();
        let (stroke, ink) = STYLES[before % STYLES.len()];
        let title = joined(" ", [name((number + 1).to_string()), series.title()]);
        let text = joined(": ", [title, words::number(series.bare(state.position))]);
        Key { sample: Sample::Line(stroke, ink), text }
    };
    all.iter().enumerate().map(key).collect()
}

/// A unit without its radians, which are numbers: PF0, PF1 and PF2 of a point are lengths all, on one axis.
fn without_radians(unit: &str) -> &str {
    let bare = unit.split_once("/rad").map_or(unit, |(bare, _)| bare);
    if bare == "rad" { "" } else { bare }
}

/// The quantities of one unit but for radians; each has its number in the list of all.
fn panel_of_unit(state: &State, scene: &Scene, all: &[&Series], unit: &str) -> Panel {
    let (_, coordinate) = coordinate_unit(&scene.linkage);
    let (mut curves, mut signs, mut names) = (Vec::new(), Vec::new(), Vec::new());
    let compared = state.compared.as_ref();
    let before = |series: &&Series| compared?.series(scene.named(&series.short)?).map(in_radians);
    let befores: Vec<Option<Series>> = all.iter().map(before).collect();
    for (number, series) in all.iter().enumerate().filter(|(_, series)| without_radians(&series.unit) == unit)
    {
        let (stroke, ink) = STYLES[curves.len() % STYLES.len()];
        curves.extend(befores[number].iter().map(|before| (before, Stroke::Dotted, Ink::Trace)));
        curves.push((*series, stroke, ink));
        let place = |[at, value]: Point| [coordinate * at, series.factor * value];
        if let Some(ends) = series.course.highest_and_lowest() {
            // A course that is constant to its rounding has no extremes.
            if series.factor * (ends[0][1] - ends[1][1]) > series.least().max(CONSTANT * series.size()) {
                signs.extend(ends.map(|end| Item::sign(place(end), Sign::Ring, Ink::Text)));
            }
            if all.len() > 1 {
                // Each number at its own part of the curve, so that the numbers of curves that meet are still seen.
                let nodes = series.course.nodes();
                let node = nodes[(2 * number + 1) * nodes.len() / (2 * all.len())];
                let number = name((number + 1).to_string());
                signs.push(Item::name(place([node.at, node.value]), number, Ink::Title));
            }
        }
        names.push(plots::numbered(number, series.told()));
    }
    let units = curves.iter().map(|(series, ..)| series.unit.as_str()).filter(|unit| !unit.is_empty());
    let units = list(different(units).into_iter().map(|symbol| words::unit(symbol.to_owned())));
    // The value at the cursor stands in the legend of several, else in the heading.
    let heading = match all {
        [alone] => [alone.told(), alone.show(state.position)],
        _ => {
            [list([joined("  ", names), units].into_iter().filter(|text| !text.is_empty())), Text::default()]
        }
    };
    let mut panel = over_positions(&scene.linkage, state.pictured(), heading, &curves, signs);
    if let Frame::Axes { y, .. } = &mut panel.frame {
        // The heading says it.
        y.label = Text::default();
    }
    panel
}
