//! Finds, lists and replaces the numbers in a scene's text. Comments, order and spelling of everything else are
//! preserved byte by byte.

mod find;
#[cfg(test)]
mod tests;
mod values;

use std::ops::Range;

use assur_mechanism::Key;
use assur_words::Text;
use toml::de::DeTable;

use crate::scan::excess;

pub(crate) use find::{place, within};
pub use values::{SceneValue, bare};
pub use values::{decimal, quoted, split};

/// Place of a number or a text in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextPlace {
    /// Bytes of the file that it takes, quotes included.
    pub span: Range<usize>,
    /// The text of a string; `None` for a bare number.
    pub text: Option<String>,
}

/// The parsed text of a scene, which may have faults.
#[derive(Debug)]
pub struct ParsedText<'a> {
    text: &'a str,
    table: toml::Spanned<DeTable<'a>>,
}

impl<'a> ParsedText<'a> {
    /// Parses a text; parts that are not TOML are left out, and all of a text that makes too many tables.
    pub fn of(text: &'a str) -> Self {
        let few = if excess(text).is_some() { "" } else { text };
        Self { text, table: DeTable::parse_recoverable(few).0 }
    }

    /// Finds the places of a key: one, or where it names several elements of a list all of them.
    ///
    /// # Errors
    ///
    /// A message about the key, with the keys that exist instead.
    pub fn find(&self, key: &Key) -> Result<Vec<TextPlace>, Text> {
        find::find(self.table.get_ref(), key.steps())
    }

    /// The bytes of the file at which a key stands; where the scene leaves it out, of the table that would have it. `None` if there
    /// is none either.
    pub(crate) fn place(&self, key: &Key) -> Option<Range<usize>> {
        find::place(self.table.get_ref(), key.steps())
    }

    /// Every number with or without a unit, and the choice of the motor, in the order of the file; of a scene with faults none.
    pub fn values(&self) -> Vec<SceneValue> {
        values::of(self)
    }
}

/// Returns the text of a scene with new TOML in some places, which must not overlap.
pub fn replaced<'v>(scene: &str, values: impl IntoIterator<Item = (&'v Range<usize>, &'v str)>) -> String {
    let mut values: Vec<_> = values.into_iter().collect();
    values.sort_by_key(|(span, _)| span.start);
    let mut text = String::with_capacity(scene.len() + 32 * values.len());
    let mut done = 0;
    for (span, value) in values {
        text += scene.get(done..span.start).unwrap_or_default();
        text += value;
        done = span.end;
    }
    text + scene.get(done..).unwrap_or_default()
}
