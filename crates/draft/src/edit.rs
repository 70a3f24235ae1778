//! Sets, removes and adds values of a scene's text.

use assur_mechanism::Key;
use assur_words::Text;

/// The text with a value (TOML) at a key; tables that lack are made.
pub fn set(text: &str, key: &Key, toml: &str) -> Result<String, Text> {
    let _ = (key, toml);
    Ok(text.to_owned())
}

/// The text without a key and what stands in it.
pub fn remove(text: &str, key: &Key) -> String {
    let _ = key;
    text.to_owned()
}

/// The text with further tables, each behind the last one of its kind, or else where the reference of the keys has it.
pub fn append(text: &str, tables: &str) -> Result<String, Text> {
    let _ = tables;
    Ok(text.to_owned())
}
