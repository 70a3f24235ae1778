//! Prints a working as plain text.

use crate::{Entry, Line, Section};

/// Greatest width of a row that is printed on paper, characters.
pub const WIDTH: usize = 100;
/// Least width of a row: what a break may leave, behind the deepest indentation.
const LEAST_WIDTH: usize = 40;

/// Indentation of the further rows of an equation, and of wrapped text in them.
const NEXT: &str = "      ";
const WRAPPED: &str = "          ";

/// The sections as plain text in rows of at most `width` characters (40 at least), in ASCII except for names and units.
pub fn text(sections: &[Section], width: usize) -> String {
    let width = width.max(LEAST_WIDTH);
    let mut out = String::new();
    for section in sections {
        if !out.is_empty() {
            out.push('\n');
        }
        wrap(&section.title, width, "", "  ", &mut out);
        out.push_str(&"-".repeat(section.title.chars().count().min(width)));
        out.push('\n');
        for entry in &section.entries {
            write(entry, width, &mut out);
        }
    }
    out
}

fn write(entry: &Entry, width: usize, out: &mut String) {
    match entry {
        Entry::Note(words) => wrap(words, width, "  ", "    ", out),
        Entry::Given { name, result, unit, what, .. } => {
            let what = if what.is_empty() { String::new() } else { format!("  ({what})") };
            wrap(&format!("{name} = {}{what}", join(result, unit)), width, "  ", WRAPPED, out);
        }
        Entry::Line(line) => equation(line, width, out),
    }
}

fn join(result: &str, unit: &str) -> String {
    if unit.is_empty() { result.to_owned() } else { format!("{result} {unit}") }
}

/// One row if it fits, otherwise a row for each part.
fn equation(line: &Line, width: usize, out: &mut String) {
    let mut parts = vec![line.text.as_str()];
    if line.substituted != line.text {
        parts.push(&line.substituted);
    }
    let result = join(&line.result, &line.unit);
    if line.substituted != line.result {
        parts.push(&result);
    } else if let Some(last) = parts.last_mut() {
        *last = &result;
    }
    let whole = format!("{} = {}", line.name, parts.join(" = "));
    if whole.chars().count() + 2 <= width {
        return wrap(&whole, width, "  ", WRAPPED, out);
    }
    wrap(&format!("{} = {}", line.name, parts[0]), width, "  ", WRAPPED, out);
    for part in &parts[1..] {
        wrap(&format!("= {part}"), width, NEXT, WRAPPED, out);
    }
}

/// Breaks a row at spaces, before an operator; if there is no space within the width, after a `*` or a comma.
fn wrap(words: &str, width: usize, indent: &str, next: &str, out: &mut String) {
    let mut rest: Vec<char> = words.chars().collect();
    let mut indent = indent;
    while !rest.is_empty() {
        let room = width - indent.len();
        let cut = if rest.len() <= room { rest.len() } else { cut(&rest, room) };
        let tail = rest.split_off(cut);
        out.push_str(indent);
        out.push_str(rest.iter().collect::<String>().trim_end());
        out.push('\n');
        rest = tail;
        while rest.first() == Some(&' ') {
            rest.remove(0);
        }
        indent = next;
    }
}

fn cut(rest: &[char], room: usize) -> usize {
    /// Shortest row that a break may leave.
    const LEAST: usize = 20;
    let sign = |c: char| matches!(c, '+' | '-' | '=' | '*' | '/');
    let space = |i: &usize| rest[*i] == ' ' && !(sign(rest[*i - 1]) && rest.get(*i - 2) == Some(&' '));
    let product = |i: &usize| rest[*i - 1] == '*';
    let places = || (LEAST..=room).rev();
    places().find(space).or_else(|| places().find(product)).unwrap_or(room)
}
