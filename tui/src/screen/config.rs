//! The configuration: how the terminal UI looks, and its keys.

mod default;
#[cfg(test)]
mod tests;

use std::ops::Range;
use std::sync::LazyLock;

use assur_scene::document::{self, Entry, Fault, Section};
use assur_scene::{Dimension, SceneErrors};

pub(crate) use default::{keep, text as default_text};

use super::command::COMMANDS;
use super::state::{Command, Key, Keymap, Kind, Look, Panels, SETTINGS, View};

/// Without a key for this command a user could not leave.
const OUT: &str = "quit";

/// The configuration; values that the file does not give are the defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Config {
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
    /// The language that is configured: a code, or what asks for that of a scene.
    pub(crate) fn language(&self) -> &'static str {
        self.look.language
    }

    /// Reads the text of a configuration. `file_name` is only repeated in errors.
    ///
    /// # Errors
    ///
    /// Every error with its place: unknown names, wrong values, keys that do not exist or that have two meanings in a
    /// view.
    pub(crate) fn read(file_name: &str, text: &str) -> Result<Self, SceneErrors> {
        static KEYS: LazyLock<Vec<&str>> =
            LazyLock::new(|| SETTINGS.iter().map(|setting| setting.name).chain(["panels", "keys"]).collect());
        document::read(file_name, text, "the configuration", &KEYS, |root| Self {
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

/// The value of a setting as a word.
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
                let message = format!(
                    "`{}` wants a number from {} to {}, got {number}",
                    entry.name,
                    range.start(),
                    range.end()
                );
                entry.fault(message, "");
            }
            Some(number.to_string())
        }
    }
}

/// Views by the names of their commands; none: no view beside the chosen one.
fn panels(entry: &Entry<'_>) -> Panels {
    let names = View::TABS.map(|view| (view.command(), view));
    let views: Vec<View> =
        entry.list("the name of a view").iter().filter_map(|item| item.choice(&names)).collect();
    Panels { shown: !views.is_empty(), views }
}

/// A key as written in the file.
struct Written {
    command: &'static str,
    key: Key,
    span: Range<usize>,
}

fn keymap(table: &Entry<'_>) -> Keymap {
    let (mut keymap, mut written) = (Keymap::of(COMMANDS), Vec::new());
    for entry in table.named("a table", "write [keys] and a line for each command") {
        let Some(command) = COMMANDS.iter().find(|command| command.name == entry.name) else {
            entry.unknown("command", COMMANDS.iter().map(|command| command.name), || {
                "`assur config` prints all commands with their keys".to_owned()
            });
            continue;
        };
        let keys = keys(&entry, command);
        if keys.is_empty() && command.name == OUT {
            entry.fault(format!("`{OUT}` needs a key"), format!("such as {OUT} = \"q\""));
        }
        keymap.bind(command.name, keys.iter().map(|written| written.key).collect());
        written.extend(keys);
    }
    for clash in keymap.clashes(COMMANDS) {
        table.note(fault(clash, &written, table));
    }
    keymap
}

/// The keys of one command: a text, or a list of texts.
fn keys(entry: &Entry<'_>, command: &'static Command) -> Vec<Written> {
    let items = if entry.is_list() { entry.list("the name of a key") } else { vec![entry.clone()] };
    let key = |item: &Entry<'_>| {
        let name = item.text("the name of a key")?;
        let key = Key::parse(name);
        if key.is_none() {
            let message = format!("`{}`: there is no key `{name}`", command.name);
            let help = format!("a key is a character, C- and a character, or one of: {}", Key::names());
            item.note(Fault::new(item.span.clone(), message).help(help));
        }
        Some(Written { command: command.name, key: key?, span: item.span.clone() })
    };
    items.iter().filter_map(key).collect()
}

/// Two commands with one key: shown at the later one that the file has.
fn fault(
    (key, view, both): (Key, View, [&'static Command; 2]),
    written: &[Written],
    table: &Entry<'_>,
) -> Fault {
    let at = |name: &str| written.iter().find(|written| written.command == name && written.key == key);
    let [one, two] = both;
    let (here, other) = match (at(one.name), at(two.name)) {
        (Some(first), Some(second)) if first.span.start > second.span.start => (Some(first), two),
        (Some(first), None) => (Some(first), two),
        (_, second) => (second, one),
    };
    let view = view.name();
    let message = format!("`{}` means both `{}` and `{}` in {view}", key.name(), one.name, two.name);
    let other = other.name;
    let label = match at(other) {
        Some(_) => format!("also a key of `{other}`"),
        None => format!("a default key of `{other}`"),
    };
    let span = here.map_or(table.span.clone(), |written| written.span.clone());
    let help = format!("give one of them another key, or none at all: {other} = []");
    Fault::new(span, message).label(label).help(help)
}
