//! The program `assur` with a group of class III more: `cargo run -- analyze eight-bar.toml`, `cargo run -- plugins`.

use std::process::ExitCode;

// Linking is what registers plugins: those of assur, and the one of this package.
use assur_all as _;
use own_program as _;

fn main() -> ExitCode {
    let program = assur_cli::cli::Program { name: env!("CARGO_PKG_NAME"), version: env!("CARGO_PKG_VERSION") };
    program.run(std::env::args_os())
}
