//! The numbers beside the drawing: coordinate, speed, the chosen quantity, every link and slide.

use assur_mechanism::Motion;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{arrows, put};
use crate::screen::draw::raster::short;
use crate::screen::number::digits;
use crate::screen::state::State;
use crate::screen::study::Study;
use crate::screen::theme::Role;

/// Draws the panel.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let lines = lines(state, study, area);
    for (row, (role, text)) in lines.iter().enumerate() {
        put(buffer, area, 1, short(row), text, state.look.theme.style(*role));
    }
}

fn lines(state: &State, study: &Study, area: Rect) -> Vec<(Role, String)> {
    let mut lines = Vec::new();
    let texts = state.texts;
    lines.push((Role::Plain, format!("{} {}", texts.coordinate, study.series[0].show(state.position))));
    if let Some(Motion::Prescribed { speed, .. }) = study.linkage.mechanism.motion {
        let unit = if study.linkage.angular() { "rad/s" } else { "m/s" };
        lines.push((Role::Plain, format!("{} {} {unit}", texts.speed, digits(speed, 5))));
    }
    // In a steady regime the speed is an answer, one for each position.
    let own = study.found.as_ref().and_then(|found| found.series.iter().find(|series| series.short == "w"));
    if let Some(series) = own.filter(|_| lines.len() == 1) {
        lines.push((Role::Plain, format!("{} {}", texts.speed, series.show(state.position))));
    }
    if let Some(found) = &study.found
        && let Some(balancing) = found.reactions.iter().find(|reaction| reaction.pair.is_empty())
    {
        let series = &found.series[balancing.series[0]];
        lines.push((Role::Plain, format!("{} {}", texts.balancing_short, series.show(state.position))));
    }
    if let Some(Some(failure)) = study.failures.get(state.position) {
        lines.push((Role::Plain, String::new()));
        lines.extend(
            wrapped(failure, usize::from(area.width.max(8)) - 2).into_iter().map(|line| (Role::Bad, line)),
        );
        return lines;
    }
    lines.push((Role::Plain, String::new()));
    chosen(state, study, &mut lines);
    arrow_scale(state, study, area, &mut lines);
    lines
}

/// A text in lines of at most so many characters, broken at spaces where it can be.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let Some(last) = lines.last_mut() else { break };
        if last.is_empty() {
            last.push_str(word);
        } else if last.chars().count() + 1 + word.chars().count() <= width {
            last.push(' ');
            last.push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// The beginning of a text; that something is missing is seen.
pub(crate) fn cut(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_owned();
    }
    text.chars().take(width.saturating_sub(1)).chain(['~']).collect()
}

/// PF0, PF1, PF2 of the chosen quantity, then PF0 of the others as far as there is room.
fn chosen(state: &State, study: &Study, lines: &mut Vec<(Role, String)>) {
    let Some(transfer) = study.transfers.get(state.chosen.transfer) else { return };
    lines.push((Role::Header, transfer.name.clone()));
    for (order, index) in transfer.orders.into_iter().enumerate() {
        lines.push((Role::Plain, format!(" PF{order} {}", study.series[index].show(state.position))));
    }
    lines.push((Role::Plain, String::new()));
    for other in &study.transfers {
        if other.name != transfer.name {
            let series = &study.series[other.orders[0]];
            lines.push((Role::Plain, format!("{} {}", series.short, series.show(state.position))));
        }
    }
}

/// What the arrows are and how long they are, at the foot of the panel.
fn arrow_scale(state: &State, study: &Study, area: Rect, lines: &mut Vec<(Role, String)>) {
    let drawing = Rect { width: state.size.0.saturating_sub(area.width), ..area };
    let legend = arrows::legend(state, study, drawing);
    let keep = usize::from(area.height).saturating_sub(legend.len() + 1);
    lines.truncate(keep);
    lines.resize_with(keep, || (Role::Plain, String::new()));
    lines.extend(legend);
}
