//! Why a scene can't be read or calculated.

use std::fmt;

use assur_mechanism::Key;
use assur_scene::SceneErrors;
use assur_words::{Describe, Text};

/// What is wrong, in English, with its place in the scene where it has one.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Error {
    /// What is wrong, where, and what to do: as the program prints it, of several faults all.
    pub message: String,
    /// The file, by the name that it was given.
    pub file: Option<String>,
    /// Line of the first fault, from 1.
    pub line: Option<usize>,
    /// Its column in characters, from 1.
    pub column: Option<usize>,
    /// The key of the scene at that place, such as `link.crank.mass`.
    pub key: Option<String>,
}

impl Error {
    pub(crate) fn told(message: Text) -> Self {
        Self { message: assur_words::Told(message).to_string(), ..Self::default() }
    }

    /// What is wrong with a call itself.
    pub(crate) fn call(message: &str) -> Self {
        Self { message: message.to_owned(), ..Self::default() }
    }

    /// Nothing has the name that was asked for; `known` are the names that there are.
    pub(crate) fn unknown<'k>(what: &str, wanted: &str, known: impl IntoIterator<Item = &'k str>) -> Self {
        let offer = assur_scene::nearest(wanted, known);
        let offer = offer.map(|known| format!("; did you mean `{known}`?")).unwrap_or_default();
        Self { message: format!("there is no {what} `{wanted}`{offer}"), ..Self::default() }
    }

    /// An error of a calculation, at its key of the scene if it has one.
    pub(crate) fn at(file: &str, text: &str, key: Option<Key>, message: Text) -> Self {
        let placed = key.as_ref().and_then(|key| assur_scene::fault_at(file, text, key, message.clone()));
        if let Some(errors) = placed {
            return Self::of_scene(&errors, text);
        }
        let key = key.map(|key| key.to_string());
        Self { file: Some(file.to_owned()), key, ..Self::told(message) }
    }

    pub(crate) fn of_scene(errors: &SceneErrors, text: &str) -> Self {
        let first = errors.errors.first();
        let key = first.and_then(|first| assur_draft::key_at(text, first.span.start));
        Self {
            file: Some(errors.file.clone()),
            line: first.map(|first| first.line),
            column: first.map(|first| first.column),
            key: key.map(|key| key.to_string()),
            ..Self::told(errors.describe())
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.message)
    }
}

impl std::error::Error for Error {}
