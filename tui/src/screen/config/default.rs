//! The default configuration as a file with comments, made from the table of commands and the defaults themselves.

use assur_scene::edit::quoted;

use super::Config;
use crate::screen::command::{COMMANDS, Command, Group};
use crate::screen::draw::raster::Marker;
use crate::screen::key::Key;
use crate::screen::state::Look;
use crate::screen::text::{ENGLISH, fill};
use crate::screen::theme::Theme;
use crate::screen::view::{footer, help};

/// Where the comments of the keys begin.
const COMMENT_AT: usize = 40;

/// The file.
pub(crate) fn text() -> String {
    let (config, texts) = (Config::default(), &ENGLISH);
    let names = |names: &[&str]| names.join(", ");
    let themes = names(&Theme::ALL.map(Theme::name));
    let markers = names(&Marker::ALL.map(Marker::name));
    let fps = fill(texts.config_fps, &[Look::FPS.start(), Look::FPS.end()]);
    let ratio = fill(texts.config_cell, &[Look::RATIO.start(), Look::RATIO.end()]);
    let mut lines = Vec::new();
    let mut setting = |help: &str, name: &str, value: &str| {
        lines.push(String::new());
        lines.extend(help.lines().map(|line| format!("# {line}")));
        lines.push(format!("{name} = {value}"));
    };
    setting(&fill(texts.config_theme, &[&themes]), "theme", &quoted(config.look.theme.name()));
    setting(&fill(texts.config_marker, &[&markers]), "marker", &quoted(config.look.marker.name()));
    setting(texts.config_ascii, "ascii", &config.look.ascii.to_string());
    setting(&fps, "fps", &config.look.fps.to_string());
    setting(&ratio, "cell_ratio", &format!("{:?}", config.look.ratio));
    setting(texts.config_mouse, "mouse", &config.mouse.to_string());
    let head = texts.config_head.lines().map(|line| format!("# {line}"));
    let keys = fill(texts.config_keys, &[&Key::names()]);
    let keys = keys.lines().map(|line| format!("# {line}"));
    let all: Vec<String> = head
        .chain(lines)
        .chain([String::new()])
        .chain(keys)
        .chain(["[keys]".to_owned()])
        .chain(Group::ALL.into_iter().flat_map(of_group))
        .collect();
    all.join("\n") + "\n"
}

/// The commands of a group of the help screen, under its title.
fn of_group(group: Group) -> Vec<String> {
    let title = [String::new(), format!("# {}", help::title(&ENGLISH, group))];
    let commands = COMMANDS.iter().filter(|command| command.group == group);
    title.into_iter().chain(commands.map(of_command)).collect()
}

fn of_command(command: &Command) -> String {
    let keys: Vec<String> = command.keys.iter().map(|key| quoted(&key.name())).collect();
    let line = format!("{} = [{}]", command.name, keys.join(", "));
    format!("{line:COMMENT_AT$} # {}", footer::texts_of(&ENGLISH, command.name).0)
}
