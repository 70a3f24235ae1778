//! The list of the scene's numbers, below the view, which follows their changes; beside it the most important results before and
//! after them.

use assur_analysis::results::{Column, Quantity};
use assur_words::{Text, list, number, text, unit};
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::widgets::{Block, Borders, Widget};
use unicode_width::UnicodeWidthStr;

use crate::number::{digits, plain};
use crate::screen::draw::{Pen, cut, short, wrapped};
use crate::screen::state::{Role, Series, State};
use assur_picture::Results;

/// Least and greatest height, with the title.
const HEIGHT: [u16; 2] = [7, 16];
/// Greatest width of the keys.
const KEYS: usize = 46;
/// Columns that a value and its change need beside the key.
const VALUE: usize = 24;
/// Columns of the results before and after a change.
const RESULTS: u16 = 42;

/// Number of rows of the list in a body of this height.
pub(crate) fn height(body: Rect) -> u16 {
    (body.height / 3).clamp(HEIGHT[0], HEIGHT[1]).min(body.height)
}

pub(crate) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let beside = if results(pen.state).is_empty() { 0 } else { RESULTS.min(area.width / 2) };
    let [list, beside] = Layout::horizontal([Constraint::Min(0), Constraint::Length(beside)]).areas(area);
    draw_list(pen, list);
    draw_results(pen, beside);
}

fn draw_list(pen: &mut Pen<'_>, area: Rect) {
    let what = &pen.state.draft;
    let place = format!(" {} / {} ", (what.chosen + 1).min(what.values.len()), what.values.len());
    let step = number(plain(what.per_cent()));
    let title = pen.state.told(text!("values-title", step = step, changed = number(what.changes())));
    let title = format!(" {title} ");
    let block = Block::new().borders(Borders::TOP).title(title).title_bottom("");
    let inner = block.inner(area);
    block.render(area, pen.buffer);
    let column = area.width.saturating_sub(short(place.width()) + 1);
    pen.put(area, column, 0, &place, Role::Plain);
    let widest = what.values.iter().map(|value| value.key.to_string().width()).max().unwrap_or(0);
    let widest = widest.min(KEYS).min(usize::from(area.width).saturating_sub(VALUE));
    let room = usize::from(area.width).saturating_sub(widest + 5);
    // What is cut of the chosen one is told in full below.
    let whole =
        what.values.get(what.chosen).map(|value| (value.key.to_string(), what.shown_value(what.chosen)));
    let whole = whole.filter(|(key, shown)| key.width() > widest || shown.width() > room);
    let whole = whole.map_or_else(Vec::new, |(key, shown)| {
        wrapped(&format!("{key}  {shown}"), usize::from(area.width).saturating_sub(4).max(1))
    });
    let rows = usize::from(inner.height).saturating_sub(whole.len());
    for (row, line) in whole.iter().enumerate() {
        pen.put(inner, 3, short(rows + row), line, Role::Dim);
    }
    let skip = what.chosen.saturating_sub(rows / 2).min(what.values.len().saturating_sub(rows));
    for (row, (index, value)) in what.values.iter().enumerate().skip(skip).take(rows).enumerate() {
        let chosen = index == what.chosen;
        let sign = [' ', '>'][usize::from(chosen)];
        let mark = [' ', '*'][usize::from(what.is_value_changed(index))];
        let (key, shown) = (tail(&value.key.to_string(), widest), what.shown_value(index));
        // Where both don't fit, the new value is more informative than the old one.
        let shown = match shown.split_once(" -> ") {
            Some((_, new)) if shown.width() > room => format!("-> {new}"),
            _ => shown,
        };
        let text = format!("{sign}{mark} {key:<widest$}  {shown}");
        let role = if chosen { Role::Cursor } else { Role::Plain };
        pen.put(inner, 0, short(row), &text, role);
    }
}

/// The end of a key that is too long: it is more informative than the beginning.
pub(crate) fn tail(key: &str, width: usize) -> String {
    let count = key.chars().count();
    if count <= width {
        return key.to_owned();
    }
    let end: String = key.chars().skip((count + 2).saturating_sub(width)).collect();
    format!("..{end}").chars().take(width).collect()
}

const DIGITS: usize = 4;

/// One result: its name with its unit, and its value in a scene.
type Finding = (Text, f64);

/// The results of a scene, of which those with the same name belong together.
fn results_of(state: &State, scene: &Results) -> Vec<Finding> {
    let mut results: Vec<Finding> = Vec::new();
    let named = |id: &'static str, series: &Series| {
        list([text!(id, quantity = &series.head), unit(series.unit.name)])
    };
    let of = |id: &'static str, symbol: &str| list([text!(id), unit(symbol.to_owned())]);
    let Some(found) = &scene.found else { return results };
    if let Some(series) = state.main_series().and_then(|series| scene.named(&series.short))
        && let Some(range) = found.range(series)
    {
        results.push((named("values-most", series), series.unit.factor * range.greatest.value));
        results.push((named("values-least", series), series.unit.factor * range.least.value));
    }
    let peaks = &found.analysis.peaks;
    if let Some((series, most)) = found.balancing().zip(peaks.of(Column::BALANCING)) {
        results.push((of("values-balance", series.unit.name), (series.unit.factor * most.value).abs()));
    }
    let forces = peaks.farthest.iter().filter(|(column, _)| column.quantity == Quantity::Force);
    let force = forces.map(|(_, most)| most.value).reduce(f64::max);
    results.extend(force.map(|force| (of("values-reaction", "N"), force)));
    if let Some(dynamics) = &found.analysis.dynamics {
        results.push((text!("values-unevenness"), dynamics.figures.unevenness));
        results.extend(dynamics.flywheel.map(|flywheel| (of("values-flywheel", "kg m2"), flywheel)));
        results.push((of("values-power", "W"), dynamics.figures.required_power));
    }
    results.extend(scene.nearest_group().map(|(_, least, _)| (text!("values-determinant"), least)));
    // What grows without limit has no value to compare.
    results.retain(|(_, value)| value.is_finite());
    results
}

/// Name, value before, value after, and the change of each result; none unless there is a scene before the changes.
fn results(state: &State) -> Vec<[String; 4]> {
    let before = state.compared.as_ref().filter(|compared| compared.before);
    let (Some(scene), Some(before)) = (&state.scene, before) else { return Vec::new() };
    let old = results_of(state, &before.results);
    let row = |(what, new): Finding| {
        let (_, old) = old.iter().find(|(known, _)| *known == what)?;
        let part = || {
            let part = format!("{:+.1}", 1e2 * (new - old) / old.abs());
            // Less than is shown is no change in either sense.
            if matches!(&*part, "+0.0" | "-0.0") { "0.0".to_owned() } else { part }
        };
        let change = if *old == 0.0 { String::new() } else { state.told(number(part())) + " %" };
        let [old, new] = [*old, new].map(|value| state.told(number(digits(value, DIGITS))));
        Some([state.told(what), old, new, change])
    };
    results_of(state, scene).into_iter().filter_map(row).collect()
}

fn draw_results(pen: &mut Pen<'_>, area: Rect) {
    if area.width == 0 {
        return;
    }
    let block = Block::new()
        .borders(Borders::TOP | Borders::LEFT)
        .title(format!(" {} ", pen.state.told(text!("values-results"))));
    let inner = block.inner(area);
    block.render(area, pen.buffer);
    let rows = results(pen.state);
    let widest = |column: usize| rows.iter().map(|row| row[column].width()).max().unwrap_or(0);
    let [before, after, change] = [1, 2, 3].map(widest);
    // The values are whole; the names share what they leave.
    let room = usize::from(inner.width).saturating_sub(before + after + change + " ->  ".len() + 1);
    let line = |[what, old, new, part]: &[String; 4]| {
        format!("{:<room$} {old:>before$} -> {new:<after$} {part:>change$}", cut(what, room))
    };
    let lines: Vec<_> = rows.iter().map(|row| (Role::Plain, line(row))).collect();
    let rows = usize::from(inner.height);
    pen.put_lines(inner, 0, lines.iter().take(rows));
}
