//! What a field draws: a figure of pictures, or a table.

use assur_figure::{
    Anchor, Element, Figure, Frame, Ink, Page, Panel, Style, elements, heading_width, plane_scale, size,
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
    Table(Table),
}

/// A table with its heading.
#[derive(Debug, Default)]
pub(crate) struct Table {
    pub(crate) title: String,
    /// The names of the columns; none, where they need no names.
    pub(crate) head: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
    /// How many columns have words, at the left; the others have numbers, at the right.
    pub(crate) words: usize,
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
            Content::Table(table) => return vec![Size { size: table.size(), page: None }],
            Content::Figure(figure) => figure,
        };
        let mut sizes: Vec<Size> = Vec::new();
        let heading = |panel: &Panel| heading_width(panel, Style::SHEET, language);
        let headings = figure.panels.iter().map(heading).fold(0.0, f64::max) * figure.columns.max(1) as f64;
        let mut width = self.least.max(headings).max(LEAST);
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
            (Content::Table(table), _) => table.elements(size.size),
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

impl Table {
    /// Its rows with its head.
    fn all(&self) -> impl Iterator<Item = &Vec<String>> {
        std::iter::once(&self.head).filter(|head| !head.is_empty()).chain(&self.rows)
    }

    /// Widths of the columns, mm.
    fn columns(&self) -> Vec<f64> {
        let count = self.all().map(Vec::len).max().unwrap_or(0);
        let widest = |column: usize| {
            let cells = self.all().filter_map(|row| row.get(column));
            cells.map(|cell| exact_width(cell, Style::SHEET.em)).fold(0.0, f64::max) + 2.0 * BESIDE
        };
        (0..count).map(widest).collect()
    }

    fn size(&self) -> [f64; 2] {
        let width = self.columns().iter().sum::<f64>().max(exact_width(&self.title, Style::SHEET.em));
        [width, ROW * (self.all().count() + 1) as f64]
    }

    fn elements(&self, [width, height]: [f64; 2]) -> Vec<Element> {
        let style = Style::SHEET;
        let base = |row: usize| ROW * (row + 1) as f64 - 0.5 * (ROW - 0.73 * style.em);
        let text = |at, words: &str, anchor| Element::text(at, words, style.em, anchor, Ink::Text);
        let rule = |ends: [[f64; 2]; 2], width| Element::line(ends, width, Ink::Text);
        let mut all = vec![text([0.0, base(0)], &self.title, Anchor::Start)];
        let mut ends = vec![0.0];
        ends.extend(self.columns().iter().scan(0.0, |end, own| {
            *end += own;
            Some(*end)
        }));
        // What a long heading leaves is room of the last column.
        ends.last_mut().into_iter().for_each(|end| *end = width);
        let heads = usize::from(!self.head.is_empty());
        for (row, cells) in self.all().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let (left, right) = (ends[column], ends[column + 1]);
                let (x, anchor) = match column {
                    _ if row < heads => (0.5 * (left + right), Anchor::Middle),
                    _ if column < self.words => (left + BESIDE, Anchor::Start),
                    _ => (right - BESIDE, Anchor::End),
                };
                all.push(text([x, base(row + 1)], cell, anchor));
            }
            let above = ROW * (row + 1) as f64;
            let is_strong = row <= heads;
            all.push(rule([[0.0, above], [width, above]], if is_strong { style.line } else { style.fine }));
        }
        all.extend(ends.iter().map(|x| rule([[*x, ROW], [*x, height]], style.line)));
        all.push(rule([[0.0, height], [width, height]], style.line));
        all
    }
}

/// A figure of one panel with this heading.
pub(crate) fn titled(mut panel: Panel, title: assur_words::Text) -> Figure {
    panel.title = title;
    Figure::of(panel)
}
