//! Positions and quantities as a table: first column and header stay, the rest scrolls both ways.

use std::fmt::Write;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::panel::cut;
use super::put;
use crate::screen::draw::raster::short;
use crate::screen::number::{digits, number};
use crate::screen::series::Series;
use crate::screen::state::State;
use crate::screen::study::Study;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Width of the first column.
const FIRST: u16 = 6;
/// Least width of another one: a number with an exponent.
const COLUMN: u16 = 12;

/// The positions in the order of the rows.
pub(crate) fn order(state: &State) -> Vec<usize> {
    let Some(study) = &state.study else { return Vec::new() };
    let mut order: Vec<usize> = (0..study.positions()).collect();
    if let Some((column, up)) = state.sorted
        && let Some(series) = study.column(column)
    {
        let value = |i: usize| series.values.get(i).copied().unwrap_or(f64::NAN);
        order.sort_by(|a, b| value(*a).total_cmp(&value(*b)));
        if !up {
            order.reverse();
        }
    }
    order
}

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    if area.height < 4 {
        return;
    }
    let theme = state.look.theme;
    let order = order(state);
    let columns = visible_columns(state, study, area.width.saturating_sub(FIRST + 2));
    put(buffer, area, 1, 0, state.texts.number, theme.style(Role::Header));
    let mut left = FIRST;
    for &(column, width) in &columns {
        let Some(series) = study.column(column) else { continue };
        let role = if column == state.chosen.column { Role::Chosen } else { Role::Header };
        put(
            buffer,
            area,
            left,
            0,
            &format!("{:>1$}", series.short, usize::from(width) - 1),
            theme.style(role),
        );
        put(
            buffer,
            area,
            left,
            1,
            &format!("{:>1$}", series.unit, usize::from(width) - 1),
            theme.style(Role::Dim),
        );
        left += width;
    }
    let height = usize::from(area.height - 3);
    let row = order.iter().position(|position| *position == state.position).unwrap_or(0);
    let skip = row.saturating_sub(height / 2).min(order.len().saturating_sub(height));
    for (line, &position) in order.iter().skip(skip).take(height).enumerate() {
        draw_row(
            state,
            study,
            position,
            &columns,
            Rect { y: area.y + 2 + short(line), height: 1, ..area },
            buffer,
        );
    }
    let below = Rect { y: area.bottom() - 1, height: 1, ..area };
    status(state, study, &columns, below, buffer);
    scroll_bar(area, skip, height, order.len(), buffer);
}

fn draw_row(
    state: &State,
    study: &Study,
    position: usize,
    columns: &[(usize, u16)],
    area: Rect,
    buffer: &mut Buffer,
) {
    let here = position == state.position;
    let style = state.look.theme.style(if here { Role::Cursor } else { Role::Plain });
    let mut text = format!("{}{position:>4} ", if here { '>' } else { ' ' });
    for &(column, width) in columns {
        let value = study.column(column).map_or_else(String::new, |series| {
            let text = value(state, column, series, position);
            fitted(text, usize::from(width) - 1)
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

/// What stands in a cell: the value, or the difference to a second scene; of the coordinate always the value.
fn value(state: &State, column: usize, series: &Series, position: usize) -> String {
    match &state.compared {
        Some(compared) if column > 0 => compared.difference(series, position).map_or_else(
            || "-".to_owned(),
            |difference| {
                if difference.abs() <= series.floor { "0".to_owned() } else { number(difference) }
            },
        ),
        _ => series.bare(position),
    }
}

/// The columns from the chosen one's page, with their widths.
fn visible_columns(state: &State, study: &Study, room: u16) -> Vec<(usize, u16)> {
    let width = |column: usize| {
        let Some(series) = study.column(column) else { return COLUMN };
        COLUMN.max(short(series.short.chars().count().max(series.unit.len()) + 1))
    };
    let mut first = 0;
    loop {
        let mut used = 0;
        let mut columns = Vec::new();
        for column in first..study.column_count() {
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

fn status(state: &State, study: &Study, columns: &[(usize, u16)], area: Rect, buffer: &mut Buffer) {
    let of = study.column(state.chosen.column).map_or("", |series| series.of.as_str());
    let (first, last) = (columns.first().map_or(0, |c| c.0 + 1), columns.last().map_or(0, |c| c.0 + 1));
    let mut text = format!("{of}   {first}-{last} / {}", study.column_count());
    if let Some((column, up)) = state.sorted {
        let name = study.column(column).map_or("", |series| series.short.as_str());
        text.push_str("   ");
        text.push_str(&fill(state.texts.sorted_by, &[&name]));
        text.push(if up { '↑' } else { '↓' });
    }
    if let Some(compared) = &state.compared {
        text.push_str("   ");
        text.push_str(&fill(state.texts.table_less, &[&compared.name]));
    }
    let text = cut(&text, usize::from(area.width.saturating_sub(2)));
    put(buffer, area, 1, 0, &text, state.look.theme.style(Role::Dim));
}

/// Where in the rows one is.
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
