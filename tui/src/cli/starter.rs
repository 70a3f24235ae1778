//! `assur new`.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use super::fault::{Fault, Status};
use crate::files::FileError;

pub(crate) fn run(path: &Path) -> Result<Status, Fault> {
    let fault = |problem: String| FileError::write(path, problem);
    let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(|error| {
        fault(match error.kind() {
            ErrorKind::AlreadyExists => "it exists already; name a new file".to_owned(),
            _ => error.to_string(),
        })
    })?;
    if let Err(error) = file.write_all(assur_scene::STARTER.as_bytes()) {
        drop(file);
        // An incomplete scene is worse than none.
        let _ = std::fs::remove_file(path);
        return Err(fault(error.to_string()).into());
    }
    Ok(Status::Done)
}
