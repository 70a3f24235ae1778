//! Writing results: to standard output, to a file, or into a folder.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use assur_words::text;
use tempfile::NamedTempFile;

use super::fault::{Fault, Status};
use crate::files::{self, FileError};

pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Fault::stdout)
}

pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// The target of the results of a command; `None` is standard output.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Output<'a> {
    target: Option<&'a Path>,
    scene: &'a Path,
}

impl<'a> Output<'a> {
    /// Rejects a target that is the scene itself, before anything is calculated.
    pub(crate) fn of(target: Option<&'a Path>, scene: &'a Path) -> Result<Self, Fault> {
        let target = target.filter(|path| !is_standard(path));
        let output = Self { target, scene };
        target.map_or(Ok(()), |path| output.refuse_scene(path)).map(|()| output)
    }

    fn refuse_scene(&self, path: &Path) -> Result<(), Fault> {
        if files::is_same(path, self.scene) {
            return Err(FileError::refused(path, text!("file-is-scene")).into());
        }
        Ok(())
    }

    /// Writes one text or file, and ends with this status; results of a command that fails never replace a file.
    pub(crate) fn write(self, content: impl AsRef<[u8]>, status: Status) -> Result<Status, Fault> {
        self.write_by(status, |out| out.write_all(content.as_ref()))
    }

    /// Writes one text or file by a function; results of a command that fails never replace a file.
    pub(crate) fn write_by(
        self,
        status: Status,
        fill: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
    ) -> Result<Status, Fault> {
        if let Some(path) = self.target {
            refuse_partial(path, status)?;
            files::remove_on_signals();
            files::write_by(path, fill)?;
        } else {
            let mut stdout = io::stdout();
            fill(&mut stdout).and_then(|()| stdout.flush()).map_err(Fault::stdout)?;
        }
        Ok(status)
    }

    /// Writes some of all possible files into the folder by a function; results of a command that fails never replace
    /// those of an earlier run.
    pub(crate) fn write_folder(
        self,
        status: Status,
        all: &[&str],
        names: &[&str],
        fill: impl FnOnce(&mut [BufWriter<&mut NamedTempFile>]) -> io::Result<()>,
    ) -> Result<Status, Fault> {
        let Some(folder) = self.target else {
            return Err(Fault::Other(text!("cli-csv-folder")));
        };
        for name in all {
            let path = folder.join(name);
            self.refuse_scene(&path)?;
            refuse_partial(&path, status)?;
        }
        files::remove_on_signals();
        files::write_folder(folder, all, names, fill)?;
        Ok(status)
    }
}

fn refuse_partial(path: &Path, status: Status) -> Result<(), Fault> {
    if status != Status::Done && path.is_file() && !files::is_stream(path) {
        return Err(Fault::Partial(FileError::refused(path, text!("file-partial")), status));
    }
    Ok(())
}
