//! A picture with its caption and the sentence that names it: as high as it is, lower or higher.

use assur_book::Block;
use assur_figure::{Anchor, Element, Figure, Frame, Ink, Page, Style, elements, plane_scale};
use assur_words::Text;

use super::lines::wrapped;
use super::{APART, BODY, LINE, ROUNDING, SHRUNK, SMALL, WIDTH};
use crate::sheet::NoteSheet;

/// A picture that may wait for a page.
pub(super) struct Float<'a> {
    sheet: &'a NoteSheet<'a>,
    words: Option<&'a Text>,
    figure: &'a Block,
    /// As high as it is.
    pub(super) whole: Drawn,
}

/// What is drawn of a picture.
#[derive(Clone, Default)]
pub(super) struct Drawn {
    pub(super) elements: Vec<Element>,
    /// Height, mm.
    pub(super) high: f64,
    /// Meters in a millimeter of its planes.
    scale: Option<f64>,
}

impl<'a> Float<'a> {
    /// A picture below the sentence that names it, if it goes with it.
    pub(super) fn new(sheet: &'a NoteSheet<'a>, words: Option<&'a Text>, figure: &'a Block) -> Self {
        let mut float = Self { sheet, words, figure, whole: Drawn::default() };
        float.whole = float.drawn(f64::INFINITY, false);
        float
    }

    /// The picture lower, so that all has this height, mm; `None` where it would be too low. `is_short`: whether the page would end too
    /// early without it.
    pub(super) fn lower(&self, room: f64, is_short: bool) -> Option<Drawn> {
        if room < SHRUNK * self.whole.high || !(is_short || is_of_curves(self.figure)) {
            return None;
        }
        let lower = self.drawn(room, false);
        // A plane has a round scale, and at half of it names cover each other.
        let is_clear = lower.scale.zip(self.whole.scale).is_none_or(|(lower, whole)| lower < 2.0 * whole);
        (lower.high <= room + ROUNDING && is_clear).then_some(lower)
    }

    /// The picture at most so high with its sentence and caption, mm; `fills`: as high as that.
    pub(super) fn drawn(&self, room: f64, fills: bool) -> Drawn {
        let Block::Figure { frames, size, caption } = self.figure else { return Drawn::default() };
        let (mut elements, mut high) = (Vec::new(), 0.0);
        let words = self.words.map(|words| self.sheet.paragraphs(words)).unwrap_or_default();
        for line in words.iter().flat_map(|own| wrapped(own, WIDTH, BODY)) {
            high += LINE * BODY;
            elements.push(Element::text([0.0, high], &line, BODY, Anchor::Start, Ink::Text));
        }
        high += if elements.is_empty() { 0.0 } else { APART };
        let caption = self.sheet.line(caption);
        let of = |size| picture(self.sheet, &frames[0], size, &caption);
        let mut drawn = of(*size);
        if fills || high + drawn.high > room {
            drawn = of([size[0], room - high - below_picture(&caption)]);
        }
        elements.extend(drawn.elements.into_iter().map(|element| element.moved([0.0, high])));
        Drawn { elements, high: high + drawn.high, scale: drawn.scale }
    }
}

/// Whether a figure has curves alone, which have no scale that a lower one would change.
fn is_of_curves(figure: &Block) -> bool {
    let Block::Figure { frames, .. } = figure else { return false };
    frames[0].panels.iter().all(|panel| matches!(panel.frame, Frame::Axes { .. }))
}

fn picture(sheet: &NoteSheet<'_>, figure: &Figure, size: [f64; 2], caption: &str) -> Drawn {
    let (drawn, [width, height]) = elements(figure, Page::Within(size), Style::NOTE, sheet.language);
    let indent = 0.5 * (WIDTH - width).max(0.0);
    let mut all: Vec<Element> = drawn.into_iter().map(|element| element.moved([indent, 0.0])).collect();
    let mut y = height;
    let high = height + below_picture(caption);
    for line in wrapped(caption, WIDTH, SMALL) {
        y += LINE * SMALL;
        all.push(Element::text([0.5 * WIDTH, y], &line, SMALL, Anchor::Middle, Ink::Text));
    }
    let scale = plane_scale(figure, Page::Within(size), Style::NOTE, sheet.language);
    Drawn { elements: all, high, scale }
}

/// Height of what stands below a picture, mm: its caption and free room.
fn below_picture(caption: &str) -> f64 {
    LINE * SMALL * wrapped(caption, WIDTH, SMALL).len() as f64 + 2.0 * APART
}
