//! Errors of a command line that the argument parser can't explain: a first word is a scene or a command.

use std::error::Error;
use std::path::Path;

use assur_words::{Describe, Text, Told, name, text};
use clap::FromArgMatches;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::args::Cli;
use super::program;

/// What ends a command line before anything is done.
pub(crate) enum Refused {
    /// What is wrong, and what to write.
    Fault(Text),
    /// The parser's own: help and version too.
    Parser(clap::Error),
}

pub(crate) fn parse(arguments: &[std::ffi::OsString]) -> Result<Cli, Refused> {
    let cli = parsed(arguments).map_err(|error| match explained(arguments, &error) {
        Some(fault) => Refused::Fault(fault),
        None => Refused::Parser(error),
    })?;
    let program = program::command();
    let words = arguments.iter().skip(1).filter_map(|word| word.to_str());
    let command =
        words.filter(|_| cli.command.is_some()).find(|word| program.find_subcommand(word).is_some());
    match command.and_then(|command| misplaced(&cli, command)) {
        Some(fault) => Err(Refused::Fault(fault)),
        None => Ok(cli),
    }
}

fn parsed(arguments: &[std::ffi::OsString]) -> Result<Cli, clap::Error> {
    let mut command = program::command();
    let matches = command.try_get_matches_from_mut(arguments)?;
    Cli::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
}

/// The language that a command line names, whether or not the rest of it can be read.
pub(crate) fn language(arguments: &[std::ffi::OsString]) -> Option<&str> {
    let words: Vec<&str> = arguments.iter().filter_map(|word| word.to_str()).collect();
    let after = words.iter().position(|word| *word == "--language").and_then(|at| words.get(at + 1).copied());
    after.or_else(|| words.iter().find_map(|word| word.strip_prefix("--language=")))
}

/// The error in words that say what to write, if the order or the spelling of the words is wrong; `None`: the parser's will do.
fn explained(arguments: &[std::ffi::OsString], error: &clap::Error) -> Option<Text> {
    let program = program::command();
    let words: Vec<&str> = arguments.iter().skip(1).filter_map(|word| word.to_str()).collect();
    let command_at = words.iter().position(|word| program.find_subcommand(word).is_some());
    let before = &words[..command_at.unwrap_or(words.len())];
    let command = command_at.map(|at| words[at]);
    let is_file = |word: &&&str| !word.starts_with('-') && Path::new(word).exists();
    match (error.kind(), error.get(ContextKind::InvalidArg)) {
        (ErrorKind::ValueValidation, Some(ContextValue::String(option))) => {
            let problem = error.source()?.downcast_ref::<Told>()?.describe();
            let Some(ContextValue::String(value)) = error.get(ContextKind::InvalidValue) else { return None };
            // The parser adds the name of the value.
            let option = option.split(' ').next().unwrap_or_default().to_owned();
            let (option, value) = (name(option), name(value.clone()));
            Some(text!("cli-value", option, value, problem))
        }
        (ErrorKind::UnknownArgument, Some(ContextValue::String(option)))
            if option.starts_with('-')
                && before.iter().any(|word| word.starts_with(option.as_str()))
                && words.first().is_some_and(|word| word.starts_with('-') || is_file(&word)) =>
        {
            let owner = owner(&program, option, command)?;
            Some(text!("cli-option-of-command", option = name(option.clone()), command = name(owner)))
        }
        (ErrorKind::UnknownArgument | ErrorKind::InvalidSubcommand, _) => {
            let first = words.iter().find(|word| !word.starts_with('-'));
            let word = first.filter(|word| !is_file(word) && command != Some(**word))?;
            let offer = nearest_command(word).map_or_else(
                || text!("cli-help-lists"),
                |command| text!("cli-offer", command = name(command)),
            );
            Some(text!("cli-unknown-word", word = name((*word).to_owned()), offer))
        }
        (ErrorKind::MissingRequiredArgument, _) => {
            before.iter().find(is_file).zip(command).map(|(scene, command)| behind(scene, command))
        }
        _ => None,
    }
}

/// The command that has an option: the one that is named, if it has it.
fn owner(program: &clap::Command, option: &str, command: Option<&str>) -> Option<String> {
    let takes = |of: &&clap::Command| {
        let names = |arg: &clap::Arg| {
            let short = arg.get_short().map(|short| format!("-{short}"));
            [short, arg.get_long().map(|long| format!("--{long}"))]
        };
        of.get_arguments().flat_map(names).flatten().any(|name| name == option)
    };
    let found = match command {
        Some(name) => program.find_subcommand(name).filter(takes),
        None => program.get_subcommands().find(takes),
    };
    found.map(|command| command.get_name().to_owned())
}

fn behind(scene: &str, command: &str) -> Text {
    let [scene, command] = [scene, command].map(|word| name(word.to_owned()));
    text!("cli-scene-first", scene, command)
}

const OTHER_NAMES: &[(&str, &str)] = &[
    ("plot", "draw"),
    ("graph", "draw"),
    ("show", "draw"),
    ("run", "analyze"),
    ("solve", "analyze"),
    ("calculate", "analyze"),
    ("simulate", "analyze"),
    ("validate", "check"),
    ("verify", "check"),
    ("optimize", "sweep"),
    ("export", "report"),
    ("init", "new"),
];

/// The command that is meant by `word`: by another name of it, or by nearly the same spelling.
pub(crate) fn nearest_command(word: &str) -> Option<String> {
    if let Some((_, command)) = OTHER_NAMES.iter().find(|(other, _)| *other == word) {
        return Some((*command).to_owned());
    }
    let program = program::command();
    let near = assur_scene::nearest(word, program.get_subcommands().map(clap::Command::get_name));
    near.filter(|near| *near != word).map(str::to_owned)
}

/// Options of the terminal UI, or methods, before a command would be ignored without a message.
fn misplaced(cli: &Cli, command: &str) -> Option<Text> {
    let before = [
        ("--analyzer", cli.methods.analyzer.is_some()),
        ("--integrator", cli.methods.integrator.is_some()),
        ("--mouse", cli.look.mouse),
        ("--fps", cli.look.fps.is_some()),
        ("--cell-ratio", cli.look.cell_ratio.is_some()),
    ];
    if let Some((option, _)) = before.iter().find(|(_, given)| *given) {
        let is_method = matches!(*option, "--analyzer" | "--integrator");
        let id = if is_method { "cli-option-first" } else { "cli-option-of-screen" };
        return Some(text!(id, option = name(*option), command = name(command.to_owned())));
    }
    Some(behind(&cli.scene.as_ref()?.display().to_string(), command))
}
