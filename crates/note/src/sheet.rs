//! What a form writes: texts and tables in the words of the language.

use assur_book::{Block, Printed, Table};
use assur_figure::svg::lowered;
use assur_scene::Note;
use assur_words::{Language, Text, joined, name, number, text, unit};

pub(super) struct NoteSheet<'a> {
    pub(super) title: &'a str,
    /// What the author says of himself, each behind its name.
    pub(super) author: Vec<(Text, String)>,
    pub(super) blocks: Vec<Block>,
    pub(super) language: &'a Language,
}

pub(super) struct Grid {
    pub(super) head: Vec<String>,
    /// Which columns stand at the right.
    pub(super) right: Vec<bool>,
    pub(super) rows: Vec<Vec<String>>,
}

pub(super) fn author(note: &Note) -> Vec<(Text, String)> {
    let rows = [
        (text!("note-author"), &note.author),
        (text!("note-group"), &note.group),
        (text!("note-variant"), &note.variant),
    ];
    rows.into_iter().filter_map(|(what, who)| Some((what, who.clone()?))).collect()
}

impl NoteSheet<'_> {
    pub(super) fn line(&self, text: &Text) -> String {
        // Signs of print, in every language; names need no quotes on paper.
        text.render(self.language).replace("->", "→").replace('`', "")
    }

    /// Gives headings, figures and tables their numbers.
    pub(super) fn number(&mut self) {
        let language = self.language;
        let [mut parts, mut figures, mut tables] = [0_usize; 3];
        let numbered = |id: &'static str, count: &mut usize, caption: &mut Text| {
            *count += 1;
            let whole = Text::message(id, vec![("number", number(*count)), ("caption", caption.clone())]);
            let bare = |whole: String| whole.trim_end_matches(['.', ' ']).to_owned();
            *caption = if caption.is_empty() { name(bare(whole.render(language))) } else { whole };
        };
        for block in &mut self.blocks {
            match block {
                Block::Heading(title) => {
                    parts += 1;
                    *title = joined(". ", [number(parts), title.clone()]);
                }
                Block::Figure { caption, .. } => numbered("note-figure", &mut figures, caption),
                Block::Table(Table { caption, .. }) | Block::Facts { caption, .. } => {
                    numbered("note-table", &mut tables, caption);
                }
                _ => {}
            }
        }
    }

    pub(super) fn grid(&self, table: &Table) -> Grid {
        let (keys, groups) = table.printed();
        let columns: Vec<Printed> = keys.into_iter().chain(groups.into_iter().flatten()).collect();
        let head = |column: &Printed| {
            let parts = [column.head.clone(), unit(column.unit)];
            self.line(&assur_words::list(parts.into_iter().filter(|part| !part.is_empty())))
        };
        let cell = |column: &Printed, row: usize| {
            column
                .cells
                .get(row)
                .map(|cell| self.line(cell))
                .map(|cell| if cell == "-" { "–".into() } else { cell })
        };
        let row = |row: usize| columns.iter().map(|column| cell(column, row).unwrap_or_default()).collect();
        Grid {
            head: columns.iter().map(head).collect(),
            right: columns.iter().map(|column| column.of_numbers).collect(),
            rows: (0..table.height()).map(row).collect(),
        }
    }
}

/// A text with its subscripts in a form: what writes a text in which nothing is markup, and what writes a subscript.
pub(super) fn rich(text: &str, plain: impl Fn(&str) -> String, low: impl Fn(&str) -> String) -> String {
    let part = |(part, below): (&str, &str)| {
        plain(part) + &if below.is_empty() { String::new() } else { low(below) }
    };
    lowered(text).map(part).collect()
}
