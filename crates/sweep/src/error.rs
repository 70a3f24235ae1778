//! Why a sweep can't begin.

use assur_scene::SceneErrors;
use assur_words::{Describe, Text, name, text};

/// Why a sweep can't begin, or has no row to write. What is wrong at one point is part of the table.
#[derive(Clone, PartialEq)]
pub enum SweepError {
    /// The scene itself is faulty.
    Scene(SceneErrors),
    /// No point makes a scene that can be calculated: what is wrong with the first one.
    AllRefused(Text),
    /// The sweep that is asked for is none: a parameter that is not written as it should be or names nothing, too many points, an
    /// unknown measure.
    Request(Text),
    /// The threads could not be started.
    Threads(Text),
}

assur_words::errors!(SweepError; Scene(SceneErrors));

impl Describe for SweepError {
    fn describe(&self) -> Text {
        match self {
            Self::Scene(errors) => errors.describe(),
            Self::AllRefused(what) | Self::Request(what) | Self::Threads(what) => what.clone(),
        }
    }
}

impl SweepError {
    /// A parameter (as it was given, or its key) with what is wrong, and what to write.
    pub(crate) fn vary(vary: impl Into<String>, problem: Text) -> Self {
        Self::Request(text!("sweep-vary", vary = name(vary.into()), problem))
    }
}
