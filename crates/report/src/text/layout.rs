//! Blocks of a document as lines of a width: for a page of the text report, and for a view of the terminal UI.

use assur_book::{Block, Cell, Column, Fact, Printed, Table, Term};
use assur_figure::cells::{self, Look, Marker};
use assur_figure::{Figure, Zoom};
use assur_words::{Text, text};
use unicode_width::UnicodeWidthStr;

use super::grid::{GAP, Ready, fold, grid, total};
use super::line::{Line, LineKind, Style, wrap};

/// Columns of the report.
pub(super) const WIDTH: usize = 100;
/// Rows of a table that are shown.
const MOST_ROWS: usize = 4096;
/// Lines of a table that are shown, all its blocks together: sixteen blocks of the most positions that are kept.
const MOST_LINES: usize = 16 * MOST_ROWS;
/// Rows of a figure in characters.
const FIGURE: u16 = 24;
/// A fact whose value is longer has lines of its own, since columns don't break.
const LONG: usize = 30;
/// The facts of the first section wrap at this column, so that they fit a terminal of 80.
const SCREEN: usize = 78;
/// Facts on a narrower page are no table.
const NARROW: usize = 60;

/// Blocks as lines of at most `width` columns.
pub fn lines(blocks: &[Block], style: Style, width: usize) -> Vec<Line> {
    let mut page = Page { lines: Vec::new(), style, width, sections: 0 };
    for block in blocks {
        page.block(block);
    }
    page.lines
}

/// A page that is being written.
#[derive(Debug)]
struct Page {
    lines: Vec<Line>,
    style: Style,
    width: usize,
    sections: usize,
}

impl Page {
    fn block(&mut self, block: &Block) {
        match block {
            Block::Title(title) => self.underlined(self.style.line(title), "="),
            Block::Heading(name) => self.section(name),
            Block::Subheading(name) => self.caption(name),
            Block::Paragraph(words) => self.paragraph(words),
            Block::Facts { caption, facts } => self.facts(caption, facts),
            Block::Table(table) => self.table(table),
            Block::Equation(terms) => self.equation(terms),
            Block::Figure { frames, caption, .. } => self.figure(frames.first(), caption),
        }
    }

    fn push(&mut self, kind: LineKind, text: impl Into<String>) {
        self.lines.push(Line { kind, text: text.into() });
    }

    fn underlined(&mut self, line: String, with: &str) {
        let rule = with.repeat(line.width());
        self.push(LineKind::Heading, line);
        self.push(LineKind::Rule, rule);
    }

    /// A figure in characters.
    fn figure(&mut self, figure: Option<&Figure>, caption: &Text) {
        let Some(figure) = figure else { return };
        let Style { language, ascii } = self.style;
        let marker = if ascii { Marker::Ascii } else { Marker::Braille };
        let look = Look { marker, ratio: 2.0, zoom: Zoom::WHOLE, language };
        let mut rows = vec![vec![' '; self.width]; usize::from(FIGURE)];
        let width = u16::try_from(self.width).unwrap_or(u16::MAX);
        for spot in cells::draw(figure, [width, FIGURE], look) {
            let row = &mut rows[usize::from(spot.row)][usize::from(spot.column)..];
            for (cell, letter) in row.iter_mut().zip(spot.text.chars()) {
                *cell = if ascii && letter == '│' { '|' } else { letter };
            }
        }
        self.gap();
        for row in rows {
            self.push(LineKind::Words, String::from_iter(row).trim_end());
        }
        self.paragraph(caption);
    }

    /// An empty line below what stands above.
    fn gap(&mut self) {
        if !self.lines.is_empty() {
            self.push(LineKind::Words, "");
        }
    }

    /// A numbered heading.
    fn section(&mut self, name: &Text) {
        self.sections += 1;
        self.gap();
        self.underlined(format!("{}. {}", self.sections, self.style.line(name)), "-");
    }

    /// A line that names the table below it.
    fn caption(&mut self, caption: &Text) {
        if !caption.is_empty() {
            self.gap();
            self.wrapped(LineKind::Heading, &self.style.line(caption), 0, 2);
        }
    }

    /// Words, broken into lines.
    fn paragraph(&mut self, words: &Text) {
        self.wrapped(LineKind::Words, &self.style.line(words), 0, 2);
    }

    fn wrapped(&mut self, kind: LineKind, words: &str, first: usize, rest: usize) {
        let lines = wrap(words, first, rest, self.width);
        self.lines.extend(lines.into_iter().map(|text| Line { kind, text }));
    }

    fn equation(&mut self, terms: &[Term]) {
        let term = |term: &Term| match term {
            Term::Sign(sign) => (*sign).to_owned(),
            _ => self.style.line(&term.text()),
        };
        let line: String = terms.iter().map(term).collect();
        self.wrapped(LineKind::Words, &line, 2, 4);
    }

    fn facts(&mut self, caption: &Text, facts: &[Fact]) {
        self.caption(caption);
        if self.width < NARROW {
            return facts.iter().for_each(|fact| self.fact(fact));
        }
        let width = self.width;
        if self.sections == 1 {
            self.width = width.min(SCREEN);
        }
        self.table_of_facts(facts);
        self.width = width;
    }

    fn table_of_facts(&mut self, facts: &[Fact]) {
        let is_long = |fact: &&Fact| self.style.line(&fact.value()).width() > LONG;
        let (long, short): (Vec<_>, Vec<_>) = facts.iter().partition(is_long);
        for fact in long {
            self.paragraph(&text!("report-fact", what = fact.what(), value = fact.with_unit()));
        }
        // Value and unit in one column: a page has no room for more.
        let heads = [text!("fact-quantity"), text!("fact-value"), text!("fact-place")].map(Column::of);
        let row = |fact: &&Fact| [fact.what(), fact.with_unit(), fact.place()].map(Cell::Text);
        let has_place = short.iter().any(|fact| !fact.at.is_empty());
        let heads = heads.into_iter().take(if has_place { 3 } else { 2 });
        self.table(&Table::list(Text::default(), heads).rows(short.iter().map(row)));
    }

    /// A fact where there is little room: its value behind its short name, its place below.
    fn fact(&mut self, fact: &Fact) {
        let place = (!fact.at.is_empty()).then(|| text!("report-fact-at", place = fact.place()));
        let [what, value] = [fact.what().short(), fact.with_unit()].map(|text| self.style.line(&text));
        // A value that has a line of its own is not broken.
        if what.width() + 1 + value.width() > self.width && value.width() + 2 <= self.width {
            self.wrapped(LineKind::Words, &what, 0, 2);
            self.wrapped(LineKind::Words, &value, 2, 2);
        } else {
            self.wrapped(LineKind::Words, &format!("{what} {value}"), 0, 2);
        }
        if let Some(place) = place {
            self.wrapped(LineKind::Words, &self.style.line(&place), 2, 2);
        }
    }

    /// A table: where it is too wide, with its words folded, else in blocks of the page's width, each with the key columns in
    /// front. Columns of one group stay together where they fit.
    fn table(&mut self, table: &Table) {
        self.caption(&table.caption);
        let (keys, groups) = table.printed();
        let ready = |columns: &Vec<Printed>| columns.iter().map(|of| Ready::of(of, self.style)).collect();
        let mut keys: Vec<_> = ready(&keys);
        let mut groups: Vec<Vec<Ready>> = groups.iter().map(ready).collect();
        if let [group] = &mut groups[..] {
            fold(keys.iter_mut().chain(group).collect(), self.width);
        }
        let room = self.width - total(&keys).min(self.width);
        if groups.iter().flatten().any(|column| column.width > room) {
            return self.rows(table);
        }
        let mut blocks: Vec<Vec<Ready>> = Vec::new();
        for group in groups {
            let fits = total(&group) <= room + GAP;
            let pieces = if fits { vec![group] } else { group.into_iter().map(|one| vec![one]).collect() };
            for piece in pieces {
                match blocks.last_mut().filter(|block| total(block) + total(&piece) <= room + GAP) {
                    Some(block) => block.extend(piece),
                    None => blocks.push(piece),
                }
            }
        }
        self.blocks(&keys, &blocks, table.height());
    }

    /// Rows of which a cell has no room beside the keys: each as a paragraph.
    fn rows(&mut self, table: &Table) {
        let (keys, groups) = table.printed();
        for row in 0..table.height().min(MOST_ROWS) {
            let cells = |columns: &mut dyn Iterator<Item = &Printed>| {
                let cells = columns.filter_map(|column| column.cells.get(row).cloned());
                assur_words::joined("; ", cells.collect::<Vec<_>>())
            };
            let (what, value) = (cells(&mut keys.iter()), cells(&mut groups.iter().flatten()));
            let line = self.style.line(&text!("report-fact", what, value));
            self.wrapped(LineKind::Row(row), &line, 0, 2);
        }
    }

    fn blocks(&mut self, keys: &[Ready], blocks: &[Vec<Ready>], height: usize) {
        let rows = height.min(MOST_ROWS);
        let most = (MOST_LINES / rows.max(1)).max(1);
        let count = |blocks: &[Vec<Ready>]| blocks.iter().map(Vec::len).sum::<usize>();
        let (all, shown) = (count(blocks), count(&blocks[..blocks.len().min(most)]));
        let only_keys = [Vec::new()];
        let blocks = if blocks.is_empty() { &only_keys } else { blocks };
        for (number, block) in blocks.iter().take(most).enumerate() {
            if number > 0 {
                self.push(LineKind::Words, "");
            }
            self.lines.extend(grid(&keys.iter().chain(block).collect::<Vec<_>>(), rows));
        }
        if rows < height {
            self.push(
                LineKind::Words,
                self.style.line(&text!("report-rows-shown", shown = rows, all = height)),
            );
        }
        if shown < all {
            self.push(LineKind::Words, self.style.line(&text!("report-columns-shown", shown, all)));
        }
    }
}
