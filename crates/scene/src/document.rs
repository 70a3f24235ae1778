//! TOML files with faults that are reported with their place: scenes, and other files that the program reads.

use std::ops::Range;

use assur_words::{Text, name, number, text};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

pub use crate::error::Fault;
pub use crate::walk::{Entry, Section};

use crate::scan::{MOST_TABLES, excess};
use crate::text::{is_unprintable, shown};
use crate::{SceneErrors, error::Faults, known::Known};

/// The greatest file that is read, in bytes: a scene has some kilobytes, a table of a hundred thousand rows some
/// megabytes.
pub const MOST_BYTES: usize = 8 << 20;

/// The greatest text of which all faults of the syntax are collected, in bytes.
const MOST_RECOVERED: usize = 1 << 20;

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
/// use assur_words::name;
///
/// let count = |text| {
///     document::read("a.toml", text, name("count.toml"), &["count"], |root| root.get("count").and_then(|entry| entry.count(1, 9)))
/// };
/// assert_eq!(count("count = 3"), Ok(Some(3)));
/// let errors = count("coutn = 3").unwrap_err();
/// assert_eq!(errors.errors[0].message.to_string(), "unknown key `coutn`");
/// assert_eq!(errors.errors[0].label.to_string(), "did you mean `count`?");
/// ```
pub fn read<T>(
    file_name: &str,
    text: &str,
    what: Text,
    known: &'static [&'static str],
    make: impl FnOnce(&Section<'_>) -> T,
) -> Result<T, SceneErrors> {
    read_known((file_name, text), what, Known::Names(known), Faults::default(), make)
}

/// Reads a TOML file whose keys stand in a table of the reference, or in a list.
pub(crate) fn read_known<T>(
    (file_name, text): (&str, &str),
    what: Text,
    known: Known,
    faults: Faults,
    make: impl FnOnce(&Section<'_>) -> T,
) -> Result<T, SceneErrors> {
    if text.len() > MOST_BYTES {
        let size = text.len().div_ceil(1 << 20);
        let message = text!("scene-file-too-large", what, most = MOST_BYTES >> 20, size);
        faults.add(0..0, message, text!("scene-right-file"));
        return Err(faults.into_errors(file_name, ""));
    }
    if let Some(at) = excess(text) {
        let message = text!("scene-many-tables", what, most = MOST_TABLES);
        faults.add(at..at + 1, message, text!("scene-one-too-many"));
        return Err(faults.into_errors(file_name, text));
    }
    let (document, syntax) = parsed(text);
    let value = if let Some(document) = document.filter(|_| syntax.is_empty()) {
        Some(make(&Section::root(document.get_ref(), what, known, &faults)))
    } else {
        let errors = syntax.iter().map(|error| (error.span().unwrap_or(0..0), error.message()));
        for fault in syntax_faults(text, errors) {
            faults.push(fault);
        }
        None
    };
    match value.filter(|_| faults.is_empty()) {
        Some(value) => Ok(value),
        None => Err(faults.into_errors(file_name, text)),
    }
}

/// The tables of a text, and the faults of its syntax: of a large text the first fault only, since a text may have one in each
/// of its bytes, and each takes far more than a byte.
pub(crate) fn parsed(text: &str) -> (Option<Spanned<DeTable<'_>>>, Vec<toml::de::Error>) {
    match DeTable::parse(text) {
        Ok(document) => (Some(document), Vec::new()),
        Err(first) if text.len() > MOST_RECOVERED => (None, vec![first]),
        Err(_) => {
            let (document, errors) = DeTable::parse_recoverable(text);
            (Some(document), errors)
        }
    }
}

/// The first faults of the syntax, in the order of the file. A text without its closing quote is the last one: what follows
/// it is read as something else than it is.
fn syntax_faults<'m>(text: &str, errors: impl Iterator<Item = (Range<usize>, &'m str)>) -> Vec<Fault> {
    let mut errors: Vec<_> = errors.collect();
    errors.sort_by_key(|(span, _)| span.start);
    let mut faults = Vec::new();
    let mut read_on = 0;
    for (span, message) in errors.into_iter().take(SYNTAX_FAULTS) {
        if span.start < read_on {
            continue;
        }
        if let Some(comma) = text.get(..span.start).and_then(decimal_comma) {
            faults.push(Fault::new(comma..comma + 1, text!("scene-decimal-comma")));
            break;
        }
        if let Some(start) = unclosed(text, span.start, message) {
            let fault = Fault::new(start..start + 1, text!("scene-unclosed"));
            faults.push(fault.label(text!("scene-begins-here")));
            break;
        }
        if let Some((at, words)) = slip(text, span.start, message) {
            // What follows is read as something else than it is.
            faults.push(Fault::new(at..at + 1, words));
            break;
        }
        let words = standing(text, &span).unwrap_or_else(|| syntax_words(message, text.get(span.clone())));
        let fault = Fault::new(span.clone(), words);
        let earlier = if message == "duplicate key" { earlier(text, &span) } else { None };
        faults.push(match earlier {
            Some(line) => fault.label(text!("scene-stands-already", line = number(line))),
            None => fault,
        });
        if earlier.is_some() {
            // Of a table that stands twice each key stands twice.
            read_on = text[span.end..].find("\n[").map_or(text.len(), |next| span.end + next);
        }
    }
    faults
}

/// The line, from 1, in which a table stands whose header is repeated here; `None` for a key that is repeated.
fn earlier(text: &str, span: &Range<usize>) -> Option<usize> {
    let before = text.get(..span.start)?;
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let header = text[start..].lines().next()?.trim();
    let same = || before[..start].lines().position(|line| line.trim() == header);
    header.starts_with('[').then(same).flatten().map(|line| line + 1)
}

/// Where the comma is in a number of a table in braces that the text ends with: `{ A = 0,5`.
fn decimal_comma(before: &str) -> Option<usize> {
    let digits = |text: &str| text.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let text = before.trim_end();
    let comma = text[..digits(text)].strip_suffix(',')?;
    let value = comma[..digits(comma)].trim_end_matches(['+', '-']);
    let is_number = comma.len() + 1 < text.len() && digits(comma) < comma.len();
    (is_number && value.trim_end().ends_with('=')).then_some(comma.len())
}

/// A slip of those who write TOML for the first time, and where it is.
fn slip(text: &str, at: usize, message: &str) -> Option<(usize, Text)> {
    let (before, rest) = (text.get(..at)?, text.get(at..)?);
    let line = &before[before.rfind('\n').map_or(0, |end| end + 1)..];
    let next = |pattern: &str| rest.trim_start().starts_with(pattern);
    let words = if next("//") {
        text!("scene-comment-sign")
    } else if next(":") {
        text!("scene-colon")
    } else if next(";") {
        text!("scene-semicolon")
    } else if next("(") {
        text!("scene-round-brackets")
    } else if next(",") && line.ends_with(|c: char| c.is_ascii_digit()) && !line.contains(['[', '{']) {
        text!("scene-decimal-comma")
    } else if let Some(sign) =
        rest.chars().next().filter(|c| !c.is_ascii() && (c.is_whitespace() || is_unprintable(*c)))
    {
        text!("scene-invisible-sign", code = name(format!("U+{:04X}", u32::from(sign))))
    } else if message.starts_with("string values must be quoted") && is_before_a_key(rest) {
        text!("scene-missing-comma")
    } else if message.starts_with("missing comma between key-value pairs") && line.trim().is_empty() {
        return before.rfind('{').map(|brace| (brace, text!("scene-unclosed-brace")));
    } else {
        return None;
    };
    Some((at + rest.len() - rest.trim_start().len(), words))
}

/// Whether a value of one word without its comma stands before the next key: `0 A = `.
fn is_before_a_key(rest: &str) -> bool {
    let mut words = rest.lines().next().unwrap_or_default().split_whitespace();
    let is_number = words.next().is_some_and(|word| word.parse::<f64>().is_ok());
    is_number && (words.next(), words.next()).1.is_some_and(|word| word.starts_with('='))
}

/// The cause of a fault of the syntax by what stands at its place; `None` where that doesn't tell it. The parser's words name what
/// it tried last: for a word without quotes, `false`.
fn standing(text: &str, span: &Range<usize>) -> Option<Text> {
    // A fault at the end of a number belongs to the number.
    let is_of_number = |c: char| c.is_ascii_digit() || ".+-".contains(c);
    let before = text.get(..span.start)?.trim_end_matches(is_of_number);
    let line = before[before.rfind('\n').map_or(0, |end| end + 1)..].trim();
    let rest = text[before.len()..].lines().next().unwrap_or_default();
    let found = rest.split([',', ']', '}', '#', '"', '\'']).next().unwrap_or_default().trim();
    let list = line.rfind(['[', '{']).filter(|&at| line[at..].starts_with('[') && !line[at..].contains(']'));
    let is_in_list = list.is_some_and(|at| line[..at].contains('='));
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    let is_key = |text: &str| {
        text.starts_with(char::is_alphabetic)
            && text.chars().all(|c| c.is_alphanumeric() || "_-.".contains(c))
    };
    if line.ends_with('=') || is_in_list && line.ends_with(['[', ',']) {
        let words = found.split_whitespace().count();
        return if found.is_empty() && !rest.trim_start().starts_with(['"', '\'']) {
            Some(text!("scene-missing-value"))
        } else if found.starts_with(char::is_alphabetic) && !found.contains('=') {
            Some(text!("scene-unquoted-text", value = shown(found)))
        } else if is_in_list && words > 1 && found.split_whitespace().all(is_number) {
            Some(text!("scene-missing-comma"))
        } else {
            // Rust reads `.5`, `5.` and `05`, too.
            let number = found.parse::<f64>().ok().filter(|_| DeValue::parse(found).is_err())?;
            Some(text!("scene-form-of-number", number = name(number.to_string())))
        };
    }
    // A fault within a header or a key is another one.
    if rest.starts_with(|c: char| !c.is_whitespace() && !"]#".contains(c)) || line.ends_with('.') {
        return None;
    }
    let is_open = line.matches('[').count() > line.matches(']').count();
    if is_open && line.starts_with('[') && is_key(line.trim_matches(['[', ']'])) {
        return Some(text!("scene-unclosed-header"));
    }
    is_key(line).then(|| text!("scene-key-without-value", key = shown(line)))
}

/// Where the text begins whose closing quote the parser misses; `None` for another fault.
fn unclosed(text: &str, at: usize, message: &str) -> Option<usize> {
    let (kind, expected) = message.strip_prefix("invalid ")?.split_once(" string, expected ")?;
    if !["`\"`", "`'`"].contains(&expected) {
        return None;
    }
    let before = text.get(..at)?;
    match kind {
        "basic" | "literal" => {
            let quote = if kind == "basic" { '"' } else { '\'' };
            let line = before.rfind('\n').map_or(0, |end| end + 1);
            before[line..].rfind(quote).map(|start| line + start)
        }
        "multi-line basic" => before.rfind("\"\"\""),
        "multi-line literal" => before.rfind("'''"),
        _ => None,
    }
}

/// The quotes that a word processor writes.
const TYPOGRAPHIC: [char; 9] =
    ['\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}', '\u{201a}', '\u{ab}', '\u{bb}', '\u{2033}'];

/// The parser's message, with the duplicate key that it does not name.
fn syntax_words(message: &str, piece: Option<&str>) -> Text {
    let said = name(message.to_owned());
    let value = piece.filter(|_| message.starts_with("string values must be quoted")).map(str::trim_start);
    if value.is_some_and(|value| value.starts_with(TYPOGRAPHIC)) {
        return text!("scene-typographic-quotes");
    }
    if let Some(value) =
        value.filter(|value| value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)))
    {
        return text!("scene-unquoted-quantity", value = shown(value.trim_end()));
    }
    match piece.filter(|piece| message == "duplicate key" && !piece.is_empty()) {
        Some(key) => text!("scene-duplicate-key", key = shown(key)),
        None if message.starts_with("invalid unquoted key") => text!("scene-unquoted-key", message = said),
        None => text!("scene-no-toml", message = said),
    }
}
