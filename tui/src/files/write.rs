//! Writing files: new content is first written completely to a temporary file next to the target, which then replaces
//! it.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufWriter, Write};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};

use assur_words::{Told, name, text};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
use signal_hook::iterator::Signals;
use tempfile::NamedTempFile;

use super::lock::Lock;
use super::{FileError, MOST_LINKS, open_stream};
use crate::lock;

/// Lock of a folder while its files are replaced.
const LOCK: &str = ".assur.lock";

static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Writes a file completely: a failure leaves the old content in place. Devices and pipes are written to directly.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), FileError> {
    write_by(path, |out| out.write_all(content.as_ref()))
}

/// Writes a file by a function, with the care of [`write`].
pub(crate) fn write_by(
    path: &Path,
    fill: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), FileError> {
    let fault = |error: io::Error| match error.kind() {
        io::ErrorKind::BrokenPipe => FileError::Reader,
        _ => FileError::write(path, error),
    };
    if path.is_dir() {
        return Err(FileError::refused(path, text!("file-name-a-file")));
    }
    if let Some(stream) = open_stream(path) {
        return stream.and_then(|mut stream| fill(&mut stream).and_then(|()| stream.flush())).map_err(fault);
    }
    let replacement = Replacement::of(path).and_then(|mut replacement| {
        fill(&mut replacement.content)?;
        replacement.content.as_file().sync_all().map(|()| replacement)
    });
    replacement.and_then(Replacement::put).map_err(fault)
}

/// Writes a new file completely, where none is yet.
pub(crate) fn create(path: &Path, content: &str) -> Result<(), FileError> {
    let exists = || FileError::refused(path, text!("file-exists"));
    if path.symlink_metadata().is_ok() {
        return Err(exists());
    }
    let filled = Replacement::of(path).and_then(|mut new| {
        new.content.write_all(content.as_bytes())?;
        new.content.as_file().sync_all().map(|()| new)
    });
    let put = filled.and_then(|new| new.content.persist_noclobber(path).map_err(|error| error.error));
    put.map(drop).map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => exists(),
        _ => FileError::write(path, error),
    })
}

/// Puts a complete file in the place of another one, or where none is, with the care of [`write`]. A link at `path`
/// itself is replaced: [`behind_links`] finds what it leads to.
pub(crate) fn put(complete: &Path, path: &Path) -> Result<(), FileError> {
    take_place(complete, path).map_err(|error| FileError::write(path, error))
}

/// The file that a path leads to through links, be it there or not; the path itself where it is no link. Of links that lead to each
/// other, one of them.
pub(crate) fn behind_links(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| behind_dangling(path))
}

/// What links lead to that end where nothing is.
fn behind_dangling(path: &Path) -> PathBuf {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&path) else { break };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    path
}

/// Writes some files into a folder by a function: all of them, or none. Files of `all` that an earlier run left and this
/// run does not write are removed.
pub(crate) fn write_folder(
    folder: &Path,
    all: &[&str],
    names: &[&str],
    fill: impl FnOnce(&mut [BufWriter<&mut NamedTempFile>]) -> io::Result<()>,
) -> Result<(), FileError> {
    if fs::metadata(folder).is_ok_and(|found| !found.is_dir()) {
        return Err(FileError::refused(folder, text!("file-not-a-folder")));
    }
    let created = !folder.exists();
    let real = behind_links(folder);
    if created {
        let parent = real.parent().filter(|parent| !parent.as_os_str().is_empty() && !parent.is_dir());
        if let Some(parent) = parent {
            return Err(FileError::refused(
                folder,
                text!("file-no-folder", folder = name(parent.display().to_string())),
            ));
        }
        fs::create_dir(&real).map_err(|error| FileError::write(folder, error))?;
    }
    // Replacing several files is not atomic, so everything that can fail before is done first.
    let ready = filled(folder, names, fill).inspect_err(|_| {
        if created {
            let _ = fs::remove_dir(&real);
        }
    })?;
    // Of two runs at once, the files are those of one.
    let _lock = Lock::wait(&folder.join(LOCK), folder)?;
    for replacement in ready {
        let path = replacement.path.clone();
        replacement.put().map_err(|error| FileError::write(&path, error))?;
    }
    for name in all.iter().filter(|name| !names.contains(name)) {
        let stale = folder.join(name);
        if fs::symlink_metadata(&stale).is_ok_and(|found| found.is_file()) {
            fs::remove_file(&stale).map_err(|error| FileError::write(&stale, error))?;
        }
    }
    Ok(())
}

/// Files that are complete, but not in their places yet.
fn filled(
    folder: &Path,
    names: &[&str],
    fill: impl FnOnce(&mut [BufWriter<&mut NamedTempFile>]) -> io::Result<()>,
) -> Result<Vec<Replacement>, FileError> {
    let open = |name: &&str| {
        let path = folder.join(name);
        Replacement::of(&path).map_err(|error| FileError::write(&path, error))
    };
    let mut all = names.iter().map(open).collect::<Result<Vec<_>, _>>()?;
    let mut outs: Vec<_> = all.iter_mut().map(|one| BufWriter::new(&mut one.content)).collect();
    let done = fill(&mut outs).and_then(|()| outs.iter_mut().try_for_each(BufWriter::flush));
    drop(outs);
    let synced = done.and_then(|()| all.iter().try_for_each(|one| one.content.as_file().sync_all()));
    synced.map_err(|error| FileError::write(folder, error)).map(|()| all)
}

/// Whether two paths lead to one file, also through links and other spellings.
pub(crate) fn is_same(one: &Path, other: &Path) -> bool {
    let file = |path: &Path| fs::metadata(path).map(|found| (found.dev(), found.ino()));
    matches!((file(one), file(other)), (Ok(one), Ok(other)) if one == other)
}

/// New content next to its target; removed unless it replaces the target.
struct Replacement {
    content: NamedTempFile,
    path: PathBuf,
}

impl Replacement {
    /// An empty temporary file next to the target; a symbolic link stays, and its target is replaced, or made where it is missing.
    fn of(path: &Path) -> io::Result<Self> {
        let path = behind_links(path);
        if let Ok(old) = fs::symlink_metadata(&path) {
            refuse_special(&old)?;
            if old.permissions().readonly() {
                let problem = Told(text!("file-read-only"));
                return Err(io::Error::new(io::ErrorKind::PermissionDenied, problem));
            }
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            let missing = text!("file-no-folder", folder = name(folder.display().to_string()));
            return Err(io::Error::new(io::ErrorKind::NotFound, Told(missing)));
        }
        let mut builder = tempfile::Builder::new();
        // The umask applies, as for any new file.
        builder.prefix(".assur-").permissions(fs::Permissions::from_mode(0o666));
        // Locked, so that a signal finds every file that was made.
        let mut temporaries = lock(&TEMPORARY);
        let content = builder.tempfile_in(folder)?;
        temporaries.push(content.path().to_owned());
        Ok(Self { content, path })
    }

    fn put(self) -> io::Result<()> {
        let temporary = self.content.into_temp_path();
        let put = take_place(&temporary, &self.path);
        lock(&TEMPORARY).retain(|path| *path != *temporary);
        put
    }
}

/// Replaces the content of a file by that of another one, which is then gone: by renaming, with the permissions of the
/// old file; where that would separate hard links or change the owner, by copying into the old file.
///
/// A copy that is interrupted, by a full disk or a crash, leaves a mixture, which renaming never does. Access lists
/// and extended attributes of a renamed file are lost.
fn take_place(complete: &Path, path: &Path) -> io::Result<()> {
    match fs::metadata(path) {
        Ok(old) if is_bound(&old, &fs::metadata(complete)?) => {
            refuse_special(&old)?;
            let mut target = OpenOptions::new().write(true).open(path)?;
            if let Err(TryLockError::WouldBlock) = target.try_lock() {
                return Err(io::Error::other(Told(text!("file-being-written"))));
            }
            let length = io::copy(&mut File::open(complete)?, &mut target)?;
            target.set_len(length)?;
            target.sync_all()?;
            fs::remove_file(complete)
        }
        old => {
            if let Ok(old) = old {
                refuse_special(&old)?;
                fs::set_permissions(complete, old.permissions())?;
            }
            fs::rename(complete, path)
        }
    }
}

fn refuse_special(old: &fs::Metadata) -> io::Result<()> {
    if old.is_file() {
        return Ok(());
    }
    Err(io::Error::new(io::ErrorKind::AlreadyExists, Told(text!("file-replaces-no-file"))))
}

/// Whether an old file has other names, or an owner that a new file would not have.
fn is_bound(old: &fs::Metadata, new: &fs::Metadata) -> bool {
    old.nlink() > 1 || old.uid() != new.uid() || old.gid() != new.gid()
}

/// Removes leftover temporary files, for exits that run no destructors.
pub(crate) fn remove_temporaries() {
    remove(&mut lock(&TEMPORARY));
}

fn remove(temporaries: &mut Vec<PathBuf>) {
    temporaries.drain(..).for_each(|path| drop(fs::remove_file(path)));
}

/// From this call on, a file that would be larger than the system allows is an error of writing, not the end of the program.
pub(crate) fn ignore_limit() {
    // Nobody asks whether it came: the error says so.
    let _ = signal_hook::flag::register(SIGXFSZ, Arc::default());
}

/// From this call on, a signal that ends the program first removes its temporary files.
pub(crate) fn remove_on_signals() {
    static LISTENING: OnceLock<()> = OnceLock::new();
    LISTENING.get_or_init(|| {
        // If no thread can be started the file is still written.
        let Ok(mut signals) = Signals::new([SIGHUP, SIGINT, SIGTERM]) else { return };
        let listen = move || {
            for signal in signals.forever() {
                // Locked to the end, so that no other file is made.
                let mut temporaries = lock(&TEMPORARY);
                remove(&mut temporaries);
                let _ = signal_hook::low_level::emulate_default_handler(signal);
            }
        };
        let _ = std::thread::Builder::new().name("assur-signals".into()).spawn(listen);
    });
}
