//! A text that is typed.

use std::fmt;
use std::ops::Deref;

use crossterm::event::KeyCode;

use super::keymap::Key;

/// Greatest length of a typed text, in bytes: a path or a formula is not longer, and a search for it takes no time that
/// is felt.
pub(crate) const LONGEST: usize = 1024;

/// A text that is typed or pasted, of at most [`LONGEST`] bytes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Entry {
    text: String,
    /// Whether something was left out.
    cut: bool,
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

    /// Adds as many letters as there is room for.
    pub(crate) fn push_str(&mut self, text: &str) {
        let room = LONGEST - self.text.len();
        let taken = text.floor_char_boundary(room);
        self.text.push_str(&text[..taken]);
        self.cut |= taken < text.len();
    }

    /// Whether something was left out since the last letter was removed.
    pub(crate) fn is_cut(&self) -> bool {
        self.cut
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

impl fmt::Display for Entry {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.text)
    }
}
