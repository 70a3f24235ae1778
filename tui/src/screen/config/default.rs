//! The default configuration as a file with comments, generated from the table of commands and the defaults themselves.

use assur_scene::edit::quoted;

use super::Config;
use crate::screen::command::COMMANDS;
use crate::screen::state::{Command, Group, Key, Look, Marker, Panels, Theme};

/// Column at which the comments of the keys begin.
const COMMENT_AT: usize = 40;

/// A setting: what it is, its name, its value as TOML.
pub(super) type Setting = (String, &'static str, String);

/// How the screen looks, as settings.
pub(super) fn settings(look: Look, panels: &Panels) -> [Setting; 6] {
    let [themes, markers] =
        [&Theme::ALL.map(Theme::name), &Marker::ALL.map(Marker::name)].map(|names| names.join(", "));
    let (fps, ratio) = (Look::FPS, Look::RATIO);
    let (fps, ratio) = ([fps.start(), fps.end()], [ratio.start(), ratio.end()]);
    [
        (format!("colors: {themes} (NO_COLOR=1 always gives mono)"), "theme", quoted(look.theme.name())),
        (format!("dots of drawings and curves: {markers}"), "marker", quoted(look.marker.name())),
        (
            "only ASCII characters; where the locale is not UTF-8 it is so anyway".to_owned(),
            "ascii",
            look.ascii.to_string(),
        ),
        (format!("frames a second of the animation, {} to {}", fps[0], fps[1]), "fps", look.fps.to_string()),
        (
            format!(
                "height of a character cell in its widths, {} to {}, for drawings to scale",
                ratio[0], ratio[1]
            ),
            "cell_ratio",
            format!("{:?}", look.ratio),
        ),
        (
            "views beside the chosen one from 120 columns, as many as there is room for; [] means none"
                .to_owned(),
            "panels",
            list_of(panels),
        ),
    ]
}

/// The file.
pub(crate) fn text() -> String {
    let config = Config::default();
    let mouse = (
        "capture the mouse: a click on a curve chooses the position".to_owned(),
        "mouse",
        config.mouse.to_string(),
    );
    let head = "Configuration of assur's terminal UI. Every value here is the default; keep what you change.
It is read from $XDG_CONFIG_HOME/assur/config.toml, or else from ~/.config/assur/config.toml.
Options of the command line go before it."
        .lines()
        .map(|line| format!("# {line}"));
    let settings = settings(config.look, &config.panels).into_iter().chain([mouse]);
    let settings = settings
        .flat_map(|(help, name, value)| [String::new(), format!("# {help}"), format!("{name} = {value}")]);
    let keys = format!("The keys of each command; the first one is shown in the hints, [] means none. A key is a character, C- and a
character (with Ctrl), or one of:
{}.
Two commands that meet in a view can't share a key.", Key::names());
    let keys = keys.lines().map(|line| format!("# {line}"));
    let all: Vec<String> = head
        .chain(settings)
        .chain([String::new()])
        .chain(keys)
        .chain(["[keys]".to_owned()])
        .chain(Group::ALL.into_iter().flat_map(of_group))
        .collect();
    all.join("\n") + "\n"
}

/// The views as a list of TOML.
fn list_of(panels: &Panels) -> String {
    let views = panels.views.iter().filter(|_| panels.shown);
    let names: Vec<String> = views.map(|view| quoted(view.command())).collect();
    format!("[{}]", names.join(", "))
}

/// The commands of a group of the help screen, under its title.
fn of_group((group, title): (Group, &str)) -> Vec<String> {
    let title = [String::new(), format!("# {title}")];
    let commands = COMMANDS.iter().filter(|command| command.group == group);
    title.into_iter().chain(commands.map(of_command)).collect()
}

fn of_command(command: &Command) -> String {
    let keys: Vec<String> = command.default_keys().iter().map(|key| quoted(&key.name())).collect();
    let line = format!("{} = [{}]", command.name, keys.join(", "));
    format!("{line:COMMENT_AT$} # {}", command.help)
}
