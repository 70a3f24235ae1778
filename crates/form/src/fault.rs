//! The faults that the reader finds in a text, at their keys.

use assur_mechanism::{Key, Step};
use assur_words::Text;

use crate::tables::{Tables, last, owner};

/// A fault of a scene, at its key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The key whose value is wrong, elements of lists by number; where a key is missing, the table that needs it. `None` where
    /// nothing stands at the place, as in a text that is no TOML.
    pub key: Option<Key>,
    /// Line in the file, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: Text,
    /// A correction; may be empty.
    pub label: Text,
}

/// All faults that the reader finds in a scene, in the order of the file; none where it reads.
pub fn faults(text: &str) -> Vec<Fault> {
    let Err(errors) = assur_scene::read("", text) else { return Vec::new() };
    let tables = Tables::of(text);
    let fault = |error: assur_scene::SceneError| Fault {
        key: tables.key_at(error.span.start),
        line: error.line,
        message: error.message,
        label: error.label,
    };
    errors.errors.into_iter().map(fault).collect()
}

impl Fault {
    /// A fault of a key that is not that of a reader.
    pub(crate) fn of(key: &Key, message: Text) -> Self {
        Self { key: Some(key.clone()), line: 0, message, label: Text::default() }
    }

    /// The key that is missing in a table, if that is the fault.
    pub(crate) fn missing(&self) -> Option<Key> {
        let is_missing = self.message.identity() == Some("scene-needs-key");
        let name = self.message.names().last().filter(|_| is_missing).map(|name| (*name).to_owned())?;
        Some(self.key.clone()?.at(name.as_str()))
    }

    /// Whether it concerns a key: lies in its value or in its list, or names it as what its table lacks.
    pub(crate) fn concerns(&self, key: &Key) -> bool {
        let Some(own) = &self.key else { return false };
        let list =
            if matches!(key.steps().last(), Some(Step::Index(_))) { key.of_list() } else { key.clone() };
        let of_table =
            own == &owner(key) && self.message.names().contains(&last(key)) && !last(key).is_empty();
        own.steps().starts_with(list.steps()) || of_table
    }
}

/// The faults of a text that another one does not have.
pub(crate) fn new(text: &str, before: &[Fault]) -> Vec<Fault> {
    let same = |one: &Fault, other: &Fault| one.key == other.key && one.message == other.message;
    let mut known: Vec<_> = before.iter().collect();
    let mut all = faults(text);
    all.retain(|fault| match known.iter().position(|own| same(own, fault)) {
        Some(at) => {
            known.remove(at);
            false
        }
        None => true,
    });
    all
}
