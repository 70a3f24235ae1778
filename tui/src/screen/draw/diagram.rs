//! Vectors in a plane of their own, with names, arrow heads and a scale.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::label::{Labels, head};
use super::raster::{Raster, Stroke};
use super::scale::Scale;
use super::text::put;
use crate::screen::state::{Bounds, Look, Role, Zoom};

/// Greatest length of the scale bar, in cell widths.
const BAR: f64 = 10.0;

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
    /// The pole, if the plan has one: it is marked, and names are at the tips, as in textbooks.
    pub(crate) pole: Option<&'a str>,
}

impl Diagram<'_> {
    /// Draws all vectors to one scale that fits.
    pub(crate) fn draw(&self, look: Look, area: Rect, buffer: &mut Buffer) {
        if self.arrows.is_empty() || area.width < 12 || area.height < 4 {
            return;
        }
        let plot = Rect { height: area.height - 1, ..area };
        let bounds = Bounds::around(self.arrows.iter().flat_map(|arrow| [arrow.from, arrow.to]));
        let scale = Scale::fit(bounds, plot, look.ratio, Zoom::WHOLE);
        let mut raster = Raster::new(plot, look.marker);
        let mut labels = Labels::new(plot);
        let header = look.theme.style(Role::Header);
        for arrow in &self.arrows {
            let (from, to, style) =
                (scale.cell(arrow.from), scale.cell(arrow.to), look.theme.style(arrow.role));
            let stroke = if arrow.name.is_empty() { Stroke::Dotted(3) } else { Stroke::Solid };
            raster.line(from, to, stroke, style);
            if !arrow.name.is_empty() {
                let (dx, dy) = (to[0] - from[0], look.ratio * (to[1] - from[1]));
                // An arrow that is too short to point ends in a dot.
                labels.put(to, if dx.hypot(dy) < 1.0 { "o" } else { head([dx, dy]) }, style);
            }
        }
        for arrow in self.arrows.iter().filter(|arrow| !arrow.name.is_empty()) {
            let part = if self.pole.is_some() { 1.0 } else { 0.6 };
            let at = [0, 1].map(|axis| (1.0 - part) * arrow.from[axis] + part * arrow.to[axis]);
            labels.beside(&raster, scale.cell(at), &arrow.name, header);
        }
        if let Some(pole) = self.pole {
            let at = scale.cell([0.0; 2]);
            labels.put(at, "o", header);
            labels.beside(&raster, at, pole, header);
        }
        raster.paint(plot, buffer);
        labels.write(&raster, buffer);
        let bar = scale.bar(BAR, 1.0, self.unit);
        put(buffer, area, 0, area.height - 1, &bar, look.theme.style(Role::Dim));
    }
}

/// The path of the tip of a vector over the cycle, with the vector of one position.
#[derive(Debug)]
pub(crate) struct Hodograph<'a> {
    pub(crate) title: &'a str,
    /// Unit of the scale.
    pub(crate) unit: &'a str,
    /// Both projections over the positions.
    pub(crate) projections: [&'a [f64]; 2],
    pub(crate) position: usize,
}

impl Hodograph<'_> {
    /// Draws the path around its origin, to one scale that fits.
    pub(crate) fn draw(&self, look: Look, area: Rect, buffer: &mut Buffer) {
        if area.height < 4 || area.width < 12 {
            return;
        }
        let header = look.theme.style(Role::Header);
        put(buffer, area, 0, 0, self.title, header);
        let plot = Rect { y: area.y + 1, height: area.height - 2, ..area };
        let [xs, ys] = self.projections;
        let tips = || xs.iter().zip(ys).map(|(x, y)| [*x, *y]);
        let bounds = Bounds::around(tips().chain([[0.0; 2]]));
        let scale = Scale::fit(bounds, plot, look.ratio, Zoom::WHOLE);
        let mut raster = Raster::new(plot, look.marker);
        let mut labels = Labels::new(plot);
        let tips: Vec<[f64; 2]> = tips().map(|tip| scale.cell(tip)).collect();
        for two in tips.windows(2) {
            raster.line(two[0], two[1], Stroke::Dotted(2), look.theme.style(Role::Second));
        }
        let origin = scale.cell([0.0; 2]);
        if let Some(tip) = tips.get(self.position).filter(|tip| tip[0].is_finite()) {
            raster.line(origin, *tip, Stroke::Solid, look.theme.style(Role::First));
            labels.put(*tip, "x", header);
        }
        labels.put(origin, "+", header);
        raster.paint(plot, buffer);
        labels.write(&raster, buffer);
        let bar = scale.bar(BAR, 1.0, self.unit);
        put(buffer, area, 0, area.height - 1, &bar, look.theme.style(Role::Dim));
    }
}
