//! What a scene has at most of anything that takes memory: counted before anything is read.

use assur_mechanism::{MOST_LINKS, MOST_LOADS, MOST_PLACES, MOST_SLIDES};
use assur_words::{Text, text};
use toml::de::DeValue;

use crate::loads::SORTS;
use crate::walk::{Entry, Section};

/// Whether the scene has too many of anything; noted at the first that is too many.
pub(crate) fn exceeded(root: &Section<'_>) -> bool {
    let list = |key: &str| root.get(key).as_ref().map_or_else(Vec::new, parts);
    let links = list("link");
    let tables = links.iter().flat_map(parts).chain(list("ground"));
    let points = tables.filter(|table| table.name == "points").flat_map(|table| parts(&table));
    let loads = SORTS.iter().flat_map(|sort| list(sort.list));
    let too_many = [
        refuse(root, points.collect(), MOST_PLACES, "scene-many-points"),
        refuse(root, loads.collect(), MOST_LOADS, "scene-many-loads"),
        refuse(root, list("slide"), MOST_SLIDES, "scene-many-slides"),
        refuse(root, links, MOST_LINKS, "scene-many-links"),
    ];
    too_many.contains(&true)
}

/// How many loads the scene has.
pub(crate) fn loads(root: &Section<'_>) -> usize {
    SORTS.iter().filter_map(|sort| root.get(sort.list)).map(|entry| parts(&entry).len()).sum()
}

/// The parts of a table or list.
fn parts<'a>(of: &Entry<'a>) -> Vec<Entry<'a>> {
    match of.value {
        DeValue::Table(_) => of.named(Text::default(), Text::default()),
        DeValue::Array(_) => of.list(Text::default()),
        _ => Vec::new(),
    }
}

fn refuse(root: &Section<'_>, mut all: Vec<Entry<'_>>, most: usize, message: &'static str) -> bool {
    if all.len() <= most {
        return false;
    }
    all.sort_unstable_by_key(|part| part.key.start);
    let message = text!(message, most, count = all.len());
    root.faults.add(all[most].key.clone(), message, text!("scene-one-too-many"));
    true
}
