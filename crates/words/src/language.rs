//! Texts in a language.

use std::collections::BTreeMap;
use std::fmt::{self, Display};
use std::sync::{Arc, OnceLock};

use fluent_bundle::{FluentArgs, FluentResource, FluentValue, concurrent::FluentBundle};
use serde::{Serialize, Serializer};
use unic_langid::LanguageIdentifier;

use crate::{CoordinateKind, Text, text::Content, text::Level, trimmed};

/// The codes of the languages, English first.
pub const LANGUAGES: [&str; 3] = ["en", "uk", "ru"];

/// A language with the texts of all crates that are linked.
pub struct Language {
    /// Its code: one of [`LANGUAGES`].
    pub code: &'static str,
    bundle: Arc<FluentBundle<FluentResource>>,
    /// Whether parts have their labels, as for a reader, and not the names by which they are found.
    has_labels: bool,
    /// Significant digits of results, where they are not to be as they come.
    digits: Option<usize>,
    /// Short signs of parts by their names, which stand for their labels.
    marks: Arc<BTreeMap<String, String>>,
    /// Whether they stand in subscripts and superscripts alone.
    marks_indices: bool,
}

impl fmt::Debug for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Language({})", self.code)
    }
}

impl Language {
    /// The language of a code; `None` for an unknown one.
    pub fn find(code: &str) -> Option<&'static Self> {
        static ALL: [OnceLock<Language>; 3] = [const { OnceLock::new() }; 3];
        let number = LANGUAGES.iter().position(|known| *known == code)?;
        Some(ALL[number].get_or_init(|| Self::read(LANGUAGES[number])))
    }

    /// English, in which every text is.
    #[expect(clippy::missing_panics_doc, reason = "English is the first of the languages")]
    pub fn english() -> &'static Self {
        Self::find(LANGUAGES[0]).expect("English is the first of the languages")
    }

    /// The same with so many significant digits of results.
    #[must_use]
    pub fn with_digits(&self, digits: usize) -> Self {
        Self {
            bundle: Arc::clone(&self.bundle),
            digits: Some(digits),
            marks: Arc::clone(&self.marks),
            ..*self
        }
    }

    /// The same with short signs of parts, by the names by which they are found, for their names and labels: the numbers of links in
    /// drawings and formulas.
    #[must_use]
    pub fn with_marks(&self, marks: impl IntoIterator<Item = (String, String)>) -> Self {
        let marks = Arc::new(marks.into_iter().collect());
        Self { bundle: Arc::clone(&self.bundle), marks, marks_indices: false, ..*self }
    }

    /// The same with these signs in subscripts and superscripts alone: words have the names of links, symbols their numbers.
    #[must_use]
    pub fn with_marks_in_indices(&self, marks: impl IntoIterator<Item = (String, String)>) -> Self {
        Self { marks_indices: true, ..self.with_marks(marks) }
    }

    /// English with the names by which parts are found: what files have.
    fn of_files() -> &'static Self {
        static OF_FILES: OnceLock<Language> = OnceLock::new();
        let english = Self::english();
        OF_FILES.get_or_init(|| Self {
            bundle: Arc::clone(&english.bundle),
            marks: Arc::default(),
            marks_indices: false,
            has_labels: false,
            ..*english
        })
    }

    /// Reads the texts; that they have no faults, and that no identity is there twice, is tested.
    fn read(code: &'static str) -> Self {
        let id: LanguageIdentifier = code.parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![id]);
        bundle.set_use_isolating(false);
        for resource in inventory::iter::<Resource>.into_iter().filter(|resource| resource.language == code) {
            let read = FluentResource::try_new(resource.texts.to_owned());
            bundle.add_resource_overriding(read.unwrap_or_else(|(read, _)| read));
        }
        let (bundle, marks) = (Arc::new(bundle), Arc::default());
        Self { code, bundle, has_labels: true, digits: None, marks, marks_indices: false }
    }

    fn is_english(&self) -> bool {
        self.code == LANGUAGES[0]
    }

    /// A text in this language as a line of letters; a subscript is one word with what it belongs to, `F_bal`.
    pub fn render(&self, text: &Text) -> String {
        self.written(text, in_line)
    }

    /// A text in this language for what can set letters lower and higher: subscripts stand in `_{...}`, superscripts in `^{...}`.
    pub fn typeset(&self, text: &Text) -> String {
        self.written(text, in_marks)
    }

    fn written(&self, text: &Text, in_level: InLevel) -> String {
        match &text.0 {
            Content::Message { id, values } => self.message(id, values, in_level),
            Content::Short(text) => match &text.0 {
                Content::Message { id, values } => self
                    .own_message(&format!("{id}.short"), values, in_level)
                    .unwrap_or_else(|| self.message(id, values, in_level)),
                _ => self.written(text, in_level),
            },
            Content::Heading(text) => capital(&self.written(text, in_level)),
            Content::Raised { letters, level } => in_level(*level, &self.index(letters)),
            Content::Name(letters) if self.marks_indices => letters.clone().into_owned(),
            Content::Name(letters) => self.mark(letters).unwrap_or(letters).to_owned(),
            Content::Labelled { name, labels } => {
                let is_marked = !self.marks.is_empty() && !self.marks_indices;
                if let Some(mark) = is_marked.then(|| self.mark(&name.to_string())).flatten() {
                    return mark.to_owned();
                }
                let own = labels.iter().find(|(code, _)| self.has_labels && *code == self.code);
                own.map_or_else(|| self.written(name, in_level), |(_, label)| label.clone())
            }
            Content::Number { digits, exact } => match exact.zip(self.digits) {
                Some((bits, digits)) => self.number(&trimmed(f64::from_bits(bits), digits)),
                None => self.number(digits),
            },
            Content::Unit(symbol) => self.unit(symbol),
            Content::Count(number) => number.to_string(),
            Content::Joined { between, parts } => {
                parts.iter().map(|part| self.written(part, in_level)).collect::<Vec<_>>().join(between)
            }
        }
    }

    /// What stands below or above a line.
    fn index(&self, letters: &Text) -> String {
        if !self.marks_indices {
            return self.render(letters);
        }
        let (bundle, marks) = (Arc::clone(&self.bundle), Arc::clone(&self.marks));
        Self { bundle, marks, marks_indices: false, ..*self }.render(letters)
    }

    fn mark(&self, name: &str) -> Option<&str> {
        self.marks.get(name).map(String::as_str)
    }

    /// What this language itself has of an identity without values, for one that is optional: `do-pick.also`.
    pub fn own(&self, id: &str) -> Option<String> {
        self.formatted(id, &FluentArgs::new())
    }

    /// An identity with a point in it names an attribute of a message: `quantity-speed.short`.
    fn formatted(&self, id: &str, values: &FluentArgs<'_>) -> Option<String> {
        let (id, attribute) = id.split_once('.').map_or((id, None), |(id, attribute)| (id, Some(attribute)));
        let message = self.bundle.get_message(id)?;
        let pattern = match attribute {
            None => message.value()?,
            Some(name) => message.get_attribute(name)?.value(),
        };
        Some(self.bundle.format_pattern(pattern, Some(values), &mut Vec::new()).into_owned())
    }

    /// In English where this language lacks it; the identity where no language has it.
    fn message(&self, id: &str, values: &[(&'static str, Text)], in_level: InLevel) -> String {
        self.own_message(id, values, in_level).unwrap_or_else(|| {
            if self.is_english() { id.to_owned() } else { Self::english().message(id, values, in_level) }
        })
    }

    /// `None` where this language lacks it.
    fn own_message(&self, id: &str, values: &[(&'static str, Text)], in_level: InLevel) -> Option<String> {
        let mut given = FluentArgs::new();
        for (name, value) in values {
            let value: FluentValue<'_> = match value.0 {
                Content::Count(number) => number.into(),
                _ => self.written(value, in_level).into(),
            };
            given.set(*name, value);
        }
        self.formatted(id, &given)
    }

    /// Digits with the signs of print of the language: minus, decimal sign, power of ten, no comma between thousands.
    fn number(&self, digits: &str) -> String {
        if self.is_english() {
            return digits.to_owned();
        }
        let (mantissa, exponent) = digits.split_once('e').unwrap_or((digits, "0"));
        let mantissa = mantissa.replace(',', "\u{a0}").replace('-', "−");
        let mantissa = mantissa.replace('.', &self.message("decimal-sign", &[], in_line));
        if exponent.chars().all(|digit| digit == '0') {
            return mantissa;
        }
        format!("{mantissa}·10{}", exponent.chars().map(raised).collect::<String>())
    }

    /// A unit with the signs of print, in the letters of the language: `m/s2` as m/s², or м/с².
    fn unit(&self, symbol: &str) -> String {
        let factor = |factor: &str| {
            let end = factor.find(|letter: char| !letter.is_ascii_alphabetic()).unwrap_or(factor.len());
            let (base, power) = factor.split_at(end);
            let power: String = power.trim_start_matches('^').chars().map(raised).collect();
            let own = match base {
                "" => return factor.to_owned(),
                base => self.own(&format!("unit-{base}")).unwrap_or_else(|| base.to_owned()),
            };
            own + &power
        };
        let parts = symbol.split('/');
        let parts = parts.map(|part| part.split([' ', '·']).map(factor).collect::<Vec<_>>().join("·"));
        match parts.collect::<Vec<_>>().as_slice() {
            [above, below, unit] => format!("({above}/{below})/{unit}"),
            parts => parts.join("/"),
        }
    }
}

/// How letters of a level are written.
type InLevel = fn(Level, &str) -> String;

/// As one word with what stands before them: `B, rod` below as `_B_rod`.
fn in_line(level: Level, letters: &str) -> String {
    let word = letters.replace(", ", "_");
    let letter = |letter: char| if letter.is_alphanumeric() { letter } else { '_' };
    std::iter::once(level.sign()).chain(word.chars().map(letter)).collect()
}

/// With marks around them.
fn in_marks(level: Level, letters: &str) -> String {
    format!("{}{{{letters}}}", level.sign())
}

/// A text with a capital at its beginning, where that is a word: a symbol is one letter, Latin or Greek.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let is_cyrillic = |letter: char| ('а'..='ӿ').contains(&letter);
    match (letters.next(), letters.clone().next()) {
        (Some(first), Some(next)) if first.is_lowercase() && (next.is_alphabetic() || is_cyrillic(first)) => {
            first.to_uppercase().chain(letters).collect()
        }
        _ => text.to_owned(),
    }
}

/// A digit or sign of an exponent.
fn raised(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0'..='9' => char::from_u32(u32::from(digit) - u32::from('0') + u32::from('⁰')).unwrap_or(digit),
        other => other,
    }
}

/// The texts of a crate in a language.
#[derive(Debug, Clone, Copy)]
pub struct Resource {
    /// Code of the language: one of [`LANGUAGES`](crate::LANGUAGES).
    pub language: &'static str,
    /// The texts by identity, in the syntax of Fluent.
    pub texts: &'static str,
    /// The crate, for messages.
    pub crate_name: &'static str,
}

inventory::collect!(Resource);

/// Brings along the files `lang/en.ftl`, `lang/uk.ftl` and `lang/ru.ftl` of the crate. It stands once in a crate.
#[macro_export]
macro_rules! resources {
    () => {
        $crate::resources!("en" "uk" "ru");
    };
    ($($language:literal)*) => {
        $($crate::inventory::submit! {
            $crate::Resource {
                language: $language,
                texts: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/lang/", $language, ".ftl")),
                crate_name: env!("CARGO_PKG_NAME"),
            }
        })*
    };
}

impl Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&Language::of_files().render(self))
    }
}

/// Whether it is an angle.
impl Serialize for CoordinateKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bool(self.is_angle())
    }
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl Text {
    /// The text in a language.
    pub fn render(&self, language: &Language) -> String {
        language.render(self)
    }

    /// The text in a language, with its subscripts in `_{...}` and its superscripts in `^{...}`: for what sets them lower and higher.
    pub fn typeset(&self, language: &Language) -> String {
        language.typeset(self)
    }
}
