//! The end of a command: status and errors.

use std::io;
use std::process::ExitCode;

use crate::files::FileError;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Status {
    /// Success.
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
#[derive(Debug, thiserror::Error)]
pub(crate) enum Fault {
    /// A file can't be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// Incomplete results would replace a file; the command ends with the status that it would have had.
    #[error("{0}")]
    Partial(FileError, Status),
    /// Standard output can't be written.
    #[error("error: can't write to standard output: {0}")]
    Stdout(io::Error),
    /// The faults of a scene, ready to print.
    #[error("{0}")]
    Scene(String),
    /// Any other error, in words.
    #[error("error: {0}")]
    Other(String),
    /// The terminal UI could not open.
    #[error("{0}")]
    Screen(#[from] crate::screen::ScreenError),
}

impl Fault {
    /// Its exit status.
    pub(crate) fn status(&self) -> Status {
        if let Self::Partial(_, status) = self { *status } else { Status::Bad }
    }

    /// An error in words.
    #[expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]
    pub(crate) fn other(what: impl ToString) -> Self {
        Self::Other(what.to_string())
    }

    /// From an error of writing to standard output.
    pub(crate) fn stdout(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe { FileError::Reader.into() } else { Self::Stdout(error) }
    }
}
