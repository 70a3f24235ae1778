//! What a scene has at most of anything that takes memory: counted before anything is read.

use std::ops::Range;

use assur_mechanism::{LONGEST_NAME, MOST_LINKS, MOST_LOADS, MOST_PLACES, MOST_SLIDES};
use assur_words::text;
use toml::de::DeValue;

use crate::error::Fault;
use crate::loads::SORTS;
use crate::text::shown;
use crate::walk::{Entry, Section};

/// Whether the scene has too many of anything; noted at the first that is too many.
pub(crate) fn exceeded(root: &Section<'_>) -> bool {
    let list = |key: &str| root.get(key).map_or_else(Vec::new, |entry| parts(entry.value));
    let links = list("link");
    let tables = links.iter().flat_map(|link| parts(link.value)).chain(list("ground"));
    let points = tables.filter(|table| table.name == "points").flat_map(|table| parts(table.value));
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
    SORTS.iter().filter_map(|sort| root.get(sort.list)).map(|entry| parts(entry.value).len()).sum()
}

/// Notes a name or title that is too long; `span`: where it stands.
pub(crate) fn check_name(entry: &Entry<'_>, span: &Range<usize>, name: &str) {
    let count = name.chars().count();
    if count > LONGEST_NAME {
        let message = text!("scene-long-name", name = shown(name), count = count, most = LONGEST_NAME);
        entry.note(Fault::new(span.clone(), message).label(text!("scene-take-shorter")));
    }
}

/// A part of a table or list.
struct Element<'a> {
    /// Empty in a list.
    name: &'a str,
    span: Range<usize>,
    value: &'a DeValue<'a>,
}

fn parts<'a>(value: &'a DeValue<'a>) -> Vec<Element<'a>> {
    match value {
        DeValue::Table(table) => {
            let all = table.iter();
            all.map(|(key, value)| Element { name: key.get_ref(), span: key.span(), value: value.get_ref() })
                .collect()
        }
        DeValue::Array(list) => {
            list.iter().map(|item| Element { name: "", span: item.span(), value: item.get_ref() }).collect()
        }
        _ => Vec::new(),
    }
}

fn refuse(root: &Section<'_>, mut all: Vec<Element<'_>>, most: usize, message: &'static str) -> bool {
    if all.len() <= most {
        return false;
    }
    all.sort_unstable_by_key(|part| part.span.start);
    let message = text!(message, most = most, count = all.len());
    root.faults.push(Fault::new(all[most].span.clone(), message).label(text!("scene-one-too-many")));
    true
}
