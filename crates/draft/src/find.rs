//! Finds keys in a text, and the keys of places.

use assur_mechanism::{Key, Step};
use assur_scene::edit::ParsedText;
use toml::Spanned;
use toml::de::{DeArray, DeValue};

use crate::braces::Braces;
use crate::layout::{Entry, Layout, in_one_piece, line_start};

/// How far a key stands in a text.
#[derive(Debug)]
pub(crate) struct Found<'a, 't> {
    /// The key, elements of a list by their number as far as they stand.
    pub(crate) steps: Vec<Step>,
    /// How many of the steps stand.
    pub(crate) depth: usize,
    /// What stands at the last of these; `None`: the text as a whole.
    pub(crate) value: Option<&'a Spanned<DeValue<'t>>>,
    /// The innermost value in brackets or braces among what stands, and how many steps lead to it.
    pub(crate) braces: Option<(usize, &'a Spanned<DeValue<'t>>)>,
    /// The innermost value in brackets or braces that has the last step in it.
    pub(crate) owner: Option<(usize, &'a Spanned<DeValue<'t>>)>,
}

impl Found<'_, '_> {
    /// Whether all of the key stands.
    pub(crate) fn stands(&self) -> bool {
        self.depth == self.steps.len()
    }

    /// The key as far as it stands.
    pub(crate) fn standing(&self) -> &[Step] {
        &self.steps[..self.depth]
    }
}

impl<'t> Layout<'t> {
    /// Finds a key as far as it stands.
    pub(crate) fn find(&self, key: &Key) -> Found<'_, 't> {
        let steps = key.steps().to_vec();
        let mut found = Found { steps, depth: 0, value: None, braces: None, owner: None };
        while let Some(step) = found.steps.get(found.depth).cloned() {
            let next = match (found.value.map(Spanned::get_ref), &step) {
                (None, Step::Name(name)) => self.root.get(name.as_str()),
                (Some(DeValue::Table(table)), Step::Name(name)) => table.get(name.as_str()),
                (Some(DeValue::Array(array)), Step::Index(index)) => array.get(*index),
                (Some(DeValue::Array(array)), Step::Name(name)) => {
                    let list = &key.steps()[..found.depth];
                    self.element(list, name, array).and_then(|index| {
                        found.steps[found.depth] = Step::Index(index);
                        array.get(index)
                    })
                }
                _ => None,
            };
            let Some(next) = next else { break };
            found.depth += 1;
            found.owner = found.braces;
            found.value = Some(next);
            let holds = next.get_ref().is_table() || next.get_ref().is_array();
            if holds && in_one_piece(self.text, next) {
                found.braces = Some((found.depth, next));
            }
        }
        found
    }

    /// The element of a list that a name means, as the reader has it.
    fn element(&self, list: &[Step], name: &str, array: &DeArray<'_>) -> Option<usize> {
        let parsed = ParsedText::of(self.text);
        let place =
            array.iter().filter_map(|item| item.get_ref().as_table()).flatten().find_map(|(key, _)| {
                parsed.find(&Key::from(list).at(name).at(&**key.get_ref())).ok()?.into_iter().next()
            })?;
        let has = |item: &Spanned<DeValue<'_>>| {
            let table = item.get_ref().as_table();
            table.is_some_and(|table| table.values().any(|value| value.span() == place.span))
        };
        array.iter().position(has)
    }

    /// The name by which the reader finds an element of a list: made of the texts in it, two of them with a sign between them.
    fn name_of(&self, list: &[Step], index: usize) -> Option<String> {
        let parsed = ParsedText::of(self.text);
        let element = self.find(&Key::from(list).at(index)).value?.get_ref().as_table()?;
        let texts: Vec<_> =
            element.iter().filter_map(|(key, value)| Some((key, value, value.get_ref().as_str()?))).collect();
        let (key, value, _) = texts.first()?;
        let is_name = |name: &String| {
            let found = parsed.find(&Key::from(list).at(name.as_str()).at(key.get_ref().as_ref()));
            found.is_ok_and(|places| places.iter().any(|place| place.span == value.span()))
        };
        let words = || texts.iter().map(|(.., word)| *word);
        let two = words().flat_map(|one| {
            words().flat_map(move |other| ["/", ":"].map(|sign| format!("{one}{sign}{other}")))
        });
        words().map(str::to_owned).chain(two).find(is_name)
    }

    /// The key of steps, elements of a list by their name where they have one.
    pub(crate) fn named(&self, path: &[Step]) -> Key {
        let named = |(depth, step): (usize, &Step)| match step {
            Step::Index(index) => {
                self.name_of(&path[..depth], *index).map_or(Step::Index(*index), Step::Name)
            }
            step => step.clone(),
        };
        let steps: Vec<Step> = path.iter().enumerate().map(named).collect();
        Key::from(&steps[..])
    }

    /// The steps to the key whose name or value, or header, is at a place.
    pub(crate) fn path_at(&self, at: usize) -> Option<Vec<Step>> {
        let section = self.sections.iter().rfind(|section| section.header.start <= at)?;
        if section.header.contains(&at) {
            return Some(section.path.clone());
        }
        let starts = |entry: &&Entry| line_start(self.text, entry.key.start) <= at;
        let entry = section.entries.iter().rfind(starts).filter(|entry| at < entry.value.end)?;
        let mut path = entry.path.clone();
        while let Some(value) = self.find(&Key::from(&path[..])).value {
            let Some(inner) = Braces::of(self.text, value).at(at) else { break };
            path.extend(inner);
        }
        Some(path)
    }
}
