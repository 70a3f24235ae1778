//! The reference of the scene: every key that the reader accepts, described once, in `keys.txt`. From here come the quantity,
//! the limits and the default of a number that is read, the keys that an error lists, `assur keys`, `docs/scene.md`, and the
//! manual page.

#[cfg(test)]
mod tests;

use std::f64::consts::TAU;
use std::ops::Bound as End;
use std::sync::LazyLock;

use assur_mechanism::{Key, Step};
use assur_words::{Describe, Language, Text, joined, name, text};

use crate::units::Dimension;

/// All tables in the order of the reference.
pub static TABLES: LazyLock<Vec<KeyTable>> = LazyLock::new(|| {
    let lines = include_str!("keys.txt").lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    let mut tables = Vec::<KeyTable>::new();
    for line in lines {
        if let Some((header, what)) = line.split_once(" : ") {
            tables.push(KeyTable { header: of(header), what, keys: Vec::new(), either: Vec::new() });
        } else if let (Some(table), Some(rivals)) = (tables.last_mut(), line.strip_prefix("either ")) {
            table.either.push(rivals.split("; ").map(|keys| keys.split(", ").collect()).collect());
        } else if let (Some(table), Some(key)) = (tables.last_mut(), SceneKey::read(line)) {
            table.keys.push(key);
        }
    }
    tables
});

/// What stands in a column, `-` for nothing.
fn of(column: &'static str) -> &'static str {
    if column == "-" { "" } else { column }
}

/// The table of a header of the reference; without keys where there is none.
pub fn table(header: &str) -> &'static KeyTable {
    static NONE: KeyTable =
        KeyTable { header: "", what: "scene-a-table", keys: Vec::new(), either: Vec::new() };
    TABLES.iter().find(|table| table.header == header).unwrap_or(&NONE)
}

/// A table of the scene and its keys.
#[derive(Debug)]
pub struct KeyTable {
    /// How it is written: `[link.NAME]`, `[[slide]]`; of the file as a whole empty.
    pub header: &'static str,
    /// The identity of what it is, with an article: a link.
    pub what: &'static str,
    /// Its keys.
    pub keys: Vec<SceneKey>,
    /// Choices among its keys: each has two or more rows of keys, and keys of two rows exclude each other.
    pub either: Vec<Vec<Vec<&'static str>>>,
}

/// A key of a table.
#[derive(Debug)]
pub struct SceneKey {
    /// How it is written; a name in capitals stands for one that the user chooses.
    pub name: &'static str,
    /// What its value may be, one of these.
    pub kinds: Vec<ValueKind>,
    /// The limits of its number.
    pub limits: Bound,
    /// What holds without it.
    pub default: KeyDefault,
    /// A value as it is written.
    pub example: &'static str,
    /// The identity of a sentence that says what it is.
    pub about: &'static str,
    /// Words by which people look for it, or which they write in its place, with commas between them.
    also: &'static str,
    /// The sorts of its table that have it, with commas between them: of a motion its kind; empty: all.
    pub sorts: &'static str,
}

/// What a value may be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ValueKind {
    /// A number in SI, or a text of a number and a unit.
    Quantity(Dimension),
    /// A quantity of the first dimension where the input turns, of the second where it slides.
    ByInput(Dimension, Dimension),
    /// A whole number.
    Count,
    /// `true` or `false`.
    Flag,
    /// A text of any words.
    Text,
    /// This word.
    Word(&'static str),
    /// The name of a part: "link", "point", "slide", "pair", "plugin".
    Named(&'static str),
    /// A place in the frame of a link: a point of it, two coordinates, or a length on its x axis.
    Place,
    /// Names of points with their places.
    Points,
    /// Two values of one kind.
    Two(Box<Self>),
    /// A list of values of one kind.
    List(Box<Self>),
    /// Rows of two numbers.
    Rows,
    /// A table with this header in the reference, or several.
    Table(&'static str),
}

/// What holds where a key is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KeyDefault {
    /// The table is refused without the key.
    Needed,
    /// The thing is absent, or as the sentence on the key says.
    Absent,
    /// This value.
    Is(&'static str),
}

impl SceneKey {
    /// Reads a line of the reference.
    fn read(line: &'static str) -> Option<Self> {
        let columns: Vec<_> = line.split(" | ").map(of).collect();
        let [name, kinds, limits, default, sorts, example, about, also] = columns[..] else { return None };
        let kinds = kinds.split("; ").map(ValueKind::read).collect::<Option<_>>()?;
        let limits = match limits {
            "" => Bound::Any,
            ">= 0" => Bound::NotNegative,
            "> 0" => Bound::Positive,
            "direction" => Bound::Direction,
            _ => return None,
        };
        let default = match default {
            "" => KeyDefault::Absent,
            "needed" => KeyDefault::Needed,
            value => KeyDefault::Is(value),
        };
        Some(Self { name, kinds, limits, default, example, about, also, sorts })
    }

    /// The quantity that it may be; `coordinate`: what the input coordinate is, `None` where that is not known.
    pub fn dimension(&self, coordinate: Option<Dimension>) -> Option<Dimension> {
        self.kinds.iter().find_map(|kind| match *kind {
            ValueKind::Quantity(dimension) => Some(dimension),
            ValueKind::ByInput(turning, sliding) => {
                coordinate.map(|coordinate| if coordinate == Dimension::Angle { turning } else { sliding })
            }
            _ => None,
        })
    }

    /// The words that it may be.
    pub fn words(&self) -> impl Iterator<Item = &'static str> {
        self.kinds.iter().filter_map(|kind| if let ValueKind::Word(word) = kind { Some(*word) } else { None })
    }

    /// Whether a table of this sort has it; without a sort every table has.
    pub fn is_of(&self, sort: Option<&str>) -> bool {
        self.sorts.is_empty() || sort.is_none_or(|sort| self.sorts.split(", ").any(|own| own == sort))
    }

    /// What its value may be, in words.
    pub fn values(&self) -> Text {
        either(self.kinds.iter().map(Describe::describe).collect())
    }

    /// The limits of its number, in words; empty where it has none.
    pub fn limits(&self) -> Text {
        match self.limits {
            Bound::Any => Text::default(),
            Bound::NotNegative => text!("scene-limit-not-negative"),
            Bound::Positive => text!("scene-limit-positive"),
            Bound::Direction => text!("scene-limit-direction"),
        }
    }

    /// Whether it, or the sentence on it, contains a word.
    fn speaks_of(&self, word: &str, language: &Language) -> bool {
        let names = self.also.split(", ").chain([self.name]);
        names.chain(self.words()).any(|own| own.to_lowercase().contains(word))
            || text!(self.about).render(language).to_lowercase().contains(word)
    }
}

/// Several texts, one of which holds: "these or the last".
pub fn either(mut texts: Vec<Text>) -> Text {
    let last = texts.pop().unwrap_or_default();
    if texts.is_empty() { last } else { text!("scene-either", these = joined(", ", texts), last) }
}

impl ValueKind {
    /// Reads a kind as the reference writes it.
    fn read(text: &'static str) -> Option<Self> {
        let within = |of: &str| text.strip_prefix(of);
        Some(match text {
            "count" => Self::Count,
            "flag" => Self::Flag,
            "text" => Self::Text,
            "place" => Self::Place,
            "points" => Self::Points,
            "rows" => Self::Rows,
            _ => {
                if let Ok(dimension) = text.parse() {
                    Self::Quantity(dimension)
                } else if let Some(part) = within("name of ") {
                    Self::Named(part)
                } else if let Some(of) = within("two of ") {
                    Self::Two(Box::new(Self::read(of)?))
                } else if let Some(of) = within("list of ") {
                    Self::List(Box::new(Self::read(of)?))
                } else if let Some(word) = within("\"") {
                    Self::Word(word.strip_suffix('"')?)
                } else if let Some((turning, sliding)) = text.split_once('/') {
                    Self::ByInput(turning.parse().ok()?, sliding.parse().ok()?)
                } else {
                    Self::Table(text)
                }
            }
        })
    }
}

impl Describe for ValueKind {
    fn describe(&self) -> Text {
        match self {
            Self::Quantity(dimension) => dimension.with_units(),
            Self::ByInput(turning, sliding) => {
                text!("scene-kind-by-input", turning = turning.with_units(), sliding = sliding.with_units())
            }
            Self::Count => text!("scene-kind-count"),
            Self::Flag => text!("scene-true-or-false"),
            Self::Text => text!("scene-a-text"),
            Self::Word(word) => name(format!("\"{word}\"")),
            Self::Named(part) => text!("scene-kind-name", what = name(*part)),
            Self::Place => text!("scene-kind-place"),
            Self::Points => text!("scene-table-of-points"),
            Self::Two(kind) => text!("scene-kind-two", of = kind.describe()),
            Self::List(kind) => text!("scene-kind-list", of = kind.describe()),
            Self::Rows => text!("scene-list-of-rows"),
            Self::Table(header) => text!("scene-kind-table", header = name(*header)),
        }
    }
}

impl KeyTable {
    /// The name of the table as it stands in keys: `link`, `drive.motor`; of the file as a whole empty.
    pub fn name(&self) -> &'static str {
        let inner = self.header.trim_matches(['[', ']']);
        inner.split(" = ").next().unwrap_or(inner).trim_end_matches(".NAME")
    }

    /// Names of its keys; with a sort those that a table of this sort has.
    pub(crate) fn names(&self, sort: Option<&str>) -> impl Iterator<Item = &'static str> {
        self.keys.iter().filter(move |key| key.is_of(sort)).map(|key| key.name)
    }

    /// All sorts of it, in the order of its keys; empty: there is only one.
    pub fn all_sorts(&self) -> Vec<&'static str> {
        let mut all = Vec::new();
        for sort in self.keys.iter().flat_map(|key| key.sorts.split(", ")).filter(|sort| !sort.is_empty()) {
            if !all.contains(&sort) {
                all.push(sort);
            }
        }
        all
    }

    /// Its keys that can't stand beside one of them.
    pub fn rivals(&self, key: &str) -> Vec<&'static str> {
        let has = |row: &Vec<&str>| row.contains(&key);
        let choices = self.either.iter().filter(|rows| rows.iter().any(has));
        choices.flatten().filter(|row| !has(row)).flatten().copied().collect()
    }

    /// A key of it.
    pub fn key(&self, name: &str) -> Option<&SceneKey> {
        self.keys.iter().find(|key| key.name == name)
    }

    /// The key that stands for names that the user chooses.
    fn chosen(&self) -> Option<&SceneKey> {
        self.keys.iter().find(|key| key.name.chars().all(|letter| letter.is_ascii_uppercase()))
    }

    /// The sorts of this table that have a key; `None` where all of them do, or none.
    pub(crate) fn sorts(&self, word: &str) -> Option<&'static str> {
        self.key(word).map(|key| key.sorts).filter(|sorts| !sorts.is_empty())
    }

    /// Where this key is found in another table.
    pub(crate) fn elsewhere(word: &str) -> Vec<&'static str> {
        let has = |table: &&KeyTable| table.key(word).is_some();
        TABLES.iter().filter(has).map(|table| table.header).filter(|header| !header.is_empty()).collect()
    }

    /// Whether a table is the value of a key of this one, as its header says: `value = { ... }`.
    fn holds(&self, header: &str) -> bool {
        header.split_once(" = ").is_some_and(|(key, _)| self.key(key).is_some())
    }

    /// The tables that have a key of this name: those in this one, or else all.
    pub(crate) fn holders(&self, word: &str) -> Vec<&'static str> {
        let all = Self::elsewhere(word);
        let within: Vec<_> = all.iter().copied().filter(|header| self.holds(header)).collect();
        if within.is_empty() { all } else { within }
    }

    /// The key that people mean by another word.
    pub(crate) fn meant(&self, word: &str) -> Option<&'static str> {
        let meant = |key: &&SceneKey| key.also.split(", ").any(|also| also.eq_ignore_ascii_case(word));
        self.keys.iter().find(meant).map(|key| key.name)
    }
}

/// Tables with those of their keys that a word is about; all keys of a table of that name.
pub fn search<'w>(
    word: &'w str,
    language: &'w Language,
) -> impl Iterator<Item = (&'static KeyTable, Vec<&'static SceneKey>)> + 'w {
    let (word, whole) = (word.trim().trim_matches(['[', ']']).to_lowercase(), word.is_empty());
    // The name of a table stands for the table and for keys of that name, not for every sentence in which it occurs.
    let names_table = TABLES.iter().any(|table| !table.header.is_empty() && table.name() == word);
    TABLES.iter().filter_map(move |table| {
        let (owner, own) = word.rsplit_once('.').unwrap_or(("", &word));
        let is_table = table.name() == word
            || (table.header.contains(".NAME") && table.name() == owner && own == "name");
        let of_table = |key: &SceneKey| !owner.is_empty() && table.name() == owner && key.name == own;
        let found = |key: &&SceneKey| {
            let speaks = if names_table { key.name == word } else { key.speaks_of(&word, language) };
            whole || is_table || of_table(key) || speaks
        };
        let keys: Vec<_> = table.keys.iter().filter(found).collect();
        (!keys.is_empty()).then_some((table, keys))
    })
}

/// The key of the reference that a value of a scene has: the innermost one that its key names. None where the reference lacks it.
pub fn key_of(key: &Key) -> Option<&'static SceneKey> {
    let name = |at: usize| match key.steps().get(at) {
        Some(Step::Name(name)) => Some(name.as_str()),
        _ => None,
    };
    let within = |at: usize, table: &str, is_list: bool| {
        let tables = TABLES.iter().filter(|known| known.name() == table);
        let own = |table: &&'static KeyTable| table.key(name(at)?).or_else(|| table.chosen());
        // `[input]` and `[[input]]` have keys of the same name.
        let found =
            tables.filter_map(|table| Some((table.header.starts_with("[[") != is_list, own(&table)?)));
        found.min_by_key(|(differs, _)| *differs).map(|(_, key)| key)
    };
    (0..key.steps().len()).rev().find_map(|at| {
        let outer = (0..at).rev().filter_map(|table| {
            // An element of a list has its number or its name between them.
            within(at, name(table)?, at > table + 1)
        });
        outer.chain((at == 0).then(|| within(0, "", false)).flatten()).next()
    })
}

/// What the reference says of a value of a scene, and the words by which people look for it: `length` for a point of a link. None
/// where it has no such key.
pub fn words_of(key: &Key) -> impl Iterator<Item = Text> + '_ {
    let named = |step: &'_ Step, name: &str| matches!(step, Step::Name(own) if own == name);
    let (first, rest) =
        key.steps().split_first().map_or((None, &[][..]), |(first, rest)| (Some(first), rest));
    let tables = TABLES.iter().filter(move |table| first.is_some_and(|first| named(first, table.name())));
    let keys = tables.flat_map(|table| &table.keys);
    let within = keys.filter(move |key| rest.iter().any(|step| named(step, key.name)));
    within.flat_map(|key| [text!(key.about), name(key.also)])
}

/// The name of a key or table that is spelled nearly like a word.
pub fn near(word: &str) -> Option<&'static str> {
    let names = TABLES.iter().flat_map(|table| table.names(None).chain([table.name()]));
    crate::text::nearest(word, names)
}

/// The greatest angle of a direction, rad, 1000 turns: a greater one would lose more than four of its 16 digits.
const MOST_DIRECTION: f64 = 1000.0 * TAU;

/// The range of a number, besides being finite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// Anything.
    Any,
    /// 0 or greater.
    NotNegative,
    /// Greater than 0.
    Positive,
    /// An angle that is a direction: at most 1000 turns either way.
    Direction,
}

impl Bound {
    /// Both ends of the range.
    pub(crate) fn ends(self) -> (End<f64>, End<f64>) {
        match self {
            Self::Any => (End::Unbounded, End::Unbounded),
            Self::NotNegative => (End::Included(0.0), End::Unbounded),
            Self::Positive => (End::Excluded(0.0), End::Unbounded),
            Self::Direction => (End::Included(-MOST_DIRECTION), End::Included(MOST_DIRECTION)),
        }
    }
}
