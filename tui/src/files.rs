//! Files of the user: errors of reading name the place; writing is complete or not done at all. Devices, pipes and open streams are
//! written to as they are, and never replaced.

mod lock;
mod write;

use std::fs::{self, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use assur_scene::document;
use assur_words::{Describe, Text, errors, name, number, quantity, text, text_of};

use crate::lock;

pub(crate) use lock::{Lock, create_own, is_at, open_own};
pub(crate) use write::{
    behind_links, create, ignore_limit, is_same, put, remove_on_signals, remove_temporaries, write, write_by,
    write_folder,
};

pub(crate) enum FileError {
    /// A file can't be read, and why.
    Read(PathBuf, Text),
    /// A file can't be written, and why; the old content is untouched.
    Write(PathBuf, Text),
    /// The reader of a pipe has closed it.
    Reader,
}

impl Describe for FileError {
    fn describe(&self) -> Text {
        let file = |path: &Path| name(shown(path));
        match self {
            Self::Read(path, problem) => text!("cli-error-in", file = file(path), problem),
            Self::Write(path, problem) => text!("file-not-written", file = file(path), problem),
            Self::Reader => text!("file-reader-gone"),
        }
    }
}

errors!(FileError);

impl FileError {
    pub(crate) fn read(path: &Path, problem: Text) -> Self {
        Self::Read(path.to_owned(), problem)
    }

    pub(crate) fn refused(path: &Path, problem: Text) -> Self {
        Self::Write(path.to_owned(), problem)
    }

    /// A file that can't be written, as whoever tried it says.
    #[expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]
    pub(crate) fn write(path: &Path, problem: io::Error) -> Self {
        Self::refused(path, text_of(&problem))
    }
}

/// Bytes that the file system of a file to be written has free for this user; `None` where it does not say.
pub(crate) fn free_beside(file: &Path) -> Option<u64> {
    let real = behind_links(file);
    let folder = real.parent().filter(|folder| !folder.as_os_str().is_empty());
    let found = rustix::fs::statvfs(folder.unwrap_or(Path::new("."))).ok()?;
    found.f_bavail.checked_mul(found.f_frsize)
}

/// What is written in place of a file for standard input.
const STANDARD_INPUT: &str = "-";

/// Whether a path means standard input.
pub(crate) fn is_standard_input(path: &Path) -> bool {
    path == Path::new(STANDARD_INPUT)
}

/// A file as messages name it.
pub(crate) fn shown(path: &Path) -> String {
    if is_standard_input(path) { "<stdin>".to_owned() } else { path.display().to_string() }
}

/// The content of a file or of standard input, whatever it is; its size has a limit. Standard input has one end, so it is kept.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    static INPUT: Mutex<Option<Vec<u8>>> = Mutex::new(None);
    if !is_standard_input(path) {
        return read_all(path, || fs::File::open(path));
    }
    let mut kept = lock(&INPUT);
    if let Some(bytes) = &*kept {
        return Ok(bytes.clone());
    }
    let bytes = read_all(path, || Ok(io::stdin()))?;
    *kept = Some(bytes.clone());
    Ok(bytes)
}

fn read_all<R: Read>(path: &Path, open: impl FnOnce() -> io::Result<R>) -> Result<Vec<u8>, FileError> {
    let error = |problem: Text| FileError::read(path, problem);
    if path.is_dir() {
        return Err(error(text!("file-is-folder")));
    }
    let most = document::MOST_BYTES;
    let mut bytes = Vec::new();
    // A device has no size, and may have no end.
    let found = open().and_then(|file| file.take(most as u64 + 1).read_to_end(&mut bytes));
    found.map_err(|problem| match problem.kind() {
        io::ErrorKind::NotFound => error(text!("file-missing")),
        _ => error(text!("file-not-read", problem = text_of(&problem))),
    })?;
    if bytes.len() > most {
        return Err(error(text!("file-too-large", most = quantity(most >> 20, "MiB"))));
    }
    Ok(bytes)
}

pub(crate) fn read(path: &Path) -> Result<String, FileError> {
    let error = |problem: Text| FileError::read(path, problem);
    String::from_utf8(read_bytes(path)?).map_err(|problem| {
        let (read, rest) = problem.as_bytes().split_at(problem.utf8_error().valid_up_to());
        let before = String::from_utf8_lossy(read);
        // A byte order mark does not belong to the first line.
        let before = before.trim_start_matches('\u{feff}');
        let line = before.split('\n').count();
        let column = before.rsplit('\n').next().map_or(0, |line| line.chars().count()) + 1;
        let byte = rest
            .first()
            .map_or_else(Text::default, |byte| text!("file-byte", byte = name(format!("0x{byte:02X}"))));
        error(text!("file-not-utf8", line = number(line), column = number(column), byte))
    })
}

/// Most symbolic links that are followed; a longer chain is taken for a loop.
const MOST_LINKS: usize = 40;

/// A device, a pipe or an open stream, to be written to as it is; `None` where a path means a file.
pub(crate) fn open_stream(path: &Path) -> Option<io::Result<Box<dyn Write + Send>>> {
    if !is_stream(path) {
        return None;
    }
    if is_standard_output(path) {
        return Some(Ok(Box::new(io::stdout())));
    }
    Some(OpenOptions::new().append(true).open(path).map(|file| Box::new(file) as Box<dyn Write + Send>))
}

/// Whether a path means a device, a pipe or an open stream such as `/dev/stdout`, even if the stream is a regular file;
/// also through links.
pub(crate) fn is_stream(path: &Path) -> bool {
    let is_special = fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir());
    is_special || stream_of(path).is_some()
}

/// The open stream that a path means, also through links.
fn stream_of(path: &Path) -> Option<PathBuf> {
    let mut path = std::path::absolute(path).ok()?;
    for _ in 0..MOST_LINKS {
        let is_open =
            path.starts_with("/dev/fd") || (path.starts_with("/proc") && path.parent()?.ends_with("fd"));
        if is_open || ["/dev/stdout", "/dev/stderr", "/dev/stdin"].iter().any(|name| path == Path::new(name))
        {
            return Some(path);
        }
        path = path.parent()?.join(fs::read_link(&path).ok()?);
    }
    None
}

fn is_standard_output(path: &Path) -> bool {
    let names = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].map(Path::new);
    stream_of(path).is_some_and(|stream| names.contains(&stream.as_path()))
}
