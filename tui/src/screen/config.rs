//! The configuration: how the terminal UI looks, and its keys.

mod default;
#[cfg(test)]
mod tests;

use std::ops::Range;

use assur_scene::document::{self, Entry, Fault, Section};
use assur_scene::{Dimension, SceneErrors};

pub(crate) use default::text as default_text;

use super::command::{COMMANDS, Command, named};
use super::draw::raster::Marker;
use super::key::Key;
use super::keymap::Keymap;
use super::state::{Look, View};
use super::text::{ENGLISH, fill};
use super::theme::Theme;
use super::view::header;

const KEYS: &[&str] = &["theme", "marker", "ascii", "fps", "cell_ratio", "mouse", "keys"];
/// Without a key for this command nobody would find the way out.
const OUT: &str = "quit";

/// What the configuration says; what it does not say is the default.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Config {
    pub(crate) look: Look,
    /// Capture the mouse.
    pub(crate) mouse: bool,
    pub(crate) keys: Keymap,
}

impl Config {
    /// Reads the text of a configuration. `file_name` is only repeated in errors.
    ///
    /// # Errors
    ///
    /// Every fault with its place: unknown names, wrong values, keys that are none or that mean two things in a view.
    pub(crate) fn read(file_name: &str, text: &str) -> Result<Self, SceneErrors> {
        document::read(file_name, text, "the configuration", KEYS, |root| Self {
            look: look(root),
            mouse: root.get("mouse").and_then(|entry| entry.flag()).unwrap_or_default(),
            keys: root.get("keys").map(|keys| keymap(&keys)).unwrap_or_default(),
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

fn ratio(entry: &Entry<'_>) -> Option<f64> {
    let ratio = entry.quantity(Dimension::Number)?;
    if Look::RATIO.contains(&ratio) {
        return Some(ratio);
    }
    let message = fill(ENGLISH.config_ratio, &[&entry.name, Look::RATIO.start(), Look::RATIO.end(), &ratio]);
    entry.fault(message, "");
    None
}

/// A key as the file has it.
struct Written {
    command: &'static Command,
    key: Key,
    span: Range<usize>,
}

fn keymap(table: &Entry<'_>) -> Keymap {
    let (mut keymap, mut written) = (Keymap::default(), Vec::new());
    for entry in table.named(ENGLISH.config_keys_table, ENGLISH.config_keys_label) {
        let Some(command) = named(&entry.name) else {
            entry.unknown(
                ENGLISH.config_command,
                COMMANDS.iter().map(|command| command.name),
                ENGLISH.config_commands,
            );
            continue;
        };
        let keys = keys(&entry, command);
        if keys.is_empty() && command.name == OUT {
            entry.fault(fill(ENGLISH.config_no_way_out, &[&OUT]), fill(ENGLISH.config_such_as, &[&OUT]));
        }
        keymap.bind(command, keys.iter().map(|written| written.key).collect());
        written.extend(keys);
    }
    for clash in keymap.clashes() {
        table.note(fault(clash, &written, table));
    }
    keymap
}

/// The keys of one command: a text, or a list of texts.
fn keys(entry: &Entry<'_>, command: &'static Command) -> Vec<Written> {
    let items = if entry.is_list() { entry.list(ENGLISH.config_a_key) } else { vec![entry.clone()] };
    let key = |item: &Entry<'_>| {
        let name = item.text(ENGLISH.config_a_key)?;
        let key = Key::parse(name);
        if key.is_none() {
            let message = fill(ENGLISH.config_no_key, &[&command.name, &name]);
            let help = fill(ENGLISH.config_keys_known, &[&Key::names()]);
            item.note(Fault::new(item.span.clone(), message).help(help));
        }
        Some(Written { command, key: key?, span: item.span.clone() })
    };
    items.iter().filter_map(key).collect()
}

/// Two commands with one key: shown at the later one that the file has.
fn fault(
    (key, view, both): (Key, View, [&'static Command; 2]),
    written: &[Written],
    table: &Entry<'_>,
) -> Fault {
    let at = |command: &'static Command| {
        written.iter().find(|written| written.command.name == command.name && written.key == key)
    };
    let [one, two] = both;
    let (here, other) = match (at(one), at(two)) {
        (Some(first), Some(second)) if first.span.start > second.span.start => (Some(first), two),
        (Some(first), None) => (Some(first), two),
        (_, second) => (second, one),
    };
    let view = header::name_in(&ENGLISH, view);
    let message = fill(ENGLISH.config_clash, &[&key.name(), &one.name, &two.name, &view]);
    let label = if at(other).is_some() { ENGLISH.config_also } else { ENGLISH.config_by_default };
    let span = here.map_or(table.span.clone(), |written| written.span.clone());
    Fault::new(span, message)
        .label(fill(label, &[&other.name]))
        .help(fill(ENGLISH.config_clash_help, &[&other.name]))
}
