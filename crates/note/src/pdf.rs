//! A note as PDF: pages of A4 with the letters that they use. A picture that doesn't fit on a page waits for the next one, so that the
//! text goes on in its place.

mod lines;
mod table;

use assur_book::{Block, Term};
use assur_figure::{Anchor, Element, Figure, Ink, Page, Style, elements};
use assur_words::{Text, number, text};

use super::cover::Cover;
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
const FULL: f64 = 0.7;
/// Lines of a paragraph that no page divides.
const UNDIVIDED: usize = 3;
/// Height of a heading in a chapter, mm.
const HEADED: f64 = 14.0;
/// Width of a rule that is to be filled in by hand, mm, and of the lines of tables.
const RULE: f64 = 60.0;
const FINE: f64 = 0.2;

/// A picture with its caption, as high as it is.
struct Float {
    elements: Vec<Element>,
    high: f64,
}

/// The pages as they are filled.
#[derive(Default)]
pub(super) struct Pages {
    done: Vec<Vec<Element>>,
    y: f64,
    waiting: Vec<Float>,
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
        self.done.push(Vec::new());
        self.y = TOP;
        while self.waiting.first().is_some_and(|float| self.y <= TOP || self.y + float.high <= LAST) {
            let float = self.waiting.remove(0);
            self.put(float);
        }
    }

    fn put(&mut self, float: Float) {
        let y = self.y;
        self.page().extend(float.elements.into_iter().map(|element| element.moved([LEFT, y])));
        self.y += float.high;
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
    }

    fn paragraph(&mut self, words: &str, size: f64) {
        let lines = wrapped(words, WIDTH, size);
        if lines.len() <= UNDIVIDED {
            self.need(LINE * size * lines.len() as f64);
        }
        for line in &lines {
            self.line(line, size, 0.0);
        }
        self.y += APART;
    }

    /// A heading with what must stand below it, and so much more.
    fn heading(&mut self, words: &str, size: f64, more: f64) {
        // Pictures that wait belong to what is above, where this doesn't leave a page half empty.
        if !self.waiting.is_empty() && self.y > TOP + FULL * (LAST - TOP) {
            self.begin();
        }
        self.need(KEPT + more);
        self.y += APART;
        self.paragraph(words, size);
    }
}

/// The whole file; `None` where its letters can't be taken from the font that is built in.
pub(super) fn write(sheet: &NoteSheet<'_>) -> Option<Vec<u8>> {
    let mut pages = Pages::default();
    cover(&sheet.cover, sheet, &mut pages);
    // The contents have room on the second page; the numbers of pages are known at the end.
    pages.begin();
    pages.y = TOP + contents_height(sheet.chapters().count());
    let (mut chapters, [mut equations, mut tables]) = (Vec::new(), [0_usize; 2]);
    for (at, block) in sheet.blocks.iter().enumerate() {
        match block {
            Block::Title(_) => {}
            Block::Heading(title) => {
                let title = sheet.line(title);
                let next = sheet.blocks.get(at + 1);
                let more = if matches!(next, Some(Block::Subheading(_))) { HEADED } else { 0.0 };
                pages.heading(&title, HEADING, more);
                chapters.push((title, pages.done.len()));
            }
            Block::Subheading(title) => pages.heading(&sheet.line(title), SUBHEADING, 0.0),
            Block::Paragraph(words) => {
                sheet.paragraphs(words).iter().for_each(|words| pages.paragraph(words, BODY));
            }
            Block::Equation(terms) => {
                equations += 1;
                equation(&mut pages, &written(sheet, terms), equations);
            }
            Block::Figure { frames, size, caption } => {
                pages.float(picture(sheet, &frames[0], *size, &sheet.line(caption)));
            }
            Block::Table(_) | Block::Facts { .. } => {
                tables += 1;
                if let Some(of) = block.as_table() {
                    let again = sheet.line(&text!("note-table-goes-on", number = number(tables)));
                    table::put(&mut pages, [&sheet.line(&of.caption), &again], &sheet.grid(&of));
                }
            }
        }
    }
    while !pages.waiting.is_empty() {
        pages.begin();
    }
    contents(sheet, &mut pages.done[1], &chapters);
    for (number, page) in pages.done.iter_mut().enumerate().skip(1) {
        let at = [LEFT + WIDTH, PAPER[1] - 12.0];
        page.push(Element::text(at, &(number + 1).to_string(), BODY, Anchor::End, Ink::Text));
    }
    let all: Vec<_> = pages.done.iter().map(|elements| assur_pdf::Page { size: PAPER, elements }).collect();
    assur_pdf::write(&sheet.line(&sheet.cover.title), &all)
}

/// The cover; what is left out is a rule.
fn cover(cover: &Cover, sheet: &NoteSheet<'_>, pages: &mut Pages) {
    let middle = LEFT + 0.5 * WIDTH;
    let page = pages.page();
    let mut y = 30.0;
    let mut put = |(word, row): (Option<&Text>, Option<&Text>), size: f64, [x, above]: [f64; 2], anchor| {
        y += above;
        let word = word.map_or_else(String::new, |word| sheet.line(word) + ": ");
        if let Some(row) = row {
            let lines = wrapped(&(word + &sheet.line(row)), WIDTH, size);
            for (number, line) in lines.iter().enumerate() {
                y += if number > 0 { LINE * size } else { 0.0 };
                page.push(Element::text([x, y], line, size, anchor, Ink::Text));
            }
        } else {
            let width = assur_pdf::text_width(&word, size);
            let from = if anchor == Anchor::Middle { x - 0.5 * (width + RULE) } else { x };
            page.push(Element::text([from, y], &word, size, Anchor::Start, Ink::Text));
            let ends = [[from + width, y + 0.8], [from + width + RULE, y + 0.8]];
            page.push(Element::line(ends, FINE, Ink::Text));
        }
    };
    for row in &cover.above {
        put((None, row.as_ref()), SUBHEADING, [middle, 9.0], Anchor::Middle);
    }
    put((None, Some(&cover.what)), HEADING, [middle, 45.0], Anchor::Middle);
    put((Some(&cover.discipline.0), cover.discipline.1.as_ref()), SUBHEADING, [middle, 10.0], Anchor::Middle);
    put((None, Some(&cover.title)), TITLE, [middle, 14.0], Anchor::Middle);
    for (number, (word, who)) in cover.people.iter().enumerate() {
        let above = if number == 0 { 45.0 } else { 9.0 };
        put((Some(word), who.as_ref()), SUBHEADING, [LEFT + 85.0, above], Anchor::Start);
    }
    for (number, row) in cover.below.iter().enumerate() {
        let above = if number == 0 { 40.0 } else { 8.0 };
        put((None, row.as_ref()), SUBHEADING, [middle, above], Anchor::Middle);
    }
}

/// The height of the contents of so many chapters, mm.
fn contents_height(chapters: usize) -> f64 {
    LINE * HEADING + 2.0 * BODY * chapters as f64 + 6.0 * APART
}

fn contents(sheet: &NoteSheet<'_>, page: &mut Vec<Element>, chapters: &[(String, usize)]) {
    let head = sheet.line(&text!("note-contents"));
    let mut y = TOP + LINE * HEADING;
    page.push(Element::text([LEFT, y], &head, HEADING, Anchor::Start, Ink::Text));
    y += 2.0 * APART;
    for (title, number) in chapters {
        y += 2.0 * BODY;
        page.push(Element::text([LEFT, y], title, BODY, Anchor::Start, Ink::Text));
        page.push(Element::text([LEFT + WIDTH, y], &number.to_string(), BODY, Anchor::End, Ink::Text));
    }
}

fn picture(sheet: &NoteSheet<'_>, figure: &Figure, size: [f64; 2], caption: &str) -> Float {
    let (drawn, [width, height]) = elements(figure, Page::Within(size), Style::NOTE, sheet.language);
    let indent = 0.5 * (WIDTH - width).max(0.0);
    let mut all: Vec<Element> = drawn.into_iter().map(|element| element.moved([indent, 0.0])).collect();
    let mut y = height;
    for line in wrapped(caption, WIDTH, SMALL) {
        y += LINE * SMALL;
        all.push(Element::text([0.5 * WIDTH, y], &line, SMALL, Anchor::Middle, Ink::Text));
    }
    Float { elements: all, high: y + 2.0 * APART }
}

/// An equation with its number at the right.
fn equation(pages: &mut Pages, words: &str, number: usize) {
    const INDENT: f64 = 8.0;
    const NUMBER: f64 = 14.0;
    let lines = wrapped(words, WIDTH - INDENT - NUMBER, BODY);
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
