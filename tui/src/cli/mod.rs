//! The command line: reads files, calls the crates, writes the results. Nothing here calculates.

mod analyze;
mod args;
mod chart;
mod config;
mod draw;
mod explain;
mod fault;
mod import;
mod keys;
mod lists;
mod options;
mod output;
mod plans;
mod program;
mod scene;
mod set;
mod sheet;
mod shell;
mod study;
mod style;
mod sweep;
mod table;
mod usage;

use std::ffi::OsString;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::process::ExitCode;

use assur_words::{Describe, name, text};
pub use program::Program;

use args::{AnalyzeArgs, Cli, Command};
use fault::{Fault, Status};
use options::{CheckedArgs, SceneArgs};
use style::Style;
use usage::Refused;

use crate::files::{self, FileError};
use crate::screen::{self, Config, Start};

/// Runs one command line and returns the exit status: 0 done; 1 no assembly, no solution or a check that fails; 2 a bad
/// scene or usage.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    files::ignore_limit();
    let (config, config_fault) = config::load();
    let asked = usage::language(&arguments).into_iter().chain([config.look.language]);
    let cli = match usage::parse(&arguments) {
        Ok(cli) => cli,
        Err(Refused::Fault(problem)) => {
            Style::of(false, asked).tell(text!("cli-error", problem));
            return Status::Bad.into();
        }
        Err(Refused::Parser(error)) => return refused(&error),
    };
    let style = Style { strict: cli.strict, ..Style::of(cli.ascii, asked) };
    match command(cli, (config, config_fault), style) {
        Ok(status) => status.into(),
        Err(Fault::File(FileError::Reader)) => ExitCode::SUCCESS,
        Err(fault) => {
            style.tell(fault.describe());
            fault.status().into()
        }
    }
}

#[cfg(test)]
pub(crate) fn program() -> clap::Command {
    program::command()
}

/// Help and version go to standard output, errors of usage to standard error.
fn refused(error: &clap::Error) -> ExitCode {
    let plain = error.render().to_string();
    if error.use_stderr() {
        // The parser's own printing has colors, but repeats words of the command line unescaped.
        if plain.chars().any(|c| c.is_control() && c != '\n') || error.print().is_err() {
            Style::of(false, []).tell(name(plain));
        }
        return Status::Bad.into();
    }
    match error.print().map_err(Fault::stdout) {
        Ok(()) | Err(Fault::File(FileError::Reader)) => ExitCode::SUCCESS,
        Err(fault) => {
            Style::of(false, []).tell(fault.describe());
            Status::Bad.into()
        }
    }
}

/// The configuration of the user, and why it is not used.
type Configured = (Config, Option<Fault>);

fn command(cli: Cli, configured: Configured, style: Style) -> Result<Status, Fault> {
    match cli.command {
        Some(Command::Analyze(args)) => analyze::run(&args, style),
        Some(Command::Check(args)) => analyze::check(&args, style),
        Some(Command::Explain(args)) => explain::run(&args, style),
        Some(Command::Chart(args)) => chart::run(&args, style),
        Some(Command::Stability(args)) => study::stability(&args, style),
        Some(Command::Geometry(args)) => study::geometry(&args, style),
        Some(Command::Shaking(args)) => study::shaking(&args, style),
        Some(Command::Structure(args)) => study::structure(&args, style),
        Some(Command::Report(args)) => draw::report(&args, cli.language.as_deref(), style),
        Some(Command::Sheet(args)) => sheet::sheet(&args, cli.language.as_deref(), style),
        Some(Command::Draw(args)) => draw::draw(&args, style),
        Some(Command::Sweep(args)) => sweep::run(&args, style),
        Some(Command::Set(args)) => set::run(&args, style),
        Some(Command::Import(args)) => import::run(&args, style),
        Some(Command::Keys(args)) => keys::run(&args, style),
        Some(Command::Plugins) => lists::plugins(style),
        Some(Command::Motors(args)) => lists::motors(&args, style),
        Some(Command::New { file: Some(file), kind }) => shell::new(&file, kind.as_deref()),
        Some(Command::New { file: None, .. }) => {
            on_screen(Cli { command: None, ..cli }, configured, style, Start::New)
        }
        Some(Command::Tour) => on_screen(Cli { command: None, ..cli }, configured, style, Start::Tour),
        Some(Command::Config) => config::print(style),
        Some(Command::Completions { shell }) => shell::completions(shell),
        Some(Command::Man) => shell::man(),
        None => scene_or_screen(cli, configured, style),
    }
}

/// `assur SCENE`: the terminal UI; if standard output is no terminal that can show it, the output of `analyze`.
fn scene_or_screen(cli: Cli, (config, config_fault): Configured, style: Style) -> Result<Status, Fault> {
    // A terminal that calls itself dumb can't move its cursor.
    let dumb = std::env::var_os("TERM").is_some_and(|name| name == "dumb");
    let on_input = cli.scene.as_deref().is_some_and(files::is_standard_input);
    let interactive = !dumb && !on_input && std::io::stdout().is_terminal() && std::io::stdin().is_terminal();
    let missing = cli.scene.as_deref().filter(|scene| !on_input && !scene.exists());
    // A single word may be meant as a command.
    let offer = missing.and_then(|word| usage::nearest_command(word.to_str()?));
    match (cli.scene, offer) {
        (Some(scene), Some(offer)) => {
            let missing = files::read(&scene).err().map(|error| error.describe()).unwrap_or_default();
            Err(Fault::Scene(text!("cli-offer-command", problem = missing, command = name(offer))))
        }
        (Some(scene), _) if !interactive => {
            let scene = SceneArgs { scene, methods: cli.methods };
            let checked = CheckedArgs { scene, ..CheckedArgs::default() };
            analyze::run(&AnalyzeArgs { checked, ..AnalyzeArgs::default() }, style)
        }
        (None, _) if !interactive => {
            style.tell(name(program::command().render_help().to_string()));
            Ok(Status::Bad)
        }
        (scene, _) => {
            let cli = Cli { scene, ..cli };
            on_screen(cli, (config, config_fault), style, Start::Scene)
        }
    }
}

/// The terminal UI.
fn on_screen(
    cli: Cli,
    (config, config_fault): Configured,
    style: Style,
    start: Start,
) -> Result<Status, Fault> {
    if !(std::io::stdout().is_terminal() && std::io::stdin().is_terminal()) {
        return Err(Fault::Scene(text!("cli-needs-a-terminal")));
    }
    let fault = config_fault.map(|fault| fault.describe());
    let (look, language, methods) = (cli.look, cli.language, cli.methods.into());
    let (ascii, config_fault, config_file) = (style.ascii, fault.clone(), config::file());
    let state_folder = screen::state_folder(|name| std::env::var_os(name).map(PathBuf::from));
    let options = screen::Options {
        ascii,
        look,
        language,
        methods,
        config,
        config_fault,
        state_folder,
        start,
        config_file,
    };
    let code = screen::run(cli.scene, options);
    if let Some(fault) = fault {
        style.tell(fault);
    }
    code.map(Status::Code).map_err(Fault::Scene)
}
