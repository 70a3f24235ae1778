//! Pages as PDF: lines, polygons, circles and texts at places in millimeters, with the letters used in them.
//!
//! Written with `pdf-writer` and `subsetter`: all that they depend on is linked anyway, and a figure already is a list of four kinds of
//! [`Element`]. `krilla` brings decoders of pictures and a second shaper of texts, `svg2pdf` an older `usvg` beside the one that is linked;
//! both would read back what is at hand. The file has no date and no number of its own: the same pages give the same bytes.

mod letters;
mod page;

use assur_figure::Element;
use pdf_writer::{Chunk, Filter, Finish, Name, Pdf, Rect, Ref, TextStr};

use letters::Letters;
pub use letters::text_width;

/// A page.
#[derive(Debug, Clone, Copy)]
pub struct Page<'a> {
    /// Width and height, mm.
    pub size: [f64; 2],
    /// What stands on it, later elements over earlier ones.
    pub elements: &'a [Element],
}

/// Points of a printer in a millimeter.
const POINT: f64 = 72.0 / 25.4;
const FONT: Name<'static> = Name(b"F");

/// The pages as a file with this title; `None` where the letters can't be taken from the font that is built in.
pub fn write(title: &str, pages: &[Page<'_>]) -> Option<Vec<u8>> {
    let mut free = Ref::new(1);
    let (catalog, tree, font, info) = (free.bump(), free.bump(), free.bump(), free.bump());
    let mut letters = Letters::new()?;
    let mut pdf = Pdf::new();
    let mut kids = Vec::new();
    let mut body = Chunk::new();
    for page in pages {
        let (own, content) = (free.bump(), free.bump());
        let drawn = page::content(page, &mut letters);
        body.stream(content, &deflated(&drawn.content)).filter(Filter::FlateDecode);
        let states: Vec<_> = drawn.opacities.iter().map(|part| (free.bump(), *part)).collect();
        for (id, part) in &states {
            body.ext_graphics(*id).non_stroking_alpha(*part).stroking_alpha(*part);
        }
        let [width, height] = page.size.map(|side| single(side * POINT));
        let mut written = body.page(own);
        written.parent(tree).media_box(Rect::new(0.0, 0.0, width, height)).contents(content);
        let mut resources = written.resources();
        resources.fonts().pair(FONT, font);
        let mut named = resources.ext_g_states();
        for (number, (id, _)) in states.iter().enumerate() {
            named.pair(Name(page::state(number).as_bytes()), *id);
        }
        named.finish();
        resources.finish();
        written.finish();
        kids.push(own);
    }
    pdf.catalog(catalog).pages(tree);
    pdf.pages(tree).count(i32::try_from(kids.len()).ok()?).kids(kids);
    pdf.document_info(info).title(TextStr(title));
    pdf.extend(&body);
    letters.write(font, &mut free, &mut pdf)?;
    Some(pdf.finish())
}

fn deflated(bytes: &[u8]) -> Vec<u8> {
    const LEVEL: u8 = 6;
    miniz_oxide::deflate::compress_to_vec_zlib(bytes, LEVEL)
}

#[expect(clippy::cast_possible_truncation, reason = "finer than any printer")]
fn single(value: f64) -> f32 {
    value as f32
}

#[cfg(test)]
mod tests;
