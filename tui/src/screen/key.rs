//! Keys and their names, the same in the table of commands, on the screen and in the configuration.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// A key with its modifiers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Key {
    pub(crate) code: KeyCode,
    pub(crate) control: bool,
}

/// A key that is a character.
pub(crate) const fn char(c: char) -> Key {
    Key { code: KeyCode::Char(c), control: false }
}

/// A character with Ctrl.
pub(crate) const fn ctrl(c: char) -> Key {
    Key { code: KeyCode::Char(c), control: true }
}

/// Any other key.
pub(crate) const fn code(code: KeyCode) -> Key {
    Key { code, control: false }
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

    /// The names of keys that are no characters.
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

#[cfg(test)]
mod tests {
    use super::super::command::COMMANDS;
    use super::Key;

    #[test]
    fn every_key_has_a_name_that_reads_back() {
        for key in COMMANDS.iter().flat_map(|command| command.keys) {
            assert_eq!(Key::parse(&key.name()), Some(*key), "{}", key.name());
        }
        assert_eq!(Key::parse("F12").map(Key::name).as_deref(), Some("F12"));
        assert_eq!(Key::parse("F13"), None);
        assert_eq!(Key::parse("nonsense"), None);
        assert_eq!(Key::parse(""), None);
    }
}
