//! Writing results: to standard output or to a file.

use std::io::{self, Write};
use std::path::Path;

use super::fault::Fault;
use crate::files;

/// Prints to standard output.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Fault::stdout)
}

/// Prints, or writes to a file.
pub(crate) fn print_or_write(text: &str, target: Option<&Path>) -> Result<(), Fault> {
    match target {
        None => print(text),
        Some(path) => Ok(files::write(path, text)?),
    }
}
