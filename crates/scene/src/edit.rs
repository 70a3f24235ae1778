//! The numbers of a scene's text: found by key, listed, and replaced with nothing else touched, so that comments, order
//! and spelling of the rest stay to the byte.

mod find;
mod key;
mod number;
#[cfg(test)]
mod tests;
mod values;

use std::ops::Range;

use toml::de::DeTable;

pub use key::Key;
pub use number::{decimal, quoted, split};
pub use values::{SceneValue, bare};

/// Where a number or a text stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Bytes of the file, quotes included.
    pub span: Range<usize>,
    /// The text of a string; `None` for a bare number.
    pub text: Option<String>,
}

/// The text of a scene, taken apart but not judged.
#[derive(Debug)]
pub struct Document<'a> {
    text: &'a str,
    table: toml::Spanned<DeTable<'a>>,
}

impl<'a> Document<'a> {
    /// Takes a text apart; what is no TOML is left out.
    pub fn of(text: &'a str) -> Self {
        Self { text, table: DeTable::parse_recoverable(text).0 }
    }

    /// The place of a key.
    ///
    /// # Errors
    ///
    /// What is wrong with the key, and what there is instead.
    pub fn find(&self, key: &Key) -> Result<Place, String> {
        find::find(self.table.get_ref(), &key.0)
    }

    /// Every number with or without a unit, in the order of the file.
    pub fn values(&self) -> Vec<SceneValue> {
        values::of(self.text, self.table.get_ref())
    }
}

/// The text of a scene with other TOML in some places, which don't overlap.
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
