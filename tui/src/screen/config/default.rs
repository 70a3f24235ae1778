//! The configuration as a file: the default with comments, generated from the settings, the table of commands and their texts;
//! and how the screen looks now, written into that of the user.

use std::path::Path;

use assur_scene::edit::quoted;
use assur_words::{self as words, Describe, Language, Text, list, text};

use super::Config;
use crate::files;
use crate::screen::command::COMMANDS;
use crate::screen::state::{Command, Group, Key, Kind, Look, Panels, Role, SETTINGS, State};

/// Column at which the comments of the keys begin.
const COMMENT_AT: usize = 40;

/// How the screen looks: names of settings, their values as TOML, and what they are.
pub(super) fn settings(look: &Look, panels: &Panels) -> Vec<(&'static str, String, Text)> {
    let toml = |kind: &Kind, word: String| match kind {
        Kind::Choice(_) => quoted(&word),
        Kind::Flag => (word == "on").to_string(),
        _ => word,
    };
    let own = SETTINGS
        .iter()
        .map(|one| (one.name, toml(&one.kind, (one.get)(look)), text!(one.text, values = one.kind.told())));
    let views = panels.views.iter().filter(|_| panels.shown).map(|view| quoted(view.command()));
    let views = format!("[{}]", views.collect::<Vec<_>>().join(", "));
    own.chain([("panels", views, text!("config-panels"))]).collect()
}

/// The file, with comments in a language.
pub(crate) fn text(language: &Language) -> String {
    let config = Config::default();
    let comment =
        |text: &Text| text.render(language).lines().map(|line| format!("# {line}")).collect::<Vec<_>>();
    let mut lines = comment(&text!("config-head"));
    for (name, value, told) in settings(&config.look, &config.panels) {
        lines.push(String::new());
        lines.extend(comment(&told));
        lines.push(format!("{name} = {value}"));
    }
    lines.push(String::new());
    lines.extend(comment(&text!("config-keys", names = words::name(Key::names()))));
    lines.push("[keys]".to_owned());
    for (group, id) in Group::ALL {
        lines.extend([String::new(), format!("# {}", text!(id).render(language))]);
        let commands = COMMANDS.iter().filter(|command| command.group == group);
        lines.extend(commands.map(|command| line_of(command, language)));
    }
    lines.join("\n") + "\n"
}

fn line_of(command: &Command, language: &Language) -> String {
    let keys: Vec<String> = command.default_keys().iter().map(|key| quoted(&key.name())).collect();
    let line = format!("{} = [{}]", command.name, keys.join(", "));
    format!("{line:COMMENT_AT$} # {}", command.help(language))
}

/// Writes what has changed since the start to the configuration file, and says so. What the terminal or its locale asks for is
/// no change.
pub(crate) fn keep(state: &mut State, file: Option<&Path>, (look, panels): &(Look, Panels)) {
    let Some(path) = file else {
        return state.say(Role::Bad, text!("say-no-place-for-config"));
    };
    let before = settings(look, panels);
    let now = settings(&state.look, &state.panels);
    let changed: Vec<_> =
        now.into_iter().filter(|one| !before.contains(one)).map(|(name, value, _)| (name, value)).collect();
    if changed.is_empty() {
        let names = list(before.iter().map(|(name, ..)| words::name(*name)));
        return state.say(Role::Plain, text!("say-nothing-to-keep", settings = names));
    }
    let old =
        if path.exists() { files::read(path).map_err(|error| error.describe()) } else { Ok(String::new()) };
    let written = old.and_then(|old| kept(&old, &changed)).and_then(|text| {
        let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
        folder.map_err(|error| words::text_of(&error))?;
        files::write(path, text.as_bytes()).map_err(|error| error.describe())
    });
    match written {
        Ok(()) => state.say(Role::Good, text!("say-kept", file = words::name(path.display().to_string()))),
        Err(error) => state.say(Role::Bad, error),
    }
}

/// The text of a configuration with these settings; everything else stays as it is.
///
/// # Errors
///
/// What the user may do instead, if the text can't be changed so that it is read again.
pub(super) fn kept(text: &str, changed: &[(&str, String)]) -> Result<String, Text> {
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
        Err(text!("say-config-form"))
    }
}
