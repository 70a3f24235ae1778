//! The configuration: how the terminal UI looks, and its keys.

mod default;
mod keep;
#[cfg(test)]
mod tests;

use std::ops::Range;

use assur_scene::document::{self, Entry, Fault, Section};
use assur_scene::{Dimension, SceneErrors};

pub(crate) use default::text as default_text;
pub(crate) use keep::keep;

use super::command::COMMANDS;
use super::state::{Command, Key, Keymap, Look, Marker, Panels, Theme, View};

const KEYS: &[&str] = &["theme", "marker", "ascii", "fps", "cell_ratio", "panels", "mouse", "keys"];
/// Without a key for this command a user could not leave.
const OUT: &str = "quit";

/// The configuration; values that the file does not give are the defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Config {
    pub(crate) look: Look,
    pub(crate) panels: Panels,
    /// Capture the mouse.
    pub(crate) mouse: bool,
    pub(crate) keys: Keymap,
}

impl Default for Config {
    fn default() -> Self {
        Self { look: Look::default(), panels: Panels::default(), mouse: false, keys: Keymap::of(COMMANDS) }
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
        document::read(file_name, text, "the configuration", KEYS, |root| Self {
            look: look(root),
            panels: root.get("panels").map_or_else(Panels::default, |entry| panels(&entry)),
            mouse: root.get("mouse").and_then(|entry| entry.flag()).unwrap_or_default(),
            keys: root.get("keys").map_or_else(|| Keymap::of(COMMANDS), |keys| keymap(&keys)),
        })
    }
}

fn look(root: &Section<'_>) -> Look {
    let default = Look::default();
    let markers = Marker::ALL.map(|marker| (marker.name(), marker));
    let themes = Theme::ALL.map(|theme| (theme.name(), theme));
    let fps = root
        .get("fps")
        .and_then(|entry| entry.count(usize::from(*Look::FPS.start()), usize::from(*Look::FPS.end())));
    Look {
        ascii: root.get("ascii").and_then(|entry| entry.flag()).unwrap_or(default.ascii),
        marker: root.get("marker").and_then(|entry| entry.choice(&markers)).unwrap_or(default.marker),
        theme: root.get("theme").and_then(|entry| entry.choice(&themes)).unwrap_or(default.theme),
        ratio: root.get("cell_ratio").and_then(|entry| ratio(&entry)).unwrap_or(default.ratio),
        fps: fps.and_then(|fps| u8::try_from(fps).ok()).unwrap_or(default.fps),
    }
}

/// Views by the names of their commands; none: no view beside the chosen one.
fn panels(entry: &Entry<'_>) -> Panels {
    let names = View::TABS.map(|view| (view.command(), view));
    let views: Vec<View> =
        entry.list("the name of a view").iter().filter_map(|item| item.choice(&names)).collect();
    Panels { shown: !views.is_empty(), views }
}

fn ratio(entry: &Entry<'_>) -> Option<f64> {
    let ratio = entry.quantity(Dimension::Number)?;
    if Look::RATIO.contains(&ratio) {
        return Some(ratio);
    }
    let message = format!(
        "`{}` wants a number from {} to {}, got {ratio}",
        entry.name,
        Look::RATIO.start(),
        Look::RATIO.end()
    );
    entry.fault(message, "");
    None
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
    let message = format!("`{}` means both `{}` and `{}` in {}", key.name(), one.name, two.name, view.name());
    let other = other.name;
    let label = match at(other) {
        Some(_) => format!("also a key of `{other}`"),
        None => format!("a default key of `{other}`"),
    };
    let span = here.map_or(table.span.clone(), |written| written.span.clone());
    let help = format!("give one of them another key, or none at all: {other} = []");
    Fault::new(span, message).label(label).help(help)
}
