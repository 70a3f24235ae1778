//! Any quantities over the positions: those of one unit over each other, with their extremes and means.

use assur_figure::{Figure, Ink, Item, Panel, Sign, Stroke};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::plots::{coordinate, over_positions};
use crate::number::digits;
use crate::screen::draw::{cut, paint, put_lines, short};
use crate::screen::state::{Role, Scene, Series, State};

/// Strokes and inks of several curves, told apart without color.
const STYLES: [(Stroke, Ink); 4] = [
    (Stroke::Solid, Ink::First),
    (Stroke::Dotted, Ink::Third),
    (Stroke::Chain, Ink::Second),
    (Stroke::Dashed, Ink::Velocity),
];
/// Columns for the name of a quantity with its unit.
const NAME: usize = 27;

/// The picked quantities that the scene has.
fn picked<'a>(state: &State, scene: &'a Scene) -> Vec<&'a Series> {
    state.picked.iter().filter_map(|short| scene.named(short)).collect()
}

/// Draws the table of extremes and means, then the curves.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let mut lines = vec![(
        Role::Dim,
        row("", ["now", "greatest", "at", "least", "at", "mean", "rms"].map(str::to_owned)),
    )];
    for (number, series) in picked(state, scene).into_iter().enumerate() {
        let unit = if series.unit.is_empty() { String::new() } else { format!(", {}", series.unit) };
        let name = format!("{} {}", number + 1, cut(&series.of, NAME.saturating_sub(unit.len() + 3)));
        let cells = series.summary().map_or_else(Default::default, |summary| {
            let ((greatest, high), (least, low)) = (summary.greatest, summary.least);
            let shown =
                |value: f64| if value.abs() <= series.floor { "0".to_owned() } else { digits(value, 5) };
            let [greatest, least, mean, rms] = [greatest, least, summary.mean, summary.rms].map(shown);
            [series.bare(state.position), greatest, high.to_string(), least, low.to_string(), mean, rms]
        });
        lines.push((Role::Plain, row(&format!("{name}{unit}"), cells)));
    }
    let [table, charts] = parts(state, area);
    put_lines(buffer, table, 1, state, &lines);
    paint(state, &figure(state, scene), charts, buffer);
}

/// The table and the charts.
pub(super) fn parts(state: &State, area: Rect) -> [Rect; 2] {
    Layout::vertical([Constraint::Length(short(state.picked.len() + 1)), Constraint::Min(0)]).areas(area)
}

/// A row of the table: the name, the value now, greatest and least value with their positions, mean, root mean square.
fn row(name: &str, [now, greatest, high, least, low, mean, rms]: [String; 7]) -> String {
    format!("{name:<NAME$}{now:>10}{greatest:>9}{high:>4}{least:>9}{low:>4}{mean:>8}{rms:>8}")
}

/// A panel for each unit, with a ring at the greatest and the least value of each curve.
pub(super) fn figure(state: &State, scene: &Scene) -> Figure {
    let all = picked(state, scene);
    let mut units: Vec<&str> = Vec::new();
    for series in &all {
        if !units.contains(&series.unit.as_str()) {
            units.push(&series.unit);
        }
    }
    let panels = units.into_iter().map(|unit| panel(state, scene, &all, unit)).collect();
    let names: Vec<&str> = all.iter().map(|series| series.of.as_str()).collect();
    Figure { title: names.join(", "), panels, columns: 1, legend: Vec::new() }
}

/// The quantities of one unit; each has its number in the list of all.
fn panel(state: &State, scene: &Scene, all: &[&Series], unit: &str) -> Panel {
    let (mut curves, mut signs, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (number, series) in all.iter().enumerate().filter(|(_, series)| series.unit == unit) {
        let (stroke, ink) = STYLES[curves.len() % STYLES.len()];
        let before = state.compared.as_ref().and_then(|compared| compared.series(series));
        curves.extend(before.map(|before| (before, Stroke::Dotted, Ink::Trace)));
        curves.push((*series, stroke, ink));
        if let Some(summary) = series.summary() {
            for (value, at) in [summary.greatest, summary.least] {
                signs.push(Item::sign([coordinate(scene, at as f64), value], Sign::Ring, Ink::Text));
            }
            if all.len() > 1 {
                // Each number at its own part of the curve, so that the numbers of curves that meet are still seen.
                let at = (2 * number + 1) * series.values.len() / (2 * all.len());
                let place = [coordinate(scene, at as f64), series.at(at)];
                signs.push(Item::name(place, (number + 1).to_string(), Ink::Title));
            }
        }
        names.push(format!("{} {}", number + 1, series.of));
    }
    let title = if all.len() > 1 {
        names.join("  ")
    } else {
        all.first().map_or_else(String::new, |series| series.of.clone())
    };
    over_positions(state, scene, title, &curves, signs)
}
