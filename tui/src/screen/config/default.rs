//! The default configuration as a file with comments, generated from the settings, the table of commands and their texts.

use assur_scene::edit::quoted;

use super::Config;
use crate::screen::command::COMMANDS;
use crate::screen::state::{Command, Group, Key, Kind, Look, Panels, SETTINGS};
use crate::words::{LANGUAGES, Words};

/// Column at which the comments of the keys begin.
const COMMENT_AT: usize = 40;

/// How the screen looks: names of settings, their values as TOML, and what they take.
pub(super) fn settings(look: &Look, panels: &Panels) -> Vec<(&'static str, String, String)> {
    let toml = |kind: &Kind, word: String| match kind {
        Kind::Choice(_) => quoted(&word),
        Kind::Flag => (word == "on").to_string(),
        _ => word,
    };
    let own = SETTINGS.iter().map(|one| (one.name, toml(&one.kind, (one.get)(look)), one.kind.told()));
    let views = panels.views.iter().filter(|_| panels.shown).map(|view| quoted(view.command()));
    let views = format!("[{}]", views.collect::<Vec<_>>().join(", "));
    own.chain([("panels", views, String::new())]).collect()
}

/// The file.
pub(crate) fn text() -> String {
    let (words, config) = (Words::of(LANGUAGES[0]), Config::default());
    let comment = |text: &str| text.lines().map(|line| format!("# {line}\n")).collect::<String>();
    let mut file = comment(&words.get("config-head"));
    for (name, value, told) in settings(&config.look, &config.panels) {
        let help = words.with(&format!("config-{name}"), &[("values", told)]);
        file += &format!("\n{}{name} = {value}\n", comment(&help));
    }
    file += &format!("\n{}[keys]\n", comment(&words.with("config-keys", &[("names", Key::names())])));
    for (group, id) in Group::ALL {
        file += &format!("\n# {}\n", words.get(id));
        let commands = COMMANDS.iter().filter(|command| command.group == group);
        file.extend(commands.map(|command| line_of(command, words)));
    }
    file
}

fn line_of(command: &Command, words: &Words) -> String {
    let keys: Vec<String> = command.default_keys().iter().map(|key| quoted(&key.name())).collect();
    let line = format!("{} = [{}]", command.name, keys.join(", "));
    format!("{line:COMMENT_AT$} # {}\n", command.help(words))
}
