//! Which characters are printed.

use std::borrow::Cow;
use std::io::Write;

use assur_report::to_ascii;

use crate::locale::is_utf8;

/// Which characters are printed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    /// In text: nothing beyond ASCII.
    pub(crate) ascii: bool,
    /// The same in forms for programs, whose encoding is UTF-8 whatever the locale.
    pub(crate) ascii_data: bool,
}

impl Style {
    /// ASCII if asked for; text also where the locale is not UTF-8.
    pub(crate) fn of(ascii: bool) -> Self {
        Self { ascii: ascii || !is_utf8(|name| std::env::var(name).ok()), ascii_data: ascii }
    }

    /// Text as it may be printed.
    pub(crate) fn text(self, text: &str) -> Cow<'_, str> {
        if self.ascii { to_ascii(text) } else { Cow::Borrowed(text) }
    }

    /// Writes to standard error; nothing can be done where that fails.
    pub(crate) fn tell(self, message: &str) {
        let message = self.text(message.trim_end());
        let _ = writeln!(std::io::stderr().lock(), "{message}");
    }
}
