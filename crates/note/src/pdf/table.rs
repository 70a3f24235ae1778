//! Tables in pages: columns as wide as their words, rows that no page divides, the head anew on each page, no picture between the pages.

use assur_figure::{Anchor, Element, Ink};

use super::lines::wrapped;
use super::{APART, FINE, LAST, LEFT, LINE, Pages, SMALL, WIDTH};
use crate::sheet::Grid;

/// Free border of a cell, mm.
const BORDER: f64 = 1.3;
/// Least width of a column, mm.
const LEAST: f64 = 10.0;
/// Rows of a table that must stand below its head on one page.
const TOGETHER: usize = 3;

/// Puts a table with its caption below what stands on the page, and another caption where it goes on, on the next page.
pub(super) fn put(pages: &mut Pages, [caption, again]: [&str; 2], grid: &Grid) {
    let widths = widths(grid);
    let head = cells(&grid.head, &widths);
    let rows: Vec<_> = grid.rows.iter().map(|row| cells(row, &widths)).collect();
    let caption = wrapped(caption, WIDTH, SMALL);
    let first: f64 = rows.iter().take(TOGETHER).map(|row| high(row)).sum();
    let above = LINE * SMALL * caption.len() as f64 + high(&head) + APART;
    if pages.y + above + rows.iter().map(|row| high(row)).sum::<f64>() > LAST {
        pages.catch_up();
    }
    pages.need(above + first);
    for line in &caption {
        pages.line(line, SMALL, 0.0);
    }
    pages.y += APART;
    row(pages, &head, &widths, |_| Anchor::Middle);
    for (number, cells) in rows.iter().enumerate() {
        // The last row does not stand alone on a page.
        let next = rows.get(number + 1).filter(|_| number + 2 == rows.len());
        // No picture stands between the parts of a table.
        if pages.y + high(cells) + next.map_or(0.0, |cells| high(cells)) > LAST {
            pages.turn();
            pages.line(again, SMALL, 0.0);
            pages.y += APART;
            row(pages, &head, &widths, |_| Anchor::Middle);
        }
        row(pages, cells, &widths, |at| if grid.right[at] { Anchor::End } else { Anchor::Start });
    }
    pages.y += 2.0 * APART;
    pages.settle();
}

/// Widths of the columns, mm: what the widest word or cell needs, less in the widest where there is too little room.
fn widths(grid: &Grid) -> Vec<f64> {
    let wide = |cell: &String| assur_pdf::text_width(cell, SMALL) + 2.0 * BORDER;
    let column = |at: usize| {
        // A head has two lines, where its words are not longer.
        let words = grid.head[at].split(' ').map(|word| wide(&word.to_owned()));
        let head = words.fold(LEAST.max(0.6 * wide(&grid.head[at])), f64::max);
        grid.rows.iter().filter_map(|row| row.get(at)).map(wide).fold(head, f64::max)
    };
    let mut widths: Vec<f64> = (0..grid.head.len()).map(column).collect();
    let all = |widths: &[f64]| widths.iter().sum::<f64>();
    // The widest are cut to one width, until all fit.
    while all(&widths) > WIDTH {
        let most = widths.iter().copied().fold(0.0, f64::max);
        let next = widths.iter().copied().filter(|width| *width < most - FINE).fold(LEAST, f64::max);
        let of_most = widths.iter().filter(|width| **width >= most - FINE).count();
        let cut = ((all(&widths) - WIDTH) / of_most as f64).min(most - next).max(FINE);
        widths.iter_mut().filter(|width| **width >= most - FINE).for_each(|width| *width -= cut);
    }
    let factor = WIDTH / all(&widths);
    widths.iter().map(|width| width * factor).collect()
}

/// The lines of the cells of a row.
fn cells(row: &[String], widths: &[f64]) -> Vec<Vec<String>> {
    row.iter().zip(widths).map(|(cell, width)| wrapped(cell, width - 2.0 * BORDER, SMALL)).collect()
}

fn high(cells: &[Vec<String>]) -> f64 {
    let lines = cells.iter().map(Vec::len).max().unwrap_or(0).max(1);
    LINE * SMALL * lines as f64 + 0.6
}

fn row(pages: &mut Pages, cells: &[Vec<String>], widths: &[f64], anchor: impl Fn(usize) -> Anchor) {
    let (top, high) = (pages.y, high(cells));
    let page = pages.page();
    let mut x = LEFT;
    for (column, (lines, width)) in cells.iter().zip(widths).enumerate() {
        let corners = [[x, top], [x + width, top], [x + width, top + high], [x, top + high], [x, top]];
        page.push(Element::line(corners, FINE, Ink::Text));
        for (number, line) in lines.iter().enumerate() {
            let y = top + LINE * SMALL * number as f64 + 1.05 * SMALL;
            let at = match anchor(column) {
                Anchor::Start => x + BORDER,
                Anchor::Middle => x + 0.5 * width,
                Anchor::End => x + width - BORDER,
            };
            page.push(Element::text([at, y], line, SMALL, anchor(column), Ink::Text));
        }
        x += width;
    }
    pages.y += high;
}
