//! Text for messages.

use std::borrow::Cow;

use assur_mechanism::appearance;
use assur_words::{Text, joined, name, number, text};

/// The longest piece of a scene that a message quotes, in characters.
const LONGEST: usize = 40;

/// Whether a character is a control character, has no width or changes the direction of writing: a name that contains
/// it looks like another name.
pub(crate) fn is_unprintable(c: char) -> bool {
    let is_invisible = matches!(c,
        '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}');
    c.is_control() || is_invisible
}

/// A number for a message: in full where it is short.
pub(crate) fn brief(value: f64) -> Text {
    let plain = value.to_string();
    number(if plain.len() <= 12 { plain } else { format!("{value:.4e}") })
}

/// A number that was calculated, to four digits.
pub(crate) fn rounded(value: f64) -> Text {
    brief(format!("{value:.3e}").parse().unwrap_or(value))
}

/// A piece of the scene as a message quotes it: one line, without control characters, of limited length.
pub(crate) fn shown(piece: &str) -> Text {
    name(cut(piece))
}

fn cut(piece: &str) -> String {
    let mut out: String =
        piece.chars().take(LONGEST).map(|c| if is_unprintable(c) { '?' } else { c }).collect();
    if piece.chars().nth(LONGEST).is_some() {
        out.push_str("...");
    }
    out
}

/// The known word with nearly the same spelling as `word`; the first of equally near ones.
pub fn nearest<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    // A third of the letters may be wrong: `lenght` for `length`, but not `mm` for `kg`.
    let limit = (word.chars().count() / 3).max(1);
    let lower = appearance(word).to_lowercase();
    let mut best: Option<(usize, &str)> = None;
    for candidate in known.into_iter().filter(|_| word.len() <= 64) {
        let distance = strsim::damerau_levenshtein(&lower, &appearance(candidate).to_lowercase());
        let short = distance >= candidate.chars().count() || distance >= word.chars().count();
        if distance <= limit && !short && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// The known words, those with nearly the same spelling as `word` first; equally near ones keep their order.
pub fn by_likeness<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Vec<&'k str> {
    // The search for a spelling takes as long as the word times each known one.
    let lower: String = appearance(word).to_lowercase().chars().take(LONGEST).collect();
    let unlikeness =
        |known: &str| -strsim::normalized_damerau_levenshtein(&lower, &appearance(known).to_lowercase());
    let mut all: Vec<(f64, &str)> = known.into_iter().map(|known| (unlikeness(known), known)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, known)| known).collect()
}

/// "did you mean `x`?" of a word, or an empty text. Of two that look the same it says which letters differ.
pub(crate) fn did_you_mean(word: &str, near: Option<&str>) -> Text {
    let Some(near) = near else { return Text::default() };
    if word != near && appearance(word) == appearance(near) {
        let foreign = if word.is_ascii() { near } else { word };
        return text!("scene-did-you-mean-letters", name = shown(near), codes = name(codes(foreign)));
    }
    text!("scene-did-you-mean", name = shown(near))
}

/// The letters of a name that are not ASCII, by their numbers in Unicode: `U+0410`; of an ASCII name the letters themselves.
pub(crate) fn codes(name: &str) -> String {
    if name.is_ascii() {
        return name.to_owned();
    }
    let foreign = name.chars().filter(|letter| !letter.is_ascii());
    foreign.map(|letter| format!("U+{:04X}", u32::from(letter))).collect::<Vec<_>>().join(" ")
}

/// An example of what may be written, as it is written.
pub(crate) fn such_as(example: impl Into<Cow<'static, str>>) -> Text {
    text!("scene-such-as", example = name(example))
}

/// A list of names, at most a dozen: "A, B, C".
pub(crate) fn row<'n>(names: impl IntoIterator<Item = &'n str>) -> Text {
    listed(names.into_iter().map(cut).collect(), 12)
}

/// A list of names, at most so many.
pub(crate) fn listed(mut names: Vec<String>, most: usize) -> Text {
    let more = names.len().saturating_sub(most);
    names.truncate(most);
    let shown = name(names.join(", "));
    if more == 0 { shown } else { text!("scene-and-more", names = shown, more) }
}

/// A text of the scene with the quotes of TOML.
pub(crate) fn in_quotes(text: &str) -> Text {
    joined("", [name("\""), shown(text), name("\"")])
}

/// That two keys exclude each other.
pub(crate) fn exclude([one, other]: [Text; 2]) -> Text {
    text!("scene-exclude", one, other)
}
