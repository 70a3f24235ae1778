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
pub(crate) mod state;
mod terminal;
pub(crate) mod view;
mod work;
mod workers;

#[cfg(test)]
pub(crate) mod tests;

use std::io::IsTerminal;
use std::path::PathBuf;

use assur_words::{Describe, Text, errors, text, text_of};
use command::COMMANDS;
pub use config::Config;
pub(crate) use config::default_text;
use state::{Look, Marker, Scene, State, Theme};

use crate::session::{Session, Source};

/// Options of the command line that go before the configuration.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct LookArgs {
    /// Capture the mouse in the terminal UI: a click on a curve chooses the position
    #[arg(long)]
    pub mouse: bool,
    /// Frames a second of the terminal UI's animation
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=60))]
    pub fps: Option<u8>,
    /// Height of a character cell in its widths, for drawings to scale in the terminal UI
    #[arg(long, value_name = "RATIO")]
    pub cell_ratio: Option<f64>,
}

/// Options of the terminal UI from the command line.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Draw with ASCII characters only; also chosen where the locale is not UTF-8.
    pub ascii: bool,
    /// What is asked for on the command line.
    pub look: LookArgs,
    /// The language that is asked for; `None`: as configured, else that of the scene's note.
    pub language: Option<String>,
    /// Force analyzer and integrator.
    pub methods: assur_analysis::Options,
    /// The configuration; the options above have precedence.
    pub config: Config,
    /// Why the configuration of the user was not used; the text is complete.
    pub config_fault: Option<Text>,
    /// The configuration file of the user, which need not exist; `None`: there is no place for it.
    pub config_file: Option<PathBuf>,
}

/// Why the terminal UI could not open.
#[non_exhaustive]
pub enum ScreenError {
    /// Standard input or output is no terminal.
    NoTerminal,
    /// The terminal returned an error.
    Terminal(std::io::Error),
    /// The scene can't be read; the text is complete, with file, line and column.
    Scene(Text),
}

impl Describe for ScreenError {
    fn describe(&self) -> Text {
        match self {
            Self::NoTerminal => text!("screen-no-terminal"),
            Self::Terminal(problem) => text!("screen-terminal-fails", problem = text_of(problem)),
            Self::Scene(fault) => fault.clone(),
        }
    }
}

errors!(ScreenError);

/// Opens the terminal UI on a scene, or on the menu of shipped scenes; returns the exit status.
///
/// # Errors
///
/// [`ScreenError`], with the terminal untouched or restored: a bad scene, no terminal, an error of the terminal.
#[expect(clippy::needless_pass_by_value, reason = "the command line gives its options away")]
pub fn run(path: Option<PathBuf>, options: Options) -> Result<u8, ScreenError> {
    let scene = match path {
        Some(path) => {
            let session = Session::open(Source::File(path));
            Some(session.and_then(Scene::of).map_err(ScreenError::Scene)?)
        }
        None => None,
    };
    if !(std::io::stdin().is_terminal() && std::io::stdout().is_terminal()) {
        return Err(ScreenError::NoTerminal);
    }
    let mut state = State::new(scene, look(&options), COMMANDS, options.config.keys.clone());
    state.fault = options.config_fault.clone().map(|fault| (text!("config-fault"), fault));
    state.panels.clone_from(&options.config.panels);
    state.size = terminal::size().unwrap_or(state.size);
    state.options.clone_from(&options.methods);
    command::start(&mut state);
    event_loop::run(state, options.config_file.as_deref()).map_err(ScreenError::Terminal)
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
