//! `assur new`.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use assur_fixtures::SCENES;
use assur_words::{text, text_of};

use super::fault::{Fault, Status};
use crate::files::FileError;

/// The mechanisms of which a scene can be written.
pub(crate) fn kinds() -> impl Iterator<Item = &'static str> {
    SCENES.iter().map(|(name, _)| *name)
}

pub(crate) fn run(path: &Path, kind: Option<&str>) -> Result<Status, Fault> {
    let scene =
        SCENES.iter().find(|(known, _)| Some(*known) == kind).map_or(assur_scene::STARTER, |(_, text)| text);
    let fault = |problem| FileError::refused(path, problem);
    let mut file = OpenOptions::new().write(true).create_new(true).open(path).map_err(|error| {
        fault(match error.kind() {
            ErrorKind::AlreadyExists => text!("file-exists"),
            _ => text_of(&error),
        })
    })?;
    if let Err(error) = file.write_all(scene.as_bytes()) {
        drop(file);
        // An incomplete scene is worse than none.
        let _ = std::fs::remove_file(path);
        return Err(fault(text_of(&error)).into());
    }
    Ok(Status::Done)
}
