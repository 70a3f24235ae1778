//! The text of the rows of a table: what stands between the numbers is made once.

use assur_analysis::results::{Section, Table};

/// Text with numbers of a row in it.
#[derive(Debug, Default)]
pub(crate) struct Template {
    /// The text before each number, and the column of the number.
    pub(crate) pieces: Vec<(String, usize)>,
    /// The text after the last number.
    pub(crate) end: String,
}

impl Template {
    /// Writes a row; `write` writes a number.
    pub(crate) fn write(&self, table: &Table, row: usize, out: &mut Vec<u8>, write: fn(f64, &mut Vec<u8>)) {
        for (text, column) in &self.pieces {
            match text.as_bytes() {
                // A comma, in most places.
                [byte] => out.push(*byte),
                text => out.extend_from_slice(text),
            }
            write(table.values(*column)[row], out);
        }
        out.extend_from_slice(self.end.as_bytes());
    }
}

/// The templates of the rows that have numbers in the same sections.
#[derive(Debug, Default)]
pub(crate) struct Templates {
    sections: Vec<Section>,
    known: Vec<(Vec<bool>, Template)>,
}

impl Templates {
    /// For the sections of these columns.
    pub(crate) fn new(table: &Table, columns: impl Iterator<Item = usize>) -> Self {
        let mut sections: Vec<Section> = columns.map(|column| table.schema().section_of(column)).collect();
        sections.sort_unstable();
        sections.dedup();
        Self { sections, known: Vec::new() }
    }

    /// The template of a row; `make` makes it from the columns in which the row has numbers.
    pub(crate) fn of(
        &mut self,
        table: &Table,
        row: usize,
        make: impl Fn(&dyn Fn(usize) -> bool) -> Template,
    ) -> &Template {
        let here = || self.sections.iter().map(|section| table.present(*section)[row]);
        let at = self.known.iter().position(|(mask, _)| mask.iter().copied().eq(here()));
        let at = at.unwrap_or_else(|| {
            let has = |column: usize| table.present(table.schema().section_of(column))[row];
            self.known.push((here().collect(), make(&has)));
            self.known.len() - 1
        });
        &self.known[at].1
    }
}
