//! Writing results: to standard output, or beside the target and then renamed.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use assur_report::csv::CsvFile;
use tempfile::NamedTempFile;

use super::fault::Fault;

/// Prints to standard output.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(Fault::stdout)
}

/// Prints, or writes to a file.
pub(crate) fn print_or_write(text: &str, target: Option<&Path>) -> Result<(), Fault> {
    match target {
        None => print(text),
        Some(path) => write(path, text),
    }
}

/// Writes a file as a whole: a failure leaves what was there before.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Fault> {
    let content = content.as_ref();
    let fault = |error: io::Error| Fault::Write { path: path.to_owned(), problem: error.to_string() };
    if path.is_dir() {
        return Err(Fault::Write {
            path: path.to_owned(),
            problem: "it is a folder; name a file".to_owned(),
        });
    }
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        // A device or a pipe can't be replaced.
        return fs::OpenOptions::new()
            .write(true)
            .open(path)
            .and_then(|mut file| file.write_all(content))
            .map_err(
                |error| if error.kind() == io::ErrorKind::BrokenPipe { Fault::Reader } else { fault(error) },
            );
    }
    let path = resolved(path);
    beside(&path, content).and_then(|file| put(file, &path)).map_err(fault)
}

/// Writes CSV files into a folder: all of them, or none.
pub(crate) fn write_folder(folder: &Path, files: &[CsvFile]) -> Result<(), Fault> {
    let fault =
        |path: &Path, error: &io::Error| Fault::Write { path: path.to_owned(), problem: error.to_string() };
    if fs::metadata(folder).is_ok_and(|found| !found.is_dir()) {
        return Err(Fault::Write {
            path: folder.to_owned(),
            problem: "csv goes into a folder, and this is a file".into(),
        });
    }
    let created = !folder.exists();
    if created {
        fs::create_dir(folder).map_err(|error| fault(folder, &error))?;
    }
    // Renaming several files is no single act, so whatever can be known to fail is looked for first.
    for path in files.iter().map(|file| folder.join(file.name)) {
        replaceable(&path).map_err(|error| fault(&path, &error))?;
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
                return Err(fault(&path, &error));
            }
        }
    }
    written.into_iter().try_for_each(|(file, path)| put(file, &path).map_err(|error| fault(&path, &error)))
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
