//! The words of a note in its language, from the resources of `lang`.

use std::fmt;

use fluent_bundle::{FluentArgs, FluentBundle, FluentResource};
use unic_langid::LanguageIdentifier;

/// The languages and their resources.
const RESOURCES: [(&str, &str); 3] = [
    ("en", include_str!("../../lang/en.ftl")),
    ("uk", include_str!("../../lang/uk.ftl")),
    ("ru", include_str!("../../lang/ru.ftl")),
];
/// What begins the name of a phrase of figures; the rest of the name is the English phrase.
const PHRASE: &str = "w-";

/// The words of one language.
pub(super) struct Words {
    bundle: FluentBundle<FluentResource>,
    pub(super) language: &'static str,
    /// English phrases and their translations, the longest first.
    phrases: Vec<(String, String)>,
}

impl fmt::Debug for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Words({})", self.language)
    }
}

impl Words {
    /// The words of a language.
    ///
    /// # Errors
    ///
    /// An unknown language, or a resource that can't be read.
    pub(super) fn of(language: &str) -> Result<Self, String> {
        let known = RESOURCES.into_iter().find(|(name, _)| *name == language);
        let (name, text) =
            known.ok_or_else(|| format!("there is no language `{language}`; there are en, uk, ru"))?;
        let id: LanguageIdentifier = name.parse().map_err(|error| format!("language {name}: {error}"))?;
        let resource = FluentResource::try_new(text.to_owned())
            .map_err(|(_, errors)| format!("the words of {name} can't be read: {errors:?}"))?;
        let mut bundle = FluentBundle::new(vec![id]);
        bundle.set_use_isolating(false);
        bundle.add_resource(resource).map_err(|errors| format!("the words of {name} clash: {errors:?}"))?;
        let mut phrases: Vec<(String, String)> = text
            .lines()
            .filter_map(|line| line.strip_prefix(PHRASE)?.split_once(" = "))
            .map(|(english, own)| (english.replace('-', " "), own.to_owned()))
            .collect();
        phrases.sort_by_key(|(english, _)| std::cmp::Reverse(english.len()));
        Ok(Self { bundle, language: name, phrases })
    }

    /// The text of an identifier; the identifier where there is none.
    pub(super) fn get(&self, id: &str) -> String {
        self.with(id, &[])
    }

    /// The text of an identifier with its values.
    pub(super) fn with(&self, id: &str, values: &[(&'static str, String)]) -> String {
        let Some(pattern) = self.bundle.get_message(id).and_then(|message| message.value()) else {
            return id.to_owned();
        };
        let mut given = FluentArgs::new();
        for (name, value) in values {
            given.set(*name, value.clone());
        }
        self.bundle.format_pattern(pattern, Some(&given), &mut Vec::new()).into_owned()
    }

    /// A number with the decimal sign of the language.
    pub(super) fn number(&self, text: &str) -> String {
        text.replace('.', &self.get("decimal"))
    }

    /// A text of a figure: its known phrases are translated, its numbers have the decimal sign of the language.
    pub(super) fn phrase(&self, text: &str) -> String {
        let mut words = String::new();
        let mut rest = text;
        let mut free = true;
        'next: while let Some(letter) = rest.chars().next() {
            if free {
                for (english, own) in &self.phrases {
                    let behind = rest.strip_prefix(english.as_str());
                    if let Some(behind) = behind.filter(|behind| !behind.starts_with(is_of_name)) {
                        words.push_str(own);
                        rest = behind;
                        free = false;
                        continue 'next;
                    }
                }
            }
            rest = &rest[letter.len_utf8()..];
            let is_decimal = letter == '.'
                && words.ends_with(|before: char| before.is_ascii_digit())
                && rest.starts_with(|after: char| after.is_ascii_digit());
            if is_decimal {
                words.push_str(&self.get("decimal"));
            } else {
                words.push(letter);
            }
            free = !is_of_name(letter);
        }
        words
    }
}

/// Whether a letter belongs to a name, so that no word begins after it or ends before it.
fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '/'
}
