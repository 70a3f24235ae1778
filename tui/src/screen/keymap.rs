//! Which keys mean which command: those of the table, or those of the configuration.

use std::collections::BTreeMap;

use super::command::{COMMANDS, Command, named};
use super::key::Key;
use super::state::View;

/// The keys of every command.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Keymap {
    /// Commands that have other keys than the table says.
    other: BTreeMap<&'static str, Vec<Key>>,
}

impl Keymap {
    /// Gives a command these keys instead of those it has.
    pub(crate) fn bind(&mut self, command: &'static Command, keys: Vec<Key>) {
        if keys == command.keys {
            self.other.remove(command.name);
        } else {
            self.other.insert(command.name, keys);
        }
    }

    /// The keys of a command, the one for the hints first.
    pub(crate) fn of(&self, command: &'static Command) -> &[Key] {
        self.other.get(command.name).map_or(command.keys, Vec::as_slice)
    }

    /// Name of the first key of a command; the way by the `:` line where it has none.
    pub(crate) fn first(&self, name: &str) -> String {
        let key = named(name).and_then(|command| self.of(command).first());
        key.map_or_else(|| format!(":{name}"), |key| key.name())
    }

    /// The command of a key in a view.
    pub(crate) fn command(&self, key: Key, view: View) -> Option<&'static Command> {
        COMMANDS.iter().find(|command| command.fits(view) && self.of(command).contains(&key))
    }

    /// Keys that mean two commands in one view.
    pub(crate) fn clashes(&self) -> Vec<(Key, View, [&'static Command; 2])> {
        let mut clashes = Vec::new();
        for (index, one) in COMMANDS.iter().enumerate() {
            for two in &COMMANDS[index + 1..] {
                let shared = View::ALL.into_iter().find(|view| one.fits(*view) && two.fits(*view));
                let Some(view) = shared else { continue };
                let keys = self.of(one).iter().filter(|key| self.of(two).contains(key));
                clashes.extend(keys.map(|key| (*key, view, [one, two])));
            }
        }
        clashes
    }
}
