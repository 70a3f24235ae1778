//! The keys that a table of the file may have, and what is meant by one that it does not have.

use assur_words::{Text, name, text};

use crate::reference::{self, KeyTable};
use crate::text::{did_you_mean, nearest};

/// The keys that a table may have.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Known {
    /// Those of a file that is no scene.
    Names(&'static [&'static str]),
    /// Those of a table of the reference, of one of its sorts where the second is given.
    Table(&'static KeyTable, Option<&'static str>),
}

impl Known {
    pub(crate) fn names(self) -> Vec<&'static str> {
        match self {
            Self::Names(names) => names.to_vec(),
            Self::Table(table, sort) => table.names(sort).collect(),
        }
    }

    /// What is meant by a key that the table does not have: the known one, or the tables that have it.
    pub(crate) fn meant(self, word: &str, known: &[&'static str]) -> Text {
        let Self::Table(table, _) = self else {
            return did_you_mean(word, nearest(word, known.iter().copied()));
        };
        if let Some(sorts) = table.sorts(word) {
            return text!("scene-key-of-sorts", sorts = name(sorts));
        }
        let (also, elsewhere) = (table.meant(word).filter(|key| known.contains(key)), table.holders(word));
        match also.or_else(|| nearest(word, known.iter().copied())) {
            None if !elsewhere.is_empty() => {
                text!("scene-key-elsewhere", tables = name(elsewhere.join(", ")))
            }
            None if reference::table("").key(word).is_some() => text!("scene-key-at-top"),
            near => did_you_mean(word, near),
        }
    }
}
