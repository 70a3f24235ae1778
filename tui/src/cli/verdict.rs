//! How a command that calculates a scene ends: the exit status, and what is told on standard error.

use std::path::Path;

use assur_analysis::AnalysisError;
use assur_words::{Describe, Text};

use super::fault::Status;
use super::scene;
use super::style::Style;
use crate::verdict::{Place, Verdict};

/// A fault is told at its line of the scene's file.
impl Place for &Path {
    fn at_key(&self, key: &[String], message: &str) -> Option<Text> {
        scene::at_key(self, key, message).map(|fault| fault.describe())
    }

    fn error(&self, error: &AnalysisError) -> Text {
        scene::fault(self, error).describe()
    }
}

impl Verdict {
    /// The exit status of a command that gives results: 1 where some of them are missing.
    pub(crate) fn status(&self) -> Status {
        if self.is_complete() { Status::Done } else { Status::Failed }
    }

    /// The exit status of a command that vouches for the results: 1 also where a check fails.
    pub(crate) fn proved(&self) -> Status {
        if self.is_proved() { Status::Done } else { Status::Failed }
    }

    /// Tells everything on standard error, what is missing first.
    pub(crate) fn tell(&self, style: Style) {
        self.messages().for_each(|message| style.tell(message));
    }
}
