//! A document as lines of at most [`WIDTH`] columns.

use std::borrow::Cow;

use assur_book::{Block, Cell, Column, Document, Fact, Printed, Table, Term};
use assur_words::{Language, Text, text};
use textwrap::Options;
use textwrap::WordSeparator::AsciiSpace;
use textwrap::WordSplitter::NoHyphenation;
use unicode_width::UnicodeWidthStr;

use crate::to_ascii;

/// Columns of the report.
const WIDTH: usize = 100;
/// Blanks between the columns of a table.
const GAP: usize = 2;
/// Rows of a table that are shown.
const MOST_ROWS: usize = 4096;
/// Lines of a table that are shown, all its blocks together: sixteen blocks of the most positions that are kept.
const MOST_LINES: usize = 16 * MOST_ROWS;
/// A fact whose value is longer has lines of its own, since columns don't break.
const LONG: usize = 30;

/// How a text is written.
#[derive(Debug, Clone, Copy)]
pub struct Style<'l> {
    /// Its language.
    pub language: &'l Language,
    /// No character beyond ASCII.
    pub ascii: bool,
}

/// A document as lines.
pub fn written(document: &Document, style: Style<'_>) -> String {
    let mut page = Page { text: String::new(), style, sections: 0 };
    document.blocks.iter().for_each(|block| page.block(block));
    page.text
}

impl Style<'_> {
    /// English, with all characters.
    pub fn english() -> Self {
        Self { language: Language::english(), ascii: false }
    }

    /// A text in the language.
    pub fn line(self, text: &Text) -> String {
        let line = text.render(self.language);
        if self.ascii { to_ascii(&line).into_owned() } else { line }
    }
}

/// A text that is being written.
#[derive(Debug)]
struct Page<'l> {
    text: String,
    style: Style<'l>,
    sections: usize,
}

impl Page<'_> {
    fn block(&mut self, block: &Block) {
        match block {
            Block::Title(title) => self.underlined(&self.style.line(title), "="),
            Block::Heading(name) => self.section(name),
            Block::Subheading(name) => self.caption(name),
            Block::Paragraph(words) => self.paragraph(words),
            Block::Facts { caption, facts } => self.facts(caption, facts),
            Block::Table(table) => self.table(table),
            Block::Equation(terms) => self.equation(terms),
            // Lines have no drawings.
            Block::Figure { .. } => {}
        }
    }

    fn underlined(&mut self, line: &str, with: &str) {
        self.text.extend([line, "\n", &with.repeat(line.width()), "\n"]);
    }

    /// A numbered heading.
    fn section(&mut self, name: &Text) {
        self.sections += 1;
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.underlined(&format!("{}. {}", self.sections, self.style.line(name)), "-");
    }

    /// A line that names the table below it.
    fn caption(&mut self, caption: &Text) {
        if !caption.is_empty() {
            self.text.push('\n');
            self.paragraph(caption);
        }
    }

    /// Words, broken into lines.
    fn paragraph(&mut self, words: &Text) {
        self.text += &wrap(&self.style.line(words), 0, 2);
    }

    fn equation(&mut self, terms: &[Term]) {
        let line = terms.iter().fold(String::new(), |line, term| {
            line + &match term {
                Term::Name(letters, below) if below.is_empty() => self.style.line(letters),
                Term::Name(letters, below) => {
                    format!("{}_{}", self.style.line(letters), self.style.line(below))
                }
                Term::Function(text) => (*text).to_owned(),
                Term::Power(text) => format!("^{text}"),
                Term::Sign(text) | Term::Number(text) => self.style.line(text),
                Term::Unit(text) => format!(" {}", self.style.line(text)),
            }
        });
        self.text += &wrap(&line, 2, 4);
    }

    fn facts(&mut self, caption: &Text, facts: &[Fact]) {
        self.caption(caption);
        let is_long = |fact: &&Fact| self.style.line(&fact.value()).len() > LONG;
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

    /// A table in blocks of the page's width, each with the key columns in front. Columns of one group stay together where
    /// they fit.
    fn table(&mut self, table: &Table) {
        self.caption(&table.caption);
        let (keys, groups) = table.printed();
        let keys: Vec<_> = keys.into_iter().map(|key| self.ready(key)).collect();
        let room = WIDTH - total(&keys).min(WIDTH);
        if groups
            .iter()
            .flatten()
            .any(|column| column.cells.iter().any(|cell| self.style.line(cell).width() > room))
        {
            return self.rows(table);
        }
        let mut blocks: Vec<Vec<Ready>> = Vec::new();
        for group in groups {
            let group: Vec<_> = group.into_iter().map(|column| self.ready(column)).collect();
            let fits = total(&group) <= room;
            let pieces = if fits { vec![group] } else { group.into_iter().map(|one| vec![one]).collect() };
            for piece in pieces {
                match blocks.last_mut().filter(|block| total(block) + total(&piece) <= room) {
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
            self.paragraph(&text!("report-fact", what = what, value = value));
        }
    }

    fn blocks(&mut self, keys: &[Ready], blocks: &[Vec<Ready>], height: usize) {
        let rows = height.min(MOST_ROWS);
        let most = (MOST_LINES / rows.max(1)).max(1);
        let count = |blocks: &[Vec<Ready>]| blocks.iter().map(Vec::len).sum::<usize>();
        let (all, shown) = (count(blocks), count(&blocks[..blocks.len().min(most)]));
        let lines: Vec<_> = match blocks {
            [] => vec![grid(&keys.iter().collect::<Vec<_>>(), rows)],
            blocks => blocks
                .iter()
                .take(most)
                .map(|block| grid(&keys.iter().chain(block).collect::<Vec<_>>(), rows))
                .collect(),
        };
        self.text += &lines.join("\n");
        let mut shortened = |text: Text| self.text.extend([self.style.line(&text).as_str(), "\n"]);
        if rows < height {
            shortened(text!("report-rows-shown", shown = rows, all = height));
        }
        if shown < all {
            shortened(text!("report-columns-shown", shown = shown, all = all));
        }
    }

    fn ready(&self, column: Printed) -> Ready {
        let right = column.is_of_numbers();
        let cells: Vec<_> = column.cells.iter().map(|cell| self.style.line(cell)).collect();
        let [head, unit] = [column.head, assur_words::unit(column.unit)].map(|text| self.style.line(&text));
        // Lines have no subscripts.
        let head = head.replace("_{", "").replace('}', "");
        let width = cells.iter().chain([&head, &unit]).map(|text| text.width()).max().unwrap_or(0);
        Ready { head, unit, cells, width, right }
    }
}

/// A column of texts, flush right or left.
#[derive(Debug)]
struct Ready {
    head: String,
    unit: String,
    cells: Vec<String>,
    width: usize,
    right: bool,
}

/// Width of columns with the gaps in front of them.
fn total(columns: &[Ready]) -> usize {
    columns.iter().map(|column| column.width + GAP).sum()
}

/// Heads, units, a line, and rows.
fn grid(columns: &[&Ready], rows: usize) -> String {
    let mut text = String::new();
    let mut line = |cell: &dyn Fn(&Ready) -> String| {
        let mut line = String::new();
        for (number, column) in columns.iter().enumerate() {
            let cell = cell(column);
            let blanks = " ".repeat(column.width - cell.width());
            let gap = " ".repeat(if number == 0 { 0 } else { GAP });
            let (before, after) = if column.right { (&*blanks, "") } else { ("", &*blanks) };
            line.extend([&gap, before, &cell, after]);
        }
        text.extend([line.trim_end(), "\n"]);
    };
    line(&|column| column.head.clone());
    if columns.iter().any(|column| !column.unit.is_empty()) {
        line(&|column| column.unit.clone());
    }
    line(&|column| "-".repeat(column.width));
    (0..rows).for_each(|row| line(&|column| column.cells.get(row).cloned().unwrap_or_default()));
    text
}

/// Rows of words in aligned columns below their heads and a line; columns of numbers are flush right.
pub fn columns(head: &[&str], rows: &[Vec<String>], ascii: bool) -> String {
    let fold = |text: &str| if ascii { to_ascii(text).into_owned() } else { text.to_owned() };
    let column = |(number, head): (usize, &&str)| {
        let cells: Vec<_> =
            rows.iter().map(|row| row.get(number).map_or_else(String::new, |cell| fold(cell))).collect();
        let head = fold(head);
        let right = cells.iter().all(|cell| cell.is_empty() || cell == "-" || cell.parse::<f64>().is_ok());
        let width = cells.iter().chain([&head]).map(|text| text.width()).max().unwrap_or(0);
        Ready { head, unit: String::new(), cells, width, right }
    };
    let all: Vec<_> = head.iter().enumerate().map(column).collect();
    grid(&all.iter().collect::<Vec<_>>(), rows.len())
}

/// Broken into lines of the report's width; all but the first are indented by `indent` columns.
pub fn wrapped(words: &str, indent: usize, ascii: bool) -> String {
    wrap(&if ascii { to_ascii(words) } else { Cow::Borrowed(words) }, 0, indent)
}

/// Words broken into lines; the first is indented by `first` columns, those after it by `rest`.
pub(super) fn wrap(words: &str, first: usize, rest: usize) -> String {
    // A space that does not break keeps the digits of a number together.
    let words: Vec<_> = words.split_ascii_whitespace().collect();
    let indents = [first, rest].map(|columns| " ".repeat(columns));
    let options = Options::new(WIDTH).initial_indent(&indents[0]).subsequent_indent(&indents[1]);
    let whole = options.break_words(false).word_separator(AsciiSpace).word_splitter(NoHyphenation);
    textwrap::fill(&words.join(" "), whole) + "\n"
}
