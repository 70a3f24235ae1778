//! Devices, pipes and open streams: they are written to as they are, and never replaced.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

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
    is_special(path) || stream_of(path).is_some()
}

fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
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
