//! How many tables and lists a text makes, counted before any is made: an empty table takes a thousand times its two letters.

/// The most tables and lists of a text. A table takes up to 1.4 kB, whatever is in it, and what else stands in the greatest text
/// takes half a gigabyte: together they stay below 1 GB. A scene has no more than 200,000 slides, or 100,000 rows of a load.
pub(crate) const MOST_TABLES: usize = 300_000;

/// Where the first table or list begins that is too many: after the key, bracket or brace that makes it.
///
/// A dotted key makes a table with each of its points. In a text with faults of the syntax at most every second table of a header
/// is missed.
pub(crate) fn excess(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    // Each takes a sign of its own.
    if bytes.len() <= MOST_TABLES {
        return None;
    }
    // Brackets and braces of values that are open; points since the last sign between keys or values.
    let (mut made, mut open, mut points) = (0, 0_usize, 0);
    let (mut is_line_start, mut is_header) = (true, false);
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let begins = is_line_start;
        is_line_start = byte == b'\n' || is_line_start && byte.is_ascii_whitespace();
        match byte {
            b'#' => {
                at += bytes[at..].iter().position(|byte| *byte == b'\n').unwrap_or(bytes.len() - at);
                continue;
            }
            b'"' | b'\'' => {
                at = after_text(bytes, at);
                continue;
            }
            b'.' => points += 1,
            b'=' => made += std::mem::take(&mut points),
            b'[' if open == 0 && (begins || is_header) => is_header = true,
            b'[' | b'{' => (made, open, points) = (made + 1, open + 1, 0),
            b']' if std::mem::take(&mut is_header) => made += 1 + std::mem::take(&mut points),
            b']' | b'}' => {
                // A number has one point.
                made += if points > 1 { points } else { 0 };
                (open, points) = (open.saturating_sub(1), 0);
            }
            b',' | b'\n' => (points, is_header) = (0, false),
            _ => {}
        }
        if made > MOST_TABLES {
            return Some(at);
        }
        at += 1;
    }
    None
}

/// The place after a text in quotes; one that is not closed ends with its line, or with the file where it may have several.
fn after_text(bytes: &[u8], from: usize) -> usize {
    let quote = bytes[from];
    let is_long = bytes[from..].starts_with(&[quote; 3]);
    let length = if is_long { 3 } else { 1 };
    let mut at = from + length;
    while let Some(&byte) = bytes.get(at) {
        if byte == quote && (!is_long || bytes[at..].starts_with(&[quote; 3])) {
            return at + length;
        }
        if byte == b'\n' && !is_long {
            return at;
        }
        at += if byte == b'\\' && quote == b'"' { 2 } else { 1 };
    }
    bytes.len()
}
