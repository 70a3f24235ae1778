//! What is told beside the results of a scene; what stops it is an error.

use std::fmt;

use assur_words::Text;
use serde::{Serialize, Serializer, ser::SerializeStruct};

use crate::Key;

/// What a warning is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum WarningKind {
    /// Something in the scene that is allowed, but probably not meant.
    Mistake,
    /// Something about the results that a reader should know.
    Remark,
}

/// A warning about a scene or its results.
///
/// As JSON it has the identity of its text (`id`), its kind, the key of the scene that it concerns (`null` where it concerns
/// none), and its text in English.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// What it is about.
    pub kind: WarningKind,
    /// The key of the scene that it concerns.
    pub key: Option<Key>,
    /// What it says.
    pub text: Text,
}

impl Warning {
    /// Something that is probably not meant, at a key of the scene.
    pub fn mistake(key: impl Into<Option<Key>>, text: Text) -> Self {
        Self { kind: WarningKind::Mistake, key: key.into(), text }
    }

    /// Whether something is probably not meant.
    pub fn is_mistake(&self) -> bool {
        self.kind == WarningKind::Mistake
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text.fmt(f)
    }
}

impl From<Text> for Warning {
    /// A remark on the results as a whole.
    fn from(text: Text) -> Self {
        Self { kind: WarningKind::Remark, key: None, text }
    }
}

impl From<&Warning> for Text {
    fn from(warning: &Warning) -> Self {
        warning.text.clone()
    }
}

impl Serialize for Warning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Warning", 4)?;
        object.serialize_field("id", &self.text.identity())?;
        object.serialize_field("kind", &self.kind)?;
        object.serialize_field("key", &self.key)?;
        object.serialize_field("text", &self.text)?;
        object.end()
    }
}
