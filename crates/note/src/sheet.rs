//! What a form writes: texts and tables in the words of the language.

use assur_book::{Block, Printed, Table, Value};
use assur_figure::letters::{Level, indexed, levels};
use assur_words::{Language, Text, joined, number, unit};
use assur_worksheet::Symbol;

use crate::cover::Cover;

pub(super) struct NoteSheet<'a> {
    pub(super) cover: Cover,
    pub(super) blocks: Vec<Block>,
    pub(super) language: &'a Language,
    /// The same with the numbers of links, for subscripts.
    pub(super) numbered: Language,
    /// Significant digits of its numbers.
    pub(super) digits: usize,
}

pub(super) struct Grid {
    pub(super) head: Vec<String>,
    /// Which columns stand at the right.
    pub(super) right: Vec<bool>,
    pub(super) rows: Vec<Vec<String>>,
}

impl NoteSheet<'_> {
    pub(super) fn line(&self, text: &Text) -> String {
        indexed(&self.plain(text))
    }

    /// A text as it stands in an equation, whose symbols have their subscripts apart.
    pub(super) fn plain(&self, text: &Text) -> String {
        // Signs of print, in every language; names need no quotes on paper.
        text.typeset(self.language).replace("->", "→").replace('`', "")
    }

    /// The subscripts of a symbol, in which links have their numbers.
    pub(super) fn below(&self, symbol: &Symbol) -> String {
        symbol.subscript().typeset(&self.numbered).replace('`', "")
    }

    /// Gives the links of structural formulas their numbers, as the drawings have them.
    pub(super) fn formulas(&mut self) {
        let in_numbers =
            |text: &Text, numbered: &Language| assur_words::name(text.typeset(numbered).replace('`', ""));
        for block in &mut self.blocks {
            match block {
                Block::Paragraph(words) if words.identity() == Some("report-formula") => {
                    *words = in_numbers(words, &self.numbered);
                }
                Block::Paragraph(words) if words.identity() == Some("note-concluded-structure") => {
                    *words = in_numbers(words, &self.numbered);
                }
                Block::Facts { facts, .. } => {
                    for fact in facts.iter_mut().filter(|fact| fact.id == "fact-formula") {
                        if let Value::Text(words) = &mut fact.value {
                            *words = in_numbers(words, &self.numbered);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// Gives headings, figures and tables their numbers.
    pub(super) fn number(&mut self) {
        let [mut parts, mut figures, mut tables] = [0_usize; 3];
        let mut chapter = Text::default();
        let numbered = |id: &'static str, count: &mut usize, caption: &mut Text, chapter: &Text| {
            *count += 1;
            // What has no name of its own is all that the chapter has.
            let own = if caption.is_empty() { chapter.clone() } else { caption.clone() };
            *caption = Text::message(id, vec![("number", number(*count)), ("caption", own)]);
        };
        for block in &mut self.blocks {
            match block {
                Block::Heading(title) => {
                    parts += 1;
                    chapter = title.clone();
                    *title = joined(". ", [number(parts), title.clone()]);
                }
                Block::Figure { caption, .. } => numbered("note-figure", &mut figures, caption, &chapter),
                Block::Table(Table { caption, .. }) | Block::Facts { caption, .. } => {
                    numbered("note-table", &mut tables, caption, &chapter);
                }
                _ => {}
            }
        }
    }

    /// A text as paragraphs, each with a stop at its end: an empty line divides them.
    pub(super) fn paragraphs(&self, text: &Text) -> Vec<String> {
        let stopped = |part: &str| {
            let stop =
                if part.is_empty() || part.ends_with(['.', ':', ';', ',', '!', '?']) { "" } else { "." };
            part.to_owned() + stop
        };
        self.line(text).split("\n\n").map(|part| stopped(part.trim())).collect()
    }

    /// The headings of the chapters, each with its number from 1.
    pub(super) fn chapters(&self) -> impl Iterator<Item = (usize, &Text)> {
        fn heading(block: &Block) -> Option<&Text> {
            if let Block::Heading(title) = block { Some(title) } else { None }
        }
        self.blocks.iter().filter_map(heading).enumerate().map(|(index, title)| (index + 1, title))
    }

    pub(super) fn grid(&self, table: &Table) -> Grid {
        let (keys, groups) = table.printed_with(self.digits);
        let columns: Vec<Printed> = keys.into_iter().chain(groups.into_iter().flatten()).collect();
        let head = |column: &Printed| {
            let words = [self.line(&column.head), self.line(&unit(column.unit))];
            let [symbol, unit] = words;
            let parts = [with_subscript(symbol), unit];
            parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
        };
        let cell = |column: &Printed, row: usize| {
            column
                .cells
                .get(row)
                .map(|cell| self.line(cell))
                .map(|cell| if cell == "-" || cell.is_empty() { "–".into() } else { cell })
        };
        let row = |row: usize| columns.iter().map(|column| cell(column, row).unwrap_or_default()).collect();
        Grid {
            head: columns.iter().map(head).collect(),
            right: columns.iter().map(|column| column.of_numbers).collect(),
            rows: (0..table.height()).map(row).collect(),
        }
    }
}

/// The symbol of a component, `vx`, or of what friction does, `Mf`, with its second letter as a subscript.
fn with_subscript(head: String) -> String {
    match *head.as_bytes() {
        [letter @ (b'v' | b'a' | b'F' | b'R'), axis @ (b'x' | b'y')]
        | [letter @ (b'F' | b'M' | b'P'), axis @ b'f'] => {
            format!("{}_{{{}}}", char::from(letter), char::from(axis))
        }
        _ => head,
    }
}

/// A text with its subscripts and superscripts in a form: what writes a text in which nothing is markup, and what writes one of these,
/// `sub` or `sup`.
pub(super) fn rich(
    text: &str,
    plain: impl Fn(&str) -> String,
    small: impl Fn(&'static str, &str) -> String,
) -> String {
    let part = |(part, level): (&str, Level)| match level {
        Level::Line => plain(part),
        Level::Below => small("sub", part),
        Level::Above => small("sup", part),
    };
    levels(text).map(part).collect()
}
