//! JSON: one object, numbers with all their digits.

pub mod analysis;
mod finite;
mod rows;

use std::io::{self, Write};

use assur_words::{Describe, Text, errors, name, text};
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

/// A result can't be written as JSON.
pub enum JsonError {
    /// The writer fails.
    Write(serde_json::Error),
    /// A number is not finite.
    NotFinite(NotFinite),
}

errors!(JsonError; Write(serde_json::Error), NotFinite(NotFinite));

impl Describe for JsonError {
    fn describe(&self) -> Text {
        match self {
            Self::Write(error) => text!("report-no-json", problem = name(error.to_string())),
            Self::NotFinite(error) => error.describe(),
        }
    }
}

/// A number of the results is not finite: nothing is written, in any format.
#[derive(Clone, PartialEq, Eq)]
pub struct NotFinite {
    /// Its place in the JSON: `positions[3].links.rocker.pf1`.
    pub place: String,
}

errors!(NotFinite);

impl Describe for NotFinite {
    fn describe(&self) -> Text {
        text!("report-not-finite", place = name(self.place.clone()))
    }
}

/// A result, if all its numbers are finite.
pub fn finite<T: Serialize>(result: &T) -> Result<&T, NotFinite> {
    match finite::place(result) {
        Some(place) => Err(NotFinite { place }),
        None => Ok(result),
    }
}

/// Compact JSON; `ascii`: other characters are escaped.
struct Compact {
    ascii: bool,
}

impl Formatter for Compact {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        if !self.ascii || fragment.is_ascii() {
            return writer.write_all(fragment.as_bytes());
        }
        for c in fragment.chars() {
            if c.is_ascii() {
                write!(writer, "{c}")?;
                continue;
            }
            for unit in c.encode_utf16(&mut [0; 2]) {
                write!(writer, "\\u{unit:04x}")?;
            }
        }
        Ok(())
    }
}

/// A result whose numbers are [`finite`].
fn serialized<T: Serialize + ?Sized>(value: &T, ascii: bool) -> Result<Vec<u8>, serde_json::Error> {
    let mut bytes = Vec::new();
    value.serialize(&mut Serializer::with_formatter(&mut bytes, Compact { ascii }))?;
    Ok(bytes)
}

/// A text in quotation marks.
fn quoted(text: &str, ascii: bool) -> String {
    String::from_utf8_lossy(&serialized(text, ascii).unwrap_or_default()).into_owned()
}

/// Any result as one line of JSON; `ascii`: other characters are escaped.
pub fn to_json<T: Serialize>(result: &T, ascii: bool) -> Result<String, JsonError> {
    let mut bytes = serialized(finite(result)?, ascii)?;
    bytes.push(b'\n');
    // The serializer writes UTF-8 only.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
