//! Positions and quantities as a table: first column and header are fixed, the rest scrolls both ways.

use assur_words::{self as words, Text, name, text, unit};
use std::fmt::Write;

use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use crate::number::{digits, number};
use crate::screen::draw::{Pen, cut, short};
use crate::screen::state::{Role, Scene, Series, State};

const FIRST: u16 = 6;
/// Least width of another one: a number with an exponent.
const COLUMN: u16 = 12;

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    if area.height < 4 {
        return;
    }
    let order = state.order();
    let columns = visible_columns(state, scene, area.width.saturating_sub(FIRST + 2));
    pen.tell(area, 1, 0, text!("table-number"), Role::Header);
    let mut left = FIRST;
    for &(column, width) in &columns {
        let Some(series) = scene.column(column) else { continue };
        let role = if column == state.chosen.column { Role::Chosen } else { Role::Header };
        let texts = [(0, series.head.clone(), role), (1, unit(series.unit.name), Role::Dim)];
        for (row, text, role) in texts {
            let text = state.told(text);
            pen.put(area, left, row, &format!("{text:>0$}", usize::from(width) - 1), role);
        }
        left += width;
    }
    let height = usize::from(area.height - 3);
    let row = order.iter().position(|position| *position == state.position).unwrap_or(0);
    let skip = row.saturating_sub(height / 2).min(order.len().saturating_sub(height));
    for (line, &position) in order.iter().skip(skip).take(height).enumerate() {
        let place = Rect { y: area.y + 2 + short(line), height: 1, ..area };
        draw_row(pen, scene, position, &columns, place);
    }
    let below = Rect { y: area.bottom() - 1, height: 1, ..area };
    status(pen, scene, &columns, below);
    let rows = Rect { y: area.y + 2, height: short(height), ..area };
    pen.mark_rows(rows, skip..order.len().min(skip + height), order.len());
}

fn draw_row(pen: &mut Pen<'_>, scene: &Scene, position: usize, columns: &[(usize, u16)], area: Rect) {
    let state = pen.state;
    let here = position == state.position;
    let role = if here { Role::Cursor } else { Role::Plain };
    let mut text = format!("{}{position:>4} ", if here { '>' } else { ' ' });
    for &(column, width) in columns {
        let value = scene.column(column).map_or_else(String::new, |series| {
            let text = fitted(value(state, column, series, position), usize::from(width) - 1);
            state.told(words::number(text))
        });
        let _ = write!(text, "{value:>0$} ", usize::from(width) - 1);
    }
    pen.put(Rect { width: area.width.saturating_sub(1), ..area }, 0, 0, &text, role);
}

/// A number in its cell: with fewer digits where it would be wider.
fn fitted(text: String, width: usize) -> String {
    let fits = |text: &String| text.chars().count() <= width;
    match text.parse::<f64>() {
        Ok(value) if !fits(&text) => {
            (3..=5).rev().map(|many| digits(value, many)).find(fits).unwrap_or_else(|| format!("{value:.0e}"))
        }
        _ => text,
    }
}

/// The content of a cell: the value, or the difference to a second scene; of the coordinate always the value.
fn value(state: &State, column: usize, series: &Series, position: usize) -> String {
    let Some(compared) = state.second().filter(|_| column > 0) else { return series.bare(position) };
    match compared.difference(series, position) {
        None => "-".to_owned(),
        Some(difference) if difference.abs() <= series.unit.factor * series.floor => "0".to_owned(),
        Some(difference) => number(difference),
    }
}

/// The columns from the chosen one's page, with their widths.
fn visible_columns(state: &State, scene: &Scene, room: u16) -> Vec<(usize, u16)> {
    let width = |column: usize| {
        let Some(series) = scene.column(column) else { return COLUMN };
        COLUMN.max(short(state.told(&series.head).width().max(series.unit.name.len() + 1) + 1))
    };
    let mut first = 0;
    loop {
        let mut used = 0;
        let mut columns = Vec::new();
        for column in first..scene.column_count() {
            used += width(column);
            if used > room && !columns.is_empty() {
                break;
            }
            columns.push((column, width(column)));
        }
        let last = columns.last().map_or(first, |last| last.0);
        if state.chosen.column <= last || columns.is_empty() {
            return columns;
        }
        first += 1;
    }
}

fn status(pen: &mut Pen<'_>, scene: &Scene, columns: &[(usize, u16)], area: Rect) {
    let state = pen.state;
    let of = scene.column(state.chosen.column).map_or_else(String::new, |series| state.told(&series.of));
    let (first, last) = (columns.first().map_or(0, |c| c.0 + 1), columns.last().map_or(0, |c| c.0 + 1));
    let mut text = format!("{of}   {first}-{last} / {}", scene.column_count());
    if let Some((column, up)) = state.sorted {
        let column = scene.column(column).map_or_else(Text::default, |series| series.head.clone());
        let sense = name(if up { "↑" } else { "↓" });
        let _ = write!(text, "   {}", state.told(text!("table-sorted", column = column, sense = sense)));
    }
    if let Some(compared) = state.second() {
        let _ = write!(text, "   {}", state.told(text!("table-differences", scene = &compared.name)));
    }
    let text = cut(&text, usize::from(area.width.saturating_sub(2)));
    pen.put(area, 1, 0, &text, Role::Dim);
}
