//! What is wrong with a command line, where the argument parser can't tell: a first word is a scene or a command.

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};

use super::args::{Cli, Command};

/// The command line, or what to print and with which kind of end.
pub(crate) fn parse(arguments: &[std::ffi::OsString]) -> Result<Cli, clap::Error> {
    let cli = Cli::try_parse_from(arguments).map_err(|error| misspelled(arguments, error))?;
    match &cli.command {
        Some(command) => misplaced(&cli, command).map_or(Ok(()), Err),
        None => Ok(()),
    }?;
    Ok(cli)
}

/// Where the first word is neither a file nor a command, but spelled nearly as one, that is what is wrong.
fn misspelled(arguments: &[std::ffi::OsString], error: clap::Error) -> clap::Error {
    if !matches!(error.kind(), ErrorKind::UnknownArgument | ErrorKind::InvalidSubcommand) {
        return error;
    }
    let words = arguments.iter().skip(1).filter_map(|word| word.to_str());
    let first = words.filter(|word| !word.starts_with('-')).find(|word| !std::path::Path::new(word).exists());
    match first.and_then(|word| Some((word, nearest_command(word)?))) {
        Some((word, command)) => fault(&format!(
            "there is neither a command nor a scene file `{word}`; did you mean `assur {command}`?"
        )),
        None => error,
    }
}

/// The command that is spelled nearly as `word`: not more than two letters away.
pub(crate) fn nearest_command(word: &str) -> Option<String> {
    let program = Cli::command();
    let names = program.get_subcommands().map(|command| command.get_name().to_owned());
    let near = names.map(|name| (strsim::damerau_levenshtein(word, &name), name)).min()?;
    (near.0 <= 2 && near.0 < near.1.len() && near.1 != word).then_some(near.1)
}

/// Options of the terminal UI, or methods, that stand before a command would be lost without a word.
fn misplaced(cli: &Cli, command: &Command) -> Option<clap::Error> {
    let before = [
        ("--analyzer", cli.methods.analyzer.is_some()),
        ("--integrator", cli.methods.integrator.is_some()),
        ("--mouse", cli.mouse),
        ("--fps", cli.fps.is_some()),
        ("--cell-ratio", cli.cell_ratio.is_some()),
    ];
    let name = command.name();
    let lost = before.iter().find(|(_, given)| *given);
    if let Some((option @ ("--analyzer" | "--integrator"), _)) = lost {
        return Some(fault(&format!(
            "`{option}` stands before the command `{name}`, where it says nothing to it; write it behind: `assur {name} ... {option} NAME`"
        )));
    }
    if let Some((option, _)) = lost {
        return Some(fault(&format!(
            "`{option}` is for the terminal UI (`assur SCENE`); `{name}` has no use for it"
        )));
    }
    let scene = cli.scene.as_ref()?;
    let scene = scene.display();
    Some(fault(&format!(
        "`{scene}` stands before the command `{name}`; write it behind: `assur {name} {scene}`"
    )))
}

fn fault(message: &str) -> clap::Error {
    Cli::command().error(ErrorKind::InvalidSubcommand, message)
}
