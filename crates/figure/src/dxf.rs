//! Figures as DXF of release 12, in ASCII: what every program for drawings opens.
//!
//! A plane of lengths is drawn in its own coordinates, a unit is a millimeter of the mechanism; another plane (a plan, a polygon)
//! to a round scale, a unit is a millimeter of paper. The first plane stands at its place, the others beside it. What a line
//! stands for is its layer; a line through points of a circle at equal steps is an arc. Plots over two axes can't be said.

mod arc;
#[cfg(test)]
mod tests;
mod write;

use assur_words::{Language, Text, text};

use crate::bounds::Bounds;
use crate::letters::flat;
use crate::model::{Figure, Frame, Item, Panel, Point, Stroke};
use crate::page::{self, EM, Element, Names, Room, Style, plain, plane};
use crate::sign::{Form, shapes};
use crate::trace::Paper;
use write::{Drawing, Layer};

/// Greatest side of a plane on paper, mm: it gives the size of texts and signs.
const SIDE: f64 = 140.0;
/// Distance between planes, in text sizes.
const APART: f64 = 6.0;
/// Half side of the paper, mm: names may stand wherever they cover least.
const PAPER: f64 = 1e6;

/// Figures below each other, the panels of each side by side.
///
/// # Errors
///
/// A panel that is a plot over two axes, or nothing to draw.
pub fn write(figures: &[Figure], language: &Language) -> Result<String, Text> {
    let panels = figures.iter().flat_map(|figure| &figure.panels);
    if panels.clone().next().is_none()
        || panels.clone().any(|panel| matches!(panel.frame, Frame::Axes { .. }))
    {
        return Err(text!("figure-dxf-planes"));
    }
    let mut drawing = Drawing::default();
    // Where the next row begins: its left and its upper edge.
    let mut corner: Option<Point> = None;
    for figure in figures {
        let (mut left, mut lowest) = (corner.map(|corner| corner[0]), f64::INFINITY);
        for (index, panel) in figure.panels.iter().enumerate() {
            let Some(sheet) = Sheet::of(panel) else { continue };
            let [low, high] = sheet.corners();
            let shift =
                [left.map_or(0.0, |left| left - low[0]), corner.map_or(0.0, |corner| corner[1] - high[1])];
            let titles = if index == 0 {
                [Some(&figure.title), Some(&panel.title)]
            } else {
                [None, Some(&panel.title)]
            };
            sheet.draw(panel, titles, shift, language, &mut drawing);
            left = Some(high[0] + shift[0] + APART * EM * sheet.factor);
            lowest = lowest.min(low[1] + shift[1] - APART * EM * sheet.factor);
            corner = corner.or(Some([low[0], high[1]]));
        }
        corner = corner.map(|[left, _]| [left, lowest]);
    }
    Ok(drawing.finish())
}

/// A page of elements, a unit is a millimeter of paper.
pub fn page(elements: &[Element]) -> String {
    let mut drawing = Drawing::default();
    drawing.place(1.0, [0.0; 2]);
    for element in elements {
        let layer = Layer::Ink(element.ink);
        match &element.form {
            page::Form::Line { points, dashes, .. } => {
                let finite = points.iter().filter(|at| at[0].is_finite() && at[1].is_finite());
                let points: Vec<Point> = finite.copied().collect();
                let stroke = match dashes {
                    [] => Stroke::Solid,
                    [_, _] if dashes[0] > 1.0 => Stroke::Dashed,
                    [_, _] => Stroke::Dotted,
                    _ => Stroke::Chain,
                };
                drawing.line(&points, layer, Some(stroke));
            }
            page::Form::Polygon { corners, .. } => drawing.outline(corners, layer),
            page::Form::Circle { at, radius, .. } => drawing.circle(*at, *radius, layer),
            page::Form::Text { seen: Some(false), .. } => {}
            page::Form::Text { at, words, size, narrow, .. } => {
                let left = element.bounds().map_or(at[0], |bounds| bounds[0]);
                drawing.narrow_text([left, at[1]], *size, *narrow, &flat(words), layer);
            }
        }
    }
    drawing.finish()
}

/// A plane on its way to the drawing: on paper in mm, y downwards, then larger by a factor.
struct Sheet<'a> {
    bounds: &'a Bounds,
    scales: &'a [crate::Scale],
    /// Units of the plane in a millimeter of paper.
    scale: f64,
    /// Units of the drawing in a millimeter of paper.
    factor: f64,
}

impl<'a> Sheet<'a> {
    fn of(panel: &'a Panel) -> Option<Self> {
        let Frame::Plane { bounds, scales } = &panel.frame else { return None };
        let [width, height] = bounds.size();
        let scale = plane::scaled(width.max(height) / SIDE, scales);
        let is_length = scales.first().is_some_and(|own| own.unit == "m");
        Some(Self { bounds, scales, scale, factor: if is_length { 1e3 * scale } else { 1.0 } })
    }

    /// Its lower left and its upper right corner in the drawing, with room for names and titles.
    fn corners(&self) -> [Point; 2] {
        let [low, high] =
            [self.bounds.low, self.bounds.high].map(|at| at.map(|x| if x.is_finite() { x } else { 0.0 }));
        let free = plane::MARGIN * EM * self.factor;
        let side = |at: Point, by: f64| at.map(|x| x / self.scale * self.factor + by);
        [side(low, -free), side(high, free)]
    }

    fn draw(
        &self,
        panel: &Panel,
        titles: [Option<&Text>; 2],
        shift: Point,
        language: &Language,
        drawing: &mut Drawing,
    ) {
        drawing.place(self.factor, shift);
        let paper =
            Paper { place: |at: Point| [at[0] / self.scale, -at[1] / self.scale], em: EM, gap: 0.1 * EM };
        let marks: Vec<Item> = panel.items.iter().flat_map(|item| paper.marks(item)).collect();
        let mut names = Names::new(
            Room { left: -PAPER, top: -PAPER, width: 2.0 * PAPER, height: 2.0 * PAPER, scale: 0.0 },
            EM,
        );
        for mark in &marks {
            draw_lines(mark, &mut names, drawing);
        }
        for mark in &marks {
            let Item::Name { at, text, ink, needed } = mark else { continue };
            let written = text.render(language);
            if let (at, true) = names.place(*at, &written, *needed) {
                drawing.text(at, EM, &written, Layer::Ink(*ink));
            }
        }
        self.titles(titles, shift, language, drawing);
    }

    /// Headings above the plane, and its scales below it.
    fn titles(&self, titles: [Option<&Text>; 2], shift: Point, language: &Language, drawing: &mut Drawing) {
        let [low, high] = self.corners();
        let paper = |[x, y]: Point| [x / self.factor, -y / self.factor];
        drawing.place(self.factor, shift);
        let lines: Vec<String> = titles.into_iter().flatten().map(|title| plain(title, language)).collect();
        let lines: Vec<&String> = lines.iter().filter(|line| !line.is_empty()).collect();
        for (row, line) in lines.iter().enumerate() {
            let [x, y] = paper([low[0], high[1]]);
            drawing.text(
                [x, y - Style::NOTE.row() * (lines.len() - row) as f64],
                EM,
                &flat(line),
                Layer::Titles,
            );
        }
        for (row, own) in self.scales.iter().enumerate() {
            let [x, y] = paper(low);
            let (_, words) = plane::told(own, self.scale, language);
            drawing.text([x, y + Style::NOTE.row() * (row + 1) as f64], EM, &flat(&words), Layer::Titles);
        }
    }
}

/// Lines, outlines and signs.
fn draw_lines(mark: &Item, names: &mut Names, drawing: &mut Drawing) {
    match mark {
        Item::Line { points, stroke, ink } => {
            names.avoid(points);
            for piece in points.split(|at| !(at[0].is_finite() && at[1].is_finite())) {
                drawing.line(piece, Layer::Ink(*ink), Some(*stroke));
            }
        }
        Item::Area { outline, ink } => {
            names.avoid(&[outline, &outline[..1.min(outline.len())]].concat());
            drawing.outline(outline, Layer::Ink(*ink));
        }
        Item::Sign { at, along, sign, ink } => {
            names.keep_sign(*at, *along, *sign);
            for shape in shapes(*at, *along, *sign, EM) {
                match shape.form {
                    Form::Circle { at, radius } => drawing.circle(at, radius, Layer::Ink(*ink)),
                    Form::Polygon(corners) => drawing.outline(&corners, Layer::Ink(*ink)),
                    Form::Line(ends) | Form::Fine(ends) => drawing.line(&ends, Layer::Ink(*ink), None),
                }
            }
        }
        _ => {}
    }
}
