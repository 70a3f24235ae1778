//! The configuration as a file: the default with comments, generated from the settings, the table of commands and their texts;
//! and how the screen looks now, written into that of the user.

use std::path::Path;

use assur_scene::edit::quoted;

use super::Config;
use crate::files;
use crate::screen::command::COMMANDS;
use crate::screen::state::{Command, Group, Key, Kind, Look, Panels, Role, SETTINGS, State};
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
    let comment = |text: &str| text.lines().map(|line| format!("# {line}")).collect::<Vec<_>>();
    let mut lines = comment(&words.get("config-head"));
    for (name, value, told) in settings(&config.look, &config.panels) {
        lines.push(String::new());
        lines.extend(comment(&words.with(&format!("config-{name}"), &[("values", told)])));
        lines.push(format!("{name} = {value}"));
    }
    lines.push(String::new());
    lines.extend(comment(&words.with("config-keys", &[("names", Key::names())])));
    lines.push("[keys]".to_owned());
    for (group, id) in Group::ALL {
        lines.extend([String::new(), format!("# {}", words.get(id))]);
        let commands = COMMANDS.iter().filter(|command| command.group == group);
        lines.extend(commands.map(|command| line_of(command, words)));
    }
    lines.join("\n") + "\n"
}

fn line_of(command: &Command, words: &Words) -> String {
    let keys: Vec<String> = command.default_keys().iter().map(|key| quoted(&key.name())).collect();
    let line = format!("{} = [{}]", command.name, keys.join(", "));
    format!("{line:COMMENT_AT$} # {}", command.help(words))
}

/// Writes what has changed since the start to the configuration file, and says so. What the terminal or its locale asks for is
/// no change.
pub(crate) fn keep(state: &mut State, file: Option<&Path>, (look, panels): &(Look, Panels)) {
    let Some(path) = file else {
        let text = "there is no place for a configuration: neither XDG_CONFIG_HOME nor HOME is set";
        return state.say(Role::Bad, text);
    };
    let before = settings(look, panels);
    let now = settings(&state.look, &state.panels);
    let changed: Vec<_> =
        now.into_iter().filter(|one| !before.contains(one)).map(|(name, value, _)| (name, value)).collect();
    if changed.is_empty() {
        let names: Vec<&str> = before.iter().map(|(name, ..)| *name).collect();
        return state.say(Role::Plain, format!("nothing that is kept has changed: {}", names.join(", ")));
    }
    let old =
        if path.exists() { files::read(path).map_err(|error| error.to_string()) } else { Ok(String::new()) };
    let written = old.and_then(|old| kept(&old, &changed)).and_then(|text| {
        let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
        folder.map_err(|error| error.to_string())?;
        files::write(path, text.as_bytes()).map_err(|error| error.to_string())
    });
    match written {
        Ok(()) => state.say(Role::Good, format!("kept in {}", path.display())),
        Err(error) => state.say(Role::Bad, error),
    }
}

/// The text of a configuration with these settings; everything else stays as it is.
///
/// # Errors
///
/// What the user may do instead, if the text can't be changed so that it is read again.
pub(super) fn kept(text: &str, changed: &[(&str, String)]) -> Result<String, String> {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for (name, value) in changed {
        let line = format!("{name} = {value}");
        // A setting stands before the first table.
        let tables = lines.iter().position(|line| line.trim_start().starts_with('[')).unwrap_or(lines.len());
        let is_setting = |line: &String| line.split_once('=').is_some_and(|(key, _)| key.trim() == *name);
        match lines[..tables].iter().position(is_setting) {
            Some(at) => lines[at] = line,
            None => lines.insert(0, line),
        }
    }
    let text = lines.join("\n") + "\n";
    let config = Config::read("config.toml", &text).ok();
    let read = config.map_or_else(Vec::new, |config| settings(&config.look, &config.panels));
    if changed.iter().all(|(name, value)| read.iter().any(|(known, read, _)| known == name && read == value))
    {
        Ok(text)
    } else {
        Err("the configuration has a form that can't be changed here; `assur config` prints one that can"
            .into())
    }
}
