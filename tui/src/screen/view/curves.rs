//! PF0, PF1, PF2 of one quantity, stacked over one axis.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::put;
use crate::screen::draw::chart::{Chart, Mark, position_of};
use crate::screen::number::number;
use crate::screen::series::zeros;
use crate::screen::state::State;
use crate::screen::study::Study;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Columns for the axis labels.
pub(crate) const LABELS: u16 = 11;

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let Some(transfer) = study.transfers.get(state.chosen.transfer) else { return };
    let theme = state.look.theme;
    let [title, charts, axis] =
        Layout::vertical([Constraint::Length(1), Constraint::Min(0), Constraint::Length(2)]).areas(area);
    put(buffer, title, 1, 0, &transfer.name, theme.style(Role::Header));
    let legend = format!("{}  {}  {}", state.texts.extremes, state.texts.zero, state.texts.inflection);
    let column = title.width.saturating_sub(u16::try_from(legend.len()).unwrap_or(0) + 1);
    put(buffer, title, column, 0, &legend, theme.style(Role::Dim));
    if let Some(compared) = &state.compared {
        let names = fill(state.texts.two_curves, &[&study.source.short_name(), &compared.name]);
        let names = format!("{}   {names}", transfer.name);
        put(
            buffer,
            title,
            1,
            0,
            &format!("{names:<width$}", width = usize::from(title.width)),
            theme.style(Role::Header),
        );
    }
    let closed = study.closed();
    let zero = transfer.orders.map(|index| zeros(&study.series[index].values, closed));
    let stacked: [Rect; 3] = Layout::vertical([Constraint::Ratio(1, 3); 3]).areas(charts);
    for (order, role) in [Role::First, Role::Second, Role::Third].into_iter().enumerate() {
        let series = &study.series[transfer.orders[order]];
        let mut marks: Vec<(f64, Mark)> = zero[order].iter().map(|at| (*at, Mark::Zero)).collect();
        if let Some(next) = zero.get(order + 1) {
            marks.extend(next.iter().map(|at| (*at, Mark::Extreme)));
        }
        if let Some(next) = zero.get(order + 2) {
            marks.extend(next.iter().map(|at| (*at, Mark::Inflection)));
        }
        let value = series.values.get(state.position).copied().unwrap_or(f64::NAN);
        let mut title = format!("PF{order}  {} {}", number(value), series.unit);
        let mut all = vec![(series.values.as_slice(), theme.style(role))];
        if let Some(compared) = &state.compared
            && let Some(other) = compared.series(series)
        {
            all.push((other.values.as_slice(), theme.style(Role::Plain)));
            let difference = compared.difference(series, state.position).unwrap_or(f64::NAN);
            title.push_str("   ");
            title.push_str(&fill(state.texts.less_other, &[&number(difference), &series.unit]));
        }
        let chart =
            Chart { title, curves: all, marks, cursor: state.position, floor: series.floor, places: None };
        chart.draw(stacked[order], LABELS, state.look, buffer);
    }
    coordinate_axis(state, study, axis, buffer);
}

/// The common axis: coordinate of the first, middle and last position.
pub(crate) fn coordinate_axis(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let series = &study.series[0];
    let style = state.look.theme.style(Role::Plain);
    let count = study.positions();
    let width = area.width.saturating_sub(LABELS + 1);
    for part in 0..=4_usize {
        let position = part * count.saturating_sub(1) / 4;
        let text = crate::screen::number::plain(series.values.get(position).copied().unwrap_or(0.0));
        let at = crate::screen::draw::chart::column_of(position, count, width);
        let column = (LABELS + at).min(area.width.saturating_sub(u16::try_from(text.len()).unwrap_or(0)));
        put(buffer, area, column, 0, &text, style);
    }
    let text = format!("{}, {}", state.texts.coordinate, series.unit);
    put(buffer, area, LABELS, 1, &text, state.look.theme.style(Role::Dim));
}

/// The position under a column of the screen.
pub(crate) fn position_at(state: &State, area: Rect, column: u16) -> Option<usize> {
    let left = area.x + LABELS;
    let width = area.width.saturating_sub(LABELS + 1);
    (column >= left && column < left + width).then(|| position_of(column - left, state.positions(), width))
}
