//! Which characters are printed.

use std::borrow::Cow;
use std::io::Write;

use assur_words::to_ascii;
use assur_words::{Language, Text};

use crate::locale::is_utf8;

/// A text with its control, bidirectional and invisible characters escaped: the name of a file or a method can't move
/// the cursor or hide the text after it.
pub(crate) fn escaped(text: &str) -> Cow<'_, str> {
    let hides = |c: char| {
        c.is_control() && !matches!(c, '\n' | '\t')
            || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
    };
    if !text.contains(hides) {
        return Cow::Borrowed(text);
    }
    let escape = |c: char| if hides(c) { c.escape_unicode().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(escape).collect())
}

/// How a command speaks, and what it takes for an error.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    /// In text: no character beyond ASCII.
    pub(crate) ascii: bool,
    /// ASCII only in formats for programs, whose encoding is UTF-8 whatever the locale.
    pub(crate) ascii_data: bool,
    pub(crate) language: &'static Language,
    /// Whether what is probably not meant in a scene is an error.
    pub(crate) strict: bool,
}

impl Style {
    /// ASCII on request; text also if the locale is not UTF-8. The language is the first of those that are asked for which is
    /// known; in ASCII it is English.
    pub(crate) fn of<'a>(ascii_data: bool, asked: impl IntoIterator<Item = &'a str>) -> Self {
        let ascii = ascii_data || !is_utf8(|name| std::env::var(name).ok());
        let language = asked.into_iter().find_map(Language::find).filter(|_| !ascii);
        Self { ascii, ascii_data, language: language.unwrap_or_else(Language::english), strict: false }
    }

    pub(crate) fn words(self) -> assur_report::text::Style {
        assur_report::text::Style { ascii: self.ascii, language: self.language }
    }

    pub(crate) fn text(self, text: &str) -> Cow<'_, str> {
        if self.ascii { to_ascii(text) } else { Cow::Borrowed(text) }
    }

    /// Writes to standard error; errors are ignored.
    pub(crate) fn tell(self, message: impl Into<Text>) {
        let message = message.into().render(self.language);
        let message = escaped(message.trim_end());
        let message = self.text(&message);
        let _ = writeln!(std::io::stderr().lock(), "{message}");
    }
}
