//! Figures on paper: elements at places in millimeters, y downwards, before they are written as SVG.

mod axes;
mod element;
mod legend;
mod names;
mod plane;

pub(crate) use element::Element;

use assur_words::{Language, Text};

use crate::model::{Figure, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use crate::trace::{block, shifted};
use element::{Outline, circle, polygon, polyline, text};
use names::Names;

/// Text size, mm.
pub const EM: f64 = 3.0;
/// Free border of the page and of each panel, mm.
const BORDER: f64 = 2.5;
/// Height of a line of text, mm.
pub(crate) const LINE: f64 = 1.5 * EM;

/// Widths of lines, mm.
mod width {
    /// A link.
    pub(super) const THICK: f64 = 0.7;
    /// A curve, an arrow, an outline.
    pub(super) const LINE: f64 = 0.35;
    /// Hatching, dots, axes.
    pub(super) const FINE: f64 = 0.18;
}

/// A rectangle of the page: left, top, width, height, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Room {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// The elements of a figure on a page of this width and height, mm.
pub(crate) fn elements(figure: &Figure, [width, height]: [f64; 2], language: &Language) -> Vec<Element> {
    let mut room =
        Room { left: BORDER, top: BORDER, width: width - 2.0 * BORDER, height: height - 2.0 * BORDER };
    let mut elements = Vec::new();
    for line in names::wrapped(&plain(&figure.title, language), room.width) {
        elements.push(text([room.left, room.top + EM], &line, Ink::Title, "start"));
        room.top += LINE;
        room.height -= LINE;
    }
    let rows = legend::rows(figure, room.width, language);
    room.height -= rows.len() as f64 * LINE;
    let mut unit = None;
    let numbers = axes::numbers(figure, room, language);
    for (index, panel) in figure.panels.iter().enumerate() {
        let part = cell(figure, index, room);
        elements.extend(match panel.frame {
            Frame::Plane { .. } => {
                let (drawn, width) = plane::elements(panel, part, language);
                unit.get_or_insert(width);
                drawn
            }
            Frame::Axes { .. } => axes::elements(panel, figure.shows_axis(index), numbers, part, language),
        });
    }
    let bottom = room.top + room.height + LINE;
    elements.extend(legend::elements(&rows, [room.left, bottom], unit.unwrap_or(1.0)));
    elements
}

/// The room of a panel; rows of panels are equally high apart from the rows of their axes.
fn cell(figure: &Figure, index: usize, room: Room) -> Room {
    let columns = figure.columns.max(1);
    let below = |row: usize| if figure.has_axis_below(row) { axes::BELOW } else { 0.0 };
    let (row, column) = (index / columns, index % columns);
    let all: f64 = (0..figure.rows()).map(below).sum();
    let (width, height) = (room.width / columns as f64, (room.height - all) / figure.rows().max(1) as f64);
    let above: f64 = (0..row).map(below).sum();
    Room {
        left: room.left + column as f64 * width,
        top: room.top + row as f64 * height + above,
        width,
        height: height + below(row),
    }
}

/// A heading without the quotes by which names of the scene are told apart in running text.
fn plain(title: &Text, language: &Language) -> String {
    title.render(language).replace('`', "")
}

const HEADING: usize = 2;

fn heading(panel: &Panel, room: Room, language: &Language) -> Vec<Element> {
    let title = plain(&panel.heading(), language);
    let mut lines = names::wrapped(&title, room.width);
    if lines.len() > HEADING {
        lines = vec![names::fitted(&title, room.width)];
    }
    let place = |row: usize| [room.left, room.top + EM + row as f64 * LINE];
    lines.iter().enumerate().map(|(row, line)| text(place(row), line, Ink::Title, "start")).collect()
}

/// The elements of marks: lines first, then signs, then names where they cover least.
fn drawn(marks: &[Item], room: Room, language: &Language) -> Vec<Element> {
    let mut elements = Vec::new();
    let mut names = Names::new(room);
    for mark in marks {
        match mark {
            Item::Line { points, stroke, ink } => {
                names.avoid(points);
                elements.extend(stroked(points, *stroke, *ink));
            }
            Item::Area { outline, ink } => {
                names.avoid(&[outline, &outline[..1.min(outline.len())]].concat());
                elements
                    .push(polygon(outline, Outline { ink: *ink, width: width::THICK, filled: Some(0.15) }));
            }
            _ => {}
        }
    }
    for mark in marks {
        if let Item::Sign { at, along, sign, ink } = mark {
            match sign {
                Sign::Hatch => names.avoid(&[*at, shifted(*at, *along, 0.4 * EM)]),
                Sign::Block => names.keep(*at, 0.5 * EM),
                Sign::Bearing => names.keep_bearing(*at),
                _ => names.keep(*at, 0.2 * EM),
            }
            elements.extend(sign_elements(*at, *along, *sign, *ink));
        }
    }
    for mark in marks {
        if let Item::Name { at, text: name, ink, needed } = mark {
            let name = name.render(language);
            let (at, seen) = names.place(*at, &name, *needed);
            let mut element = text(at, &name, *ink, "start");
            // A name that is not seen stays, so that all frames of an animation have the same elements.
            element.attributes.push(("visibility", if seen { "visible" } else { "hidden" }.to_owned()));
            elements.push(element);
        }
    }
    elements
}

/// The elements of a line; it is interrupted where a point is not finite.
fn stroked(points: &[Point], stroke: Stroke, ink: Ink) -> Vec<Element> {
    let pieces = points.split(|at| !(at[0].is_finite() && at[1].is_finite()));
    let drawn = |piece: &[Point]| match piece {
        // A point without neighbors is no line, but a value.
        [alone] => circle(*alone, width::THICK, Outline { ink, width: width::FINE, filled: Some(1.0) }),
        line => polyline(line, stroke, ink),
    };
    pieces.filter(|piece| !piece.is_empty()).map(drawn).collect()
}

fn sign_elements(at: Point, along: Point, sign: Sign, ink: Ink) -> Vec<Element> {
    let line = Outline { ink, width: width::LINE, filled: None };
    let paper = Outline { filled: Some(0.0), ..line };
    let full = Outline { filled: Some(1.0), ..line };
    let cross = |directions: [Point; 2]| {
        let ends = directions.map(|along| [shifted(at, along, -0.3 * EM), shifted(at, along, 0.3 * EM)]);
        ends.iter().map(|ends| polyline(ends, Stroke::Solid, ink)).collect()
    };
    match sign {
        Sign::Pin => vec![circle(at, 0.3 * EM, paper)],
        Sign::Dot | Sign::Node => vec![circle(at, 0.13 * EM, full)],
        Sign::Ring => vec![circle(at, 0.25 * EM, paper)],
        Sign::Star => vec![circle(at, 0.15 * EM, paper)],
        Sign::Cross => {
            let half = std::f64::consts::FRAC_1_SQRT_2;
            cross([[half, half], [half, -half]])
        }
        Sign::Plus => cross([[1.0, 0.0], [0.0, 1.0]]),
        Sign::Block => vec![polygon(&block(at, along, EM), paper)],
        Sign::Hatch => {
            // A stroke at half a right angle to the line.
            let slanted = [along[0] + along[1], along[1] - along[0]];
            let fine = [at, shifted(at, slanted, 0.4 * EM)];
            vec![element::fine(&fine, ink)]
        }
        Sign::Head => {
            let back = shifted(at, along, -0.8 * EM);
            let across = [-along[1], along[0]];
            vec![polygon(&[at, shifted(back, across, 0.22 * EM), shifted(back, across, -0.22 * EM)], full)]
        }
        Sign::Bearing => bearing(at, ink),
    }
}

fn bearing(at: Point, ink: Ink) -> Vec<Element> {
    let line = Outline { ink, width: width::LINE, filled: Some(0.0) };
    let base = at[1] + 1.1 * EM;
    let corner = |side: f64| [at[0] + side * EM, base];
    let hatching = (0..5).map(|stroke| {
        let x = at[0] + (-1.0 + 0.5 * f64::from(stroke)) * EM;
        element::fine(&[[x, base], [x - 0.4 * EM, base + 0.4 * EM]], ink)
    });
    let mut elements = vec![polygon(&[at, corner(-0.7), corner(0.7)], line)];
    elements.push(polyline(&[corner(-1.2), corner(1.2)], Stroke::Solid, ink));
    elements.extend(hatching);
    elements.push(circle(at, 0.3 * EM, line));
    elements
}
