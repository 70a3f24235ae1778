//! The working, remarks and names of checks in a language, from the resources of `lang`.
//!
//! What comes from elsewhere in English is translated by `*.toml`: whole sentences, in which `{}` stands for any text, and
//! phrases within a text. Names of the scene stay as they are.

#[cfg(test)]
mod tests;

use std::fmt;
use std::sync::OnceLock;

use assur_words::{Language, Text, text};

/// The languages.
pub(crate) const LANGUAGES: [&str; 3] = ["en", "uk", "ru"];
/// Their resources, in the same order: phrases with units.
const RESOURCES: [&str; 3] =
    [include_str!("../lang/en.toml"), include_str!("../lang/uk.toml"), include_str!("../lang/ru.toml")];
/// Units without exponents, as results write them.
const UNITS: [&str; 12] = ["m", "mm", "s", "kg", "N", "rad", "deg", "J", "W", "kW", "rpm", "Hz"];
/// The name of the fixed link in every scene.
const GROUND: &str = "ground";
/// What stands for any text in a sentence.
const ANY: &str = "{}";

/// The words of one language.
pub(crate) struct Words {
    pub(crate) language: &'static str,
    /// English sentences with [`ANY`], and their translations, the longest first.
    sentences: Vec<(String, String)>,
    /// English phrases and their translations, the longest first.
    phrases: Vec<(String, String)>,
    /// English units and their translations.
    units: Vec<(String, String)>,
    /// Parts of subscripts that the working gives, and their translations.
    subscripts: Vec<(String, String)>,
}

impl fmt::Debug for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Words({})", self.language)
    }
}

impl Words {
    /// The words of a language; of an unknown one, English.
    pub(crate) fn of(language: &str) -> &'static Self {
        static ALL: [OnceLock<Words>; 3] = [const { OnceLock::new() }; 3];
        let number = LANGUAGES.iter().position(|known| *known == language).unwrap_or(0);
        ALL[number].get_or_init(|| Self::read(number))
    }

    /// Reads the resources of a language; that they have no faults is tested.
    fn read(number: usize) -> Self {
        let others: toml::Table = RESOURCES[number].parse().unwrap_or_default();
        let section = |of: &str| -> Vec<(String, String)> {
            let table = others.get(of).and_then(toml::Value::as_table).into_iter().flatten();
            table.filter_map(|(english, own)| Some((english.clone(), own.as_str()?.to_owned()))).collect()
        };
        let mut all = section("phrases");
        all.sort_by_key(|(english, _)| std::cmp::Reverse(english.len()));
        let (sentences, phrases) = all.into_iter().partition(|(english, _)| english.contains(ANY));
        Self {
            language: LANGUAGES[number],
            sentences,
            phrases,
            units: section("units"),
            subscripts: section("subscripts"),
        }
    }

    /// A text that has an identity.
    fn get(&self, text: &Text) -> String {
        text.render(Language::find(self.language).unwrap_or_else(Language::english))
    }

    /// A part of a subscript: a name, or a word of the working.
    pub(crate) fn subscript(&self, part: &str) -> String {
        let own = self.subscripts.iter().find(|(english, _)| english == part);
        own.map_or_else(|| self.name(part), |(_, own)| own.clone())
    }

    /// `None` for a text that is no unit.
    fn printed(&self, text: &str) -> Option<String> {
        let factor = |text: &str| {
            let end = text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len());
            let (base, power) = text.split_at(end);
            let power = match power.trim_start_matches('^') {
                "" => "",
                "2" | "²" => "²",
                "3" | "³" => "³",
                _ => return None,
            };
            let base = UNITS.contains(&base).then_some(base)?;
            let own = self.units.iter().find(|(english, _)| english == base);
            Some(own.map_or(base, |(_, own)| own).to_owned() + power)
        };
        let part = |text: &str| {
            let factors: Option<Vec<String>> = text.split([' ', '·']).map(factor).collect();
            factors.map(|factors| factors.join("·"))
        };
        let parts: Vec<String> = text.split('/').map(part).collect::<Option<_>>()?;
        Some(match parts.as_slice() {
            [above, below, unit] => format!("({above}/{below})/{unit}"),
            _ => parts.join("/"),
        })
    }

    /// A text from elsewhere in English: a sentence that is known as a whole, or its known phrases, units and numbers.
    pub(crate) fn phrase(&self, text: &str) -> String {
        self.sentence(text).unwrap_or_else(|| self.name(&self.pieces(text))).replace('`', "")
    }

    /// A name of a link, a pair or a load, or several in a formula: of the scene as it is, given by the program in the
    /// words of the language (`contact 1 on rod`, `ram/ground`).
    pub(crate) fn name(&self, text: &str) -> String {
        let text = self.sentence(text).unwrap_or_else(|| text.to_owned());
        let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
        let mut named = String::new();
        for part in text.split_inclusive(|letter| !is_part(letter)) {
            let word = part.trim_end_matches(|letter| !is_part(letter));
            let own = if word == GROUND { self.get(&text!("mechanism-ground")) } else { word.to_owned() };
            named.push_str(&(own + &part[word.len()..]));
        }
        named
    }

    fn sentence(&self, text: &str) -> Option<String> {
        self.sentences.iter().find_map(|(english, own)| {
            let found = captured(english, text)?;
            let mut found = found.into_iter();
            let mut parts = own.split(ANY);
            let first = parts.next().unwrap_or_default().to_owned();
            let mut between = || self.name(&self.pieces(found.next().unwrap_or_default()));
            Some(parts.fold(first, |line, part| line + &between() + part))
        })
    }

    fn pieces(&self, text: &str) -> String {
        let mut words = String::new();
        let mut at = 0;
        while let Some(letter) = text[at..].chars().next() {
            let (before, rest) = text.split_at(at);
            if let Some((length, own)) = self.known(before, rest) {
                words.push_str(&own);
                at += length;
                continue;
            }
            at += letter.len_utf8();
            let follows_digit = before.ends_with(|before: char| before.is_ascii_digit());
            let leads_digit = text[at..].starts_with(|after: char| after.is_ascii_digit());
            match letter {
                '.' if follows_digit && leads_digit => words.push_str(&self.get(&text!("decimal-sign"))),
                '-' if leads_digit && !before.ends_with(is_of_name) => words.push('−'),
                _ => words.push(letter),
            }
        }
        words
    }

    /// Length and translation of the phrase, or of the unit, with which the rest begins.
    fn known(&self, before: &str, rest: &str) -> Option<(usize, String)> {
        if before.ends_with(is_of_name) {
            return None;
        }
        let ends = |length: &usize| !rest[*length..].starts_with(is_of_name);
        let phrase = self.phrases.iter().find(|(english, _)| {
            rest.starts_with(english.as_str()) && (ends(&english.len()) || english.ends_with(' '))
        });
        if let Some((english, own)) = phrase {
            return Some((english.len(), own.clone()));
        }
        let is_end = |c: char| c.is_ascii_digit() || c == ')';
        let number = before.strip_suffix(' ').is_some_and(|text| text.ends_with(is_end));
        if !(number || before.ends_with(", ")) {
            return None;
        }
        let places = rest.char_indices().map(|(at, _)| at).chain([rest.len()]).take(MOST_OF_UNIT).skip(1);
        let lengths: Vec<usize> = places.filter(ends).collect();
        lengths.into_iter().rev().find_map(|length| Some((length, self.printed(&rest[..length])?)))
    }
}

/// No unit has more letters.
const MOST_OF_UNIT: usize = 16;

/// What stands in a text where a sentence has [`ANY`]; `None` where the text is another sentence.
fn captured<'t>(sentence: &str, text: &'t str) -> Option<Vec<&'t str>> {
    let mut parts: Vec<&str> = sentence.split(ANY).collect();
    let (last, mut rest) = (parts.pop()?, text.strip_prefix(parts.first()?)?);
    rest = rest.strip_suffix(last)?;
    let mut found = Vec::new();
    for part in &parts[1..] {
        let (before, behind) = rest.split_once(part)?;
        found.push(before);
        rest = behind;
    }
    found.push(rest);
    Some(found)
}

/// Whether a letter belongs to a name, so that no word begins after it or ends before it.
fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '/'
}
