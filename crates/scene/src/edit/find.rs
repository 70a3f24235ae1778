//! Finds a value of the scene by its key.

use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::Place;
use super::key::{Step, shown};
use crate::text::nearest;

/// Greatest number of names that a message lists.
const MOST: usize = 24;

/// The values of a key, one or more, or an error about the key.
pub(super) fn find(document: &DeTable<'_>, steps: &[Step]) -> Result<Vec<Place>, String> {
    let several = steps.iter().enumerate().find_map(|(depth, step)| match step {
        Step::Range(first, last) => Some((depth, *first, *last)),
        _ => None,
    });
    let Some((depth, first, last)) = several else { return one(document, steps).map(|place| vec![place]) };
    let last = match last {
        Some(last) => last,
        None => length(document, &steps[..depth])?.saturating_sub(1),
    };
    let mut all = Vec::new();
    for index in first..=last {
        let mut single = steps.to_vec();
        single[depth] = Step::Index(index);
        all.extend(find(document, &single)?);
    }
    Ok(all)
}

/// Number of elements of a list.
fn length(document: &DeTable<'_>, steps: &[Step]) -> Result<usize, String> {
    match within(document, steps)?.get_ref() {
        DeValue::Array(array) => Ok(array.len()),
        _ => Err(format!("`{}` is no list", shown(steps))),
    }
}

fn one(document: &DeTable<'_>, steps: &[Step]) -> Result<Place, String> {
    leaf(within(document, steps)?, steps)
}

fn within<'a, 'b>(document: &'a DeTable<'b>, steps: &[Step]) -> Result<&'a Spanned<DeValue<'b>>, String> {
    let mut at = in_table(document, steps, 0)?;
    for depth in 1..steps.len() {
        at = match at.get_ref() {
            DeValue::Table(table) => in_table(table, steps, depth)?,
            DeValue::Array(array) => in_array(array, steps, depth)?,
            _ => return Err(format!("`{}` is a single value without parts", shown(&steps[..depth]))),
        };
    }
    Ok(at)
}

fn in_table<'a, 'b>(
    table: &'a DeTable<'b>,
    steps: &[Step],
    depth: usize,
) -> Result<&'a Spanned<DeValue<'b>>, String> {
    let owner = owner(&steps[..depth]);
    let names = keys(table);
    let Step::Name(name) = &steps[depth] else {
        return Err(format!("{owner} is no list; it has: {}", listed(&names)));
    };
    table.get(name.as_str()).ok_or_else(|| absent(&owner, steps, depth, name, &names))
}

fn in_array<'a, 'b>(
    array: &'a DeArray<'b>,
    steps: &[Step],
    depth: usize,
) -> Result<&'a Spanned<DeValue<'b>>, String> {
    let owner = owner(&steps[..depth]);
    match &steps[depth] {
        Step::Index(index) => array.get(*index).ok_or_else(|| {
            let last = array.len().checked_sub(1).map(|last| format!(", from [0] to [{last}]"));
            format!("{owner} has {} elements{}", array.len(), last.unwrap_or_default())
        }),
        Step::Name(name) => {
            let same = |item: &&Spanned<DeValue<'b>>| element_name(item.get_ref()).as_ref() == Some(name);
            let found = array.iter().find(same);
            found.ok_or_else(|| {
                let names: Vec<String> =
                    array.iter().filter_map(|item| element_name(item.get_ref())).collect();
                let by_index =
                    format!("name an element by its number, such as `{}[0]`", shown(&steps[..depth]));
                if names.is_empty() {
                    format!("{owner} is a list without names: {by_index}")
                } else {
                    format!("{}, or {by_index}", absent(&owner, steps, depth, name, &names))
                }
            })
        }
        Step::Range(..) => Err(format!("`{}` names several values", shown(steps))),
    }
}

/// The name of a load; of a slide its name or default name.
pub(super) fn element_name(value: &DeValue<'_>) -> Option<String> {
    let DeValue::Table(table) = value else { return None };
    let text = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str());
    let default = || Some(format!("{}/{}", text("link")?, text("on")?));
    text("name").map(str::to_owned).or_else(default)
}

fn leaf(at: &Spanned<DeValue<'_>>, steps: &[Step]) -> Result<Place, String> {
    let key = shown(steps);
    let text = match at.get_ref() {
        DeValue::Integer(_) | DeValue::Float(_) => None,
        DeValue::String(text) => Some(text.to_string()),
        DeValue::Table(table) => return Err(format!("`{key}` is a table; it has: {}", listed(&keys(table)))),
        DeValue::Array(array) => {
            let elements: Vec<String> = (0..array.len()).map(|index| format!("{key}[{index}]")).collect();
            return Err(format!("`{key}` is a list; it has: {}", listed(&elements)));
        }
        DeValue::Boolean(_) => return Err(format!("`{key}` is true or false, not a number")),
        DeValue::Datetime(_) => return Err(format!("`{key}` is a date, not a number")),
    };
    Ok(Place { span: at.span(), text })
}

/// Keys in the order in which they are in the file.
fn keys(table: &DeTable<'_>) -> Vec<String> {
    let mut keys: Vec<_> = table.iter().collect();
    keys.sort_by_key(|(key, _)| key.span().start);
    keys.into_iter().map(|(key, _)| key.get_ref().to_string()).collect()
}

fn owner(steps: &[Step]) -> String {
    if steps.is_empty() { "the scene".to_owned() } else { format!("`{}`", shown(steps)) }
}

fn absent(owner: &str, steps: &[Step], depth: usize, name: &str, names: &[String]) -> String {
    let near = nearest(name, names.iter().map(String::as_str)).map(|near| {
        let mut steps = steps[..=depth].to_vec();
        steps[depth] = Step::Name(near.to_owned());
        format!("; did you mean `{}`?", shown(&steps))
    });
    // An absent key has its default; only a value that is written in the scene can be replaced.
    let default = "; a default must be written in the scene before it can be varied";
    let hint = near.unwrap_or_else(|| default.to_owned());
    format!("{owner} has no `{name}`{hint}; it has: {}", listed(names))
}

fn listed(names: &[String]) -> String {
    if names.is_empty() {
        return "nothing".to_owned();
    }
    let more = names.len().saturating_sub(MOST);
    let list = names[..names.len() - more].join(", ");
    if more == 0 { list } else { format!("{list} and {more} more") }
}
