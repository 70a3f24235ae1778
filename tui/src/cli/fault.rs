//! What ends a command.

use std::io;
use std::process::ExitCode;

use crate::files::FileError;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Status {
    /// All is well.
    Done,
    /// No assembly, no solution, or a check that fails.
    Failed,
    /// A bad scene or usage.
    Bad,
    /// As the terminal UI says.
    Code(u8),
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

/// Why a command could not do its work; all end with status 2, but a reader that went away with 0.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Fault {
    /// A file can't be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// Results that are not whole would replace a file; the command ends as it would have.
    #[error("{0}")]
    Partial(FileError, Status),
    /// Standard output refuses.
    #[error("error: can't write to standard output: {0}")]
    Stdout(io::Error),
    /// The faults of a scene, ready to print.
    #[error("{0}")]
    Scene(String),
    /// Anything else, in words.
    #[error("error: {0}")]
    Other(String),
    /// The terminal UI could not open.
    #[error("{0}")]
    Screen(#[from] crate::screen::ScreenError),
}

impl Fault {
    /// The exit status that it means.
    pub(crate) fn status(&self) -> Status {
        if let Self::Partial(_, status) = self { *status } else { Status::Bad }
    }

    /// A fault in words.
    #[expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]
    pub(crate) fn other(what: impl ToString) -> Self {
        Self::Other(what.to_string())
    }

    /// From writing to standard output.
    pub(crate) fn stdout(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe { FileError::Reader.into() } else { Self::Stdout(error) }
    }
}
