//! Where the rows of a sweep go: they are collected beside the file until they are complete.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use assur_sweep::{Origin, difference};
use assur_words::{Text, name, number, text};

use crate::cli::fault::{Fault, Status};
use crate::cli::style::Style;
use crate::files::{self, FileError, Lock};

/// What the name of the file that says what rows of CSV are made of adds to theirs.
const ORIGIN: &str = ".origin.json";

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Csv,
    Parquet,
}

/// The form, from the name of the file; known before anything is calculated.
pub(super) fn form(path: &Path) -> Result<Form, Fault> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let fault = |problem| FileError::refused(path, problem).into();
    let form = match extension.as_deref() {
        // Whether the target is a device such as `/dev/null`.
        None | Some("csv") => Form::Csv,
        Some("parquet") => Form::Parquet,
        Some(_) => return Err(fault(text!("file-row-form"))),
    };
    if form == Form::Parquet && files::is_stream(path) {
        return Err(fault(text!("file-parquet-stream")));
    }
    let real = files::behind_links(path);
    match real.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()) {
        Some(folder) => Err(fault(text!("file-no-folder", folder = name(folder.display().to_string())))),
        None => Ok(form),
    }
}

/// What is beside a file, `NAME.part`, until it is complete: rows that are calculated so far.
pub(super) struct Unfinished<'a> {
    pub(super) target: &'a Path,
    /// What is beside it: a file, or a folder.
    pub(super) path: PathBuf,
    /// The file itself, where `target` is a link to it.
    real: PathBuf,
    /// Held until all is written.
    _lock: Option<Lock>,
}

impl<'a> Unfinished<'a> {
    /// Refuses what an earlier run left, unless this run goes on with it, and what another process is writing.
    pub(super) fn of(target: &'a Path, resume: bool, style: Style) -> Result<Self, Fault> {
        if target.is_dir() {
            return Err(FileError::refused(target, text!("file-name-a-file")).into());
        }
        // Beside the file itself, not beside a link to it.
        let real = files::behind_links(target);
        if real.is_symlink() {
            return Err(FileError::refused(target, text!("file-replaces-no-file")).into());
        }
        let path = with_ending(&real, ".part");
        let lock = Lock::of(&with_ending(&path, ".lock"), target)?;
        if lock.is_none() {
            style.tell(text!("cli-sweep-no-locks", file = name(target.display().to_string())));
        }
        let unfinished = Self { target, path, real, _lock: lock };
        // A link counts too, wherever it leads.
        if unfinished.path.symlink_metadata().is_ok() && !resume {
            return Err(unfinished.refused(text!("cli-sweep-ended")));
        }
        Ok(unfinished)
    }

    pub(super) fn fault(&self, problem: io::Error) -> Fault {
        FileError::write(&self.path, problem).into()
    }

    pub(super) fn refused(&self, problem: Text) -> Fault {
        FileError::refused(&self.path, problem).into()
    }

    /// Refuses rows that are made of something else than this sweep's.
    pub(super) fn compare(&self, found: &Origin, wanted: &Origin) -> Result<(), Fault> {
        let foreign = |difference| self.refused(text!("cli-sweep-other", difference));
        difference(found, wanted).map_or(Ok(()), |problem| Err(foreign(problem)))
    }

    /// Refuses rows of CSV of which an earlier run said beside them that they are of another sweep. What was not finished, or is
    /// of an earlier version, says nothing.
    pub(super) fn compare_said(&self, wanted: &Origin) -> Result<(), Fault> {
        let said = files::read(&with_ending(&self.path, ORIGIN)).ok();
        let found = said.and_then(|text| serde_json::from_str(&text).ok());
        found.map_or(Ok(()), |found| self.compare(&found, wanted))
    }

    /// Says beside rows of CSV what they are made of.
    pub(super) fn say(&self, origin: &Origin) -> Result<(), Fault> {
        let path = with_ending(&self.path, ORIGIN);
        let text = serde_json::to_string_pretty(origin).map_err(|problem| self.fault(problem.into()))?;
        let written = files::create_own(&path).and_then(|mut file| writeln!(file, "{text}"));
        written.map_err(|problem| FileError::write(&path, problem).into())
    }

    /// Refuses to go on where something else is in the place of what this sweep writes to.
    pub(super) fn keep(&self, opened: &File) -> Result<(), Fault> {
        if files::is_at(opened, &self.path) { Ok(()) } else { Err(self.refused(text!("file-replaced"))) }
    }

    /// What is here is not what the sweep would write.
    pub(super) fn foreign(&self, row: usize) -> Fault {
        self.refused(text!("cli-sweep-foreign", row = number(row)))
    }

    /// Refuses to replace a file by rows some of which have no values.
    pub(super) fn refuse_partial(&self, status: Status) -> Result<(), Fault> {
        if status == Status::Done || !self.target.is_file() {
            return Ok(());
        }
        let problem = text!("file-partial-rows", file = name(self.path.display().to_string()));
        Err(Fault::Partial(FileError::refused(self.target, problem), status))
    }

    /// Puts a complete file in the place of the target, and what is said of it beside it.
    pub(super) fn put(&self, complete: &Path) -> Result<(), Fault> {
        files::put(complete, &self.real)?;
        let said = with_ending(&self.path, ORIGIN);
        if said.exists() {
            files::put(&said, &with_ending(&self.real, ORIGIN))?;
        }
        Ok(())
    }

    /// Removes the rows of CSV and what is said of them.
    pub(super) fn remove(&self) -> Result<(), Fault> {
        let _ = std::fs::remove_file(with_ending(&self.path, ORIGIN));
        std::fs::remove_file(&self.path).map_err(|error| self.fault(error))
    }
}

/// Bytes that an earlier run left for this one to go on with.
pub(super) fn begun(target: &Path) -> u64 {
    let path = with_ending(&files::behind_links(target), ".part");
    let length = |path: &Path| path.metadata().map_or(0, |found| found.len());
    match path.read_dir() {
        Ok(parts) => parts.flatten().map(|part| length(&part.path())).sum(),
        Err(_) => length(&path),
    }
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    name.into()
}
