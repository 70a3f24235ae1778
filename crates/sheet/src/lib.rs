//! The drawing sheet of a scene: its fields in a frame with a title block, as PDF, SVG or DXF.
//!
//! [`sheet`] makes pages of elements of pictures of the results (`fields`), each as large as all have room (`layout`), beside the
//! title block of the language (`title`); [`Form::write`] gives them a form.

mod drawn;
mod fields;
mod format;
mod layout;
pub mod preview;
mod tables;
mod title;

use assur_figure::{Element, Form as Outline, Ink, dxf, svg};
use assur_picture::{Results, mechanism::numbers};
use assur_scene::{Note, SHEET_FIELDS, SheetField, SheetFormat};
use assur_words::{Language, Text, text};

use drawn::{Drawn, Size};
use fields::Source;
pub use format::Area;
use format::{Standard, USUAL};
use layout::{Block, Placed};
use title::Filling;

assur_words::resources!();

/// The form of a sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// One file with a page for each sheet.
    Pdf,
    /// A file for each sheet.
    Svg,
    /// A file for each sheet, a unit is a millimeter of paper.
    Dxf,
}

impl Form {
    /// The form that the ending of a file name chooses.
    pub fn of(ending: &str) -> Option<Self> {
        let forms = [("pdf", Self::Pdf), ("svg", Self::Svg), ("dxf", Self::Dxf)];
        forms.into_iter().find(|(name, _)| ending.eq_ignore_ascii_case(name)).map(|(_, form)| form)
    }

    /// The files of pages, in their order.
    ///
    /// # Errors
    ///
    /// In words: the font that is built in does not serve.
    pub fn write(self, title: &str, pages: &[Page]) -> Result<Vec<Vec<u8>>, Text> {
        Ok(match self {
            Self::Pdf => {
                let of = |page: &Page| (page.size, page.elements().collect::<Vec<_>>());
                let all: Vec<_> = pages.iter().map(of).collect();
                let all: Vec<_> =
                    all.iter().map(|(size, elements)| assur_pdf::Page { size: *size, elements }).collect();
                vec![assur_pdf::write(title, &all).ok_or_else(|| text!("sheet-no-font"))?]
            }
            Self::Svg => {
                let of = |page: &Page| svg::page(title, page.size, &page.elements().collect::<Vec<_>>());
                pages.iter().map(|page| of(page).into_bytes()).collect()
            }
            Self::Dxf => {
                let of = |page: &Page| dxf::page(&page.elements().collect::<Vec<_>>());
                pages.iter().map(|page| of(page).into_bytes()).collect()
            }
        })
    }
}

/// What stands on a sheet together.
#[derive(Debug)]
pub struct Part {
    /// The field; `None`: frame and title block.
    pub field: Option<SheetField>,
    /// Its elements.
    pub elements: Vec<Element>,
}

impl Part {
    /// The rectangle that its elements cover; `None` where they show nothing.
    pub fn area(&self) -> Option<Area> {
        self.elements.iter().filter_map(Element::bounds).reduce(|one, other| {
            [one[0].min(other[0]), one[1].min(other[1]), one[2].max(other[2]), one[3].max(other[3])]
        })
    }
}

/// A sheet.
#[derive(Debug)]
pub struct Page {
    /// Its format.
    pub format: SheetFormat,
    /// Its width and height, mm.
    pub size: [f64; 2],
    /// The inside of its frame, and the title block.
    pub frame: [Area; 2],
    /// Frame and title block, then the fields.
    pub parts: Vec<Part>,
}

impl Page {
    /// All that stands on it.
    pub fn elements(&self) -> impl Iterator<Item = Element> {
        self.parts.iter().flat_map(|part| part.elements.iter().cloned())
    }

    /// How much of the area inside the frame the fields and the title block cover.
    pub fn covered(&self) -> f64 {
        let area = |of: Area| (of[2] - of[0]) * (of[3] - of[1]);
        let fields = self.parts.iter().filter(|part| part.field.is_some()).filter_map(Part::area);
        (fields.map(area).sum::<f64>() + area(self.frame[1])) / area(self.frame[0])
    }
}

/// The fields that a scene wants, in their order.
pub fn wanted(note: &Note) -> Vec<SheetField> {
    let every = || SHEET_FIELDS.iter().map(|(_, field)| *field).collect();
    note.sheet.fields.clone().unwrap_or_else(every)
}

/// The sheets of a scene whose analysis is done, in the words of a language.
///
/// # Errors
///
/// In words: no analysis, none of the fields has anything to show, or one is larger than the sheet.
pub fn sheet(results: &Results, note: &Note, language: &Language) -> Result<Vec<Page>, Text> {
    let language = &language.with_digits(note.digits);
    let found = results.found.as_deref().ok_or_else(|| text!("sheet-no-results"))?;
    let wanted = if note.sheet.plans.is_empty() { &note.positions } else { &note.sheet.plans };
    let numbered = &language.with_marks(numbers(&results.linkage.mechanism));
    let drawn = Source { results, found, note, language, numbered, plans: results.chosen(wanted) }.blocks();
    if drawn.is_empty() {
        return Err(text!("sheet-nothing"));
    }
    let words = |own: &Drawn| if own.has_numbers { numbered } else { language };
    let sizes: Vec<Vec<Size>> = drawn.iter().map(|own| own.sizes(words(own))).collect();
    let block = |(own, sizes): (&Drawn, &Vec<Size>)| Block {
        sizes: sizes.iter().map(|own| own.size).collect(),
        weight: own.weight,
    };
    let blocks: Vec<Block> = drawn.iter().zip(&sizes).map(block).collect();
    let standard = Standard::of(language);
    let areas = |format| {
        let frame = standard.frame(format::size(format));
        [frame, standard.title(frame)]
    };
    let holds = |format: &SheetFormat| {
        let [frame, title] = areas(*format);
        layout::fits(&blocks, frame, title)
    };
    // What no smaller format holds goes on sheets of the greatest usual one, where all fields keep their order.
    let small = USUAL.into_iter().filter(|format| *format != SheetFormat::A1).find(holds);
    let format = note.sheet.format.or(small).unwrap_or(SheetFormat::A1);
    let areas = areas(format);
    let [frame, block] = areas;
    let alone = small.filter(|small| *small == format).and_then(|_| layout::arrange(&blocks, frame, block));
    let sheets = alone.map_or_else(|| divided(&blocks, areas), |placed| Ok(vec![(0, placed)]))?;
    let count = sheets.len();
    let title = Text::from(&results.linkage.mechanism.title).render(language);
    let title = title.as_str();
    let page = |(number, (first, placed)): (usize, &(usize, Vec<Placed>))| {
        let own = |at: usize| (&drawn[first + at], sizes[first + at][placed[at].level]);
        let scale = (0..placed.len()).map(own).find(|(drawn, _)| drawn.field == SheetField::Mechanism);
        let scale = scale.and_then(|(drawn, size)| drawn.scale(size, language));
        let mass = results.linkage.mechanism.links.iter().skip(1).map(|link| link.mass).sum();
        let fields = (0..placed.len()).map(|at| own(at).0.field);
        let drawing = title::drawing(&fields.collect::<Vec<_>>());
        let filling = Filling { title, drawing, note, language, sheet: [number + 1, count], mass, scale };
        let elements = title::elements(standard, format::size(format), &filling);
        let mut parts = vec![Part { field: None, elements }];
        parts.extend(placed.iter().enumerate().map(|(at, placed)| {
            let (drawn, size) = own(at);
            part(drawn, size, placed.corner, words(drawn))
        }));
        Page { format, size: format::size(format), frame: areas, parts }
    };
    Ok(sheets.iter().enumerate().map(page).collect())
}

fn part(drawn: &Drawn, size: Size, corner: [f64; 2], language: &Language) -> Part {
    let elements = drawn.elements(size, language).into_iter();
    let placed = |element: Element| printed(element).moved(corner);
    Part { field: Some(drawn.field), elements: elements.map(placed).collect() }
}

/// A text with the signs and in the ink of print.
fn printed(mut element: Element) -> Element {
    if let Outline::Text { words, .. } = &mut element.form {
        *words = words.replace("->", "→");
        element.ink = if element.ink == Ink::Dim { Ink::Text } else { element.ink };
    }
    element
}

/// The blocks in so many sheets as they need, about equally many on each, with the number of the first block of each.
fn divided(blocks: &[Block], [frame, title]: [Area; 2]) -> Result<Vec<(usize, Vec<Placed>)>, Text> {
    /// By how much a sheet may have more than its share, tried in this order.
    const MORE: [f64; 6] = [1.0, 1.05, 1.1, 1.2, 1.35, 1.6];
    let least = |block: &Block| block.sizes[0].iter().product::<f64>();
    let all: f64 = blocks.iter().map(least).sum();
    let counts = |most: f64| {
        let (mut counts, mut first) = (Vec::new(), 0);
        while first < blocks.len() {
            let mut area = 0.0;
            let within = blocks[first..].iter().take_while(|block| {
                area += least(block);
                area <= most
            });
            let own = within.count().max(1);
            counts.push(layout::fitting(&blocks[first..first + own], frame, title));
            if counts.last() == Some(&0) {
                break;
            }
            first += counts.last().unwrap_or(&1);
        }
        counts
    };
    let needed = counts(f64::INFINITY);
    let share = all / needed.len() as f64;
    let even = MORE.into_iter().map(|more| counts(more * share)).find(|own| own.len() <= needed.len());
    let (mut sheets, mut first) = (Vec::new(), 0);
    for count in even.unwrap_or(needed) {
        let placed = layout::arrange(&blocks[first..first + count], frame, title);
        let placed = placed.filter(|placed| !placed.is_empty()).ok_or_else(|| text!("sheet-too-small"))?;
        sheets.push((first, placed));
        first += count;
    }
    Ok(sheets)
}
