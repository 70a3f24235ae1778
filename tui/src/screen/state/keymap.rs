//! Keys and their names, commands as data, and the assignment of keys to commands, from the table or from the configuration.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use assur_words::{Language, text};
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use strum::VariantArray;

use super::State;
use super::kinds::View;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Group {
    Move,
    Choose,
    Change,
    Views,
    Look,
    Program,
}

impl Group {
    /// In the order of the help screen, with the identifiers of their titles.
    pub(crate) const ALL: [(Self, &str); 6] = [
        (Self::Move, "group-move"),
        (Self::Choose, "group-choose"),
        (Self::Change, "group-change"),
        (Self::Views, "group-views"),
        (Self::Look, "group-look"),
        (Self::Program, "group-program"),
    ];
}

/// One user command. The state receives the table of all commands from above.
#[derive(Debug)]
pub(crate) struct Command {
    /// Name on the `:` line and in the configuration.
    pub(crate) name: &'static str,
    /// The identity of its text: what it does.
    pub(crate) text: &'static str,
    pub(crate) group: Group,
    /// Names of its keys by default, the one for the hints first.
    pub(crate) keys: &'static str,
    /// Views in which the keys apply; empty: all with a scene and the menu.
    pub(crate) views: &'static [View],
    pub(crate) run: fn(&mut State),
    /// Whether it can do anything now, so that it is worth a hint.
    pub(crate) works: fn(&State) -> bool,
}

impl Command {
    /// Hinted only where it can do something.
    pub(crate) const fn only(mut self, works: fn(&State) -> bool) -> Self {
        self.works = works;
        self
    }

    pub(crate) fn fits(&self, view: View) -> bool {
        self.views.is_empty() || self.views.contains(&view)
    }

    pub(crate) fn help(&self, language: &Language) -> String {
        text!(self.text).render(language)
    }

    /// Another of its texts: its name among the hints (`hint`), other words for it (`also`); empty where there is none.
    pub(crate) fn text(&self, language: &Language, attribute: &str) -> String {
        language.own(&format!("{}.{attribute}", self.text)).unwrap_or_default()
    }

    pub(crate) fn default_keys(&self) -> Vec<Key> {
        self.keys.split(' ').filter_map(Key::parse).collect()
    }
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Keymap(BTreeMap<&'static str, Vec<Key>>);

impl Keymap {
    pub(crate) fn of(commands: &[Command]) -> Self {
        Self(commands.iter().map(|command| (command.name, command.default_keys())).collect())
    }

    pub(crate) fn bind(&mut self, command: &'static str, keys: Vec<Key>) {
        self.0.insert(command, keys);
    }

    /// The keys of a command, the one for the hints first.
    pub(crate) fn keys(&self, command: &str) -> &[Key] {
        self.0.get(command).map_or(&[], Vec::as_slice)
    }

    /// The keys of a command of the program that work whatever is open, also where text is typed.
    pub(crate) fn everywhere(&self, command: &str) -> Vec<Key> {
        self.keys(command).iter().copied().filter(|key| key.control).collect()
    }

    /// Name of the first key of a command; if it has none, its form for the `:` line.
    pub(crate) fn first(&self, command: &str) -> String {
        self.keys(command).first().map_or_else(|| format!(":{command}"), |key| key.name())
    }

    pub(crate) fn clashes<'a>(&self, commands: &'a [Command]) -> Vec<(Key, View, [&'a Command; 2])> {
        let mut clashes = Vec::new();
        for (index, one) in commands.iter().enumerate() {
            for two in &commands[index + 1..] {
                let shared = View::VARIANTS.iter().find(|view| one.fits(**view) && two.fits(**view));
                let Some(&view) = shared else { continue };
                let keys = self.keys(one.name).iter().filter(|key| self.keys(two.name).contains(key));
                clashes.extend(keys.map(|key| (*key, view, [one, two])));
            }
        }
        clashes
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Key {
    pub(crate) code: KeyCode,
    pub(crate) control: bool,
    /// With the shift key; of letters it is in the letter itself.
    pub(crate) shift: bool,
}

impl From<KeyEvent> for Key {
    fn from(event: KeyEvent) -> Self {
        let shift = is_arrow(event.code) && event.modifiers.contains(KeyModifiers::SHIFT);
        Self { code: event.code, control: event.modifiers.contains(KeyModifiers::CONTROL), shift }
    }
}

fn is_arrow(code: KeyCode) -> bool {
    matches!(code, KeyCode::Left | KeyCode::Right | KeyCode::Up | KeyCode::Down)
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
        match (self.control, self.shift) {
            (true, _) => format!("C-{name}"),
            (_, true) => format!("S-{name}"),
            _ => name,
        }
    }

    pub(crate) fn names() -> String {
        let names: Vec<&str> = NAMES.iter().map(|(_, name)| *name).collect();
        format!("{}, F1 ... F12", names.join(", "))
    }

    pub(crate) fn parse(name: &str) -> Option<Self> {
        let (control, name) = match name.strip_prefix("C-") {
            Some(rest) if !rest.is_empty() => (true, rest),
            _ => (false, name),
        };
        let (shift, name) = match name.strip_prefix("S-") {
            Some(rest) if Self::parse(rest).is_some_and(|key| is_arrow(key.code)) => (true, rest),
            _ => (false, name),
        };
        let code = NAMES.iter().find(|(_, known)| known.eq_ignore_ascii_case(name)).map(|(code, _)| *code);
        let mut letters = name.chars();
        let code = match (code, letters.next(), letters.next()) {
            (Some(code), ..) => code,
            (None, Some(letter), None) => KeyCode::Char(letter),
            _ => KeyCode::F(name.strip_prefix(['F', 'f'])?.parse().ok().filter(|n| (1..=12).contains(n))?),
        };
        Some(Self { code, control, shift })
    }
}
