//! Keys of values in a scene: dotted paths with indices.

use std::fmt;

use assur_words::{Text, name, text};
use serde::{Serialize, Serializer};

use crate::Name;

/// One step into the scene.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// A key of a table, or the name of an element of a list.
    Name(String),
    /// An element of a list, from 0.
    Index(usize),
    /// Several elements of a list: from the first number to the last one, or to the end of the list.
    Range(usize, Option<usize>),
}

impl Step {
    /// The name of a step that is one.
    pub fn name(&self) -> Option<&str> {
        if let Self::Name(name) = self { Some(name) } else { None }
    }
}

impl From<&str> for Step {
    fn from(name: &str) -> Self {
        Self::Name(name.to_owned())
    }
}

impl From<&Name> for Step {
    fn from(name: &Name) -> Self {
        name.as_str().into()
    }
}

impl From<usize> for Step {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

/// Path to a value in a scene: `link.crank.points.A[0]`. A name that contains a point or bracket is quoted. An
/// element of a list is given by its number, from 0, or by its `name`; a slide also by `<link>/<on>`. Several elements are
/// given by two numbers, or by `*`, so that a key names a column of a table: `force.cutting.value.forward[1..2][1]`,
/// `moment.brake.value.table[*][1]`.
///
/// # Examples
///
/// ```
/// use assur_mechanism::Key;
///
/// let key = Key::of("force").at(0).at("value");
/// assert_eq!(key.to_string(), "force[0].value");
/// assert_eq!(Key::parse("force[0].value"), Ok(key));
/// assert_eq!(Key::parse("moment.brake.value.table[*][1]").unwrap().to_string(), "moment.brake.value.table[*][1]");
/// assert!(Key::parse("link[x]").unwrap_err().to_string().starts_with("`[x]` is not an element: write a whole number from 0"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key(Vec<Step>);

impl Key {
    /// The key of a value of the scene as a whole, or of a table.
    pub fn of(first: impl Into<Step>) -> Self {
        Self(vec![first.into()])
    }

    /// The key of a value within this one.
    #[must_use]
    pub fn at(mut self, step: impl Into<Step>) -> Self {
        self.0.push(step.into());
        self
    }

    /// Of a number in a list the key of the list, of any other value its own.
    #[must_use]
    pub fn of_list(&self) -> Self {
        let items = self.0.iter().rev().take_while(|step| matches!(step, Step::Index(_))).count();
        Self(self.0[..self.0.len() - items].to_vec())
    }

    /// Its steps from the scene as a whole.
    pub fn steps(&self) -> &[Step] {
        &self.0
    }

    /// Reads a key.
    ///
    /// # Errors
    ///
    /// What is wrong with it, in words.
    pub fn parse(text: &str) -> Result<Self, Text> {
        let mut steps = Vec::new();
        let mut rest = text.trim();
        loop {
            let (first, after) = first_name(rest)?;
            steps.push(Step::Name(first));
            rest = after;
            while let Some(inside) = rest.strip_prefix('[') {
                let (index, after) =
                    inside.split_once(']').ok_or_else(|| text!("mechanism-bracket-not-closed"))?;
                steps.push(
                    element(index.trim())
                        .ok_or_else(|| text!("mechanism-no-index", index = name(index.to_owned())))?,
                );
                rest = after;
            }
            if rest.is_empty() {
                return Ok(Self(steps));
            }
            let continues = || text!("mechanism-key-continues", rest = name(rest.to_owned()));
            rest = rest.strip_prefix('.').ok_or_else(continues)?;
        }
    }
}

impl From<&[Step]> for Key {
    fn from(steps: &[Step]) -> Self {
        Self(steps.to_vec())
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (depth, step) in self.0.iter().enumerate() {
            match step {
                Step::Index(index) => write!(f, "[{index}]")?,
                Step::Range(first, Some(last)) => write!(f, "[{first}..{last}]")?,
                Step::Range(..) => f.write_str("[*]")?,
                Step::Name(name) => {
                    let dot = if depth > 0 { "." } else { "" };
                    let bare = !name.contains(['.', '[', '"']) && name.trim() == name;
                    let quote = if bare { "" } else { "'" };
                    write!(f, "{dot}{quote}{name}{quote}")?;
                }
            }
        }
        Ok(())
    }
}

impl From<&Key> for Text {
    fn from(key: &Key) -> Self {
        name(key.to_string())
    }
}

impl Serialize for Key {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
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

/// The name at the beginning, and the text after it.
fn first_name(text: &str) -> Result<(String, &str), Text> {
    for quote in ['"', '\''] {
        if let Some(inside) = text.strip_prefix(quote) {
            let (name, after) =
                inside.split_once(quote).ok_or_else(|| text!("mechanism-quote-not-closed"))?;
            return Ok((name.to_owned(), after));
        }
    }
    let end = text.find(['.', '[']).unwrap_or(text.len());
    let name = text[..end].trim();
    if name.is_empty() {
        return Err(text!("mechanism-what-is-a-key"));
    }
    Ok((name.to_owned(), &text[end..]))
}
