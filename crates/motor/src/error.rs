//! What can be wrong with a catalogue, a designation, rated data or a request.

use assur_plugin::RegistryError;
use assur_words::{Describe, Text, name};

/// Why a catalogue, a motor or a characteristic can't be had, in words: whoever asked for it can only tell the reason.
#[derive(Clone, PartialEq)]
pub struct MotorError(pub(crate) Text);

assur_words::errors!(MotorError);

impl Describe for MotorError {
    fn describe(&self) -> Text {
        self.0.clone()
    }
}

impl From<RegistryError> for MotorError {
    fn from(error: RegistryError) -> Self {
        Self(error.describe())
    }
}

/// A list of designations or other names.
pub(crate) fn names(list: &[String]) -> Text {
    assur_words::list(list.iter().map(|one| name(one.clone())))
}
