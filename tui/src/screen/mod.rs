//! The terminal UI.
//!
//! [`run`] is the entry point. The layers, from below: `state` is everything on which a frame depends; `draw` puts
//! figures, curves and text into cells; `view` is pure functions from the state to a frame; `command` changes the
//! state, by a table of commands that is passed to the state, so that views can show its keys without depending on it;
//! `event_loop` applies the events that wait in `inbox` and redraws only after one that
//! changed something. Nothing here calculates; reading and calculating (`work`) run in threads of `workers`.

pub(crate) mod command;
mod config;
mod draw;
mod event_loop;
mod inbox;
mod input;
mod pixels;
mod recovery;
pub(crate) mod state;
mod terminal;
pub(crate) mod view;
mod work;
mod workers;

#[cfg(test)]
pub(crate) mod tests;

use std::path::PathBuf;

use assur_words::{Text, text, text_of};
use command::COMMANDS;
pub(crate) use config::{Config, default_text};
use recovery::Recovery;
pub(crate) use recovery::folder as state_folder;
use state::{Look, Marker, Scene, State, Theme};

use crate::session::{Session, Source};

/// Options of the command line that go before the configuration.
#[derive(Debug, Clone, Default, clap::Args)]
pub(crate) struct LookArgs {
    /// Capture the mouse in the terminal UI: a click on a curve chooses the position
    #[arg(long)]
    pub(crate) mouse: bool,
    /// Frames a second of the terminal UI's animation
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=60))]
    pub(crate) fps: Option<u8>,
    /// Height of a character cell in its widths, for drawings to scale in the terminal UI
    #[arg(long, value_name = "RATIO")]
    pub(crate) cell_ratio: Option<f64>,
}

/// Options of the terminal UI from the command line.
#[derive(Debug)]
pub(crate) struct Options {
    /// Draw with ASCII characters only; also chosen where the locale is not UTF-8.
    pub(crate) ascii: bool,
    pub(crate) look: LookArgs,
    /// The language that is asked for; `None`: as configured, else that of the scene's note.
    pub(crate) language: Option<String>,
    pub(crate) methods: assur_analysis::Options,
    /// The configuration; the options above have precedence.
    pub(crate) config: Config,
    pub(crate) config_fault: Option<Text>,
    /// Where programs keep unsaved changes; `None`: there is no place for it.
    pub(crate) state_folder: Option<PathBuf>,
    pub(crate) start: Start,
    /// The configuration file of the user, which need not exist; `None`: there is no place for it.
    pub(crate) config_file: Option<PathBuf>,
}

/// What the terminal UI begins with.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Start {
    /// A scene, or the list of scenes.
    #[default]
    Scene,
    /// A mechanism from nothing.
    New,
    /// The tour.
    Tour,
}

/// Opens the terminal UI on a scene, or on the menu of shipped scenes; returns the exit status.
///
/// # Errors
///
/// In words, with the terminal untouched or restored: the faults of a scene, complete with file, line and column, or what the terminal
/// says.
pub(crate) fn run(path: Option<PathBuf>, options: Options) -> Result<u8, Text> {
    let session = path.map(|path| Session::open(Source::File(path))).transpose()?;
    let scene = session.map(Scene::of).transpose()?;
    let mut state = State::new(scene, look(&options), COMMANDS, options.config.keys);
    state.fault = options.config_fault.map(|fault| (text!("config-fault"), fault));
    state.panels = options.config.panels;
    state.size = terminal::size().unwrap_or(state.size);
    state.options = options.methods;
    match options.start {
        Start::Scene => command::start(&mut state),
        Start::New => command::from_nothing(&mut state),
        Start::Tour => command::tour(&mut state),
    }
    state.recovered = options.state_folder.as_deref().map(recovery::left).unwrap_or_default();
    command::offer_recovered(&mut state);
    let recovery = options.state_folder.as_deref().map(Recovery::new);
    let ended = event_loop::run(state, options.config_file.as_deref(), recovery);
    ended.map_err(|problem| text!("screen-terminal-fails", problem = text_of(&problem)))
}

/// How to draw, from options, configuration, locale and `NO_COLOR`.
fn look(options: &Options) -> Look {
    let variable = |name: &str| std::env::var(name).ok();
    let (asked, look) = (&options.look, options.config.look);
    let ascii = options.ascii || look.ascii || !crate::locale::is_utf8(variable);
    let theme = variable("NO_COLOR").filter(|value| !value.is_empty()).map(|_| Theme::Mono);
    let look = look.with("fps", asked.fps.map(|fps| fps.to_string()));
    let look = look.with("cell_ratio", asked.cell_ratio.map(|ratio| ratio.to_string()));
    let look = look.with("language", options.language.clone());
    Look {
        ascii,
        marker: if ascii { Marker::Ascii } else { look.marker },
        theme: theme.unwrap_or(look.theme),
        mouse: asked.mouse || look.mouse,
        ..look
    }
}
