//! Vectors in a plane of their own, with names, heads and a scale.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::label::Labels;
use super::raster::{Raster, Stroke, whole};
use super::scale::{Scale, Zoom};
use crate::screen::number::plain;
use crate::screen::plans::bounds;
use crate::screen::state::Look;
use crate::screen::theme::Role;
use crate::screen::view::mechanism::round_length;
use crate::screen::view::put;

/// A vector from one point to another.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Arrow {
    pub(crate) from: [f64; 2],
    pub(crate) to: [f64; 2],
    /// May be empty: then it is a thin line.
    pub(crate) name: String,
    pub(crate) role: Role,
}

/// Vectors that are drawn together.
#[derive(Debug)]
pub(crate) struct Diagram<'a> {
    pub(crate) arrows: Vec<Arrow>,
    /// Unit of the scale.
    pub(crate) unit: &'a str,
    /// The pole, where a plan has one: it is marked, and names stand at the tips, as in textbooks.
    pub(crate) pole: Option<&'a str>,
}

impl Diagram<'_> {
    /// Draws all to one scale that fits.
    pub(crate) fn draw(&self, look: Look, area: Rect, buffer: &mut Buffer) {
        if self.arrows.is_empty() || area.width < 12 || area.height < 4 {
            return;
        }
        let plot = Rect { height: area.height - 1, ..area };
        let scale = Scale::fit(
            bounds(self.arrows.iter().flat_map(|a| [a.from, a.to])),
            plot,
            look.ratio,
            Zoom::WHOLE,
        );
        let mut raster = Raster::new(plot, look.marker);
        let mut labels = Labels::new(plot);
        for arrow in &self.arrows {
            let (from, to) = (scale.cell(arrow.from), scale.cell(arrow.to));
            let stroke = if arrow.name.is_empty() { Stroke::Dotted(3) } else { Stroke::Solid };
            raster.line(from, to, stroke, look.theme.style(arrow.role));
            if !arrow.name.is_empty() {
                labels.put(to, head(from, to, look.ratio), look.theme.style(arrow.role));
            }
        }
        for arrow in self.arrows.iter().filter(|arrow| !arrow.name.is_empty()) {
            let part = if self.pole.is_some() { 1.0 } else { 0.6 };
            let at = [0, 1].map(|axis| (1.0 - part) * arrow.from[axis] + part * arrow.to[axis]);
            labels.beside(&raster, scale.cell(at), &arrow.name, look.theme.style(Role::Header));
        }
        if let Some(pole) = self.pole {
            let at = scale.cell([0.0; 2]);
            labels.put(at, "o", look.theme.style(Role::Header));
            labels.beside(&raster, at, pole, look.theme.style(Role::Header));
        }
        raster.paint(plot, buffer);
        labels.write(&raster, buffer);
        let length = round_length(10.0 * scale.meters);
        let dashes = "-".repeat(whole((length / scale.meters).round().clamp(2.0, 40.0)) - 1);
        let text = format!("|{dashes}| {} {}", plain(length), self.unit);
        put(buffer, area, 0, area.height - 1, &text, look.theme.style(Role::Dim));
    }
}

/// The character of an arrow's head; a dot where the arrow is too short to point.
fn head(from: [f64; 2], to: [f64; 2], ratio: f64) -> &'static str {
    let (dx, dy) = (to[0] - from[0], ratio * (to[1] - from[1]));
    match () {
        () if dx.hypot(dy) < 1.0 => "o",
        () if dx.abs() >= dy.abs() => {
            if dx > 0.0 {
                ">"
            } else {
                "<"
            }
        }
        () if dy > 0.0 => "v",
        () => "^",
    }
}
