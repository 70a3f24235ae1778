//! Errors of a command line that the argument parser can't explain: a first word is a scene or a command.

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Parser};

use super::args::Cli;

/// The command line, or the text to print and the kind of exit.
pub(crate) fn parse(arguments: &[std::ffi::OsString]) -> Result<Cli, clap::Error> {
    let cli = Cli::try_parse_from(arguments).map_err(|error| explained(arguments, error))?;
    let program = Cli::command();
    let words = arguments.iter().skip(1).filter_map(|word| word.to_str());
    let command =
        words.filter(|_| cli.command.is_some()).find(|word| program.find_subcommand(word).is_some());
    command.and_then(|command| misplaced(&cli, command)).map_or(Ok(cli), Err)
}

/// The error in words that say what to write, if the order or the spelling of the words is wrong; else the parser's.
fn explained(arguments: &[std::ffi::OsString], error: clap::Error) -> clap::Error {
    let program = Cli::command();
    let words: Vec<&str> = arguments.iter().skip(1).filter_map(|word| word.to_str()).collect();
    let command_at = words.iter().position(|word| program.find_subcommand(word).is_some());
    let before = &words[..command_at.unwrap_or(words.len())];
    let command = command_at.map(|at| words[at]);
    let is_file = |word: &&&str| !word.starts_with('-') && Path::new(word).exists();
    let message = match (error.kind(), error.get(ContextKind::InvalidArg)) {
        (ErrorKind::UnknownArgument, Some(ContextValue::String(option)))
            if option.starts_with('-')
                && before.iter().any(|word| word.starts_with(option.as_str()))
                && words.first().is_some_and(|word| word.starts_with('-') || is_file(&word)) =>
        {
            let takes = |of: &&clap::Command| {
                let names = |arg: &clap::Arg| {
                    let short = arg.get_short().map(|short| format!("-{short}"));
                    [short, arg.get_long().map(|long| format!("--{long}"))]
                };
                of.get_arguments().flat_map(names).flatten().any(|name| name == *option)
            };
            let known = |name: &str| program.find_subcommand(name).filter(takes).map(clap::Command::get_name);
            let owner = match command {
                Some(name) => known(name),
                None => program.get_subcommands().find(takes).map(clap::Command::get_name),
            };
            owner.map(|owner| {
                format!(
                    "`{option}` belongs to a command and must follow it: `assur {owner} SCENE {option} ...`"
                )
            })
        }
        (ErrorKind::UnknownArgument | ErrorKind::InvalidSubcommand, _) => {
            let first = words.iter().find(|word| !word.starts_with('-'));
            first.filter(|word| !is_file(word) && command != Some(**word)).map(|word| {
                let offer = nearest_command(word).map_or_else(
                    || "`assur --help` lists the commands".to_owned(),
                    |command| format!("did you mean `assur {command}`?"),
                );
                format!("there is neither a command nor a scene file `{word}`; {offer}")
            })
        }
        (ErrorKind::MissingRequiredArgument, _) => before.iter().find(is_file).zip(command).map(behind),
        _ => None,
    };
    message.map_or(error, |message| fault(&message))
}

/// The error that a scene precedes the command.
fn behind((scene, command): (&&str, &str)) -> String {
    format!("`{scene}` stands before the command `{command}`; write it behind: `assur {command} {scene}`")
}

/// The command whose spelling is near to `word`: at most two letters away.
pub(crate) fn nearest_command(word: &str) -> Option<String> {
    let program = Cli::command();
    let names = program.get_subcommands().map(|command| command.get_name().to_owned());
    let near = names.map(|name| (strsim::damerau_levenshtein(word, &name), name)).min()?;
    (near.0 <= 2 && near.0 < near.1.len() && near.1 != word).then_some(near.1)
}

/// Options of the terminal UI, or methods, before a command would be ignored without a message.
fn misplaced(cli: &Cli, name: &str) -> Option<clap::Error> {
    let before = [
        ("--analyzer", cli.methods.analyzer.is_some()),
        ("--integrator", cli.methods.integrator.is_some()),
        ("--mouse", cli.look.mouse),
        ("--fps", cli.look.fps.is_some()),
        ("--cell-ratio", cli.look.cell_ratio.is_some()),
    ];
    let lost = before.iter().find(|(_, given)| *given);
    if let Some((option @ ("--analyzer" | "--integrator"), _)) = lost {
        return Some(fault(&format!(
            "`{option}` stands before the command `{name}`, where it has no effect; write it behind: `assur {name} ... {option} NAME`"
        )));
    }
    if let Some((option, _)) = lost {
        return Some(fault(&format!(
            "`{option}` is for the terminal UI (`assur SCENE`); `{name}` has no use for it"
        )));
    }
    let scene = cli.scene.as_ref()?.display().to_string();
    Some(fault(&behind((&scene.as_str(), name))))
}

fn fault(message: &str) -> clap::Error {
    Cli::command().error(ErrorKind::InvalidSubcommand, message)
}
