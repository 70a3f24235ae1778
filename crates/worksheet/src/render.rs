//! Prints a working as plain text.

use assur_words::Language;

use crate::{Entry, Section, Term};

/// Greatest width of a row that is printed on paper, characters.
pub const WIDTH: usize = 100;
/// Least width of a row: what a break may leave, behind the deepest indentation.
const LEAST_WIDTH: usize = 40;

/// Indentation of the further rows of an equation, and of wrapped text in them.
const NEXT: &str = "      ";
const WRAPPED: &str = "          ";

/// The sections as plain text in a language, in rows of at most `width` characters (40 at least).
pub fn text(sections: &[Section], width: usize, language: &Language) -> String {
    let width = width.max(LEAST_WIDTH);
    let mut out = String::new();
    for section in sections {
        if !out.is_empty() {
            out.push('\n');
        }
        let title = section.title.render(language);
        wrap(&title, width, "", "  ", &mut out);
        out.push_str(&"-".repeat(title.chars().count().min(width)));
        out.push('\n');
        for entry in &section.entries {
            write(entry, width, language, &mut out);
        }
    }
    out
}

fn write(entry: &Entry, width: usize, language: &Language, out: &mut String) {
    if let Entry::Note(words) = entry {
        return wrap(&words.render(language), width, "  ", "    ", out);
    }
    let side = |terms: Vec<Term>| terms.iter().map(|term| term.text().render(language)).collect::<String>();
    let sides: Vec<String> = entry.sides().into_iter().map(side).collect();
    equation(&sides, width, out);
}

/// One row if it fits, otherwise a row for each further side.
fn equation(sides: &[String], width: usize, out: &mut String) {
    let whole = sides.join(" = ");
    if whole.chars().count() + 2 <= width || sides.len() < 3 {
        return wrap(&whole, width, "  ", WRAPPED, out);
    }
    wrap(&sides[..2].join(" = "), width, "  ", WRAPPED, out);
    for side in &sides[2..] {
        wrap(&format!("= {side}"), width, NEXT, WRAPPED, out);
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
    let sign = |c: char| matches!(c, '+' | '-' | '−' | '=' | '*' | '/');
    let space = |i: &usize| rest[*i] == ' ' && !(sign(rest[*i - 1]) && rest.get(*i - 2) == Some(&' '));
    let product = |i: &usize| rest[*i - 1] == '*';
    let places = || (LEAST..=room).rev();
    places().find(space).or_else(|| places().find(product)).unwrap_or(room)
}
