//! Where the rows of a sweep go: they are collected beside the file until they are complete.

use std::path::{Path, PathBuf};

use crate::cli::fault::{Fault, Status};
use crate::cli::style::Style;
use crate::files::{self, FileError, Lock};

/// Form of the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Csv,
    Parquet,
}

/// The form, from the name of the file; known before anything is calculated.
pub(super) fn form(path: &Path) -> Result<Form, Fault> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let fault = |problem: String| FileError::write(path, problem).into();
    let form = match extension.as_deref() {
        // Whether the target is a device such as `/dev/null`.
        None | Some("csv") => Form::Csv,
        Some("parquet") => Form::Parquet,
        Some(_) => return Err(fault("name it *.csv or *.parquet".to_owned())),
    };
    if form == Form::Parquet && files::is_stream(path) {
        let problem =
            "Parquet is put together from parts, so it can't go to a device or a pipe; write it to a file";
        return Err(fault(problem.to_owned()));
    }
    match path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()) {
        Some(folder) => Err(fault(format!("there is no folder {}", folder.display()))),
        None => Ok(form),
    }
}

/// What is beside a file, `NAME.part`, until it is complete: rows that are calculated so far.
pub(super) struct Unfinished<'a> {
    /// The file.
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
            return Err(FileError::write(target, "it is a folder; name a file").into());
        }
        // Beside the file itself, not beside a link to it.
        let real = files::behind_links(target);
        let path = with_ending(&real, ".part");
        let lock = Lock::of(&with_ending(&path, ".lock"), target)?;
        if lock.is_none() {
            style.tell(&format!(
                "note: the file system of {} has no locks: start no second sweep that writes this file",
                target.display()
            ));
        }
        let unfinished = Self { target, path, real, _lock: lock };
        // A link counts too, wherever it leads.
        if unfinished.path.symlink_metadata().is_ok() && !resume {
            return Err(unfinished
                .fault("a sweep was ended here before it was complete: go on with --resume, or remove it"));
        }
        Ok(unfinished)
    }

    pub(super) fn fault(&self, problem: impl ToString) -> Fault {
        FileError::write(&self.path, problem).into()
    }

    /// What is here is not what the sweep would write.
    pub(super) fn foreign(&self, row: usize) -> Fault {
        self.fault(format!("row {row} is not of this sweep: remove it, or repeat the call that wrote it"))
    }

    /// Refuses to replace a file by rows some of which have no values.
    pub(super) fn refuse_partial(&self, status: Status) -> Result<(), Fault> {
        if status == Status::Done || !self.target.is_file() {
            return Ok(());
        }
        let problem = format!(
            "the results are incomplete, so the existing file is kept; the rows are in {}",
            self.path.display()
        );
        Err(Fault::Partial(FileError::write(self.target, problem), status))
    }

    /// Puts a complete file in the place of the target.
    pub(super) fn put(&self, complete: &Path) -> Result<(), Fault> {
        files::put(complete, &self.real).map_err(Fault::from)
    }
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    name.into()
}
