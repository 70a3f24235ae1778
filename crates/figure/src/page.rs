//! Figures on paper: elements at places in millimeters, y downwards, before they are written as SVG.

mod axes;
mod element;
mod legend;
mod names;
pub(crate) mod plane;

pub(crate) use element::Element;

use assur_words::{Language, Text};

use crate::model::{Figure, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use crate::sign::{Form, Shape, shapes};
use element::{Outline, circle, polygon, polyline, text};
pub(crate) use names::Names;

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

/// A page, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Page {
    /// Of this width and height.
    Of([f64; 2]),
    /// Of this width and height for curves; planes shrink to their drawings, and the page with them, but that it may grow by its legend and
    /// for rows of planes.
    Within([f64; 2]),
}

impl From<[f64; 2]> for Page {
    fn from(size: [f64; 2]) -> Self {
        Self::Of(size)
    }
}

/// Least width of a page that shrinks to its drawing, least height of a row of planes, and least width of a panel beside others, mm.
const LEAST_PAGE: f64 = 100.0;
const LEAST_ROW: f64 = 80.0;
const SHARE: f64 = 65.0;

/// The elements of a figure on a page, and the width and height of the page, mm.
pub(crate) fn elements(figure: &Figure, page: Page, language: &Language) -> (Vec<Element>, [f64; 2]) {
    let (Page::Of(size) | Page::Within(size)) = page;
    let [width, height] = size.map(|side| side - 2.0 * BORDER);
    let title = |width| names::wrapped(&plain(&figure.title, language), width);
    let rows = legend::rows(figure, width, language);
    let free = [width, height - LINE * (title(width).len() + rows.len()) as f64];
    let (mut rooms, mut used) = (cells(figure, free), free);
    if let Page::Within(_) = page {
        let is_plane = |panel: &Panel| matches!(panel.frame, Frame::Plane { .. });
        let high = height.max(LEAST_ROW * figure.rows() as f64);
        let free = if figure.panels.iter().all(is_plane) { [width, high] } else { free };
        (rooms, used) = shrunk(figure, free, language);
    }
    let aside = (legend::width(&rows).max(LEAST_PAGE).min(width) - used[0]).max(0.0);
    let title = title(used[0] + aside);
    let above = BORDER + LINE * title.len() as f64;
    for room in &mut rooms {
        (room.left, room.top) = (room.left + BORDER + 0.5 * aside, room.top + above);
    }
    let baseline = |row: usize| [BORDER, BORDER + EM + row as f64 * LINE];
    let lines = title.iter().enumerate();
    let mut elements: Vec<_> =
        lines.map(|(row, line)| text(baseline(row), line, Ink::Title, "start")).collect();
    let numbers = axes::numbers(figure, used[1], language);
    for (index, (panel, room)) in figure.panels.iter().zip(rooms).enumerate() {
        elements.extend(match panel.frame {
            Frame::Plane { .. } => plane::elements(panel, room, language),
            Frame::Axes { .. } => axes::elements(panel, figure.shows_axis(index), numbers, room, language),
        });
    }
    let bottom = above + used[1];
    elements.extend(legend::elements(&rows, [BORDER, bottom + LINE]));
    let needed = [used[0] + aside + 2.0 * BORDER, bottom + LINE * rows.len() as f64 + BORDER];
    let needed = needed.map(|side| (100.0 * side).round() / 100.0);
    (elements, if let Page::Of(size) = page { size } else { needed })
}

/// The rooms of the panels; rows of panels are equally high apart from the rows of their axes.
fn cells(figure: &Figure, [width, height]: [f64; 2]) -> Vec<Room> {
    let columns = figure.columns.max(1);
    let below = |row: usize| if figure.has_axis_below(row) { axes::BELOW } else { 0.0 };
    let all: f64 = (0..figure.rows()).map(below).sum();
    let (width, height) = (width / columns as f64, (height - all) / figure.rows().max(1) as f64);
    let cell = |index: usize| {
        let (row, column) = (index / columns, index % columns);
        let top = row as f64 * height + (0..row).map(below).sum::<f64>();
        Room { left: column as f64 * width, top, width, height: height + below(row) }
    };
    (0..figure.panels.len()).map(cell).collect()
}

/// The rooms of the panels in a width, with the width and height of all: each plane has what its drawing needs, curves have the rest of
/// their row.
fn shrunk(figure: &Figure, [width, height]: [f64; 2], language: &Language) -> (Vec<Room>, [f64; 2]) {
    let is_plane = |panel: &Panel| matches!(panel.frame, Frame::Plane { .. });
    let columns = figure.columns.max(1);
    let mut rooms = cells(figure, [width, height]);
    let mut used = [0.0_f64; 2];
    for (row, panels) in rooms.chunks_mut(columns).zip(figure.panels.chunks(columns)) {
        let share = SHARE.min(width / panels.len() as f64);
        let mut rest = width - share * panels.len() as f64;
        for (room, panel) in row.iter_mut().zip(panels).filter(|(_, panel)| is_plane(panel)) {
            *room = plane::shrunk(panel, Room { width: share + rest, ..*room }, language);
            rest += share - room.width;
        }
        let curves = panels.iter().filter(|panel| !is_plane(panel)).count();
        let high = row.iter().map(|room| room.height).fold(0.0, f64::max);
        let mut left = 0.0;
        for (room, panel) in row.iter_mut().zip(panels) {
            let width = if is_plane(panel) { room.width } else { share + rest / curves as f64 };
            *room = Room { left, top: used[1], width, height: high };
            left += width;
        }
        used = [used[0].max(left), used[1] + high];
    }
    (rooms, used)
}

/// A heading without the quotes by which names of the scene are told apart in running text.
pub(crate) fn plain(title: &Text, language: &Language) -> String {
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
            names.keep_sign(*at, *along, *sign);
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
    let outline = |filled| Outline { ink, width: width::LINE, filled };
    let element = |shape: Shape| match shape.form {
        Form::Circle { at, radius } => circle(at, radius, outline(Some(shape.filled))),
        Form::Polygon(corners) => polygon(&corners, outline(Some(shape.filled))),
        Form::Line(ends) => polyline(&ends, Stroke::Solid, ink),
        Form::Fine(ends) => element::fine(&ends, ink),
    };
    shapes(at, along, sign, EM).into_iter().map(element).collect()
}
