//! The text of a scene from a number.

use assur_mechanism::Mechanism;
use assur_testkit::Rng;
use assur_testkit::specimen::{Recipe, scene_text};

/// Where a text comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// A random mechanism with its loads, and a drive for some.
    Mechanism,
    /// A known scene with numbers, lines and sections changed.
    Mutated,
    /// A known scene with bytes changed.
    Bytes,
}

/// Numbers at which programs break.
const NUMBERS: [&str; 26] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "1e-3",
    "1e3",
    "1e-9",
    "1e9",
    "1e15",
    "-1e15",
    "1e30",
    "-1e30",
    "1e-30",
    "1e-300",
    "5e-324",
    "1e300",
    "1.7976931348623157e308",
    "-1.7976931348623157e308",
    "9223372036854775807",
    "nan",
    "inf",
    "3.141592653589793",
    "0.1",
    "12",
    "\"\"",
    "true",
];

/// Pieces of text that mean something in a scene, or to a terminal, or to a reader of tables.
const PIECES: [&str; 16] = [
    "[",
    "]",
    "{",
    "}",
    "\"",
    "=",
    "\n",
    "#",
    "[[slide]]\n",
    "\u{1b}[31m",
    "\u{202e}",
    "\u{200b}",
    "\0",
    "é",
    "=1+1",
    "'",
];

/// Drives and motions that are added to a random mechanism.
const MOTIONS: [&str; 4] = [
    "[motion]\nkind = \"transient\"\nspeed = 3\nuntil = \"0.5 s\"\nsamples = 12\n",
    "[motion]\nkind = \"transient\"\nspeed = 2\nuntil = \"1 rev\"\nsamples = 12\n",
    "[motion]\nkind = \"steady\"\nmean_speed = 6\nunevenness = 0.05\n[drive]\ntorque = \"balance\"\nflywheel = \"auto\"\n",
    "[motion]\nkind = \"transient\"\nspeed = 0\nuntil = \"rest\"\nsamples = 8\n",
];

/// The text of input `number`, made from the known scenes; the same for the same number.
pub fn input(number: u64, known: &[String]) -> (Source, String) {
    let mut rng = Rng::new(number);
    match rng.below(8) {
        0 => (Source::Mechanism, mechanism(number, &mut rng).unwrap_or_default()),
        1..=5 => (Source::Mutated, mutated(known, &mut rng)),
        _ => (Source::Bytes, String::from_utf8_lossy(&bytes(known, &mut rng)).into_owned()),
    }
}

fn mechanism(seed: u64, rng: &mut Rng) -> Option<String> {
    let recipe = Recipe { groups: 1 + rng.below(4), only: None, loads: rng.chance(0.8) };
    let found = recipe.specimen(seed)?.mechanism;
    if rng.chance(0.5) {
        return Some(scene_text(&found));
    }
    let text = scene_text(&Mechanism { motion: None, drive: None, balance: None, ..found });
    let motion: &&str = rng.pick(&MOTIONS);
    Some(text + motion)
}

fn mutated(known: &[String], rng: &mut Rng) -> String {
    let mut text = rng.pick(known).clone();
    for _ in 0..=rng.below(4) {
        text = match rng.below(10) {
            0..=4 => number_changed(&text, rng),
            5..=7 => lines_changed(&text, rng),
            8 => {
                let other: &String = rng.pick(known);
                sections_changed(&text, other, rng)
            }
            _ => with_piece(&text, rng),
        };
    }
    text
}

/// Byte ranges of the numbers of a text.
fn numbers_of(text: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let starts = bytes[at].is_ascii_digit()
            && (at == 0 || !bytes[at - 1].is_ascii_alphanumeric() && bytes[at - 1] != b'_');
        if !starts {
            at += 1;
            continue;
        }
        let sign = usize::from(at > 0 && matches!(bytes[at - 1], b'-' | b'+'));
        let mut end = at;
        while end < bytes.len()
            && (bytes[end].is_ascii_digit()
                || matches!(bytes[end], b'.' | b'e' | b'_')
                || matches!(bytes[end], b'-' | b'+') && bytes[end - 1] == b'e')
        {
            end += 1;
        }
        found.push(at - sign..end);
        at = end;
    }
    found
}

fn number_changed(text: &str, rng: &mut Rng) -> String {
    let numbers = numbers_of(text);
    if numbers.is_empty() {
        return text.to_owned();
    }
    let at = rng.pick(&numbers).clone();
    let old = &text[at.clone()];
    let new = match (rng.below(4), old.parse::<f64>()) {
        (0, Ok(value)) => format!("{:?}", value * 10.0_f64.powf(rng.signed(0.0, 1.0))),
        (1, Ok(value)) => format!("{:?}", -value),
        (2, Ok(value)) => format!("{:?}", value * (1.0 + rng.signed(0.0, 1e-9))),
        _ => (*rng.pick(&NUMBERS)).to_owned(),
    };
    format!("{}{new}{}", &text[..at.start], &text[at.end..])
}

fn lines_changed(text: &str, rng: &mut Rng) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    if lines.is_empty() {
        return text.to_owned();
    }
    let (a, b) = (rng.below(lines.len()), rng.below(lines.len()));
    match rng.below(3) {
        0 => drop(lines.remove(a)),
        1 => lines.insert(b, lines[a]),
        _ => lines.swap(a, b),
    }
    lines.join("\n") + "\n"
}

/// The text in pieces that begin with the head of a section.
fn sections_of(text: &str) -> Vec<String> {
    let mut sections = vec![String::new()];
    for line in text.lines() {
        if line.starts_with('[') {
            sections.push(String::new());
        }
        if let Some(last) = sections.last_mut() {
            *last += line;
            last.push('\n');
        }
    }
    sections
}

fn sections_changed(text: &str, other: &str, rng: &mut Rng) -> String {
    let mut sections = sections_of(text);
    let (a, b) = (rng.below(sections.len()), rng.below(sections.len()));
    match rng.below(4) {
        0 => drop(sections.remove(a)),
        1 => sections.push(sections[a].clone()),
        2 => sections.swap(a, b),
        _ => sections.push(rng.pick(&sections_of(other)).clone()),
    }
    sections.concat()
}

fn with_piece(text: &str, rng: &mut Rng) -> String {
    let places: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
    let at = if places.is_empty() { 0 } else { *rng.pick(&places) };
    format!("{}{}{}", &text[..at], rng.pick(&PIECES), &text[at..])
}

fn bytes(known: &[String], rng: &mut Rng) -> Vec<u8> {
    let mut bytes = rng.pick(known).clone().into_bytes();
    for _ in 0..=rng.below(6) {
        let at = rng.below(bytes.len().max(1));
        let end = (at + 1 + rng.below(20)).min(bytes.len());
        match rng.below(4) {
            0 if at < bytes.len() => bytes[at] ^= 1 << rng.below(8),
            1 if at < end => drop(bytes.drain(at..end)),
            2 if at < end => {
                let copy = bytes[at..end].to_vec();
                let to = rng.below(bytes.len());
                bytes.splice(to..to, copy);
            }
            _ => {
                let at = at.min(bytes.len());
                let byte = u8::try_from(rng.below(256)).unwrap_or_default();
                bytes.insert(at, byte);
            }
        }
    }
    bytes
}
