//! Sets, removes and adds values of a scene's text.

use std::ops::Range;

use assur_mechanism::{Key, Step};
use assur_scene::edit::{ParsedText, replaced};
use assur_words::Text;
use toml::Spanned;
use toml::de::DeValue;

use crate::layout::{Layout, Section, check, in_one_piece};
use crate::written::inline;

/// The text with a value (TOML: `"100 mm"` with its quotes, `[0, 1]`, `{ a = 1 }`) at a key. Of a key that stands only the bytes
/// of the value change. Another one is added to its table as this is written: in its braces, below its header; a table that lacks
/// is made, with a header of its own where the reference of the keys has one. The number behind the last element of a list adds
/// an element.
///
/// # Errors
///
/// What is wrong with the text, the value or the key, in the reader's words.
///
/// # Examples
///
/// ```
/// use assur_draft::set;
/// use assur_mechanism::Key;
///
/// let text = "[link.crank]\npoints = { O = 0 } # a crank\n";
/// let key = Key::parse("link.crank.points.A").unwrap();
/// let text = set(text, &key, "\"100 mm\"").unwrap();
/// assert_eq!(text, "[link.crank]\npoints = { O = 0, A = \"100 mm\" } # a crank\n");
/// let text = set(&text, &Key::parse("title").unwrap(), "\"Crank\"").unwrap();
/// assert!(text.starts_with("title = \"Crank\"\n\n[link.crank]\n"));
/// ```
pub fn set(text: &str, key: &Key, toml: &str) -> Result<String, Text> {
    let layout = Layout::of(text)?;
    let toml = toml.trim();
    let value = DeValue::parse(toml);
    let value = value.map_err(|_| check(&format!("value = {toml}")).err().unwrap_or_default())?;
    let value = (toml, &value);
    if key.steps().iter().any(|step| matches!(step, Step::Range(..))) {
        let places = ParsedText::of(text).find(key)?;
        return Ok(replaced(text, places.iter().map(|place| (&place.span, toml))));
    }
    let found = layout.find(key);
    let result = match found.value.filter(|_| found.stands()) {
        Some(old) if in_one_piece(text, old) => Some(replaced(text, [(&old.span(), toml)])),
        Some(_) => layout.with_table(found.standing(), value).or_else(|| {
            let without = layout.without(&found)?;
            let layout = Layout::of(&without).ok()?;
            let found = layout.find(key);
            layout.inserted(&found, value)
        }),
        None => layout.inserted(&found, value),
    };
    let result = result.ok_or_else(|| ParsedText::of(text).find(key).err().unwrap_or_default())?;
    check(&result).map(|()| result)
}

/// The text without a key and what stands in it: without the lines of a key and the comments on them, without a table and the
/// comment lines directly above its header, without an element of a list. A key that doesn't stand changes nothing, nor does
/// anything in a text with faults of its syntax.
pub fn remove(text: &str, key: &Key) -> String {
    let without = Layout::of(text).ok().and_then(|layout| layout.without(&layout.find(key)));
    without.filter(|text| check(text).is_ok()).unwrap_or_else(|| text.to_owned())
}

/// The text with further tables, each behind the last one of its kind, or else where the reference of the keys has it, with a
/// blank line before it. What belongs to a table that stands already is put into it, key by key.
///
/// # Errors
///
/// What is wrong with the text or the tables, in the reader's words.
///
/// # Examples
///
/// ```
/// let text = "[ground]\npoints = { O = 0 }\n\n[motion]\nspeed = 1\n";
/// let text = assur_draft::append(text, "[ground]\npoints = { B = [1, 0] }\n[link.rod]\npoints = { B = 0 }").unwrap();
/// assert_eq!(
///     text,
///     "[ground]\npoints = { O = 0, B = [1, 0] }\n\n[link.rod]\npoints = { B = 0 }\n\n[motion]\nspeed = 1\n"
/// );
/// ```
pub fn append(text: &str, tables: &str) -> Result<String, Text> {
    check(text)?;
    let added = Layout::of(tables)?;
    let mut result = text.to_owned();
    let mut index = 0;
    while let Some(section) = added.sections.get(index) {
        // Tables of an element of a list can't stand without it.
        let list = section.path.iter().position(|step| matches!(step, Step::Index(_)));
        let path = list.map_or(&section.path[..], |at| &section.path[..=at]);
        let of_element = |other: &&Section| list.is_some() && other.path.starts_with(path);
        let count = added.sections[index..].iter().take_while(of_element).count().max(1);
        result = with_sections(&result, &added, path, index..index + count)?;
        index += count;
    }
    check(&result).map(|()| result)
}

/// The text with these sections of another one; `path`: of the first, an element of a list being one with all that is in it.
fn with_sections(
    text: &str,
    added: &Layout<'_>,
    path: &[Step],
    sections: Range<usize>,
) -> Result<String, Text> {
    let layout = Layout::of(text)?;
    let (key, own) = (Key::from(path), &added.sections[sections.start]);
    let names = key.of_list();
    let is_element = names != key;
    let found = layout.find(&names);
    let is_written = || {
        let path = found.standing();
        found.braces.is_some() || layout.section(path).is_some() || layout.last_line(path).is_some()
    };
    if path.is_empty() || !is_element && found.stands() && is_written() {
        let merged = |text: String, entry: &crate::layout::Entry| {
            let key = Key::from(&entry.path[..]);
            added.find(&key).value.map_or(Ok(text.clone()), |value| merge(&text, &key, added.text, value))
        };
        return own.entries.iter().try_fold(text.to_owned(), merged);
    }
    if let (Some(_), Some(value)) = (found.braces, added.find(&key).value) {
        let list = found.value.and_then(|list| list.get_ref().as_array());
        let key = if is_element { names.at(list.map_or(0, |list| list.len())) } else { names };
        return set(text, &key, &inline(added.text, value));
    }
    let lines = &added.text[added.lead(sections.start)..added.tail(sections.end - 1)];
    let lines = lines.trim_start_matches('\u{feff}').trim_end().replace("\r\n", "\n");
    Ok(layout.with_lines(layout.place_of(path), &lines, true))
}

/// The text with a value of another one; a table is put into that which stands, key by key.
fn merge(text: &str, key: &Key, source: &str, value: &Spanned<DeValue<'_>>) -> Result<String, Text> {
    let layout = Layout::of(text)?;
    let found = layout.find(key);
    let is_table = found.stands() && found.value.is_some_and(|value| value.get_ref().is_table());
    let Some(table) = value.get_ref().as_table().filter(|_| is_table) else {
        return set(text, key, &inline(source, value));
    };
    let mut all: Vec<_> = table.iter().collect();
    all.sort_by_key(|(key, _)| key.span().start);
    all.into_iter().try_fold(text.to_owned(), |text, (name, value)| {
        merge(&text, &key.clone().at(name.get_ref().as_ref()), source, value)
    })
}
