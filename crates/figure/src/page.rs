//! Figures on paper: elements at places in millimeters, y downwards, before a writer gives them a form.

mod axes;
mod element;
mod legend;
mod names;
pub(crate) mod plane;
mod together;

pub use element::{Anchor, Element, Form, color};

use assur_words::{Language, Text};

use crate::model::{Figure, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use crate::sign::{self, Shape, shapes};
use element::{circle, polygon, polyline};
pub(crate) use names::Names;
pub use names::text_width;

/// Text size of figures in a text, mm.
pub const EM: f64 = 3.0;
/// Free border of the page and of each panel, mm.
const BORDER: f64 = 2.5;
/// Height of a line of text, in text sizes.
const LINE: f64 = 1.5;

/// How large letters and how wide lines are on paper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// Text size, mm.
    pub em: f64,
    /// Width of a link, mm.
    pub thick: f64,
    /// Width of a curve, an arrow, an outline, mm.
    pub line: f64,
    /// Width of hatching, dots, axes, mm.
    pub fine: f64,
    /// Whether the axes of curves have round scales, which are told.
    pub axes_to_scale: bool,
    /// Length of the sample of a stroke in a legend, in text sizes.
    pub sample: f64,
    /// Least width of a page that shrinks to its drawing, and least height of a row of planes, mm.
    pub least: [f64; 2],
}

impl Style {
    /// Of figures in a text.
    pub const NOTE: Self = Self {
        em: EM,
        thick: 0.7,
        line: 0.35,
        fine: 0.18,
        axes_to_scale: false,
        sample: 2.5,
        least: [100.0, 80.0],
    };
    /// Of a drawing sheet: lines of ISO 128, and a text whose capitals and subscripts are 3.5 mm high.
    pub const SHEET: Self = Self {
        em: 5.0,
        thick: 0.8,
        line: 0.4,
        fine: 0.2,
        axes_to_scale: true,
        sample: 1.2,
        least: [30.0, 50.0],
    };

    /// Height of a line of text, mm.
    pub(crate) fn row(&self) -> f64 {
        LINE * self.em
    }
}

/// In which style and words a figure comes to paper.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Print<'a> {
    pub(crate) style: Style,
    pub(crate) language: &'a Language,
}

impl Print<'_> {
    fn width(&self, text: &str) -> f64 {
        names::text_width(text, self.style.em)
    }

    fn wrapped(&self, text: &str, width: f64) -> Vec<String> {
        names::wrapped(text, width, self.style.em)
    }

    fn text(&self, at: Point, words: &str, ink: Ink, anchor: Anchor) -> Element {
        Element::text(at, words, self.style.em, anchor, ink)
    }
}

/// A rectangle of the page: left, top, width, height, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Room {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// The least scale of a plane in it, units in a millimeter, where it has that of other planes; else 0.
    pub(crate) scale: f64,
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

/// Least width of a panel beside others, mm.
const SHARE: f64 = 65.0;

/// Where everything of a figure is on its page.
struct Arranged<'a> {
    title: Vec<String>,
    legend: legend::Rows<'a>,
    /// Of the panels.
    rooms: Vec<Room>,
    /// Height of the panels, and the place of their lower end.
    high: f64,
    bottom: f64,
    size: [f64; 2],
}

impl<'a> Arranged<'a> {
    fn of(figure: &'a Figure, page: Page, print: &Print<'_>) -> Self {
        let line = print.style.row();
        let (Page::Of(size) | Page::Within(size)) = page;
        let [width, height] = size.map(|side| side - 2.0 * BORDER);
        let title = |width| print.wrapped(&plain(&figure.title, print.language), width);
        let legend = legend::rows(figure, width, print);
        let free = [width, height - line * (title(width).len() + legend.len()) as f64];
        let (mut rooms, mut used) = (cells(figure, free, print), free);
        if let Page::Within(_) = page {
            let is_plane = |panel: &Panel| matches!(panel.frame, Frame::Plane { .. });
            let high = height.max(print.style.least[1] * figure.rows() as f64);
            let free = if figure.panels.iter().all(is_plane) { [width, high] } else { free };
            (rooms, used) = shrunk(figure, free, print);
        }
        let aside = (legend::width(&legend, print).max(print.style.least[0]).min(width) - used[0]).max(0.0);
        let title = title(used[0] + aside);
        let above = BORDER + line * title.len() as f64;
        for room in &mut rooms {
            (room.left, room.top) = (room.left + BORDER + 0.5 * aside, room.top + above);
        }
        let bottom = above + used[1];
        let needed = [used[0] + aside + 2.0 * BORDER, bottom + line * legend.len() as f64 + BORDER];
        let needed = needed.map(|side| (100.0 * side).round() / 100.0);
        let size = if let Page::Of(size) = page { size } else { needed };
        Self { title, legend, rooms, high: used[1], bottom, size }
    }
}

/// The width and height of the page of a figure, mm, with entries of its legend that are wider than the page.
pub fn size(figure: &Figure, page: Page, style: Style, language: &Language) -> [f64; 2] {
    let print = &Print { style, language };
    let Arranged { legend, size: [width, height], .. } = Arranged::of(figure, page, print);
    [width.max(legend::width(&legend, print) + 2.0 * BORDER), height]
}

/// How many units of the plane of its first panel a millimeter of a page stands for; `None` of curves.
pub fn plane_scale(figure: &Figure, page: Page, style: Style, language: &Language) -> Option<f64> {
    let print = &Print { style, language };
    let rooms = Arranged::of(figure, page, print).rooms;
    plane::scale_in(figure.panels.first()?, *rooms.first()?, print)
}

/// The elements of a figure on a page, and the width and height of the page, mm.
pub fn elements(figure: &Figure, page: Page, style: Style, language: &Language) -> (Vec<Element>, [f64; 2]) {
    let print = &Print { style, language };
    let line = style.row();
    let all = Arranged::of(figure, page, print);
    let baseline = |row: usize| [BORDER, BORDER + style.em + row as f64 * line];
    let lines = all.title.iter().enumerate();
    let mut elements: Vec<_> =
        lines.map(|(row, line)| print.text(baseline(row), line, Ink::Title, Anchor::Start)).collect();
    let numbers = axes::numbers(figure, all.high, print);
    for (index, (panel, room)) in figure.panels.iter().zip(all.rooms).enumerate() {
        elements.extend(match panel.frame {
            Frame::Plane { .. } => plane::elements(panel, room, print),
            Frame::Axes { .. } => axes::elements(panel, figure.shows_axis(index), numbers, room, print),
        });
    }
    elements.extend(legend::elements(&all.legend, [BORDER, all.bottom + line], print));
    (elements, all.size)
}

/// The rooms of the panels; rows of panels are equally high apart from the rows of their axes.
fn cells(figure: &Figure, [width, height]: [f64; 2], print: &Print<'_>) -> Vec<Room> {
    let columns = figure.columns.max(1);
    let below = |row: usize| if figure.has_axis_below(row) { axes::BELOW * print.style.row() } else { 0.0 };
    let all: f64 = (0..figure.rows()).map(below).sum();
    let (width, height) = (width / columns as f64, (height - all) / figure.rows().max(1) as f64);
    let cell = |index: usize| {
        let (row, column) = (index / columns, index % columns);
        let top = row as f64 * height + (0..row).map(below).sum::<f64>();
        Room { left: column as f64 * width, top, width, height: height + below(row), scale: 0.0 }
    };
    (0..figure.panels.len()).map(cell).collect()
}

/// The rooms of the panels in a width, with the width and height of all: each plane has what its drawing needs, curves have the rest of
/// their row. Planes of one kind have one scale.
fn shrunk(figure: &Figure, size: [f64; 2], print: &Print<'_>) -> (Vec<Room>, [f64; 2]) {
    if let Some(own) = together::placed(figure, size, print) {
        return own;
    }
    let [width, height] = size;
    let is_plane = |panel: &Panel| matches!(panel.frame, Frame::Plane { .. });
    let columns = figure.columns.max(1);
    let mut rooms = cells(figure, [width, height], print);
    let mut used = [0.0_f64; 2];
    for (row, panels) in rooms.chunks_mut(columns).zip(figure.panels.chunks(columns)) {
        let share = SHARE.min(width / panels.len() as f64);
        let mut rest = width - share * panels.len() as f64;
        for (room, panel) in row.iter_mut().zip(panels).filter(|(_, panel)| is_plane(panel)) {
            *room = plane::shrunk(panel, Room { width: share + rest, ..*room }, print);
            rest += share - room.width;
        }
        let curves = panels.iter().filter(|panel| !is_plane(panel)).count();
        let high = row.iter().map(|room| room.height).fold(0.0, f64::max);
        let mut left = 0.0;
        for (room, panel) in row.iter_mut().zip(panels) {
            let width = if is_plane(panel) { room.width } else { share + rest / curves as f64 };
            *room = Room { left, top: used[1], width, height: high, ..*room };
            left += width;
        }
        used = [used[0].max(left), used[1] + high];
    }
    (rooms, used)
}

/// A heading without the quotes by which names of the scene are told apart in running text.
pub(crate) fn plain(title: &Text, language: &Language) -> String {
    title.typeset(language).replace('`', "")
}

/// Lines of the heading of a panel.
const HEADING: usize = 2;

/// The least width of a panel in which its heading, and beside it the factor of the axis of curves, are not cut off, mm.
pub fn heading_width(panel: &Panel, style: Style, language: &Language) -> f64 {
    let print = &Print { style, language };
    let title = plain(&panel.heading(), language);
    let halves = title.match_indices(' ').map(|(at, _)| title.split_at(at));
    let widest = halves.map(|(first, rest)| print.width(first).max(print.width(rest)));
    let lines = widest.fold(print.width(&title), f64::min);
    let factor = match &panel.frame {
        Frame::Axes { y, .. } if style.axes_to_scale => axes::factor_room(y, print),
        _ => 0.0,
    };
    lines + factor + 2.0 * (style.em + BORDER)
}

fn heading(panel: &Panel, room: Room, print: &Print<'_>) -> Vec<Element> {
    let (title, em) = (plain(&panel.heading(), print.language), print.style.em);
    // The heading beside it is not to seem to go on with it.
    let width = room.width - em;
    let mut lines = print.wrapped(&title, width);
    if lines.len() > HEADING {
        lines = vec![names::fitted(&title, width, em)];
    }
    let place = |row: usize| [room.left, room.top + em + row as f64 * print.style.row()];
    let written = |(row, line): (usize, &String)| print.text(place(row), line, Ink::Title, Anchor::Start);
    lines.iter().enumerate().map(written).collect()
}

/// The elements of marks: lines first, then signs, then names where they cover least.
fn drawn(marks: &[Item], room: Room, print: &Print<'_>) -> Vec<Element> {
    let style = &print.style;
    let mut elements = Vec::new();
    let mut names = Names::new(room, style.em);
    for mark in marks {
        match mark {
            Item::Line { points, stroke, ink } => {
                names.avoid(points);
                elements.extend(stroked(points, *stroke, *ink, style));
            }
            Item::Area { outline, ink } => {
                names.avoid(&[outline, &outline[..1.min(outline.len())]].concat());
                elements.push(polygon(outline, style.thick, Some(0.15), *ink));
            }
            _ => {}
        }
    }
    for mark in marks {
        if let Item::Sign { at, along, sign, ink } = mark {
            names.keep_sign(*at, *along, *sign);
            elements.extend(sign_elements(*at, *along, *sign, *ink, style));
        }
    }
    for mark in marks {
        if let Item::Name { at, text: name, ink, needed } = mark {
            let name = name.typeset(print.language);
            let (at, is_seen) = names.place(*at, &name, *needed);
            let mut element = print.text(at, &name, *ink, Anchor::Start);
            // A name that is not seen stays, so that all frames of an animation have the same elements.
            if let Form::Text { seen, .. } = &mut element.form {
                *seen = Some(is_seen);
            }
            elements.push(element);
        }
    }
    elements
}

/// The elements of a line; it is interrupted where a point is not finite.
fn stroked(points: &[Point], stroke: Stroke, ink: Ink, style: &Style) -> Vec<Element> {
    let pieces = points.split(|at| !(at[0].is_finite() && at[1].is_finite()));
    let drawn = |piece: &[Point]| match piece {
        // A point without neighbors is no line, but a value.
        [alone] => circle(*alone, style.thick, style.fine, Some(1.0), ink),
        line => polyline(line, stroke, ink, style),
    };
    pieces.filter(|piece| !piece.is_empty()).map(drawn).collect()
}

fn sign_elements(at: Point, along: Point, sign: Sign, ink: Ink, style: &Style) -> Vec<Element> {
    let element = |shape: Shape| match shape.form {
        sign::Form::Circle { at, radius } => circle(at, radius, style.line, Some(shape.filled), ink),
        sign::Form::Polygon(corners) => polygon(&corners, style.line, Some(shape.filled), ink),
        sign::Form::Line(ends) => polyline(&ends, Stroke::Solid, ink, style),
        sign::Form::Fine(ends) => Element::line(ends, style.fine, ink),
    };
    shapes(at, along, sign, style.em).into_iter().map(element).collect()
}
