//! The program.

use std::process::ExitCode;

use assur_all as _;

fn main() -> ExitCode {
    assur::cli::run(std::env::args_os())
}
