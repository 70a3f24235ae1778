//! TOML files with faults that are reported with their place: scenes, and other files that the program reads.

use toml::de::DeTable;

pub use crate::error::Fault;
pub use crate::walk::{Entry, Section};

use crate::SceneErrors;
use crate::error::Faults;
use crate::text::shown;

/// The greatest file that is read, in bytes: a scene has some kilobytes, a table of a hundred thousand rows some
/// megabytes.
pub const MOST_BYTES: usize = 8 << 20;

/// Number of syntax faults that are reported; later ones are often only consequences of the first.
const SYNTAX_FAULTS: usize = 3;

/// Reads a TOML file. `what` names its kind with an article ("a scene"), then come its known keys and a function that
/// turns its tables into a value. `file_name` appears only in errors.
///
/// # Errors
///
/// [`SceneErrors`] with every fault: those of the syntax or, if it is correct, those noted while reading. The value
/// that was built in spite of faults is discarded.
///
/// # Examples
///
/// ```
/// use assur_scene::document;
///
/// let count = |text| {
///     document::read("a.toml", text, "a file", &["count"], |root| root.get("count").and_then(|entry| entry.count(1, 9)))
/// };
/// assert_eq!(count("count = 3"), Ok(Some(3)));
/// let errors = count("coutn = 3").unwrap_err();
/// assert_eq!(errors.errors[0].message, "unknown key `coutn`");
/// assert_eq!(errors.errors[0].label, "did you mean `count`?");
/// ```
pub fn read<T>(
    file_name: &str,
    text: &str,
    what: &'static str,
    known: &'static [&'static str],
    make: impl FnOnce(&Section<'_>) -> T,
) -> Result<T, SceneErrors> {
    let faults = Faults::default();
    if text.len() > MOST_BYTES {
        let size = text.len().div_ceil(1 << 20);
        let message = format!("{what} has at most {} MiB, this one has {size}", MOST_BYTES >> 20);
        faults.push(Fault::new(0..0, message).label("is it the right file?"));
        return Err(faults.into_errors(file_name, ""));
    }
    let (document, syntax) = DeTable::parse_recoverable(text);
    let value = if syntax.is_empty() {
        Some(make(&Section::root(document.get_ref(), what, known, &faults)))
    } else {
        for error in syntax.iter().take(SYNTAX_FAULTS) {
            let span = error.span().unwrap_or(0..0);
            faults.push(Fault::new(span.clone(), syntax_words(error.message(), text.get(span))));
        }
        None
    };
    match value.filter(|_| faults.is_empty()) {
        Some(value) => Ok(value),
        None => Err(faults.into_errors(file_name, text)),
    }
}

/// The parser's message, with the duplicate key that it does not name.
fn syntax_words(message: &str, piece: Option<&str>) -> String {
    match piece.filter(|piece| message == "duplicate key" && !piece.is_empty()) {
        Some(key) => format!("not TOML: duplicate key `{}`", shown(key)),
        None if message.starts_with("invalid unquoted key") => {
            format!("not TOML: {message}; a name with other characters must be in quotes")
        }
        None => format!("not TOML: {message}"),
    }
}
