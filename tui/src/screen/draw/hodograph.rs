//! The path of the tip of a vector over the cycle, with the vector of one position.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::label::Labels;
use super::raster::{Raster, Stroke};
use super::scale::{Bounds, Scale, Zoom};
use crate::screen::number::plain;
use crate::screen::state::Look;
use crate::screen::theme::Role;
use crate::screen::view::mechanism::round_length;
use crate::screen::view::put;

/// Draws the hodograph of a vector given by its projections.
pub(crate) fn draw(
    title: &str,
    unit: &str,
    [xs, ys]: [&[f64]; 2],
    position: usize,
    area: Rect,
    look: Look,
    buffer: &mut Buffer,
) {
    if area.height < 4 || area.width < 12 {
        return;
    }
    put(buffer, area, 0, 0, title, look.theme.style(Role::Header));
    let plot = Rect { y: area.y + 1, height: area.height - 2, ..area };
    let mut bounds = Bounds::EMPTY;
    bounds.add([0.0, 0.0]);
    xs.iter().zip(ys).for_each(|(x, y)| bounds.add([*x, *y]));
    let scale = Scale::fit(bounds, plot, look.ratio, Zoom::WHOLE);
    let mut raster = Raster::new(plot, look.marker);
    let mut labels = Labels::new(plot);
    let tips: Vec<[f64; 2]> = xs.iter().zip(ys).map(|(x, y)| scale.cell([*x, *y])).collect();
    for two in tips.windows(2) {
        raster.line(two[0], two[1], Stroke::Dotted(2), look.theme.style(Role::Second));
    }
    let origin = scale.cell([0.0, 0.0]);
    if let Some(tip) = tips.get(position).filter(|tip| tip[0].is_finite()) {
        raster.line(origin, *tip, Stroke::Solid, look.theme.style(Role::First));
        labels.put(*tip, "x", look.theme.style(Role::Header));
    }
    labels.put(origin, "+", look.theme.style(Role::Header));
    raster.paint(plot, buffer);
    labels.write(&raster, buffer);
    let length = round_length(10.0 * scale.meters);
    let dashes = "-".repeat(super::raster::whole((length / scale.meters).round().clamp(2.0, 40.0)) - 1);
    let text = format!("|{dashes}| {} {unit}", plain(length));
    put(buffer, area, 0, area.height - 1, &text, look.theme.style(Role::Dim));
}
