//! What stands on paper: lines, polygons, circles and texts at places in millimeters, before a writer gives them a form.

use super::Style;
use super::names::text_width;
use crate::bounds::Bounds;
use crate::letters::indexed;
use crate::model::{Ink, Point, Stroke};

/// One thing on paper.
#[derive(Debug, Clone, PartialEq)]
pub struct Element {
    /// Its outline, or its letters.
    pub form: Form,
    /// What it stands for.
    pub ink: Ink,
    /// Width of its line, mm; a text has none.
    pub width: f64,
}

/// The outline of an element; places are in millimeters, y downwards.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// A line from point to point.
    Line {
        /// The points; those that are not finite are left out.
        points: Vec<Point>,
        /// Lengths of dashes and gaps in turn, mm; none: a whole line.
        dashes: &'static [f64],
        /// How much it covers, where it is not all: a grid is seen behind the curves.
        opacity: Option<f64>,
    },
    /// A closed outline.
    Polygon {
        /// Its corners.
        corners: Vec<Point>,
        /// How much of its ink fills it: 0 paper, 1 all; `None`: what is below is seen.
        filled: Option<f64>,
    },
    /// A circle.
    Circle {
        /// Its center.
        at: Point,
        /// Its radius, mm.
        radius: f64,
        /// As of a polygon.
        filled: Option<f64>,
    },
    /// A text on its baseline.
    Text {
        /// Where it is anchored.
        at: Point,
        /// Its letters, with subscripts as `_{...}` and superscripts as `^{...}`.
        words: String,
        /// Text size, mm.
        size: f64,
        /// Which part of it stands there.
        anchor: Anchor,
        /// Width of its letters as part of that of the font: below 1 they are narrow.
        narrow: f64,
        /// Whether it is seen, of a name that may be hidden.
        seen: Option<bool>,
    },
}

/// The part of a text that stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its beginning.
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

/// Colors of the links, which differ for most color-blind readers (after Okabe and Ito).
const LINKS: [&str; 6] = ["#0072b2", "#d55e00", "#56799a", "#b8860b", "#7b3294", "#4d4d4d"];

/// The color of an ink, as SVG has it.
pub fn color(ink: Ink) -> &'static str {
    match ink {
        Ink::Text | Ink::Title | Ink::Ground => "#000000",
        Ink::Dim => "#707070",
        Ink::Link(number) => LINKS[number.saturating_sub(1) % LINKS.len()],
        Ink::Marked => "#e60000",
        Ink::Trace => "#8c8c8c",
        Ink::Velocity | Ink::Second => "#009e73",
        Ink::Acceleration | Ink::Third => "#c2417c",
        Ink::First => "#0072b2",
        Ink::Cursor => "#e69f00",
    }
}

impl Element {
    /// The same at another place.
    #[must_use]
    pub fn moved(mut self, by: Point) -> Self {
        let shift = |at: &mut Point| *at = [at[0] + by[0], at[1] + by[1]];
        match &mut self.form {
            Form::Line { points: all, .. } | Form::Polygon { corners: all, .. } => {
                all.iter_mut().for_each(shift);
            }
            Form::Circle { at, .. } | Form::Text { at, .. } => shift(at),
        }
        self
    }

    /// A line of this width, mm.
    pub fn line(points: impl Into<Vec<Point>>, width: f64, ink: Ink) -> Self {
        Self { form: Form::Line { points: points.into(), dashes: &[], opacity: None }, ink, width }
    }

    /// Makes the letters of a text narrow, so that what is so wide, mm, has this width at most.
    pub fn narrowed(&mut self, width: f64, room: f64) {
        if let Form::Text { narrow, .. } = &mut self.form {
            *narrow = (room / width).min(1.0);
        }
    }

    /// The left, the top, the right and the bottom of what is seen of it, mm; `None` of a hidden name.
    pub fn bounds(&self) -> Option<[f64; 4]> {
        let around = |all: &[Point], by: f64| {
            let own = Bounds::around(all.iter().copied());
            Some([own.low[0] - by, own.low[1] - by, own.high[0] + by, own.high[1] + by])
        };
        match &self.form {
            Form::Line { points: all, .. } | Form::Polygon { corners: all, .. } => {
                around(all, 0.5 * self.width)
            }
            Form::Circle { at, radius, .. } => around(&[*at], radius + 0.5 * self.width),
            Form::Text { seen: Some(false), .. } => None,
            Form::Text { words, .. } if words.is_empty() => None,
            Form::Text { at: [x, y], words, size, anchor, narrow, .. } => {
                let width = narrow * text_width(words, *size);
                let left = match anchor {
                    Anchor::Start => *x,
                    Anchor::Middle => x - 0.5 * width,
                    Anchor::End => x - width,
                };
                Some([left, y - 0.75 * size, left + width, y + 0.1 * size])
            }
        }
    }

    /// A text of this size, mm, in which the numbers of single letters are [subscripts](indexed).
    pub fn text(at: Point, words: &str, size: f64, anchor: Anchor, ink: Ink) -> Self {
        Self {
            form: Form::Text { at, words: indexed(words), size, anchor, narrow: 1.0, seen: None },
            ink,
            width: 0.0,
        }
    }
}

pub(super) fn polyline(all: &[Point], stroke: Stroke, ink: Ink, style: &Style) -> Element {
    let (width, dashes): (f64, &'static [f64]) = match stroke {
        Stroke::Thick => (style.thick, &[]),
        Stroke::Solid => (style.line, &[]),
        Stroke::Dashed => (style.line, &[1.6, 1.1]),
        Stroke::Dotted => (style.line, &[0.35, 0.9]),
        Stroke::Chain => (style.line, &[3.0, 0.9, 0.35, 0.9]),
        Stroke::Fine | Stroke::Stars => (style.fine, &[]),
    };
    let mut line = Element::line(all, width, ink);
    if let Form::Line { dashes: own, .. } = &mut line.form {
        *own = dashes;
    }
    line
}

pub(super) fn polygon(all: &[Point], width: f64, filled: Option<f64>, ink: Ink) -> Element {
    Element { form: Form::Polygon { corners: all.into(), filled }, ink, width }
}

pub(super) fn circle(at: Point, radius: f64, width: f64, filled: Option<f64>, ink: Ink) -> Element {
    Element { form: Form::Circle { at, radius, filled }, ink, width }
}
