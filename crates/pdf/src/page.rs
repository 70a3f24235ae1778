//! The content of a page: elements as operators of PDF.

use assur_figure::letters::levels;
use assur_figure::{Anchor, Element, Form, Ink, Point, color};
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Name, Str};

use crate::letters::Letters;
use crate::{FONT, POINT, Page, single};

/// Distance of the middle control point of a quarter of a circle from its end, parts of the radius.
const QUARTER: f64 = 0.552_284_75;

/// What a page holds.
pub(crate) struct Drawn {
    pub(crate) content: Vec<u8>,
    /// How much of their ink shows what is not whole, by the number of its state.
    pub(crate) opacities: Vec<f32>,
}

/// The name of a state of the page by its number.
pub(crate) fn state(number: usize) -> String {
    format!("G{number}")
}

pub(crate) fn content(page: &Page<'_>, letters: &mut Letters) -> Drawn {
    let mut own = Writer { content: Content::new(), height: page.size[1], opacities: Vec::new(), letters };
    own.content.set_line_cap(LineCapStyle::RoundCap).set_line_join(LineJoinStyle::RoundJoin);
    for element in page.elements {
        own.element(element);
    }
    Drawn { content: own.content.finish().into_vec(), opacities: own.opacities }
}

struct Writer<'a> {
    content: Content,
    /// Of the page, mm.
    height: f64,
    opacities: Vec<f32>,
    letters: &'a mut Letters,
}

impl Writer<'_> {
    /// A place in the coordinates of the page, whose y grows upwards.
    fn at(&self, [x, y]: Point) -> [f32; 2] {
        [x * POINT, (self.height - y) * POINT].map(single)
    }

    fn element(&mut self, element: &Element) {
        match &element.form {
            Form::Line { points, dashes, opacity } => {
                self.content.save_state();
                self.pen(element);
                self.see_through(*opacity);
                self.content.set_dash_pattern(dashes.iter().map(|length| single(length * POINT)), 0.0);
                self.path(points);
                self.content.stroke().restore_state();
            }
            Form::Polygon { corners, filled } => {
                self.filled(element, *filled, |writer| {
                    writer.path(corners);
                    writer.content.close_path();
                });
            }
            Form::Circle { at, radius, filled } => {
                self.filled(element, *filled, |writer| writer.circle(*at, *radius));
            }
            Form::Text { seen: Some(false), .. } => {}
            Form::Text { at, words, size, anchor, narrow, .. } => {
                self.text(*at, words, [*size, *narrow], *anchor, element.ink);
            }
        }
    }

    fn pen(&mut self, element: &Element) {
        let [red, green, blue] = shade(element.ink);
        self.content.set_stroke_rgb(red, green, blue).set_line_width(single(element.width * POINT));
    }

    /// Sets how much of what follows covers what lies below.
    fn see_through(&mut self, part: Option<f64>) {
        let Some(part) = part.filter(|part| *part > 0.0 && *part < 1.0).map(single) else { return };
        let known = self.opacities.iter().position(|own| own.to_bits() == part.to_bits());
        let number = known.unwrap_or_else(|| {
            self.opacities.push(part);
            self.opacities.len() - 1
        });
        self.content.set_parameters(Name(state(number).as_bytes()));
    }

    /// A closed path with its inside below its line.
    fn filled(&mut self, element: &Element, filled: Option<f64>, path: impl Fn(&mut Self)) {
        if let Some(part) = filled {
            let [red, green, blue] = if part == 0.0 { [1.0; 3] } else { shade(element.ink) };
            self.content.save_state().set_fill_rgb(red, green, blue);
            self.see_through(filled);
            path(self);
            self.content.fill_nonzero().restore_state();
        }
        self.content.save_state();
        self.pen(element);
        path(self);
        self.content.stroke().restore_state();
    }

    fn path(&mut self, points: &[Point]) {
        let places = points.iter().filter(|at| at[0].is_finite() && at[1].is_finite());
        for (index, [x, y]) in places.map(|at| self.at(*at)).collect::<Vec<_>>().into_iter().enumerate() {
            if index == 0 {
                self.content.move_to(x, y);
            } else {
                self.content.line_to(x, y);
            }
        }
    }

    fn circle(&mut self, [x, y]: Point, radius: f64) {
        let place = |along: f64, across: f64| [x + radius * along, y + radius * across];
        let [from_x, from_y] = self.at(place(1.0, 0.0));
        self.content.move_to(from_x, from_y);
        for (c, s) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
            let ends = [place(c - QUARTER * s, s + QUARTER * c), place(QUARTER * c - s, c + QUARTER * s)];
            let [[x1, y1], [x2, y2], [x3, y3]] = [ends[0], ends[1], place(-s, c)].map(|at| self.at(at));
            self.content.cubic_to(x1, y1, x2, y2, x3, y3);
        }
        self.content.close_path();
    }

    fn text(&mut self, [mut x, y]: Point, words: &str, [size, narrow]: [f64; 2], anchor: Anchor, ink: Ink) {
        let before = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        x -= before * narrow * size * self.letters.width(words);
        let [red, green, blue] = shade(ink);
        self.content.set_fill_rgb(red, green, blue).begin_text();
        for (part, level) in levels(words) {
            let (bytes, width) = self.letters.encoded(part);
            let ([left, base], own) = (self.at([x, y + level.down(size)]), level.size() * size);
            x += narrow * width * own;
            self.content.set_font(FONT, single(own * POINT));
            self.content.set_text_matrix([single(narrow), 0.0, 0.0, 1.0, left, base]).show(Str(&bytes));
        }
        self.content.end_text();
    }
}

/// An ink as parts of red, green and blue.
fn shade(ink: Ink) -> [f32; 3] {
    let told = color(ink);
    let part = |from: usize| told.get(from..from + 2).and_then(|two| u8::from_str_radix(two, 16).ok());
    [1, 3, 5].map(|from| f32::from(part(from).unwrap_or_default()) / 255.0)
}
