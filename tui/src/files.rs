//! Files of the user: errors of reading name the place; writing is complete or not done at all.

mod lock;
mod stream;
mod write;

use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use assur_kinematics::CompileError;
use assur_mechanism::{Mechanism, Motion};
use assur_scene::{SceneErrors, document};

pub(crate) use lock::{Lock, create_own, open_own};
pub(crate) use stream::{is_stream, open_stream};
pub(crate) use write::{
    behind_links, is_same, put, remove_on_signals, remove_temporaries, write, write_by, write_folder,
};

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
    /// A file can't be written; the old content is untouched.
    #[error("error: can't write {}: {problem}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// The reader of a pipe has closed it.
    #[error("the reader of the output has gone")]
    Reader,
}

#[expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]
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
        let (read, rest) = problem.as_bytes().split_at(problem.utf8_error().valid_up_to());
        let before = String::from_utf8_lossy(read);
        // A byte order mark does not belong to the first line.
        let before = before.trim_start_matches('\u{feff}');
        let line = before.split('\n').count();
        let column = before.rsplit('\n').next().map_or(0, |line| line.chars().count()) + 1;
        let byte = rest.first().map_or_else(String::new, |byte| format!(": byte 0x{byte:02X}"));
        error(format!("is not UTF-8 text (line {line}, column {column}{byte}); save it as UTF-8"))
    })
}

/// An error of compiling at its line of the scene, if it concerns a link.
pub(crate) fn located(name: &str, text: &str, error: &CompileError) -> Option<SceneErrors> {
    assur_scene::fault_at(name, text, &error.key()?, &error.to_string())
}

/// An integrator of a scene that is not registered, at its line.
pub(crate) fn integrator_fault(name: &str, text: &str, mechanism: &Mechanism) -> Option<SceneErrors> {
    let Some(Motion::Transient { integrator, .. }) = &mechanism.motion else { return None };
    let error = assur_integrator::find(integrator).err().filter(|_| integrator != "auto")?;
    assur_scene::fault_at(name, text, &["motion", "integrator"], &error.to_string())
}
