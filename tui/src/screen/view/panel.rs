//! The numbers next to the drawing: coordinate, speed, the chosen quantity, every link and slide.

use assur_mechanism::Motion;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::arrows;
use crate::number::digits;
use crate::screen::draw::{put_lines, wrapped};
use crate::screen::state::{Role, Scene, State};

/// Draws the panel; `drawing` is the area of the arrows.
pub(super) fn draw(state: &State, scene: &Scene, drawing: Rect, area: Rect, buffer: &mut Buffer) {
    let plain = |text: String| (Role::Plain, text);
    let mut lines: Vec<_> = input(state, scene).into_iter().map(plain).collect();
    lines.push(plain(String::new()));
    if let Some(Some(failure)) = scene.failures.get(state.position) {
        let rows = wrapped(failure, usize::from(area.width.max(8)) - 2);
        lines.extend(rows.into_iter().map(|line| (Role::Bad, line)));
    } else {
        lines.extend(quantities(state, scene));
        // The legend and the scale of the arrows, at the foot of the panel.
        let legend = arrows::legend(state, scene, drawing);
        lines.resize(usize::from(area.height).saturating_sub(legend.len() + 1), plain(String::new()));
        lines.extend(legend);
    }
    put_lines(buffer, area, 1, state.look, &lines);
}

/// Coordinate and speed of the input, and the balancing load.
fn input(state: &State, scene: &Scene) -> Vec<String> {
    let at = state.position;
    let mut lines = vec![format!("coordinate {}", scene.series[0].show(at))];
    let unit = if scene.linkage.angular() { "rad/s" } else { "m/s" };
    let found = scene.found.as_ref();
    // In a steady regime the speed is a result, one for each position.
    let own = found.and_then(|found| found.series.iter().find(|series| series.short == "w"));
    let speed = match scene.linkage.mechanism.motion {
        Some(Motion::Prescribed { speed, .. }) => Some(format!("{} {unit}", digits(speed, 5))),
        _ => own.map(|series| series.show(at)),
    };
    lines.extend(speed.map(|speed| format!("speed {speed}")));
    let balancing = found.and_then(|found| found.balancing());
    lines.extend(balancing.map(|series| format!("balance {}", series.show(at))));
    lines
}

/// PF0, PF1, PF2 of the chosen quantity, then PF0 of the others.
fn quantities(state: &State, scene: &Scene) -> Vec<(Role, String)> {
    let Some(transfer) = scene.transfers.get(state.chosen.transfer) else { return Vec::new() };
    let show = |index: usize| scene.series[index].show(state.position);
    let mut lines = vec![(Role::Header, transfer.name.clone())];
    let orders = transfer.orders.iter().enumerate();
    lines.extend(orders.map(|(order, index)| (Role::Plain, format!(" PF{order} {}", show(*index)))));
    lines.push((Role::Plain, String::new()));
    let others =
        scene.transfers.iter().filter(|other| other.name != transfer.name).map(|other| other.orders[0]);
    lines.extend(others.map(|first| (Role::Plain, format!("{} {}", scene.series[first].short, show(first)))));
    lines
}
