//! Of which sort a table is, where the reference knows several.

use assur_mechanism::Key;
use assur_scene::reference::{KeyDefault, KeyTable, SceneKey, table};

use crate::field::{Opening, what};
use crate::tables::{Tables, headers};

/// The sort of a table that stands, or would be there without any keys.
pub(crate) fn sort(tables: &Tables<'_>, at: &Key, table: &KeyTable) -> Option<&'static str> {
    let sorts = table.all_sorts();
    let of_scene = match table.header {
        "[motion]" if tables.is_over_time() => Some("over_time"),
        "[[friction]]" => return tables.sort_of_pair(tables.word(&at.clone().at("pair"))?),
        _ => None,
    };
    let of_key = || {
        sorts.iter().copied().find(|sort| table.key(sort).is_some() && tables.stands(&at.clone().at(*sort)))
    };
    of_scene.or_else(of_key).or_else(|| of_word(tables, at, table))
}

/// The sort that a word of the table says, or else its default.
fn of_word(tables: &Tables<'_>, at: &Key, table: &KeyTable) -> Option<&'static str> {
    let key = word_key(table)?;
    let sorts = table.all_sorts();
    let default = if let KeyDefault::Is(word) = key.default { Some(word.trim_matches('"')) } else { None };
    let word = tables.word(&at.clone().at(key.name)).or(default)?;
    // A word that is no sort is another spelling of the one before it.
    let words: Vec<_> = key.words().collect();
    let place = words.iter().position(|own| *own == word)?;
    words[..=place].iter().rev().find_map(|word| sorts.iter().copied().find(|sort| sort == word))
}

/// The key whose words are sorts of its table.
pub(crate) fn word_key(table: &KeyTable) -> Option<&SceneKey> {
    let sorts = table.all_sorts();
    table.keys.iter().find(|key| key.words().any(|word| sorts.contains(&word)))
}

/// The tables that may be the value of a key, one for each sort.
pub(crate) fn openings(tables: &Tables<'_>, at: &Key, key: &SceneKey) -> Vec<Opening> {
    let stands = tables.table(at).is_some();
    let of_header = |header: &'static str| {
        let known = table(header);
        let own = sort(tables, at, known).filter(|_| stands);
        let opening = move |sort: Option<&'static str>| Opening {
            header,
            sort,
            label: what(header, sort),
            stands: stands && sort == own,
        };
        let sorts = known.all_sorts();
        let sorts: Vec<_> = if sorts.is_empty() { vec![None] } else { sorts.into_iter().map(Some).collect() };
        sorts.into_iter().map(opening)
    };
    let all = headers(key).filter(|header| !header.starts_with('[')).flat_map(of_header);
    all.filter(|opening| opening.sort.is_none_or(|sort| opening.stands || is_possible(tables, at, sort)))
        .collect()
}

/// Whether the value of a key may be a table of a sort: only a force has a point whose stroke can be followed, and of several inputs none
/// has the coordinate of the mechanism.
pub(crate) fn is_possible(tables: &Tables<'_>, at: &Key, sort: &str) -> bool {
    let is_single = tables.count(&Key::of("input")) == 0;
    match sort {
        "stroke" => is_single && at.steps().first() == Some(&"force".into()),
        "angle" | "coordinate" | "speed" => is_single,
        _ => true,
    }
}
