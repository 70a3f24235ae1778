//! The program.

use std::process::ExitCode;

use assur::screen::{Options, run};
use assur_all as _;

fn main() -> ExitCode {
    let path = std::env::args_os().nth(1).map(Into::into);
    match run(path, Options::default()) {
        Ok(status) => ExitCode::from(status),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}
