//! The curves of the chosen quantity, or of those that were picked with their extremes and means.

use assur_analysis::results::{Means, Turn};
use assur_book::{Cell, Range, Table};
use assur_picture::curves::{figure, picked};
use assur_picture::plots;
use assur_report::text::Line;
use assur_words::{self as words, Text, text, unit};
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::number::trimmed;
use crate::screen::draw::{Pen, cut, short};
use crate::screen::state::{Role, Scene, Series, State};

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    if !state.picked.is_empty() {
        let [table, charts] = parts_of_picked(state, scene, area);
        page::draw(pen, &extremes(state, scene, area.width), 0, &|_| Role::Plain, table);
        return pen.paint(&figure(scene, &state.pictured()), charts);
    }
    let [title, charts] = parts(area);
    let figure = figure(scene, &state.pictured());
    let legend = if state.compared.is_some() { Text::default() } else { text!("curve-signs") };
    let legend = state.told(legend);
    let column = title.width.saturating_sub(short(legend.chars().count()) + 1);
    let header = cut(&state.told(&figure.title), usize::from(column.saturating_sub(2)));
    pen.put(title, 1, 0, &header, Role::Header);
    pen.put(title, column, 0, &legend, Role::Dim);
    pen.paint(&figure, charts);
}

fn parts(area: Rect) -> [Rect; 2] {
    Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area)
}

/// The position under a cell of the screen.
pub(crate) fn position_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<usize> {
    let scene = state.scene.as_ref()?;
    if state.picked.is_empty() && scene.samples().is_some() {
        // The curves are those of a cycle, in which a place belongs to many samples.
        return None;
    }
    let charts =
        if state.picked.is_empty() { parts(area)[1] } else { parts_of_picked(state, scene, area)[1] };
    let cell = [column.checked_sub(charts.x)?, row.checked_sub(charts.y)?];
    let size = [charts.width, charts.height];
    let value = assur_figure::cells::value_at(&figure(scene, &state.pictured()), size, cell)?;
    let distance = |position: &usize| (scene.on_axis(*position as f64) - value).abs();
    (0..scene.positions()).min_by(|one, other| distance(one).total_cmp(&distance(other)))
}

/// Digits of the coordinate of an extreme.
const PLACE: usize = 5;

/// Extremes with their coordinates, and means: between the positions too, as the first results have them.
fn extremes(state: &State, scene: &Scene, width: u16) -> Vec<Line> {
    let (symbol, factor) = scene.axis_unit();
    let shown = |series: &Series, value: f64| {
        let value = series.unit.factor * value;
        if value.abs() <= series.least() { 0.0 } else { value }
    };
    let range = |series: &Series| scene.found.as_ref().and_then(|found| found.range(series));
    let value = |series: &Series, of: fn(Range) -> Turn| match range(series).map(of) {
        Some(extreme) if extreme.value.is_infinite() => Cell::from(text!("curve-unlimited")),
        extreme => Cell::from(extreme.map(|extreme| shown(series, extreme.value))),
    };
    let at = |series: &Series, of: fn(Range) -> Turn| {
        range(series).map(|range| words::number(trimmed(factor * of(range).at, PLACE)))
    };
    let mean = |series: &Series, of: fn(Means) -> f64| {
        let means = range(series).and_then(|range| range.means).filter(Means::are_sure);
        means.map(|means| shown(series, of(means)))
    };
    let place = || text!("curve-at", unit = unit(symbol));
    let all = picked(scene, &state.pictured()).into_iter().enumerate();
    let table = Table::each(Text::default(), all)
        .column(Text::default(), |(number, series)| plots::numbered(*number, series.of.clone()))
        .column(Text::default(), |(_, series)| unit(series.unit.name))
        .column(text!("curve-greatest"), |(_, series)| value(series, |range| range.greatest))
        .column(place(), |(_, series)| at(series, |range| range.greatest))
        .column(text!("curve-least"), |(_, series)| value(series, |range| range.least))
        .column(place(), |(_, series)| at(series, |range| range.least))
        .column(text!("curve-mean"), |(_, series)| mean(series, |means| means.mean))
        .column(text!("curve-rms"), |(_, series)| mean(series, |means| means.rms));
    page::told(state, width.saturating_sub(2), |page| page.table(table.table()))
}

fn parts_of_picked(state: &State, scene: &Scene, area: Rect) -> [Rect; 2] {
    let rows = short(extremes(state, scene, area.width).len());
    Layout::vertical([Constraint::Length(rows), Constraint::Min(0)]).areas(area)
}
