//! A text that is typed, and what is searched by it: the help, and a list to choose from (scenes, quantities, motors). What is typed narrows the
//! list, letters in order and not necessarily side by side.

use std::cmp::Reverse;
use std::ops::Deref;

use assur_words::Text;
use crossterm::event::KeyCode;

use super::keymap::Key;
use super::kinds::round;
use super::subsequence::score;

/// Greatest length of a typed text, in bytes: a path or a formula is not longer, and a search for it takes no time that
/// is felt.
pub(crate) const LONGEST: usize = 1024;

/// A text that is typed or pasted, of at most [`LONGEST`] bytes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Entry {
    text: String,
    /// Whether something was left out since the last letter was removed.
    pub(crate) cut: bool,
}

impl Entry {
    /// Takes a key that writes or deletes; returns whether the text may have changed.
    pub(crate) fn press(&mut self, key: Key) -> bool {
        match key.code {
            KeyCode::Backspace => {
                self.cut = false;
                return self.text.pop().is_some();
            }
            KeyCode::Char('u') if key.control => *self = Self::default(),
            KeyCode::Char(letter) if !key.control => self.push_str(letter.encode_utf8(&mut [0; 4])),
            _ => return false,
        }
        true
    }

    pub(crate) fn push_str(&mut self, text: &str) {
        let room = LONGEST - self.text.len();
        let taken = text.floor_char_boundary(room);
        self.text.push_str(&text[..taken]);
        self.cut |= taken < text.len();
    }
}

impl From<&str> for Entry {
    fn from(text: &str) -> Self {
        let mut entry = Self::default();
        entry.push_str(text);
        entry
    }
}

impl Deref for Entry {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

/// A text that is typed to search a list. Before the first letter, keys keep their meaning; `/` begins a search with any
/// letter.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Filter {
    pub(crate) text: Entry,
    pub(crate) typing: bool,
}

impl Filter {
    /// Takes a key; returns whether the text has changed.
    pub(crate) fn press(&mut self, key: Key) -> bool {
        let begins = !self.typing && matches!(key.code, KeyCode::Char(_)) && !key.control;
        self.typing |= begins;
        !(begins && key.code == KeyCode::Char('/')) && self.text.press(key)
    }
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Help {
    pub(crate) scroll: usize,
    pub(crate) filter: Filter,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PickerKind {
    Scenes,
    Quantities,
    Motors,
    /// What a new mechanism begins with.
    Starts,
    /// Groups that can be added.
    Additions,
    /// Tables of the scene.
    Tables,
    /// What can be the input.
    Drives,
    /// What a field may be.
    Choices,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Choice {
    /// What is taken: the name of a scene, the short name of a quantity, the designation of a motor.
    pub(crate) name: String,
    /// What is shown and searched.
    pub(crate) text: String,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Picker {
    pub(crate) kind: PickerKind,
    pub(crate) heading: Text,
    pub(crate) filter: Filter,
    /// Number of the chosen row among those that are left.
    pub(crate) chosen: usize,
    pub(crate) rows: Vec<Choice>,
    /// Names that are taken together, in the order of their marking.
    pub(crate) marked: Vec<String>,
}

impl Picker {
    pub(crate) fn new(kind: PickerKind, heading: Text, rows: Vec<Choice>) -> Self {
        Self { kind, heading, filter: Filter::default(), chosen: 0, rows, marked: Vec::new() }
    }

    /// The rows that the typed text leaves, the best match first: those that have most of the typed words as a whole.
    pub(crate) fn left(&self) -> Vec<&Choice> {
        if self.filter.text.trim().is_empty() {
            return self.rows.iter().collect();
        }
        let typed = self.filter.text.split_whitespace();
        let (numbers, words): (Vec<&str>, Vec<&str>) = typed.partition(|word| is_number(word));
        // Digits that stand apart are no number: 1500 is a field of its own.
        let has_numbers = |choice: &&Choice| {
            let fields: Vec<&str> = choice.text.split([' ', '/']).collect();
            numbers.iter().all(|number| fields.iter().any(|field| same_number(field, number)))
        };
        let is_word = |typed: &str, text: &str| {
            text.split(|letter: char| !letter.is_alphanumeric()).any(|word| word.eq_ignore_ascii_case(typed))
        };
        let whole = |choice: &&Choice| {
            self.filter.text.split_whitespace().filter(|typed| is_word(typed, &choice.text)).count()
        };
        // A row whose own name begins with what is typed comes before all whose texts contain it.
        let wanted = self.filter.text.trim().to_lowercase();
        let begins = |choice: &&Choice| {
            let mut words = choice.name.split(|letter: char| !letter.is_alphanumeric());
            words.find(|word| !word.is_empty()).is_some_and(|word| word.to_lowercase().starts_with(&wanted))
        };
        let rated =
            |choice| Some((Reverse((begins(&choice), whole(&choice), score(&words, &choice.text)?)), choice));
        let mut found: Vec<_> = self.rows.iter().filter(has_numbers).filter_map(rated).collect();
        found.sort_by_key(|(rate, _)| *rate);
        found.into_iter().map(|(_, choice)| choice).collect()
    }

    pub(crate) fn choice(&self) -> Option<&Choice> {
        self.left().get(self.chosen).copied()
    }

    pub(crate) fn step(&mut self, by: isize) {
        self.chosen = round(self.chosen, by, self.left().len());
    }

    pub(crate) fn mark(&mut self) {
        let Some(name) = self.choice().map(|choice| choice.name.clone()) else { return };
        match self.marked.iter().position(|marked| *marked == name) {
            Some(at) => drop(self.marked.remove(at)),
            None => self.marked.push(name),
        }
    }

    /// The names that are taken: those that are marked, or else the chosen one.
    pub(crate) fn taken(&self) -> Vec<String> {
        if self.marked.is_empty() {
            self.choice().map(|choice| choice.name.clone()).into_iter().collect()
        } else {
            self.marked.clone()
        }
    }
}

/// Whether a typed word is a number, with a point or a comma.
fn is_number(word: &str) -> bool {
    word.starts_with(|letter: char| letter.is_ascii_digit())
        && word.chars().all(|letter| letter.is_ascii_digit() || ".,".contains(letter))
}

/// Whether a field is the number that is typed, however many zeros follow.
fn same_number(field: &str, typed: &str) -> bool {
    let value = |text: &str| text.replace(',', ".").parse::<f64>().ok();
    value(field).zip(value(typed)).is_some_and(|(field, typed)| field.total_cmp(&typed).is_eq())
}

/// What the one-line input is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PromptKind {
    Command,
    Search,
}

/// The one-line input for `:` and `/` while it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Prompt {
    pub(crate) kind: PromptKind,
    pub(crate) text: Entry,
    /// Number of the completion inserted by Tab, and the text that was typed before.
    pub(crate) completing: Option<(usize, String)>,
}
