//! Files of the user: read with the place of what is wrong, written as a whole or not at all.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use assur_mechanism::{Mechanism, Motion};
use assur_report::csv::CsvFile;
use assur_scene::{SceneErrors, document};
use assur_structure::StructureError;
use tempfile::NamedTempFile;

/// Why a file is not read or written.
#[derive(Debug, thiserror::Error)]
pub(crate) enum FileError {
    /// A file can't be read.
    #[error("error: {}: {problem}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// A file can't be written; what was there is untouched.
    #[error("error: can't write {}: {problem}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// The reader of a pipe has gone.
    #[error("the reader of the output has gone")]
    Reader,
}

impl FileError {
    pub(crate) fn read(path: &Path, problem: impl ToString) -> Self {
        Self::Read { path: path.to_owned(), problem: problem.to_string() }
    }

    pub(crate) fn write(path: &Path, problem: impl ToString) -> Self {
        Self::Write { path: path.to_owned(), problem: problem.to_string() }
    }
}

/// The text of a scene or a configuration.
pub(crate) fn read(path: &Path) -> Result<String, FileError> {
    let error = |problem: String| FileError::read(path, problem);
    if path.is_dir() {
        return Err(error("is a folder, not a scene file".to_owned()));
    }
    let most = document::MOST_BYTES;
    let mut bytes = Vec::new();
    // A device has no size, and may have no end.
    let found = fs::File::open(path).and_then(|file| file.take(most as u64 + 1).read_to_end(&mut bytes));
    found.map_err(|problem| match problem.kind() {
        io::ErrorKind::NotFound => {
            error("there is no such file (`assur new FILE` writes a scene to begin with)".to_owned())
        }
        _ => error(format!("can't be read: {problem}")),
    })?;
    if bytes.len() > most {
        return Err(error(format!("is larger than {} MiB: is it the right file?", most >> 20)));
    }
    String::from_utf8(bytes).map_err(|problem| {
        let at = problem.utf8_error().valid_up_to();
        let line = problem.as_bytes()[..at].split(|byte| *byte == b'\n').count();
        error(format!("is not UTF-8 text (byte {at}, line {line}); save it as UTF-8"))
    })
}

/// A fault of the structure at its line of the scene, where it concerns a link.
pub(crate) fn located(name: &str, text: &str, error: &StructureError) -> Option<SceneErrors> {
    assur_scene::fault_at(name, text, &["link", error.link()?], &error.to_string())
}

/// An integrator of a scene that is not registered, at its line.
pub(crate) fn integrator_fault(name: &str, text: &str, mechanism: &Mechanism) -> Option<SceneErrors> {
    let Some(Motion::Transient { integrator, .. }) = &mechanism.motion else { return None };
    let error = assur_integrator::find(integrator).err().filter(|_| integrator != "auto")?;
    assur_scene::fault_at(name, text, &["motion", "integrator"], &error.to_string())
}

/// Writes a file as a whole: a failure leaves what was there before.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), FileError> {
    let content = content.as_ref();
    if path.is_dir() {
        return Err(FileError::write(path, "it is a folder; name a file"));
    }
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        // A device or a pipe can't be replaced.
        return fs::OpenOptions::new()
            .write(true)
            .open(path)
            .and_then(|mut file| file.write_all(content))
            .map_err(|error| match error.kind() {
                io::ErrorKind::BrokenPipe => FileError::Reader,
                _ => FileError::write(path, error),
            });
    }
    let path = resolved(path);
    beside(&path, content).and_then(|file| put(file, &path)).map_err(|error| FileError::write(&path, error))
}

/// Writes CSV files into a folder: all of them, or none.
pub(crate) fn write_folder(folder: &Path, files: &[CsvFile]) -> Result<(), FileError> {
    if fs::metadata(folder).is_ok_and(|found| !found.is_dir()) {
        return Err(FileError::write(folder, "csv goes into a folder, and this is a file"));
    }
    let created = !folder.exists();
    if created {
        fs::create_dir(folder).map_err(|error| FileError::write(folder, error))?;
    }
    // Renaming several files is no single act, so whatever can be known to fail is looked for first.
    for path in files.iter().map(|file| folder.join(file.name)) {
        replaceable(&path).map_err(|error| FileError::write(&path, error))?;
    }
    let mut written = Vec::with_capacity(files.len());
    for file in files {
        let path = resolved(&folder.join(file.name));
        match beside(&path, file.text.as_bytes()) {
            Ok(temporary) => written.push((temporary, path)),
            Err(error) => {
                drop(written);
                if created {
                    let _ = fs::remove_dir(folder);
                }
                return Err(FileError::write(&path, error));
            }
        }
    }
    written
        .into_iter()
        .try_for_each(|(file, path)| put(file, &path).map_err(|error| FileError::write(&path, error)))
}

/// The file behind a symbolic link, so that the link stays.
fn resolved(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

/// A temporary file in the folder of the target, with the content; it vanishes unless it is put in place.
fn beside(path: &Path, content: &[u8]) -> io::Result<NamedTempFile> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        let missing = format!("there is no folder {}", folder.display());
        return Err(io::Error::new(io::ErrorKind::NotFound, missing));
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".assur-");
    #[cfg(unix)]
    let builder = {
        use std::os::unix::fs::PermissionsExt;
        // The umask takes its part, as for any new file.
        builder.permissions(fs::Permissions::from_mode(0o666))
    };
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(content)?;
    file.as_file().sync_all()?;
    Ok(file)
}

/// Refuses a target that can't be replaced by a file.
fn replaceable(path: &Path) -> io::Result<()> {
    let Ok(old) = fs::metadata(path) else { return Ok(()) };
    if !old.is_file() {
        return Err(io::Error::new(io::ErrorKind::AlreadyExists, "what is there is not a file"));
    }
    if old.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file that is there is read-only"));
    }
    Ok(())
}

/// Renames to the target, keeping the permissions of a file that is replaced.
fn put(file: NamedTempFile, path: &Path) -> io::Result<()> {
    replaceable(path)?;
    if let Ok(old) = fs::metadata(path) {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.persist(path).map(drop).map_err(|error| error.error)
}
