//! A key of a table of a scene.

use assur_words::{Describe, Language, Text, text};

use super::bound::Bound;
use super::kind::{ValueKind, either};
use crate::units::Dimension;

/// A key of a table.
#[derive(Debug)]
pub struct SceneKey {
    /// How it is written; a name in capitals stands for one that the user chooses.
    pub name: &'static str,
    /// What its value may be, one of these.
    pub kinds: Vec<ValueKind>,
    /// The limits of its number.
    pub limits: Bound,
    /// What holds without it.
    pub default: KeyDefault,
    /// A value as it is written.
    pub example: &'static str,
    /// The identity of a sentence that says what it is.
    pub about: &'static str,
    /// Words by which people look for it, or which they write in its place, with commas between them.
    pub(super) also: &'static str,
    /// The sorts of its table that have it, with commas between them: of a motion its kind; empty: all.
    pub sorts: &'static str,
}

/// What holds where a key is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KeyDefault {
    /// The table is refused without the key.
    Needed,
    /// The thing is absent, or as the sentence on the key says.
    Absent,
    /// This value.
    Is(&'static str),
}

/// What stands in a column, `-` for nothing.
pub(super) fn of(column: &'static str) -> &'static str {
    if column == "-" { "" } else { column }
}

impl SceneKey {
    /// Reads a line of the reference.
    pub(super) fn read(line: &'static str) -> Option<Self> {
        let columns: Vec<_> = line.split(" | ").map(of).collect();
        let [name, kinds, limits, default, sorts, example, about, also] = columns[..] else { return None };
        let kinds = kinds.split("; ").map(ValueKind::read).collect::<Option<_>>()?;
        let limits = Bound::read(limits)?;
        let default = match default {
            "" => KeyDefault::Absent,
            "needed" => KeyDefault::Needed,
            value => KeyDefault::Is(value),
        };
        Some(Self { name, kinds, limits, default, example, about, also, sorts })
    }

    /// The quantity that it may be; `coordinate`: what the input coordinate is, `None` where that is not known.
    pub fn dimension(&self, coordinate: Option<Dimension>) -> Option<Dimension> {
        self.kinds.iter().find_map(|kind| match *kind {
            ValueKind::Quantity(dimension) => Some(dimension),
            ValueKind::ByInput(turning, sliding) => {
                coordinate.map(|coordinate| if coordinate == Dimension::Angle { turning } else { sliding })
            }
            _ => None,
        })
    }

    /// The words that it may be.
    pub fn words(&self) -> impl Iterator<Item = &'static str> {
        self.kinds.iter().filter_map(|kind| if let ValueKind::Word(word) = kind { Some(*word) } else { None })
    }

    /// Whether a table of this sort has it; without a sort every table has.
    pub fn is_of(&self, sort: Option<&str>) -> bool {
        self.sorts.is_empty() || sort.is_none_or(|sort| self.sorts.split(", ").any(|own| own == sort))
    }

    /// What its value may be, in words.
    pub fn values(&self) -> Text {
        either(self.kinds.iter().map(Describe::describe).collect())
    }

    /// The limits of its number, in words; empty where it has none.
    pub fn limits(&self) -> Text {
        self.limits.describe()
    }

    /// Whether its names, its words or the sentence on it have these letters, which are in lower case; `begin`: at the beginning of
    /// a word.
    pub(super) fn speaks_of(&self, letters: &str, begin: bool, language: &Language) -> bool {
        let names = self.also.split(", ").chain([self.name]);
        names.chain(self.words()).any(|own| has(&own.to_lowercase(), letters, begin))
            || has(&text!(self.about).render(language).to_lowercase(), letters, begin)
    }
}

/// Whether a text has these letters; `begin`: at the beginning of a word.
fn has(text: &str, letters: &str, begin: bool) -> bool {
    let begins = |at: usize| !text[..at].chars().next_back().is_some_and(char::is_alphanumeric);
    text.match_indices(letters).any(|(at, _)| !begin || begins(at))
}
