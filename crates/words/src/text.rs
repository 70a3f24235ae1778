//! A text by its identity and values.

use std::{borrow::Cow, fmt::Display, io};

use crate::digits;

/// A text that a person reads, before it is put into a language.
///
/// Its `Display` is English with the names by which parts are found: so JSON has it, which is never translated.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Text(pub(crate) Content);

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Content {
    /// A message of the resources; behind a point in the identity, one of its attributes.
    Message { id: &'static str, values: Vec<(&'static str, Text)> },
    /// The same letters in every language.
    Name(Cow<'static, str>),
    /// What is found by its name, and what a reader calls it: by the code of a language.
    Labelled { name: Box<Text>, labels: Vec<(&'static str, String)> },
    /// Digits as English prints them; the bits of the number that was rounded to them, where it is known.
    Number { digits: String, exact: Option<u64> },
    /// The symbol of a unit in English.
    Unit(Cow<'static, str>),
    /// How many there are of something: chooses the grammatical number.
    Count(usize),
    /// A message where there is little room.
    Short(Box<Text>),
    /// The beginning of a line.
    Heading(Box<Text>),
    /// Small letters below or above the line.
    Raised { letters: Box<Text>, level: Level },
    /// Several texts with the same letters between them.
    Joined { between: &'static str, parts: Vec<Text> },
}

/// Where small letters of a symbol stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Level {
    /// A subscript.
    Below,
    /// A superscript.
    Above,
}

impl Level {
    /// What stands before the letters.
    pub(crate) fn sign(self) -> char {
        match self {
            Self::Below => '_',
            Self::Above => '^',
        }
    }
}

/// A text by its identity: `text!("group-past-end", group = name(group), gap = quantity(format_args!("{gap:.2}"), "mm"))`.
/// Each value is a [`Text`], or a count; of a variable with the name of the value the name is enough. Without values it may
/// stand in a constant: in the entry of a plugin.
#[macro_export]
macro_rules! text {
    (@ $value:ident) => { $crate::Text::from($value) };
    (@ $value:ident = $text:expr) => { $crate::Text::from($text) };
    ($id:expr $(, $value:ident $(= $text:expr)?)* $(,)?) => {
        $crate::Text::message($id, vec![$((stringify!($value), $crate::text!(@ $value $(= $text)?))),*])
    };
}

impl Text {
    /// The message of an identity with its values; [`text!`](crate::text!) is shorter.
    pub const fn message(id: &'static str, values: Vec<(&'static str, Self)>) -> Self {
        Self(Content::Message { id, values })
    }

    /// The identity of its message; of several texts, that of the first that has one. `None` for letters and numbers alone.
    pub fn identity(&self) -> Option<&'static str> {
        match &self.0 {
            Content::Message { id, .. } => Some(id),
            Content::Short(text) | Content::Heading(text) | Content::Raised { letters: text, .. } => {
                text.identity()
            }
            Content::Joined { parts, .. } => parts.iter().find_map(Self::identity),
            Content::Name(_)
            | Content::Labelled { .. }
            | Content::Number { .. }
            | Content::Unit(_)
            | Content::Count(_) => None,
        }
    }

    /// Whether it has no letters in any language.
    pub fn is_empty(&self) -> bool {
        match &self.0 {
            Content::Name(letters) | Content::Unit(letters) => letters.is_empty(),
            Content::Number { digits, .. } => digits.is_empty(),
            Content::Joined { parts, .. } => parts.iter().all(Self::is_empty),
            Content::Short(text)
            | Content::Heading(text)
            | Content::Labelled { name: text, .. }
            | Content::Raised { letters: text, .. } => text.is_empty(),
            Content::Message { .. } | Content::Count(_) => false,
        }
    }

    /// Whether it is a number or a count and nothing else.
    pub fn is_number(&self) -> bool {
        matches!(self.0, Content::Number { .. } | Content::Count(_))
    }

    /// What stands in it with the same letters in every language: names, not labels, keys, paths, symbols.
    pub fn names(&self) -> Vec<&str> {
        match &self.0 {
            Content::Name(letters) => vec![letters],
            Content::Labelled { name, .. } => name.names(),
            Content::Message { values, .. } => values.iter().flat_map(|(_, value)| value.names()).collect(),
            Content::Short(text) | Content::Heading(text) | Content::Raised { letters: text, .. } => {
                text.names()
            }
            Content::Joined { parts, .. } => parts.iter().flat_map(Self::names).collect(),
            Content::Number { .. } | Content::Unit(_) | Content::Count(_) => Vec::new(),
        }
    }

    /// A symbol with a subscript: `F` with `bal` is `F_bal` where a line has no levels, and stands as in print where
    /// [`typeset`](Self::typeset) writes it.
    #[must_use]
    pub fn below(self, subscript: impl Into<Self>) -> Self {
        self.with(Level::Below, subscript.into())
    }

    /// A symbol with a superscript, as [`below`](Self::below): `a` with `n` is `a^n`.
    #[must_use]
    pub fn above(self, superscript: impl Into<Self>) -> Self {
        self.with(Level::Above, superscript.into())
    }

    fn with(self, level: Level, letters: Self) -> Self {
        if letters.is_empty() {
            return self;
        }
        joined("", [self, Self(Content::Raised { letters: Box::new(letters), level })])
    }

    /// The same where there is little room: the attribute `.short` of its message, where a language has one.
    #[must_use]
    pub fn short(self) -> Self {
        Self(Content::Short(Box::new(self)))
    }

    /// The same as a heading: a word at its beginning has a capital; a symbol of one letter stays as it is.
    #[must_use]
    pub fn heading(self) -> Self {
        Self(Content::Heading(Box::new(self)))
    }
}

impl Default for Text {
    /// The empty text.
    fn default() -> Self {
        name("")
    }
}

impl From<&Self> for Text {
    fn from(text: &Self) -> Self {
        text.clone()
    }
}

impl From<usize> for Text {
    fn from(number: usize) -> Self {
        count(number)
    }
}

/// What has the same letters in every language: a name of the scene, a kind of group, a method, a key, a path, a symbol, a
/// quoted line. No words.
pub fn name(letters: impl Into<Cow<'static, str>>) -> Text {
    Text(Content::Name(letters.into()))
}

/// What is found by a name, and what a reader calls it, by the code of a language; in a language that is left out its name there. Files
/// have the name in every language.
pub fn labelled(name: impl Into<Text>, labels: impl IntoIterator<Item = (&'static str, String)>) -> Text {
    Text(Content::Labelled { name: Box::new(name.into()), labels: labels.into_iter().collect() })
}

/// A number by its digits as English prints them: `-1.5e-7`. A language has its own decimal sign, minus and powers of ten.
pub fn number(digits: impl Display) -> Text {
    Text(Content::Number { digits: digits.to_string(), exact: None })
}

/// A number by its digits, as [`number`], with what was rounded to them: a [`Language`](crate::Language) with digits of its own rounds it
/// anew.
pub fn exact(value: f64, digits: impl Display) -> Text {
    Text(Content::Number { digits: digits.to_string(), exact: Some(value.to_bits()) })
}

/// The number of what results count from 0 and readers count from 1: of a mode of a group, a circuit, a branch.
pub fn ordinal(index: usize) -> Text {
    number(index + 1)
}

/// A unit by its English symbol: `kg m2/rad`.
pub fn unit(symbol: impl Into<Cow<'static, str>>) -> Text {
    Text(Content::Unit(symbol.into()))
}

/// A number, as [`number`], with its unit; the number alone where the symbol is empty.
pub fn quantity(digits: impl Display, symbol: impl Into<Cow<'static, str>>) -> Text {
    let symbol = symbol.into();
    if symbol.is_empty() { number(digits) } else { joined(" ", [number(digits), unit(symbol)]) }
}

/// A measured value, as [`exact`], with so many digits where a language has none of its own, and its unit.
pub fn measured(value: f64, significant: usize, symbol: impl Into<Cow<'static, str>>) -> Text {
    let symbol = symbol.into();
    let number = exact(value, digits(value, significant));
    if symbol.is_empty() { number } else { joined(" ", [number, unit(symbol)]) }
}

/// A length, m, in millimeters with so many decimals.
pub fn millimeters(length: f64, decimals: usize) -> Text {
    quantity(format_args!("{:.decimals$}", 1e3 * length), "mm")
}

/// An angle, rad, in degrees with so many decimals.
pub fn degrees(angle: f64, decimals: usize) -> Text {
    quantity(format_args!("{:.decimals$}", angle.to_degrees()), "deg")
}

/// What the coordinate of a mechanism is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CoordinateKind {
    /// An angle, rad.
    Angle,
    /// A displacement, m.
    Length,
    /// The time, s.
    Time,
}

impl CoordinateKind {
    /// Whether it is an angle.
    pub fn is_angle(self) -> bool {
        self == Self::Angle
    }

    /// Whether it is the time.
    pub fn is_time(self) -> bool {
        self == Self::Time
    }
}

/// The coordinate of a mechanism with so many decimals: an angle, rad, in degrees, a length, m, in millimeters, or a time, s.
pub fn coordinate(value: f64, kind: CoordinateKind, decimals: usize) -> Text {
    match kind {
        CoordinateKind::Angle => degrees(value, decimals),
        CoordinateKind::Length => millimeters(value, decimals),
        CoordinateKind::Time => quantity(format_args!("{value:.decimals$}"), "s"),
    }
}

/// How many there are of something: `{ $bodies -> [one] a body *[other] { $bodies } bodies }`.
pub fn count(number: usize) -> Text {
    Text(Content::Count(number))
}

/// Several texts with a comma between them.
pub fn list(parts: impl IntoIterator<Item = Text>) -> Text {
    joined(", ", parts)
}

/// Several texts with the same letters, not words, between them.
pub fn joined(between: &'static str, parts: impl IntoIterator<Item = Text>) -> Text {
    Text(Content::Joined { between, parts: parts.into_iter().collect() })
}

/// A type that describes itself in words for users: an error, a remark, a name.
pub trait Describe {
    /// The text that a person reads.
    fn describe(&self) -> Text;
}

/// Makes types that [`Describe`] themselves errors, whose `Display` is the English text, and `Debug`, too: it is what a program prints
/// whose `main` returns the error.
///
/// After a semicolon stand the variants of one type that hold an error of another crate:
/// `errors!(Own; Position(PositionError), Load(LoadError))`. The operator `?` converts such an error.
#[macro_export]
macro_rules! errors {
    ($($error:ty),* $(,)?) => {
        $(impl std::fmt::Display for $error {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(&$crate::Describe::describe(self), f)
            }
        }

        impl std::fmt::Debug for $error {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(self, f)
            }
        }

        impl std::error::Error for $error {})*
    };
    ($error:ty; $($variant:ident($cause:ty)),+ $(,)?) => {
        $crate::errors!($error);

        $(impl From<$cause> for $error {
            fn from(error: $cause) -> Self {
                Self::$variant(error)
            }
        })+
    };
}

/// A text as an error, for a library that takes errors and hands them back: [`text_of`] has the text again.
#[derive(Clone, PartialEq, Eq)]
pub struct Told(pub Text);

impl Describe for Told {
    fn describe(&self) -> Text {
        self.0.clone()
    }
}

errors!(Told);

/// What an error says: the [`Told`] text in it, or the words of the system or library that it comes from.
pub fn text_of(error: &io::Error) -> Text {
    let told = error.get_ref().and_then(|inner| inner.downcast_ref::<Told>());
    told.map_or_else(|| name(error.to_string()), Told::describe)
}
