//! What is reported beside the results.

use std::fmt;

use assur_words::Text;
use serde::{Serialize, Serializer, ser::SerializeStruct};

use crate::Key;

/// What a notice is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum NoticeKind {
    /// Something in the scene that is allowed, but probably not meant.
    Mistake,
    /// Something about the results that a reader should know.
    Remark,
}

/// A notice on a scene or on its results.
///
/// As JSON it has the identity of its text (`id`), its kind, the key of the scene that it concerns (`null` where it concerns
/// none), and its text in English.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    /// What it is about.
    pub kind: NoticeKind,
    /// The key of the scene that it concerns.
    pub key: Option<Key>,
    /// What it says.
    pub text: Text,
}

impl Notice {
    /// Something that is probably not meant, at a key of the scene.
    pub fn mistake(key: impl Into<Option<Key>>, text: Text) -> Self {
        Self { kind: NoticeKind::Mistake, key: key.into(), text }
    }

    /// Whether something is probably not meant.
    pub fn is_mistake(&self) -> bool {
        self.kind == NoticeKind::Mistake
    }
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text.fmt(f)
    }
}

impl From<Text> for Notice {
    /// A remark on the results as a whole.
    fn from(text: Text) -> Self {
        Self { kind: NoticeKind::Remark, key: None, text }
    }
}

impl From<&Notice> for Text {
    fn from(note: &Notice) -> Self {
        note.text.clone()
    }
}

impl Serialize for Notice {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Notice", 4)?;
        object.serialize_field("id", &self.text.identity())?;
        object.serialize_field("kind", &self.kind)?;
        object.serialize_field("key", &self.key)?;
        object.serialize_field("text", &self.text)?;
        object.end()
    }
}
