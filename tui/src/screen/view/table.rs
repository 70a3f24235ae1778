//! Positions and quantities as a table: first column and header are fixed, the rest scrolls both ways.

use assur_words::{self as words, Text, name, text, unit};
use std::fmt::Write;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use crate::number::{digits, number};
use crate::screen::draw::{cut, put, short};
use crate::screen::state::{Role, Scene, Series, State};

const FIRST: u16 = 6;
/// Least width of another one: a number with an exponent.
const COLUMN: u16 = 12;

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    if area.height < 4 {
        return;
    }
    let order = state.order();
    let columns = visible_columns(state, scene, area.width.saturating_sub(FIRST + 2));
    put(buffer, area, 1, 0, &state.told(text!("table-number")), state.style(Role::Header));
    let mut left = FIRST;
    for &(column, width) in &columns {
        let Some(series) = scene.column(column) else { continue };
        let role = if column == state.chosen.column { Role::Chosen } else { Role::Header };
        let texts = [(0, series.head.clone(), role), (1, unit(series.unit.clone()), Role::Dim)];
        for (row, text, role) in texts {
            let text = state.told(text);
            put(buffer, area, left, row, &format!("{text:>0$}", usize::from(width) - 1), state.style(role));
        }
        left += width;
    }
    let height = usize::from(area.height - 3);
    let row = order.iter().position(|position| *position == state.position).unwrap_or(0);
    let skip = row.saturating_sub(height / 2).min(order.len().saturating_sub(height));
    for (line, &position) in order.iter().skip(skip).take(height).enumerate() {
        let place = Rect { y: area.y + 2 + short(line), height: 1, ..area };
        draw_row(state, scene, position, &columns, place, buffer);
    }
    let below = Rect { y: area.bottom() - 1, height: 1, ..area };
    status(state, scene, &columns, below, buffer);
    scroll_bar(area, skip, height, order.len(), buffer);
}

fn draw_row(
    state: &State,
    scene: &Scene,
    position: usize,
    columns: &[(usize, u16)],
    area: Rect,
    buffer: &mut Buffer,
) {
    let here = position == state.position;
    let style = state.style(if here { Role::Cursor } else { Role::Plain });
    let mut text = format!("{}{position:>4} ", if here { '>' } else { ' ' });
    for &(column, width) in columns {
        let value = scene.column(column).map_or_else(String::new, |series| {
            let text = fitted(value(state, column, series, position), usize::from(width) - 1);
            state.told(words::number(text))
        });
        let _ = write!(text, "{value:>0$} ", usize::from(width) - 1);
    }
    put(buffer, Rect { width: area.width.saturating_sub(1), ..area }, 0, 0, &text, style);
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
    let compared = state.compared.as_ref().filter(|compared| column > 0 && !compared.before);
    let Some(compared) = compared else { return series.bare(position) };
    match compared.difference(series, position) {
        None => "-".to_owned(),
        Some(difference) if difference.abs() <= series.factor * series.floor => "0".to_owned(),
        Some(difference) => number(difference),
    }
}

/// The columns from the chosen one's page, with their widths.
fn visible_columns(state: &State, scene: &Scene, room: u16) -> Vec<(usize, u16)> {
    let width = |column: usize| {
        let Some(series) = scene.column(column) else { return COLUMN };
        COLUMN.max(short(state.told(&series.head).width().max(series.unit.len() + 1) + 1))
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

fn status(state: &State, scene: &Scene, columns: &[(usize, u16)], area: Rect, buffer: &mut Buffer) {
    let of = scene.column(state.chosen.column).map_or_else(String::new, |series| state.told(&series.of));
    let (first, last) = (columns.first().map_or(0, |c| c.0 + 1), columns.last().map_or(0, |c| c.0 + 1));
    let mut text = format!("{of}   {first}-{last} / {}", scene.column_count());
    if let Some((column, up)) = state.sorted {
        let column = scene.column(column).map_or_else(Text::default, |series| series.head.clone());
        let sense = name(if up { "↑" } else { "↓" });
        let _ = write!(text, "   {}", state.told(text!("table-sorted", column = column, sense = sense)));
    }
    if let Some(compared) = state.compared.as_ref().filter(|compared| !compared.before) {
        let _ = write!(text, "   {}", state.told(text!("table-differences", scene = &compared.name)));
    }
    let text = cut(&text, usize::from(area.width.saturating_sub(2)));
    put(buffer, area, 1, 0, &text, state.style(Role::Dim));
}

fn scroll_bar(area: Rect, skip: usize, shown: usize, count: usize, buffer: &mut Buffer) {
    if count <= shown || shown == 0 || area.width == 0 {
        return;
    }
    let (from, to) = (skip * shown / count, ((skip + shown) * shown).div_ceil(count));
    for row in 0..shown {
        let sign = if (from..to).contains(&row) { "█" } else { "│" };
        put(buffer, area, area.width - 1, short(row) + 2, sign, ratatui::style::Style::new());
    }
}
