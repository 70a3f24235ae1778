//! Cover and contents.

use assur_figure::{Anchor, Element, Ink};
use assur_words::{Text, text};

use super::lines::wrapped;
use super::{APART, BODY, FINE, HEADING, LAST, LEFT, LINE, Pages, RULE, SUBHEADING, TITLE, TOP, WIDTH};
use crate::cover::Cover;
use crate::sheet::NoteSheet;

/// Distance of the last rows of the cover, mm.
const BELOW: f64 = 8.0;

/// The cover; what is left out is a rule. A row at a distance below 0 is so far above the end of the page.
pub(super) fn cover(cover: &Cover, sheet: &NoteSheet<'_>, pages: &mut Pages) {
    let middle = LEFT + 0.5 * WIDTH;
    let page = pages.page();
    let mut y = 30.0;
    let mut put = |(word, row): (Option<&Text>, Option<&Text>), size: f64, [x, above]: [f64; 2], anchor| {
        y = if above < 0.0 { LAST + above } else { y + above };
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
    // City and year close the page.
    for (number, row) in cover.below.iter().rev().enumerate() {
        put((None, row.as_ref()), SUBHEADING, [middle, -BELOW * (number + 1) as f64], Anchor::Middle);
    }
}

/// The height of the contents of so many chapters, mm.
pub(super) fn contents_height(chapters: usize) -> f64 {
    LINE * HEADING + 2.0 * BODY * chapters as f64 + 6.0 * APART
}

pub(super) fn contents(sheet: &NoteSheet<'_>, page: &mut Vec<Element>, chapters: &[(String, usize)]) {
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
