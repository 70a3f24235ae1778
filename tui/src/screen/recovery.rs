//! Unsaved changes are kept in a file while the program runs; what a program has left behind when it died is offered by the next one.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::state::{Draft, Recovered};
use crate::files::{self, Lock};
use crate::session::Source;

/// Folder below that of states.
const FOLDER: &str = "assur";
/// Before the name of the scene's file, in the first line.
const MARK: &str = "# unsaved changes of ";

/// The file of this program.
#[derive(Debug)]
pub(crate) struct Recovery {
    path: PathBuf,
    /// While it is held, the program lives.
    lock: Option<Lock>,
    kept: Option<Arc<str>>,
}

/// `$XDG_STATE_HOME/assur`, else `~/.local/state/assur`; a path that is not absolute counts as unset, as the specification demands.
pub(crate) fn folder(variable: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
    let absolute = |name| variable(name).filter(|path| path.is_absolute());
    let home = || absolute("HOME").map(|home| home.join(".local/state"));
    absolute("XDG_STATE_HOME").or_else(home).map(|folder| folder.join(FOLDER))
}

impl Recovery {
    pub(crate) fn new(folder: &Path) -> Self {
        Self { path: folder.join(format!("{}.toml", std::process::id())), lock: None, kept: None }
    }

    /// Writes the text if it has changes that no file has, and removes the file where it has none. What can't be written is not told:
    /// the scene itself is safe.
    pub(crate) fn keep(&mut self, draft: &Draft) {
        let wanted = Some(draft.text()).filter(|_| !draft.is_kept());
        if wanted == self.kept.as_ref() {
            return;
        }
        let Some(text) = wanted else { return self.remove() };
        if self.lock.is_none() {
            let made = self.path.parent().map(fs::create_dir_all);
            self.lock = made.and_then(|_| Lock::of(&lock_of(&self.path), &self.path).ok().flatten());
        }
        let source = match &draft.source {
            Source::File(path) => {
                std::path::absolute(path).unwrap_or_else(|_| path.clone()).display().to_string()
            }
            other => other.name(),
        };
        let content = format!("{MARK}{}\n{text}", source.replace('\n', " "));
        if files::write(&self.path, content.as_bytes()).is_ok() {
            self.kept = Some(Arc::clone(text));
        }
    }

    /// The program ends as the user wants: nothing is left.
    pub(crate) fn remove(&mut self) {
        if self.kept.take().is_some() {
            // It may be gone already.
            let _ = fs::remove_file(&self.path);
        }
        self.lock = None;
    }
}

fn lock_of(path: &Path) -> PathBuf {
    path.with_extension("lock")
}

/// What programs that have died left in a folder, the last first.
pub(crate) fn left(folder: &Path) -> Vec<Recovered> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let files =
        entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|own| own == "toml"));
    let mut files: Vec<_> =
        files.filter_map(|path| Some((fs::metadata(&path).ok()?.modified().ok()?, path))).collect();
    files.sort();
    files.into_iter().rev().filter_map(|(_, path)| one(path)).collect()
}

fn one(path: PathBuf) -> Option<Recovered> {
    // Whoever holds the lock lives.
    let free = Lock::of(&lock_of(&path), &path).ok()?;
    drop(free);
    let content = files::read(&path).ok()?;
    let (first, text) = content.split_once('\n')?;
    let source = first.strip_prefix(MARK)?;
    let source = if source == Source::New.name() { Source::New } else { Source::File(source.into()) };
    Some(Recovered { path, source, text: text.into() })
}
