//! What a value of a scene may be.

use assur_words::{Describe, Text, joined, name, text};

use crate::units::Dimension;

/// What a value may be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ValueKind {
    /// A number in SI, or a text of a number and a unit.
    Quantity(Dimension),
    /// A quantity of the first dimension where the input turns, of the second where it slides.
    ByInput(Dimension, Dimension),
    /// A whole number.
    Count,
    /// `true` or `false`.
    Flag,
    /// A text of any words.
    Text,
    /// This word.
    Word(&'static str),
    /// The name of a part: "link", "point", "slide", "pair", "plugin".
    Named(&'static str),
    /// A place in the frame of a link: a point of it, two coordinates, or a length on its x axis.
    Place,
    /// Names of points with their places.
    Points,
    /// Two values of one kind.
    Two(Box<Self>),
    /// A list of values of one kind.
    List(Box<Self>),
    /// Rows of two numbers.
    Rows,
    /// A table with this header in the reference, or several.
    Table(&'static str),
}

impl ValueKind {
    /// Reads a kind as the reference writes it.
    pub(super) fn read(text: &'static str) -> Option<Self> {
        let within = |of: &str| text.strip_prefix(of);
        Some(match text {
            "count" => Self::Count,
            "flag" => Self::Flag,
            "text" => Self::Text,
            "place" => Self::Place,
            "points" => Self::Points,
            "rows" => Self::Rows,
            _ => {
                if let Ok(dimension) = text.parse() {
                    Self::Quantity(dimension)
                } else if let Some(part) = within("name of ") {
                    Self::Named(part)
                } else if let Some(of) = within("two of ") {
                    Self::Two(Box::new(Self::read(of)?))
                } else if let Some(of) = within("list of ") {
                    Self::List(Box::new(Self::read(of)?))
                } else if let Some(word) = within("\"") {
                    Self::Word(word.strip_suffix('"')?)
                } else if let Some((turning, sliding)) = text.split_once('/') {
                    Self::ByInput(turning.parse().ok()?, sliding.parse().ok()?)
                } else {
                    Self::Table(text)
                }
            }
        })
    }
}

impl Describe for ValueKind {
    fn describe(&self) -> Text {
        match self {
            Self::Quantity(dimension) => dimension.with_units(),
            Self::ByInput(turning, sliding) => {
                text!("scene-kind-by-input", turning = turning.with_units(), sliding = sliding.with_units())
            }
            Self::Count => text!("scene-kind-count"),
            Self::Flag => text!("scene-true-or-false"),
            Self::Text => text!("scene-a-text"),
            Self::Word(word) => name(format!("\"{word}\"")),
            Self::Named(part) => text!("scene-kind-name", what = name(*part)),
            Self::Place => text!("scene-kind-place"),
            Self::Points => text!("scene-table-of-points"),
            Self::Two(kind) => text!("scene-kind-two", of = kind.describe()),
            Self::List(kind) => text!("scene-kind-list", of = kind.describe()),
            Self::Rows => text!("scene-list-of-rows"),
            Self::Table(header) => text!("scene-kind-table", header = name(*header)),
        }
    }
}

/// Several texts, one of which holds: "these or the last".
pub fn either(mut texts: Vec<Text>) -> Text {
    let last = texts.pop().unwrap_or_default();
    if texts.is_empty() { last } else { text!("scene-either", these = joined(", ", texts), last) }
}
