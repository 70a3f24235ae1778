//! One writer a file: a lock beside what is written over some time, and files beside a target that are our own.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use assur_words::{Text, Told, name, text};

use super::FileError;

/// What the text of a lock begins with: a file with another text belongs to somebody else.
const MARK: &str = "assur";

const LONGEST: u64 = 200;

/// How often a file is opened again that is removed or replaced at the same moment.
const MOST_TRIES: usize = 100;

/// The right to write: while it lives, no other process gets it.
///
/// The operating system holds the lock and releases it when the process ends, by whatever means; a file that a killed
/// process leaves is taken over by the next one. The file is removed by whoever holds the lock, so a lock counts only
/// if its file still is where its path leads.
#[derive(Debug)]
pub(crate) struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    /// The lock for writing `target`, in a file at `path`; `None` where the file system has no locks.
    pub(crate) fn of(path: &Path, target: &Path) -> Result<Option<Self>, FileError> {
        Self::by(path, target, File::try_lock)
    }

    /// As [`Lock::of`], but waits until the other process has ended: for what takes a moment.
    pub(super) fn wait(path: &Path, target: &Path) -> Result<Option<Self>, FileError> {
        Self::by(path, target, |file| file.lock().map_err(TryLockError::Error))
    }

    fn by(
        path: &Path,
        target: &Path,
        lock: impl Fn(&File) -> Result<(), TryLockError>,
    ) -> Result<Option<Self>, FileError> {
        let fault = |error: io::Error| FileError::write(path, error);
        for _ in 0..MOST_TRIES {
            let mut file = open_own(path).map_err(fault)?;
            let text = text_of(&mut file).map_err(fault)?;
            if !text.is_empty() && !text.starts_with(MARK) {
                return Err(FileError::refused(path, text!("file-not-our-lock")));
            }
            match lock(&file) {
                Ok(()) if is_at(&file, path) => {
                    sign(&mut file).map_err(fault)?;
                    return Ok(Some(Self { path: path.to_owned(), _file: file }));
                }
                // Whoever held it has removed it in between.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(FileError::refused(target, told(&text, path))),
                Err(TryLockError::Error(_)) => {
                    let _ = fs::remove_file(path);
                    return Ok(None);
                }
            }
        }
        Err(FileError::refused(target, told("", path)))
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Still locked: whoever has opened the file gets a lock that does not count.
        let _ = fs::remove_file(&self.path);
    }
}

fn text_of(file: &mut File) -> io::Result<String> {
    let mut bytes = Vec::new();
    file.take(LONGEST).read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).lines().next().unwrap_or_default().to_owned())
}

fn sign(file: &mut File) -> io::Result<()> {
    let host = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    let of = if host.trim().is_empty() { String::new() } else { format!(" of {}", host.trim()) };
    let text = format!("{MARK}, process {}{of}\n", std::process::id());
    file.rewind()?;
    file.write_all(text.as_bytes())?;
    file.set_len(text.len() as u64)
}

/// Who writes, from the text of a lock.
fn told(text: &str, path: &Path) -> Text {
    let writer = text.strip_prefix(MARK).map(|rest| rest.trim_start_matches([',', ' ']));
    let writer = writer.filter(|writer| !writer.is_empty());
    let writer = writer.map_or_else(|| text!("file-another-process"), |writer| name(writer.to_owned()));
    text!("file-locked", writer, lock = name(path.display().to_string()))
}

/// Opens a file of our own beside a target, or creates it: a regular file with one name. What a link points to is
/// neither opened nor created.
///
/// # Errors
///
/// Something else is there, or the file can't be opened.
pub(crate) fn open_own(path: &Path) -> io::Result<File> {
    for _ in 0..MOST_TRIES {
        // Creates nothing through a link, not even through a dangling one.
        match OpenOptions::new().read(true).write(true).create_new(true).open(path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            created => return created,
        }
        let opened = check_own(path).and_then(|()| OpenOptions::new().read(true).write(true).open(path));
        match opened {
            Ok(file) if is_at(&file, path) => return Ok(file),
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            // Removed or replaced in between.
            _ => {}
        }
    }
    Err(io::Error::other(Told(text!("file-comes-and-goes"))))
}

/// An empty file of our own in the place of an old one; a link there is removed, and what it points to is left.
///
/// # Errors
///
/// The old file can't be removed, or the new one not created.
pub(crate) fn create_own(path: &Path) -> io::Result<File> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        _ => {}
    }
    OpenOptions::new().write(true).create_new(true).open(path)
}

/// Refuses what is no regular file with one name.
fn check_own(path: &Path) -> io::Result<()> {
    let found = fs::symlink_metadata(path)?;
    let problem = if found.is_file() && found.nlink() <= 1 {
        return Ok(());
    } else if found.is_symlink() {
        text!("file-is-link")
    } else if found.is_file() {
        text!("file-has-names")
    } else {
        text!("file-is-no-file")
    };
    Err(io::Error::new(io::ErrorKind::AlreadyExists, Told(problem)))
}

/// Whether an open file is still the one to which its path leads, not through a link.
pub(crate) fn is_at(file: &File, path: &Path) -> bool {
    let (Ok(open), Ok(there)) = (file.metadata(), fs::symlink_metadata(path)) else { return false };
    (open.dev(), open.ino()) == (there.dev(), there.ino())
}
