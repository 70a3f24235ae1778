//! What the program calls itself.

use std::ffi::OsString;
use std::process::ExitCode;
use std::sync::OnceLock;

use clap::CommandFactory;

use super::args::Cli;

/// Name and version of a program with this command line, as its help, version, completions and manual have them.
#[derive(Debug, Clone, Copy)]
pub struct Program {
    /// The name under which it is called.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
}

/// The program of this repository; behind its version stands the commit of which an optimized build was made.
const ASSUR: Program = Program { name: "assur", version: env!("ASSUR_VERSION") };

static OWN: OnceLock<Program> = OnceLock::new();

impl Program {
    /// Runs one command line under this name, as [`run`](super::run) does. The first call in a process gives the name.
    pub fn run(self, arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
        OWN.get_or_init(|| self);
        super::run(arguments)
    }
}

/// The program that runs.
pub(super) fn own() -> Program {
    *OWN.get().unwrap_or(&ASSUR)
}

/// The commands and options under the name of the program that runs.
pub(super) fn command() -> clap::Command {
    let Program { name, version } = own();
    Cli::command().name(name).bin_name(name).version(version)
}
