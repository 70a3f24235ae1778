//! The tables of a scene with their keys, as `keys.txt` has them.

use std::sync::LazyLock;

use super::key::{SceneKey, of};

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

/// The table of a header of the reference; without keys where there is none.
pub fn table(header: &str) -> &'static KeyTable {
    static NONE: KeyTable =
        KeyTable { header: "", what: "scene-a-table", keys: Vec::new(), either: Vec::new() };
    TABLES.iter().find(|table| table.header == header).unwrap_or(&NONE)
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
    pub(super) fn chosen(&self) -> Option<&SceneKey> {
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
