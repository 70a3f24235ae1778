//! The program.

use std::process::ExitCode;

use assur_all as _;

/// The allocator of musl takes a lock for each call: with it a sweep by several threads takes a quarter longer.
#[cfg(target_env = "musl")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    assur_cli::cli::run(std::env::args_os())
}
