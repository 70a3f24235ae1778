//! Columns of a table side by side.

use assur_book::Printed;
use assur_words::unit;
use unicode_width::UnicodeWidthStr;

use super::line::{Line, LineKind, Style, wrap};

/// Blanks between the columns of a table.
pub(super) const GAP: usize = 2;

/// A column of texts, flush right or left; each cell in one line or more.
#[derive(Debug)]
pub(super) struct Ready {
    head: Vec<String>,
    unit: String,
    cells: Vec<Vec<String>>,
    pub(super) width: usize,
    right: bool,
}

impl Ready {
    pub(super) fn of(column: &Printed, style: Style) -> Self {
        let cells = column.cells.iter().map(|cell| vec![style.line(cell)]).collect();
        let (head, unit) = (vec![style.line(&column.head)], style.line(&unit(column.unit)));
        let right = column.of_numbers;
        let mut column = Self { head, unit, cells, width: 0, right };
        column.width = column.widest(UnicodeWidthStr::width);
        column
    }

    /// The greatest of its lines.
    fn widest(&self, of: fn(&str) -> usize) -> usize {
        let cells = self.cells.iter().chain([&self.head]).flatten().map(|line| of(line)).max();
        cells.unwrap_or(0).max(self.unit.width())
    }

    /// The least width to which it can be folded.
    fn least(&self) -> usize {
        fn longest(line: &str) -> usize {
            line.split(' ').map(UnicodeWidthStr::width).max().unwrap_or(0)
        }

        let of_cell: fn(&str) -> usize = if self.right { UnicodeWidthStr::width } else { longest };
        let cells = self.cells.iter().flatten().map(|line| of_cell(line));
        let head = self.head.iter().map(|line| longest(line));
        cells.chain(head).max().unwrap_or(0).max(self.unit.width())
    }

    fn fold(&mut self, width: usize) {
        let folded = if self.right { Vec::new() } else { self.cells.iter_mut().collect() };
        for cell in folded.into_iter().chain([&mut self.head]) {
            *cell = wrap(&cell.join(" "), 0, 0, width);
        }
        self.width = self.widest(UnicodeWidthStr::width);
    }
}

/// Folds the widest columns until all fit; nothing where they can't.
pub(super) fn fold(mut columns: Vec<&mut Ready>, room: usize) {
    let gaps = GAP * columns.len().saturating_sub(1);
    let least: Vec<usize> = columns.iter().map(|column| column.least()).collect();
    let mut widths: Vec<usize> = columns.iter().map(|column| column.width).collect();
    if least.iter().sum::<usize>() + gaps > room {
        return;
    }
    while widths.iter().sum::<usize>() + gaps > room {
        let slack = widths.iter().zip(&least).enumerate().filter(|(_, (width, least))| width > least);
        let Some((widest, _)) = slack.max_by_key(|(_, (width, _))| **width) else { return };
        widths[widest] -= 1;
    }
    for (column, width) in columns.iter_mut().zip(widths) {
        if width < column.width {
            column.fold(width);
        }
    }
}

/// Width of columns with the gaps in front of them.
pub(super) fn total(columns: &[Ready]) -> usize {
    columns.iter().map(|column| column.width + GAP).sum()
}

/// Heads, units, a line, and rows.
pub(super) fn grid(columns: &[&Ready], rows: usize) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut line = |kind: LineKind, cell: &dyn Fn(&Ready) -> String| {
        let mut text = String::new();
        for (number, column) in columns.iter().enumerate() {
            let cell = cell(column);
            let blanks = " ".repeat(column.width.saturating_sub(cell.width()));
            let gap = " ".repeat(if number == 0 { 0 } else { GAP });
            let (before, after) = if column.right { (&*blanks, "") } else { ("", &*blanks) };
            text.extend([&gap, before, &cell, after]);
        }
        lines.push(Line { kind, text: text.trim_end().to_owned() });
    };
    let part = |cell: Option<&Vec<String>>, at: usize| {
        cell.and_then(|lines| lines.get(at)).cloned().unwrap_or_default()
    };
    for at in 0..columns.iter().map(|column| column.head.len()).max().unwrap_or(0) {
        line(LineKind::Head, &|column| part(Some(&column.head), at));
    }
    if columns.iter().any(|column| !column.unit.is_empty()) {
        line(LineKind::Head, &|column| column.unit.clone());
    }
    line(LineKind::Rule, &|column| "-".repeat(column.width));
    for row in 0..rows {
        let height = columns.iter().filter_map(|column| column.cells.get(row)).map(Vec::len).max();
        (0..height.unwrap_or(1))
            .for_each(|at| line(LineKind::Row(row), &|column| part(column.cells.get(row), at)));
    }
    lines
}
