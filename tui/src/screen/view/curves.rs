//! PF0, PF1, PF2 of one quantity, stacked over one axis.

use std::fmt::Write;

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use crate::number::{number, plain};
use crate::screen::draw::{Chart, LABELS, Mark, column_of, position_of, put, short};
use crate::screen::state::{Found, Role, Scene, State, View, zeros};

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(transfer) = scene.transfers.get(state.chosen.transfer) else { return };
    let [title, charts, axis] =
        Layout::vertical([Constraint::Length(1), Constraint::Min(0), Constraint::Length(2)]).areas(area);
    draw_title(state, scene, &transfer.name, title, buffer);
    let zero = transfer.orders.map(|index| zeros(&scene.series[index].values, scene.closed()));
    let stacked: [Rect; 3] = Layout::vertical([Constraint::Ratio(1, 3); 3]).areas(charts);
    for (order, role) in [Role::First, Role::Second, Role::Third].into_iter().enumerate() {
        let series = &scene.series[transfer.orders[order]];
        let mut title = format!("PF{order}  {} {}", number(series.at(state.position)), series.unit);
        let mut curves = vec![(series.values.as_slice(), state.look.theme.style(role))];
        if let Some(compared) = &state.compared
            && let Some(other) = compared.series(series)
        {
            curves.push((other.values.as_slice(), state.look.theme.style(Role::Plain)));
            let difference = compared.difference(series, state.position).unwrap_or(f64::NAN);
            let _ = write!(title, "   1 - 2: {} {}", number(difference), series.unit);
        }
        // The zeros of the first derivative mark extremes, those of the second one inflections.
        let kinds = [Mark::Zero, Mark::Extreme, Mark::Inflection];
        let marks =
            zero[order..].iter().zip(kinds).flat_map(|(at, mark)| at.iter().map(move |at| (*at, mark)));
        let (marks, cursor, floor) = (marks.collect(), state.position, series.floor);
        Chart { title, curves, marks, cursor, floor, places: None }.draw(stacked[order], state.look, buffer);
    }
    coordinate_axis(state, scene, axis, buffer);
}

fn draw_title(state: &State, scene: &Scene, name: &str, area: Rect, buffer: &mut Buffer) {
    let header = state.look.theme.style(Role::Header);
    if let Some(compared) = &state.compared {
        let own = scene.source.short_name();
        put(buffer, area, 1, 0, &format!("{name}   1 {own} (line)  2 {} (stars)", compared.name), header);
        return;
    }
    put(buffer, area, 1, 0, name, header);
    let legend = "o extreme  x zero  + inflection";
    let column = area.width.saturating_sub(short(legend.len()) + 1);
    put(buffer, area, column, 0, legend, state.look.theme.style(Role::Dim));
}

/// Charts of these series of the analysis, and of the corresponding ones of another analyzer, over one axis.
pub(super) fn draw_stack(
    state: &State,
    scene: &Scene,
    found: &Found,
    wanted: &[usize],
    area: Rect,
    buffer: &mut Buffer,
) {
    let [charts, axis] = Layout::vertical([Constraint::Min(0), Constraint::Length(2)]).areas(area);
    let count = u32::try_from(wanted.len()).unwrap_or(1);
    let stacked = Layout::vertical(vec![Constraint::Ratio(1, count); wanted.len()]).split(charts);
    let theme = state.look.theme;
    for (index, place) in wanted.iter().zip(stacked.iter()) {
        let series = &found.series[*index];
        let other = scene.other.as_ref().filter(|_| state.view == View::Forces);
        let other = other.and_then(|other| other.series.iter().find(|other| other.of == series.of));
        let mut curves = vec![(series.values.as_slice(), theme.style(Role::First))];
        curves.extend(other.map(|other| (other.values.as_slice(), theme.style(Role::Third))));
        let title = format!("{}  {}", series.of, series.show(state.position));
        Chart { title, curves, cursor: state.position, floor: series.floor, ..Chart::default() }
            .draw(*place, state.look, buffer);
    }
    coordinate_axis(state, scene, axis, buffer);
}

/// The common axis: the coordinate of five positions from the first to the last.
fn coordinate_axis(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let series = &scene.series[0];
    let (count, width) = (scene.positions(), area.width.saturating_sub(LABELS + 1));
    for part in 0..=4_usize {
        let position = part * count.saturating_sub(1) / 4;
        let text = plain(series.at(position));
        let at = LABELS + column_of(position, count, width);
        let column = at.min(area.width.saturating_sub(short(text.len())));
        put(buffer, area, column, 0, &text, state.look.theme.style(Role::Plain));
    }
    let text = format!("coordinate, {}", series.unit);
    put(buffer, area, LABELS, 1, &text, state.look.theme.style(Role::Dim));
}

/// The position under a column of the screen.
pub(crate) fn position_at(state: &State, area: Rect, column: u16) -> Option<usize> {
    let left = area.x + LABELS;
    let width = area.width.saturating_sub(LABELS + 1);
    (column >= left && column < left + width).then(|| position_of(column - left, state.positions(), width))
}
