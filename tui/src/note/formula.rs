//! The working of a position as equations.

use assur_book::{Block, Document, Term};
use assur_words::{name, number, text, unit};
use assur_working::WorkingError;
use assur_worksheet::{Entry, Line};

use super::NoteError;
use super::context::Context;
use crate::words::Words;

/// Functions of the working.
const FUNCTIONS: [&str; 9] = ["sin", "cos", "tan", "atan2", "asin", "acos", "abs", "sign", "sqrt"];
/// Greek letters and their names in the working.
const GREEK: [(&str, &str); 8] = [
    ("w", "ω"),
    ("phi", "φ"),
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("sigma", "σ"),
    ("pi", "π"),
];

/// The equations of the first chosen position.
pub(super) fn working(context: &mut Context<'_>, page: &mut Document) -> Result<(), NoteError> {
    let words = context.words;
    let position = context.positions[0];
    let plans = context.found()?.plans.at(position);
    page.heading(text!("note-working", position = number(position)));
    let sections = match plans.working() {
        Ok(sections) => sections,
        Err(error @ WorkingError::Load { .. }) => {
            page.paragraph(name(words.phrase(&error.to_string())));
            return Ok(());
        }
        Err(error) => return Err(NoteError::Working(name(error.to_string()))),
    };
    // The first section repeats title and structure.
    for section in sections.iter().skip(1) {
        page.blocks.push(Block::Subheading(name(words.phrase(&section.title))));
        page.blocks.extend(section.entries.iter().map(|entry| match entry {
            // An equation without numbers.
            Entry::Note(text) if text.starts_with('(') => Block::Equation(symbols(words, text)),
            Entry::Note(text) => Block::Paragraph(name(remark(words, text))),
            Entry::Given { name, result, unit, .. } => {
                let mut terms = symbols(words, name);
                terms.extend(equals(symbols(words, result)));
                terms.extend(unit_of(unit));
                Block::Equation(terms)
            }
            Entry::Line(line) => Block::Equation(equation(words, line)),
        }));
    }
    Ok(())
}

/// A remark with Greek letters and subscripts.
fn remark(words: &Words, text: &str) -> String {
    let text = words.phrase(text);
    let mut line = String::new();
    let mut rest = text.as_str();
    while let Some(letter) = rest.chars().next() {
        let end = rest.find(|c: char| !is_of_symbol(c)).unwrap_or(rest.len()).max(letter.len_utf8());
        let (word, behind) = rest.split_at(end);
        if is_symbol(word) {
            let (letters, below) = named(words, word);
            line.push_str(&letters);
            if !below.is_empty() {
                line.extend(["_{", &below, "}"]);
            }
        } else {
            line.push_str(word);
        }
        rest = behind;
    }
    line.replace("^2", "²").replace(" -", " −").replace("(-", "(−")
}

fn equals(terms: Vec<Term>) -> impl Iterator<Item = Term> {
    std::iter::once(Term::Sign(" = ".to_owned())).chain(terms)
}

fn unit_of(symbol: &str) -> Option<Term> {
    (!symbol.is_empty()).then(|| Term::Unit(unit(symbol.to_owned())))
}

/// Name, formula, formula with numbers, result with its unit; what would repeat the part before it is left out.
fn equation(words: &Words, line: &Line) -> Vec<Term> {
    let mut terms = symbols(words, &line.name);
    let mut before = "";
    for part in [&line.text, &line.substituted, &line.result].map(String::as_str) {
        // `0.5 = 0.500000` says nothing.
        let same = part
            .parse::<f64>()
            .is_ok_and(|value| before.parse::<f64>().is_ok_and(|last| last.total_cmp(&value).is_eq()));
        if part != before && !part.is_empty() && !same {
            terms.extend(equals(symbols(words, part)));
        }
        before = part;
    }
    terms.extend(unit_of(&line.unit));
    terms
}

fn is_of_symbol(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '\''
}

/// An expression of the working: `x_A*cos(q)^2`.
fn symbols(words: &Words, text: &str) -> Vec<Term> {
    let mut terms = Vec::new();
    let mut rest = text;
    while let Some(letter) = rest.chars().next() {
        let split = |wanted: &dyn Fn(char) -> bool| {
            rest.split_at(rest.find(|c: char| !wanted(c)).unwrap_or(rest.len()))
        };
        let term;
        (term, rest) = if letter.is_alphabetic() {
            let (name, behind) = split(&is_of_symbol);
            (symbol(words, name), behind)
        } else if letter.is_ascii_digit() {
            let end = number_end(rest);
            (Term::Number(number(&rest[..end])), &rest[end..])
        } else if letter == '^' {
            let (power, behind) =
                rest[1..].split_at(rest[1..].find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len() - 1));
            (Term::Power(power.to_owned()), behind)
        } else {
            let sign = match letter {
                '*' => "·".to_owned(),
                '-' => "−".to_owned(),
                other => other.to_string(),
            };
            (Term::Sign(sign), &rest[letter.len_utf8()..])
        };
        terms.push(term);
    }
    terms
}

/// Where the number ends with which a text begins: `1.5e-7`.
fn number_end(text: &str) -> usize {
    let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
    let exponent = text[end..].strip_prefix('e').map(|rest| {
        let sign = usize::from(rest.starts_with('-'));
        sign + rest[sign..].find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len() - sign)
    });
    exponent.map_or(end, |length| end + 1 + length)
}

fn symbol(words: &Words, symbol: &str) -> Term {
    match symbol {
        "sqrt" => Term::Function("√"),
        other => match FUNCTIONS.into_iter().find(|function| *function == other) {
            Some(function) => Term::Function(function),
            None => {
                let (letters, below) = named(words, other);
                Term::Name(letters, name(below))
            }
        },
    }
}

/// Letter with primes, and the subscript, of a symbol of the working: `d'x_1` is d′ with the subscript `x, 1`.
fn named(words: &Words, name: &str) -> (String, String) {
    let (base, below) = name.split_once('_').unwrap_or((name, ""));
    let letters = base.replace('\'', "");
    let primes = match base.len() - letters.len() {
        0 => "",
        1 => "′",
        _ => "″",
    };
    let (letter, part) = match GREEK.into_iter().find(|(english, _)| *english == letters) {
        Some((_, greek)) => (greek, ""),
        None => letters.split_at(letters.chars().next().map_or(0, char::len_utf8)),
    };
    let parts = std::iter::once(part).chain(below.split('_')).filter(|part| !part.is_empty());
    let parts: Vec<String> = parts.map(|part| words.subscript(part)).collect();
    (format!("{letter}{primes}"), parts.join(", "))
}

/// Whether a word of a remark is a symbol: `phi`, `x_A`, `s'`, not a word or a name.
fn is_symbol(word: &str) -> bool {
    let base = word.split_once('_').map_or(word, |(base, _)| base);
    let letters = base.trim_end_matches('\'');
    GREEK.iter().any(|(english, _)| *english == letters)
        || (base != word || letters != base) && letters.len() <= 2
}
