//! PF0, PF1, PF2 of one quantity, stacked over one axis; or the quantities that were picked.

use std::fmt::Write;

use assur_figure::{Figure, Ink, Item, Key, Panel, Sample, Sign, Stroke};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::plots::{coordinate, over_positions};
use super::quantities;
use crate::number::number;
use crate::screen::draw::{cut, paint, put, short};
use crate::screen::state::{Compared, Found, Role, Scene, Series, State, zeros};

/// What the signs on the curves are. The zeros of the first derivative mark extremes, those of the second one inflections.
const SIGNS: [(Sign, &str); 3] = [(Sign::Cross, "zero"), (Sign::Ring, "extreme"), (Sign::Plus, "inflection")];

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    if !state.picked.is_empty() {
        return quantities::draw(state, scene, area, buffer);
    }
    let [title, charts] = parts(area);
    let figure = figure(state, scene);
    let words = state.words();
    let legend = if state.compared.is_some() { "" } else { "o extreme  x zero  + inflection" };
    let legend = words.shown(legend);
    let column = title.width.saturating_sub(short(legend.chars().count()) + 1);
    let header = cut(&words.shown(&figure.title), usize::from(column.saturating_sub(2)));
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
        return quantities::figure(state, scene);
    }
    let Some(transfer) = scene.transfers.get(state.chosen.transfer) else { return Figure::default() };
    let mut title = transfer.name.clone();
    let mut legend: Vec<Key> = Vec::new();
    if let Some(compared) = &state.compared {
        let (now, stroke) =
            if compared.before { ("now".to_owned(), "dots") } else { (scene.source.short_name(), "stars") };
        let _ = write!(title, "   1 {now} (line)  2 {} ({stroke})", compared.name);
    } else {
        legend.extend(
            SIGNS.map(|(sign, text)| Key { sample: Sample::Sign(sign, Ink::Text), text: text.into() }),
        );
    }
    let inks = [Ink::First, Ink::Second, Ink::Third];
    let panels =
        inks.into_iter().enumerate().map(|(order, ink)| panel(state, scene, transfer.orders, order, ink));
    Figure { title, panels: panels.collect(), columns: 1, legend }
}

fn panel(state: &State, scene: &Scene, orders: [usize; 3], order: usize, ink: Ink) -> Panel {
    let series = &scene.series[orders[order]];
    let mut title = format!("PF{order}  {} {}", number(series.at(state.position)), series.unit);
    let mut curves = vec![(series, Stroke::Solid, ink)];
    if let Some(compared) = &state.compared
        && let Some(other) = compared.series(series)
    {
        curves.push((other, stroke_of(compared), Ink::Text));
        let difference = compared.difference(series, state.position).unwrap_or(f64::NAN);
        let _ = write!(title, "   1 - 2: {} {}", number(difference), series.unit);
    }
    let mut signs = Vec::new();
    for (derivative, (sign, _)) in orders[order..].iter().zip(SIGNS) {
        for at in zeros(&scene.series[*derivative].values, scene.closed()) {
            let value = if sign == Sign::Cross { 0.0 } else { between(series, at) };
            signs.push(Item::sign([coordinate(scene, at), value], sign, Ink::Text));
        }
    }
    over_positions(state, scene, title, &curves, signs)
}

/// The stroke of the curve of a second scene.
fn stroke_of(compared: &Compared) -> Stroke {
    if compared.before { Stroke::Dotted } else { Stroke::Stars }
}

/// Value between two positions, linear.
fn between(series: &Series, at: f64) -> f64 {
    let count = series.values.len().max(1);
    let before = (0..count).rev().find(|position| *position as f64 <= at).unwrap_or(0);
    let [a, b] = [before, (before + 1) % count].map(|position| series.at(position));
    let part = at - before as f64;
    if part > 0.0 { a + part * (b - a) } else { a }
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
        let same = other.and_then(|other| other.series.iter().find(|other| other.of == series.of));
        let mut curves = vec![(series, Stroke::Solid, Ink::First)];
        if let Some(compared) = &state.compared {
            curves.extend(compared.series(series).map(|same| (same, stroke_of(compared), Ink::Text)));
        }
        curves.extend(same.map(|same| (same, Stroke::Stars, Ink::Third)));
        let title = format!("{}  {}", series.of, series.show(state.position));
        over_positions(state, scene, title, &curves, Vec::new())
    };
    wanted.iter().map(panel).collect()
}

/// The position under a cell of the screen.
pub(crate) fn position_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<usize> {
    let scene = state.scene.as_ref()?;
    let charts = if state.picked.is_empty() { parts(area)[1] } else { quantities::parts(state, area)[1] };
    let cell = [column.checked_sub(charts.x)?, row.checked_sub(charts.y)?];
    let value = assur_figure::cells::value_at(&figure(state, scene), [charts.width, charts.height], cell)?;
    let distance = |position: &usize| (coordinate(scene, *position as f64) - value).abs();
    (0..scene.positions()).min_by(|one, other| distance(one).total_cmp(&distance(other)))
}
