//! JSON: one object, numbers with all their digits.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

/// A result can't be written as JSON.
#[derive(Debug, thiserror::Error)]
#[error("the result can't be written as JSON: {0}")]
pub struct JsonError(#[from] serde_json::Error);

/// Compact JSON in which a number that is not finite is a fault, not a `null`.
struct Strict {
    ascii: bool,
}

impl Formatter for Strict {
    /// Results hold no empty options, so this is only asked for NaN and infinity.
    fn write_null<W: ?Sized + Write>(&mut self, _writer: &mut W) -> io::Result<()> {
        Err(io::Error::new(
            io::ErrorKind::InvalidData,
            "a number is not finite; this is a bug of the program",
        ))
    }

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

/// Any result as one line of JSON; `ascii`: other characters are escaped.
///
/// # Errors
///
/// [`JsonError`] for a number that is not finite: a bug of the program, never written silently.
pub fn to_json<T: Serialize>(result: &T, ascii: bool) -> Result<String, JsonError> {
    let mut bytes = Vec::with_capacity(1 << 16);
    result.serialize(&mut Serializer::with_formatter(&mut bytes, Strict { ascii }))?;
    bytes.push(b'\n');
    // The serializer writes UTF-8 only.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
