//! Keys and their names, used in the table of commands, on the screen and in the configuration.

#[cfg(test)]
mod tests;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// A key with its modifiers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Key {
    pub(crate) code: KeyCode,
    pub(crate) control: bool,
}

impl From<KeyEvent> for Key {
    fn from(event: KeyEvent) -> Self {
        Self { code: event.code, control: event.modifiers.contains(KeyModifiers::CONTROL) }
    }
}

const NAMES: &[(KeyCode, &str)] = &[
    (KeyCode::Left, "Left"),
    (KeyCode::Right, "Right"),
    (KeyCode::Up, "Up"),
    (KeyCode::Down, "Down"),
    (KeyCode::Home, "Home"),
    (KeyCode::End, "End"),
    (KeyCode::PageUp, "PgUp"),
    (KeyCode::PageDown, "PgDn"),
    (KeyCode::Enter, "Enter"),
    (KeyCode::Esc, "Esc"),
    (KeyCode::Tab, "Tab"),
    (KeyCode::BackTab, "S-Tab"),
    (KeyCode::Backspace, "Backspace"),
    (KeyCode::Delete, "Del"),
    (KeyCode::Insert, "Ins"),
    (KeyCode::Char(' '), "Space"),
];

impl Key {
    /// Its name: `Right`, `q`, `C-l`.
    pub(crate) fn name(self) -> String {
        let name = NAMES.iter().find(|(code, _)| *code == self.code).map(|(_, name)| (*name).to_owned());
        let name = name.unwrap_or_else(|| match self.code {
            KeyCode::Char(c) => c.to_string(),
            KeyCode::F(number) => format!("F{number}"),
            other => format!("{other:?}"),
        });
        if self.control { format!("C-{name}") } else { name }
    }

    /// The names of keys that are not characters.
    pub(crate) fn names() -> String {
        let names: Vec<&str> = NAMES.iter().map(|(_, name)| *name).collect();
        format!("{}, F1 ... F12", names.join(", "))
    }

    /// The key of a name.
    pub(crate) fn parse(name: &str) -> Option<Self> {
        let (control, name) = match name.strip_prefix("C-") {
            Some(rest) if !rest.is_empty() => (true, rest),
            _ => (false, name),
        };
        let code = NAMES.iter().find(|(_, known)| known.eq_ignore_ascii_case(name)).map(|(code, _)| *code);
        let mut letters = name.chars();
        let code = match (code, letters.next(), letters.next()) {
            (Some(code), ..) => code,
            (None, Some(letter), None) => KeyCode::Char(letter),
            _ => KeyCode::F(name.strip_prefix(['F', 'f'])?.parse().ok().filter(|n| (1..=12).contains(n))?),
        };
        Some(Self { code, control })
    }
}
