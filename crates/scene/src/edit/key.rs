//! Keys of values: dotted paths with indices.

use assur_words::{Text, text};

use crate::text::shown as quote;

/// One step into the scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    /// A key of a table, or the name of an element of a list.
    Name(String),
    /// An element of a list, from 0.
    Index(usize),
    /// Several elements of a list: from the first number to the last one, or to the end of the list.
    Range(usize, Option<usize>),
}

/// Path to a value in a scene: `link.crank.points.A[0]`. A name that contains a point or bracket is quoted. An
/// element of a list is given by its number, from 0, or by its `name`; a slide also by `<link>/<on>`. Several elements are
/// given by two numbers, or by `*`, so that a key names a column of a table: `force.cutting.value.forward[1..2][1]`,
/// `moment.brake.value.table[*][1]`.
///
/// # Examples
///
/// ```
/// use assur_scene::edit::KeyPath;
///
/// let key = KeyPath::parse("force.cutting.value").unwrap();
/// assert_eq!(key.to_string(), "force.cutting.value");
/// assert_eq!(KeyPath::parse("moment.brake.value.table[*][1]").unwrap().to_string(), "moment.brake.value.table[*][1]");
/// assert!(KeyPath::parse("link[x]").unwrap_err().to_string().starts_with("`[x]` is no element: write a whole number from 0"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyPath(pub(super) Vec<Step>);

impl KeyPath {
    /// Reads a key.
    ///
    /// # Errors
    ///
    /// What is wrong with it, in words.
    pub fn parse(text: &str) -> Result<Self, Text> {
        parse(text).map(Self)
    }
}

impl std::fmt::Display for KeyPath {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&shown(&self.0))
    }
}

fn parse(text: &str) -> Result<Vec<Step>, Text> {
    let mut steps = Vec::new();
    let mut rest = text.trim();
    loop {
        let (name, after) = name(rest)?;
        steps.push(Step::Name(name));
        rest = after;
        while let Some(inside) = rest.strip_prefix('[') {
            let (index, after) = inside.split_once(']').ok_or_else(|| text!("scene-bracket-not-closed"))?;
            steps.push(element(index.trim()).ok_or_else(|| wrong_index(index))?);
            rest = after;
        }
        if rest.is_empty() {
            return Ok(steps);
        }
        rest = rest.strip_prefix('.').ok_or_else(|| text!("scene-key-continues", rest = quote(rest)))?;
    }
}

/// Reads what stands in brackets: `3`, `1..2`, `*`.
fn element(text: &str) -> Option<Step> {
    if text == "*" {
        return Some(Step::Range(0, None));
    }
    let Some((first, last)) = text.split_once("..") else { return text.parse().ok().map(Step::Index) };
    let (first, last) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
    (first <= last).then_some(Step::Range(first, Some(last)))
}

fn wrong_index(index: &str) -> Text {
    text!("scene-no-index", index = quote(index))
}

/// The name at the beginning, and the text after it.
fn name(text: &str) -> Result<(String, &str), Text> {
    for quote in ['"', '\''] {
        if let Some(inside) = text.strip_prefix(quote) {
            let (name, after) = inside.split_once(quote).ok_or_else(|| text!("scene-quote-not-closed"))?;
            return Ok((name.to_owned(), after));
        }
    }
    let end = text.find(['.', '[']).unwrap_or(text.len());
    let name = text[..end].trim();
    if name.is_empty() {
        return Err(text!("scene-what-is-a-key"));
    }
    Ok((name.to_owned(), &text[end..]))
}

/// The steps as a key.
pub(super) fn shown(steps: &[Step]) -> String {
    let mut text = String::new();
    for step in steps {
        match step {
            Step::Index(index) => text.extend(["[", &index.to_string(), "]"]),
            Step::Range(first, Some(last)) => {
                text.extend(["[", &first.to_string(), "..", &last.to_string(), "]"]);
            }
            Step::Range(..) => text.push_str("[*]"),
            Step::Name(name) => {
                if !text.is_empty() {
                    text.push('.');
                }
                text += &quoted(name);
            }
        }
    }
    text
}

fn quoted(name: &str) -> String {
    if name.contains(['.', '[', '"']) || name.trim() != name { format!("'{name}'") } else { name.to_owned() }
}
