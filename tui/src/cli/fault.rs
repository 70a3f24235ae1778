//! The end of a command: status and errors.
#![expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]

use std::io;
use std::process::ExitCode;

use assur_scene::SceneErrors;
use assur_words::{Describe, Text, errors, name, text, text_of};

use crate::files::FileError;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Status {
    Done,
    /// No assembly, no solution, or a check that fails.
    Failed,
    /// A bad scene or usage.
    Bad,
    /// The exit status of the terminal UI.
    Code(u8),
}

impl Status {
    /// This status, or the other one where this is success.
    pub(crate) fn or(self, other: Self) -> Self {
        if self == Self::Done { other } else { self }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        match status {
            Status::Done => Self::SUCCESS,
            Status::Failed => Self::from(1),
            Status::Bad => Self::from(2),
            Status::Code(code) => Self::from(code),
        }
    }
}

/// Why a command failed; all errors end with status 2, except a reader that closed the pipe, with 0.
pub(crate) enum Fault {
    File(FileError),
    /// Incomplete results would replace a file; the command ends with the status that it would have had.
    Partial(FileError, Status),
    /// The faults of a scene, ready to print.
    Scene(Text),
    Other(Text),
}

errors!(Fault; File(FileError));

impl Describe for Fault {
    fn describe(&self) -> Text {
        match self {
            Self::File(error) | Self::Partial(error, _) => error.describe(),
            Self::Scene(faults) => faults.clone(),
            Self::Other(problem) => text!("cli-error", problem),
        }
    }
}

impl Fault {
    pub(crate) fn status(&self) -> Status {
        if let Self::Partial(_, status) = self { *status } else { Status::Bad }
    }

    /// The faults of a scene, or of another text that is read.
    pub(crate) fn scene(errors: SceneErrors) -> Self {
        Self::Scene(errors.describe())
    }

    /// An error that says itself what it is, in any language.
    pub(crate) fn told(error: impl Describe) -> Self {
        Self::Other(error.describe())
    }

    /// An error of a library, in its words.
    pub(crate) fn other(what: impl ToString) -> Self {
        Self::Other(name(what.to_string()))
    }

    /// From an error of writing to standard output.
    pub(crate) fn stdout(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => FileError::Reader.into(),
            _ => Self::Scene(text!("cli-stdout", problem = text_of(&error))),
        }
    }
}
