//! A note as PDF: pages of A4 with the letters that they use. A picture that doesn't fit on a page waits for the next one, so that the
//! text goes on in its place.

mod float;
mod front;
mod lines;
mod table;

use assur_book::{Block, Term};
use assur_figure::{Anchor, Element, Ink};
use assur_words::{Text, number, text};

use super::sheet::NoteSheet;
use float::{Drawn, Float};
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
/// Up to how many times its height the last picture of a page is higher where the page would end too early.
const STRETCHED: f64 = 2.2;
/// Difference of heights that is rounding, mm.
const ROUNDING: f64 = 1e-9;
/// Lines of a paragraph that no page divides.
const UNDIVIDED: usize = 3;
/// What must fit below a paragraph that leads to an equation, mm.
const LEADING: f64 = 8.0;
/// Height of a heading in a chapter, mm.
const HEADED: f64 = 14.0;
/// Width of a rule that is to be filled in by hand, mm, and of the lines of tables.
const RULE: f64 = 60.0;
const FINE: f64 = 0.2;

/// The pages as they are filled.
#[derive(Default)]
pub(super) struct Pages<'a> {
    done: Vec<Vec<Element>>,
    y: f64,
    waiting: Vec<Float<'a>>,
    /// Whether the last thing on the page is a heading.
    headed: bool,
    /// The picture that was put last.
    last: Option<Last<'a>>,
}

/// A picture on the page: how many elements the page had before it, and where it begins and ends, mm.
struct Last<'a> {
    float: Float<'a>,
    before: usize,
    from: f64,
    to: f64,
}

impl<'a> Pages<'a> {
    fn page(&mut self) -> &mut Vec<Element> {
        if self.done.is_empty() {
            self.begin();
        }
        let last = self.done.len() - 1;
        &mut self.done[last]
    }

    /// Begins a page with the pictures that wait for it.
    fn begin(&mut self) {
        self.stretch();
        self.turn();
        self.settle();
    }

    /// Begins an empty page: pictures wait on.
    fn turn(&mut self) {
        self.done.push(Vec::new());
        self.y = TOP;
        self.last = None;
    }

    /// Whether the page would be too short if it ended here.
    fn is_short(&self) -> bool {
        self.y < TOP + FULL * (LAST - TOP)
    }

    /// Puts the pictures that wait where they fit; on an empty page one in any case.
    fn settle(&mut self) {
        while let Some(drawn) = self.waiting.first().and_then(|float| self.fitting(float)) {
            let float = self.waiting.remove(0);
            self.put(float, drawn);
        }
    }

    /// A picture as it goes where the page stands: as high as it is, or lower where this page has no more room.
    fn fitting(&self, float: &Float<'a>) -> Option<Drawn> {
        let room = LAST - self.y;
        if self.y <= TOP || float.whole.high <= room + ROUNDING {
            return Some(float.whole.clone());
        }
        float.lower(room, self.is_short())
    }

    /// Puts the pictures that wait, which belong to what is above, before what follows, where this leaves no page too short.
    fn catch_up(&mut self) {
        while !self.waiting.is_empty() {
            self.stretch();
            if self.is_short() {
                break;
            }
            self.begin();
        }
    }

    fn put(&mut self, float: Float<'a>, drawn: Drawn) {
        let (from, before) = (self.y, self.page().len());
        self.page().extend(drawn.elements.into_iter().map(|element| element.moved([LEFT, from])));
        self.y += drawn.high;
        self.headed = false;
        self.last = Some(Last { float, before, from, to: self.y });
    }

    /// Draws the picture at the end of a page that ends too early higher, where the page is then long enough.
    fn stretch(&mut self) {
        if !self.is_short() || self.last.as_ref().is_none_or(|last| last.to < self.y) {
            return;
        }
        let Some(last) = self.last.take() else { return };
        let room = (LAST - last.from).min(STRETCHED * (last.to - last.from));
        let drawn = last.float.drawn(room, true);
        if last.from + drawn.high >= TOP + FULL * (LAST - TOP) && drawn.high <= room + ROUNDING {
            self.page().truncate(last.before);
            self.y = last.from;
            self.put(last.float, drawn);
        }
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
    fn float(&mut self, float: Float<'a>) {
        if self.done.is_empty() {
            self.begin();
        }
        self.waiting.push(float);
        if self.waiting.len() == 1 {
            self.settle();
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
    pages: Pages<'a>,
    /// The chapters with their pages.
    chapters: Vec<(String, usize)>,
    equations: usize,
    tables: usize,
}

impl<'a> Body<'a> {
    /// Writes the first of some blocks; returns how many it took.
    fn block(&mut self, blocks: &'a [Block]) -> usize {
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
                self.pages.float(Float::new(sheet, None, figure));
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
    fn told(&mut self, words: &'a Text, figure: &'a Block) {
        let float = Float::new(self.sheet, Some(words), figure);
        let fits = self.pages.waiting.is_empty() && self.pages.fitting(&float).is_some();
        let stays = self.pages.headed || self.pages.waiting.is_empty() && self.pages.is_short();
        if fits || !stays {
            return self.pages.float(float);
        }
        self.paragraph(words, false);
        self.pages.float(Float::new(self.sheet, None, figure));
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
