//! Finds a value of the scene by its key.

use assur_mechanism::{Key, Step};
use assur_words::{Text, name, number, text};
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::TextPlace;
use crate::reading::{self, element_names};
use crate::text::nearest;

/// Greatest number of names that a message lists.
const MOST: usize = 24;

/// The values of a key, one or more, or an error about the key.
pub(super) fn find(document: &DeTable<'_>, steps: &[Step]) -> Result<Vec<TextPlace>, Text> {
    let several = steps.iter().enumerate().find_map(|(depth, step)| match step {
        Step::Range(first, last) => Some((depth, *first, *last)),
        _ => None,
    });
    let Some((depth, first, last)) = several else { return Ok(vec![leaf(within(document, steps)?, steps)?]) };
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
fn length(document: &DeTable<'_>, steps: &[Step]) -> Result<usize, Text> {
    match within(document, steps)?.get_ref() {
        DeValue::Array(array) => Ok(array.len()),
        _ => Err(text!("scene-no-list", key = key(steps))),
    }
}

/// The bytes of the file at which a key stands, of an element of a list those of the element; where the scene leaves the key out,
/// of the table that would have it.
pub(crate) fn place(document: &DeTable<'_>, steps: &[Step]) -> Option<std::ops::Range<usize>> {
    let of = |steps: &[Step]| {
        let value = within(document, steps).ok()?;
        let (last, before) = steps.split_last()?;
        let owner = if before.is_empty() {
            Some(document)
        } else {
            within(document, before).ok()?.get_ref().as_table()
        };
        let Step::Name(name) = last else { return Some(value.span()) };
        Some(
            owner
                .and_then(|table| table.get_key_value(name.as_str()))
                .map_or(value.span(), |(key, _)| key.span()),
        )
    };
    (1..=steps.len()).rev().find_map(|depth| of(&steps[..depth]))
}

/// The value of a key.
pub(crate) fn within<'a, 'b>(
    document: &'a DeTable<'b>,
    steps: &[Step],
) -> Result<&'a Spanned<DeValue<'b>>, Text> {
    let mut at = in_table(document, steps, 0)?;
    for depth in 1..steps.len() {
        at = match at.get_ref() {
            DeValue::Table(table) => in_table(table, steps, depth)?,
            DeValue::Array(array) => in_array(array, steps, depth)?,
            _ => return Err(text!("scene-single-value", key = key(&steps[..depth]))),
        };
    }
    Ok(at)
}

fn in_table<'a, 'b>(
    table: &'a DeTable<'b>,
    steps: &[Step],
    depth: usize,
) -> Result<&'a Spanned<DeValue<'b>>, Text> {
    let owner = owner(&steps[..depth]);
    let names = keys(table);
    let Step::Name(name) = &steps[depth] else {
        return Err(text!("scene-table-is-no-list", owner, names = listed(names)));
    };
    table.get(name.as_str()).ok_or_else(|| {
        let longer = if depth == 0 { longer(table, steps) } else { None };
        absent(owner, (steps, depth), (name, longer), names)
    })
}

fn in_array<'a, 'b>(
    array: &'a DeArray<'b>,
    steps: &[Step],
    depth: usize,
) -> Result<&'a Spanned<DeValue<'b>>, Text> {
    let owner = owner(&steps[..depth]);
    match &steps[depth] {
        Step::Index(index) => array.get(*index).ok_or_else(|| {
            let (count, last) = (array.len(), number(array.len().saturating_sub(1)));
            if count == 0 {
                return text!("scene-no-elements", owner);
            }
            text!("scene-elements", owner, count, last)
        }),
        Step::Name(name) => {
            let names = element_names(&steps[..depth], array);
            let found = names.iter().position(|own| own.as_ref() == Some(name));
            found.and_then(|index| array.get(index)).ok_or_else(|| {
                let names: Vec<String> = names.into_iter().flatten().collect();
                let list = key(&steps[..depth]);
                if names.is_empty() {
                    return text!("scene-list-without-names", owner, list);
                }
                let problem = absent(owner, (steps, depth), (name, None), names);
                text!("scene-or-by-number", problem, list)
            })
        }
        Step::Range(..) => Err(text!("scene-several-values", key = key(steps))),
    }
}

fn leaf(at: &Spanned<DeValue<'_>>, steps: &[Step]) -> Result<TextPlace, Text> {
    let key = key(steps);
    let text = match at.get_ref() {
        DeValue::Integer(_) | DeValue::Float(_) => None,
        DeValue::String(text) => Some(text.to_string()),
        DeValue::Table(table) => {
            return Err(text!("scene-is-a-table", key, names = listed(keys(table))));
        }
        DeValue::Array(array) => {
            let elements = (0..array.len()).map(|index| Key::from(steps).at(index).to_string()).collect();
            return Err(text!("scene-is-a-list", key, names = listed(elements)));
        }
        DeValue::Boolean(_) => return Err(text!("scene-is-a-boolean", key)),
        DeValue::Datetime(_) => return Err(text!("scene-is-a-date", key)),
    };
    Ok(TextPlace { span: at.span(), text })
}

/// Keys in the order in which they are in the file.
fn keys(table: &DeTable<'_>) -> Vec<String> {
    let mut keys: Vec<_> = table.iter().collect();
    keys.sort_by_key(|(key, _)| key.span().start);
    keys.into_iter().map(|(key, _)| key.get_ref().to_string()).collect()
}

fn owner(steps: &[Step]) -> Text {
    if steps.is_empty() { text!("scene-the-scene") } else { name(format!("`{}`", Key::from(steps))) }
}

fn key(steps: &[Step]) -> Text {
    Text::from(&Key::from(steps))
}

/// The first key of the file that has these steps among its own, in their order and with the last of them last: `link.crank.points.A`
/// of `crank.A`.
fn longer(table: &DeTable<'_>, steps: &[Step]) -> Option<Key> {
    let is_part = |key: &&(usize, Key)| {
        let mut rest = key.1.steps().iter();
        steps.iter().all(|step| rest.any(|other| other == step))
            && rest.all(|step| matches!(step, Step::Index(_)))
    };
    let keys: Vec<(usize, Key)> = reading::keys(table).into_iter().collect();
    keys.iter().filter(is_part).min_by_key(|key| key.0).map(|key| key.1.clone())
}

/// What is said of an absent name; `longer`: a key of the scene of which the steps are a part.
fn absent(
    owner: Text,
    (steps, depth): (&[Step], usize),
    (absent, longer): (&str, Option<Key>),
    names: Vec<String>,
) -> Text {
    let near = longer.or_else(|| {
        let mut steps = steps[..=depth].to_vec();
        steps[depth] = Step::Name(nearest(absent, names.iter().map(String::as_str))?.to_owned());
        Some(Key::from(&steps[..]))
    });
    let near = near.map(|near| text!("scene-did-you-mean", name = &near));
    // An absent key has its default; only a value that is written in the scene can be replaced.
    let hint = near.unwrap_or_else(|| text!("scene-default-not-written"));
    let absent = name(absent.to_owned());
    text!("scene-owner-has-no", owner, name = absent, hint, names = listed(names))
}

fn listed(names: Vec<String>) -> Text {
    if names.is_empty() { text!("scene-nothing") } else { crate::text::listed(names, MOST) }
}
