//! What a field draws: a figure of pictures, or a table.

use assur_figure::{
    Anchor, Element, Figure, Frame, Ink, Page, Panel, Style, elements, heading_width, plane_scale, size,
    text_width,
};
use assur_pdf::text_width as exact_width;
use assur_scene::SheetField;
use assur_words::Language;

/// Widths in which a picture is tried, mm: the least, the greatest, and the ratio of two that follow each other.
const LEAST: f64 = 60.0;
const MOST: f64 = 720.0;
const STEP: f64 = 1.07;
/// Height of a plane beside its width at most.
const UPRIGHT: f64 = 1.4;
/// Height of a plot of several below each other beside its width, from flat to high, and least height, mm.
const FLAT: [f64; 3] = [0.22, 0.34, 0.5];
const LEAST_PLOT: f64 = 38.0;
/// Height of a row of a table, and space beside its texts, mm.
const ROW: f64 = 8.0;
const BESIDE: f64 = 1.5;

/// A block of a field.
#[derive(Debug)]
pub(crate) struct Drawn {
    pub(crate) field: SheetField,
    pub(crate) content: Content,
    /// How large it should be beside others, and its least width, mm.
    pub(crate) weight: f64,
    pub(crate) least: f64,
    /// Whether links have their numbers in it, and not their names.
    pub(crate) has_numbers: bool,
}

/// What a field draws.
#[derive(Debug)]
pub(crate) enum Content {
    Figure(Figure),
    /// A heading, and rows of what is told and its value; whether values stand at the right.
    Table {
        title: String,
        rows: Vec<[String; 2]>,
        right: bool,
    },
}

/// A size in which a field can be drawn, mm, and on which page it has this size; a table has none.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Size {
    pub(crate) size: [f64; 2],
    page: Option<Page>,
}

impl Drawn {
    /// The sizes in which it can be drawn, from the least.
    pub(crate) fn sizes(&self, language: &Language) -> Vec<Size> {
        let figure = match &self.content {
            Content::Table { title, rows, .. } => {
                return vec![Size { size: table_size(title, rows), page: None }];
            }
            Content::Figure(figure) => figure,
        };
        let mut sizes: Vec<Size> = Vec::new();
        let heading = |panel: &Panel| heading_width(panel, Style::SHEET, language);
        let headings = figure.panels.iter().map(heading).fold(LEAST, f64::max);
        let mut width = self.least.max(headings);
        while width <= MOST {
            for page in pages(figure, width) {
                let own = Size { size: room(figure, page, language), page: Some(page) };
                if sizes.iter().all(|known| known.size.map(f64::to_bits) != own.size.map(f64::to_bits)) {
                    sizes.push(own);
                }
            }
            width *= STEP;
        }
        sizes.sort_by(|one, other| area(one).total_cmp(&area(other)));
        sizes
    }

    /// How many meters of a figure a millimeter stands for.
    pub(crate) fn scale(&self, size: Size, language: &Language) -> Option<f64> {
        let Content::Figure(figure) = &self.content else { return None };
        plane_scale(figure, size.page?, Style::SHEET, language)
    }

    /// What stands on paper in this size, from its upper left corner.
    pub(crate) fn elements(&self, size: Size, language: &Language) -> Vec<Element> {
        match (&self.content, size.page) {
            (Content::Figure(figure), Some(page)) => {
                let all = elements(figure, page, Style::SHEET, language).0;
                let left = sides(&all, 0.0)[0];
                all.into_iter().map(|element| element.moved([-left, 0.0])).collect()
            }
            (Content::Table { title, rows, right }, _) => table(title, rows, *right, size.size),
            (Content::Figure(_), None) => Vec::new(),
        }
    }
}

/// Where elements end at the left, if it is left of 0, and at the right, if it is right of a width.
fn sides(all: &[Element], width: f64) -> [f64; 2] {
    let bounds = all.iter().filter_map(Element::bounds);
    bounds.fold([0.0, width], |[left, right], own| [f64::min(left, own[0]), f64::max(right, own[2])])
}

/// What a figure takes on a page. The numbers beside axes may be wider than a page has room for.
fn room(figure: &Figure, page: Page, language: &Language) -> [f64; 2] {
    if is_plane(figure) {
        return size(figure, page, Style::SHEET, language);
    }
    let (all, [width, height]) = elements(figure, page, Style::SHEET, language);
    let [left, right] = sides(&all, width);
    [right - left, height]
}

fn area(of: &Size) -> f64 {
    of.size.iter().product()
}

fn is_plane(figure: &Figure) -> bool {
    figure.panels.iter().all(|panel| matches!(panel.frame, Frame::Plane { .. }))
}

/// The pages of a figure in a width.
fn pages(figure: &Figure, width: f64) -> Vec<Page> {
    if is_plane(figure) {
        return vec![Page::Within([width, UPRIGHT * width])];
    }
    let plots = figure.rows().max(1) as f64;
    let high = |flat: f64| Page::Of([width, plots * (flat * width).max(LEAST_PLOT) + 10.0 * plots]);
    FLAT.map(high).into()
}

fn columns(rows: &[[String; 2]]) -> [f64; 2] {
    let widest = |column: usize| {
        rows.iter().map(|row| exact_width(&row[column], Style::SHEET.em)).fold(0.0, f64::max) + 2.0 * BESIDE
    };
    [widest(0), widest(1)]
}

fn table_size(title: &str, rows: &[[String; 2]]) -> [f64; 2] {
    let width = columns(rows).iter().sum::<f64>().max(text_width(title, Style::SHEET.em));
    [width, ROW * (rows.len() + 1) as f64]
}

fn table(title: &str, rows: &[[String; 2]], right: bool, [width, height]: [f64; 2]) -> Vec<Element> {
    let style = Style::SHEET;
    let base = |row: usize| ROW * (row + 1) as f64 - 0.5 * (ROW - 0.73 * style.em);
    let text = |at, words: &str, anchor| Element::text(at, words, style.em, anchor, Ink::Text);
    let mut all = vec![text([0.0, base(0)], title, Anchor::Start)];
    let middle = width - columns(rows)[1];
    for (row, [told, value]) in rows.iter().enumerate() {
        all.push(text([BESIDE, base(row + 1)], told, Anchor::Start));
        let (x, anchor) =
            if right { (width - BESIDE, Anchor::End) } else { (middle + BESIDE, Anchor::Start) };
        all.push(text([x, base(row + 1)], value, anchor));
        let under = ROW * (row + 1) as f64;
        all.push(Element::line(
            [[0.0, under], [width, under]],
            if row == 0 { style.line } else { style.fine },
            Ink::Text,
        ));
    }
    let sides = [0.0, middle, width].map(|x| Element::line([[x, ROW], [x, height]], style.line, Ink::Text));
    all.extend(sides);
    all.push(Element::line([[0.0, height], [width, height]], style.line, Ink::Text));
    all
}

/// A figure of one panel with this heading.
pub(crate) fn titled(mut panel: Panel, title: assur_words::Text) -> Figure {
    panel.title = title;
    Figure::of(panel)
}
