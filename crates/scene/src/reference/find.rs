//! Keys of the reference that a word or a value of a scene is about.

use assur_mechanism::{Key, Step};
use assur_words::{Language, Text, name, text};

use super::key::SceneKey;
use super::table::{KeyTable, TABLES};

/// Tables with those of their keys that a word is about; all keys of a table of that name. Letters within words count where no word
/// begins with them.
pub fn search<'w>(
    word: &'w str,
    language: &'w Language,
) -> impl Iterator<Item = (&'static KeyTable, Vec<&'static SceneKey>)> + 'w {
    let (word, whole) = (word.trim().trim_matches(['[', ']']).to_lowercase(), word.is_empty());
    // The name of a table stands for the table and for keys of that name, not for every sentence in which it occurs.
    let names_table = TABLES.iter().any(|table| !table.header.is_empty() && table.name() == word);
    let mut all = TABLES.iter().flat_map(|table| &table.keys);
    let begin = all.any(|key| key.speaks_of(&word, true, language));
    TABLES.iter().filter_map(move |table| {
        let (owner, own) = word.rsplit_once('.').unwrap_or(("", &word));
        let is_table = table.name() == word
            || (table.header.contains(".NAME") && table.name() == owner && own == "name");
        let of_table = |key: &SceneKey| !owner.is_empty() && table.name() == owner && key.name == own;
        let found = |key: &&SceneKey| {
            let speaks = if names_table { key.name == word } else { key.speaks_of(&word, begin, language) };
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
        // Of a table with a name that the user chooses, the name stands between, which may be that of a key: a point `r`.
        let is_far = |known: &KeyTable| is_list || !known.header.contains(".NAME = ");
        let tables = TABLES.iter().filter(|known| known.name() == table && is_far(known));
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
