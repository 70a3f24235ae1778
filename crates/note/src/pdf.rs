//! A note as PDF: pages of A4 with the letters that they use. A picture that doesn't fit on a page waits for the next one, so that the
//! text goes on in its place.

mod front;
mod lines;
mod table;

use assur_book::{Block, Term};
use assur_figure::{Anchor, Element, Figure, Frame, Ink, Page, Style, elements, plane_scale};
use assur_words::{Text, number, text};

use super::sheet::NoteSheet;
use lines::wrapped;

/// Width and height of the paper, mm.
const PAPER: [f64; 2] = [210.0, 297.0];
/// Left border, and the first and last line of a page, mm.
const LEFT: f64 = 25.0;
const TOP: f64 = 22.0;
const LAST: f64 = 275.0;
/// Width of the text, mm.
const WIDTH: f64 = 170.0;
/// Sizes of letters, mm: text, captions and tables, headings of chapters and within them, the title.
const BODY: f64 = 3.5;
const SMALL: f64 = 2.9;
const HEADING: f64 = 4.8;
const SUBHEADING: f64 = 3.8;
const TITLE: f64 = 6.2;
/// Height of a line, in sizes of its letters; space between blocks, mm.
const LINE: f64 = 1.45;
const APART: f64 = 2.2;
/// What must fit below a heading, mm.
const KEPT: f64 = 36.0;
/// How full a page is that may end before a heading, as part of its height.
const FULL: f64 = 0.69;
/// Down to which part of its height a picture is lower where the page has no more room: one of curves, and on a page that would end too
/// early any.
const SHRUNK: f64 = 0.7;
/// Lines of a paragraph that no page divides.
const UNDIVIDED: usize = 3;
/// What must fit below a paragraph that leads to an equation, mm.
const LEADING: f64 = 8.0;
/// Height of a heading in a chapter, mm.
const HEADED: f64 = 14.0;
/// Width of a rule that is to be filled in by hand, mm, and of the lines of tables.
const RULE: f64 = 60.0;
const FINE: f64 = 0.2;

/// A picture with its caption, as high as it is.
struct Float {
    elements: Vec<Element>,
    high: f64,
    /// Meters in a millimeter of its planes.
    scale: Option<f64>,
}

/// The pages as they are filled.
#[derive(Default)]
pub(super) struct Pages {
    done: Vec<Vec<Element>>,
    y: f64,
    waiting: Vec<Float>,
    /// Whether the last thing on the page is a heading.
    headed: bool,
}

impl Pages {
    fn page(&mut self) -> &mut Vec<Element> {
        if self.done.is_empty() {
            self.begin();
        }
        let last = self.done.len() - 1;
        &mut self.done[last]
    }

    /// Begins a page with the pictures that wait for it.
    fn begin(&mut self) {
        self.turn();
        self.settle();
    }

    /// Begins an empty page: pictures wait on.
    fn turn(&mut self) {
        self.done.push(Vec::new());
        self.y = TOP;
    }

    /// Puts the pictures that wait where they fit; on an empty page one in any case.
    fn settle(&mut self) {
        while self.waiting.first().is_some_and(|float| self.y <= TOP || self.y + float.high <= LAST) {
            let float = self.waiting.remove(0);
            self.put(float);
        }
    }

    /// Puts the pictures that wait, which belong to what is above, before what follows, where this doesn't leave a page half empty.
    fn catch_up(&mut self) {
        while !self.waiting.is_empty() && self.y > TOP + FULL * (LAST - TOP) {
            self.begin();
        }
    }

    fn put(&mut self, float: Float) {
        let y = self.y;
        self.page().extend(float.elements.into_iter().map(|element| element.moved([LEFT, y])));
        self.y += float.high;
        self.headed = false;
    }

    /// Makes room for so much, on a new page where this one has too little.
    fn need(&mut self, high: f64) {
        if self.done.is_empty() || self.y + high > LAST {
            self.begin();
        }
        // Pictures that waited may have taken the place.
        while self.y > TOP && self.y + high > LAST {
            self.begin();
        }
    }

    /// A picture here, or on the next page; pictures keep their order.
    fn float(&mut self, float: Float) {
        if self.done.is_empty() {
            self.begin();
        }
        if self.waiting.is_empty() && self.y + float.high <= LAST {
            self.put(float);
        } else {
            self.waiting.push(float);
        }
    }

    /// A line of text at a distance from the left border.
    fn line(&mut self, words: &str, size: f64, indent: f64) {
        self.need(LINE * size);
        self.y += LINE * size;
        let at = [LEFT + indent, self.y];
        self.page().push(Element::text(at, words, size, Anchor::Start, Ink::Text));
        self.headed = false;
    }

    /// A paragraph with so much room below it, mm.
    fn paragraph(&mut self, words: &str, size: f64, below: f64) {
        let lines = wrapped(words, WIDTH, size);
        let high = |count: usize| LINE * size * count as f64;
        for (at, line) in lines.iter().enumerate() {
            // No page begins or ends with one line of several.
            match lines.len() - at {
                left if left == lines.len() && left <= UNDIVIDED => self.need(high(left) + below),
                2 => self.need(high(2) + below),
                _ if at == 0 => self.need(high(2)),
                _ => {}
            }
            self.line(line, size, 0.0);
        }
        self.y += APART;
    }

    /// A heading with so much below it, mm; `begins`: whether pictures that wait stand before it.
    fn heading(&mut self, words: &str, size: f64, below: f64, begins: bool) {
        if begins {
            self.catch_up();
        }
        // What is higher than a page fits on none.
        self.need(below.min(LAST - TOP));
        self.y += APART;
        self.paragraph(words, size, 0.0);
        self.headed = true;
    }
}

/// The whole file; `None` where its letters can't be taken from the font that is built in.
pub(super) fn write(sheet: &NoteSheet<'_>) -> Option<Vec<u8>> {
    let all = pages(sheet);
    let all: Vec<_> = all.iter().map(|elements| assur_pdf::Page { size: PAPER, elements }).collect();
    assur_pdf::write(&sheet.line(&sheet.cover.title), &all)
}

/// What stands on each page, from the cover.
pub(super) fn pages(sheet: &NoteSheet<'_>) -> Vec<Vec<Element>> {
    let mut pages = Pages::default();
    front::cover(&sheet.cover, sheet, &mut pages);
    // The contents have room on the second page; the numbers of pages are known at the end.
    pages.begin();
    pages.y = TOP + front::contents_height(sheet.chapters().count());
    let mut body = Body { sheet, pages, chapters: Vec::new(), equations: 0, tables: 0 };
    let mut rest = &sheet.blocks[..];
    while !rest.is_empty() {
        let done = body.block(rest);
        rest = &rest[done..];
    }
    let Body { mut pages, chapters, .. } = body;
    while !pages.waiting.is_empty() {
        pages.begin();
    }
    front::contents(sheet, &mut pages.done[1], &chapters);
    for (number, page) in pages.done.iter_mut().enumerate().skip(1) {
        let at = [LEFT + WIDTH, PAPER[1] - 12.0];
        page.push(Element::text(at, &(number + 1).to_string(), BODY, Anchor::End, Ink::Text));
    }
    pages.done
}

/// What is written of the blocks so far.
struct Body<'a> {
    sheet: &'a NoteSheet<'a>,
    pages: Pages,
    /// The chapters with their pages.
    chapters: Vec<(String, usize)>,
    equations: usize,
    tables: usize,
}

impl Body<'_> {
    /// Writes the first of some blocks; returns how many it took.
    fn block(&mut self, blocks: &[Block]) -> usize {
        let (sheet, next) = (self.sheet, blocks.get(1));
        match &blocks[0] {
            Block::Title(_) => {}
            Block::Heading(title) => {
                let title = sheet.line(title);
                self.pages.heading(&title, HEADING, Self::below_heading(&blocks[1..]), true);
                self.chapters.push((title, self.pages.done.len()));
                if let Some(Block::Subheading(title)) = next {
                    self.pages.heading(&sheet.line(title), SUBHEADING, KEPT, false);
                    return 2;
                }
            }
            Block::Subheading(title) => self.pages.heading(&sheet.line(title), SUBHEADING, KEPT, true),
            Block::Paragraph(words) => {
                if let Some(figure @ Block::Figure { .. }) = next {
                    self.told(words, figure);
                    return 2;
                }
                self.paragraph(words, matches!(next, Some(Block::Equation(_))));
            }
            Block::Equation(terms) => {
                self.equations += 1;
                equation(&mut self.pages, &written(sheet, terms), self.equations);
                if !matches!(next, Some(Block::Equation(_))) {
                    self.pages.y += APART;
                }
            }
            figure @ Block::Figure { .. } => {
                self.pages.float(self.picture(&Text::default(), figure, f64::INFINITY));
            }
            table @ (Block::Table(_) | Block::Facts { .. }) => {
                self.tables += 1;
                if let Some(of) = table.as_table() {
                    let again = sheet.line(&text!("note-table-goes-on", number = number(self.tables)));
                    table::put(&mut self.pages, [&sheet.line(&of.caption), &again], &sheet.grid(&of));
                }
            }
        }
        1
    }

    /// A picture with the sentence that names it; where the picture waits, the sentence goes with it, but stays below a heading and on a
    /// page that would end too early.
    fn told(&mut self, words: &Text, figure: &Block) {
        let mut whole = self.picture(words, figure, f64::INFINITY);
        let pages = &self.pages;
        let room = LAST - pages.y;
        if pages.waiting.is_empty()
            && whole.high > room
            && room >= SHRUNK * whole.high
            && (is_of_curves(figure) || pages.y < TOP + FULL * (LAST - TOP))
        {
            let lower = self.picture(words, figure, room);
            // A plane has a round scale, and at half of it names cover each other.
            let is_clear = lower.scale.zip(whole.scale).is_none_or(|(lower, whole)| lower < 2.0 * whole);
            whole = if lower.high <= room && is_clear { lower } else { whole };
        }
        let stays = pages.headed || pages.waiting.is_empty() && pages.y < TOP + FULL * (LAST - TOP);
        let fits = pages.waiting.is_empty() && pages.y + whole.high <= LAST;
        if fits || !stays {
            return self.pages.float(whole);
        }
        self.paragraph(words, false);
        self.pages.float(self.picture(&Text::default(), figure, f64::INFINITY));
    }

    /// A paragraph, which does not stand apart from an equation that it leads to.
    fn paragraph(&mut self, words: &Text, leads: bool) {
        let words = self.sheet.paragraphs(words);
        let last = words.len().saturating_sub(1);
        for (at, own) in words.iter().enumerate() {
            let leads = leads && at == last;
            self.pages.paragraph(own, BODY, if leads { LEADING } else { 0.0 });
            if leads {
                self.pages.y -= 0.7 * APART;
            }
        }
    }

    /// What must stand below a heading before these blocks, mm.
    fn below_heading(blocks: &[Block]) -> f64 {
        match blocks {
            [Block::Subheading(_), ..] => KEPT + HEADED,
            _ => KEPT,
        }
    }

    /// A picture below the sentence that names it; curves are so low that all has this height.
    fn picture(&self, words: &Text, figure: &Block, room: f64) -> Float {
        let Block::Figure { frames, size, caption } = figure else {
            return Float { elements: Vec::new(), high: 0.0, scale: None };
        };
        let (mut elements, mut high) = (Vec::new(), 0.0);
        for line in self.sheet.paragraphs(words).iter().flat_map(|own| wrapped(own, WIDTH, BODY)) {
            high += LINE * BODY;
            elements.push(Element::text([0.0, high], &line, BODY, Anchor::Start, Ink::Text));
        }
        high += if elements.is_empty() { 0.0 } else { APART };
        let caption = self.sheet.line(caption);
        let of = |size| picture(self.sheet, &frames[0], size, &caption);
        let mut drawn = of(*size);
        if high + drawn.high > room {
            drawn = of([size[0], room - high - below_picture(&caption)]);
        }
        elements.extend(drawn.elements.into_iter().map(|element| element.moved([0.0, high])));
        Float { elements, high: high + drawn.high, scale: drawn.scale }
    }
}

/// Whether a figure has curves alone, which have no scale that a lower one would change.
fn is_of_curves(figure: &Block) -> bool {
    let Block::Figure { frames, .. } = figure else { return false };
    frames[0].panels.iter().all(|panel| matches!(panel.frame, Frame::Axes { .. }))
}

fn picture(sheet: &NoteSheet<'_>, figure: &Figure, size: [f64; 2], caption: &str) -> Float {
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
    Float { elements: all, high, scale }
}

/// Height of what stands below a picture, mm: its caption and free room.
fn below_picture(caption: &str) -> f64 {
    LINE * SMALL * wrapped(caption, WIDTH, SMALL).len() as f64 + 2.0 * APART
}

/// An equation with its number at the right.
fn equation(pages: &mut Pages, words: &str, number: usize) {
    const INDENT: f64 = 8.0;
    const NUMBER: f64 = 14.0;
    let lines = wrapped(words, WIDTH - INDENT - NUMBER, BODY);
    pages.need(LINE * BODY * (lines.len() as f64 + 0.25));
    for (at, line) in lines.iter().enumerate() {
        pages.line(line, BODY, if at == 0 { INDENT } else { 1.5 * INDENT });
    }
    let at = [LEFT + WIDTH, pages.y];
    pages.page().push(Element::text(at, &format!("({number})"), BODY, Anchor::End, Ink::Text));
    // Room for subscripts.
    pages.y += 0.25 * BODY;
}

/// An equation in letters, with subscripts as texts have them.
fn written(sheet: &NoteSheet<'_>, terms: &[Term]) -> String {
    let term = |term: &Term| match term {
        Term::Symbol(symbol) => {
            let below = sheet.below(symbol);
            let letter = sheet.line(&symbol.letter());
            if below.is_empty() { letter } else { format!("{letter}_{{{below}}}") }
        }
        Term::Function("sqrt") => "√".to_owned(),
        Term::Square => "²".to_owned(),
        Term::Words(text) => format!("   ({})", sheet.line(text)),
        Term::Sign(_) | Term::Comma => sheet.line(&term.text()).replace('*', "·").replace('-', "−"),
        Term::Function(_) | Term::Number(_) | Term::Unit(_) => sheet.line(&term.text()),
    };
    terms.iter().map(term).collect()
}
