//! The configuration: how the terminal UI looks, and its keys.

mod default;
#[cfg(test)]
mod tests;

use std::ops::Range;
use std::sync::LazyLock;

use assur_scene::document::{self, Entry, Fault, Section};
use assur_scene::{Dimension, SceneErrors};
use assur_words::{self as words, Text, name, text};

pub(crate) use default::{keep, text as default_text};

use super::command::COMMANDS;
use super::state::{Command, Key, Keymap, Kind, Look, Panels, SETTINGS, View};

/// Without a key for this command a user could not leave.
const OUT: &str = "quit";

/// The configuration; values that the file does not give are the defaults.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Config {
    pub(crate) look: Look,
    pub(crate) panels: Panels,
    pub(crate) keys: Keymap,
}

impl Default for Config {
    fn default() -> Self {
        Self { look: Look::default(), panels: Panels::default(), keys: Keymap::of(COMMANDS) }
    }
}

impl Config {
    /// Reads the text of a configuration. `file_name` is only repeated in errors.
    ///
    /// # Errors
    ///
    /// Every error with its place: unknown names, wrong values, keys that do not exist or that have two meanings in a
    /// view.
    pub(crate) fn read(file_name: &str, text: &str) -> Result<Self, SceneErrors> {
        static KEYS: LazyLock<Vec<&str>> =
            LazyLock::new(|| SETTINGS.iter().map(|setting| setting.name).chain(["panels", "keys"]).collect());
        document::read(file_name, text, text!("config-file"), &KEYS, |root| Self {
            look: look(root),
            panels: root.get("panels").map_or_else(Panels::default, |entry| panels(&entry)),
            keys: root.get("keys").map_or_else(|| Keymap::of(COMMANDS), |keys| keymap(&keys)),
        })
    }
}

fn look(root: &Section<'_>) -> Look {
    SETTINGS.iter().fold(Look::default(), |look, setting| {
        look.with(setting.name, root.get(setting.name).and_then(|entry| word(&entry, &setting.kind)))
    })
}

fn word(entry: &Entry<'_>, kind: &Kind) -> Option<String> {
    match kind {
        Kind::Choice(words) => {
            let words: Vec<_> = words.iter().map(|word| (*word, *word)).collect();
            entry.choice(&words).map(str::to_owned)
        }
        Kind::Flag => entry.flag().map(|on| if on { "on" } else { "off" }.to_owned()),
        Kind::Count(range) => entry.count(*range.start(), *range.end()).map(|count| count.to_string()),
        Kind::Number(range) => {
            let number = entry.quantity(Dimension::Number)?;
            if !range.contains(&number) {
                let [least, most] = [range.start(), range.end()].map(words::number);
                let problem = text!("config-number", least = least, most = most, got = words::number(number));
                entry.problem(problem, Text::default());
            }
            Some(number.to_string())
        }
    }
}

/// Views by the names of their commands; none: no view beside the chosen one.
fn panels(entry: &Entry<'_>) -> Panels {
    let names = View::TABS.map(|view| (view.command(), view));
    let views: Vec<View> =
        entry.list(text!("config-name-of-view")).iter().filter_map(|item| item.choice(&names)).collect();
    Panels { shown: !views.is_empty(), views }
}

struct Written {
    command: &'static str,
    key: Key,
    span: Range<usize>,
}

fn keymap(table: &Entry<'_>) -> Keymap {
    let (mut keymap, mut written) = (Keymap::of(COMMANDS), Vec::new());
    for entry in table.named(text!("config-table"), text!("config-write-keys")) {
        let Some(command) = COMMANDS.iter().find(|command| command.name == entry.name) else {
            let known = COMMANDS.iter().map(|command| command.name);
            entry.unknown(text!("config-command"), known, || text!("config-all-commands"));
            continue;
        };
        let keys = keys(&entry, command);
        if keys.is_empty() && command.name == OUT {
            entry.fault(text!("config-no-way-out", command = name(OUT)), name(format!("{OUT} = \"q\"")));
        }
        keymap.bind(command.name, keys.iter().map(|written| written.key).collect());
        written.extend(keys);
    }
    for clash in keymap.clashes(COMMANDS) {
        table.note(fault(clash, &written, table));
    }
    keymap
}

fn keys(entry: &Entry<'_>, command: &'static Command) -> Vec<Written> {
    let items = if entry.is_list() { entry.list(text!("config-name-of-key")) } else { vec![entry.clone()] };
    let key = |item: &Entry<'_>| {
        let written = item.text(text!("config-name-of-key"))?;
        let key = Key::parse(written);
        if key.is_none() {
            let (command, written) = (name(command.name), name(written.to_owned()));
            let message = text!("config-no-such-key", command = command, key = written);
            let help = text!("config-what-is-a-key", keys = name(Key::names()));
            item.note(Fault::new(item.span.clone(), message).help(help));
        }
        Some(Written { command: command.name, key: key?, span: item.span.clone() })
    };
    items.iter().filter_map(key).collect()
}

/// Two commands with one key: shown at the later one that the file has.
fn fault((key, view, both): (Key, View, [&'static Command; 2]), own: &[Written], table: &Entry<'_>) -> Fault {
    let at = |name: &str| own.iter().find(|written| written.command == name && written.key == key);
    let [one, two] = both;
    let (here, other) = match (at(one.name), at(two.name)) {
        (Some(first), Some(second)) if first.span.start > second.span.start => (Some(first), two),
        (Some(first), None) => (Some(first), two),
        (_, second) => (second, one),
    };
    let view = view.name();
    let message = text!(
        "config-two-meanings",
        key = name(key.name()),
        one = name(one.name),
        two = name(two.name),
        view = view
    );
    let label = match at(other.name) {
        Some(_) => text!("config-also-a-key", command = name(other.name)),
        None => text!("config-default-key", command = name(other.name)),
    };
    let span = here.map_or(table.span.clone(), |written| written.span.clone());
    let help = text!("config-another-key", command = name(other.name));
    Fault::new(span, message).label(label).help(help)
}
