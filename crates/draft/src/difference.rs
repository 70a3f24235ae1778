//! What a step has changed in a text.

use std::ops::Range;

use assur_mechanism::Key;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::layout::Layout;
use crate::written::inline;

/// A key at which two texts differ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The key, elements of lists by their number; of a table that only one of the texts has, that of the table.
    pub key: Key,
    /// Its value (TOML) before; `None`: it was not there.
    pub before: Option<String>,
    /// Its value (TOML) after; `None`: it is gone.
    pub after: Option<String>,
}

/// Where two texts differ, in the order of the names; nothing where one of them is too large, with faults of its syntax.
///
/// # Examples
///
/// ```
/// use assur_draft::differences;
///
/// let found = differences("[link.a]\nmass = 1\n", "[link.a]\nmass = 2\n[link.b]\nmass = 1\n");
/// let told: Vec<_> = found.iter().map(|one| (one.key.to_string(), one.before.as_deref(), one.after.is_some())).collect();
/// assert_eq!(told, [("link.a.mass".to_owned(), Some("1"), true), ("link.b".to_owned(), None, true)]);
/// ```
pub fn differences(before: &str, after: &str) -> Vec<Difference> {
    let (Some(one), Some(other)) = (Layout::of_any(before), Layout::of_any(after)) else { return Vec::new() };
    let mut found = Found { texts: [before, after], all: Vec::new() };
    found.tables(&Key::from(&[][..]), &one.root, &other.root);
    found.all
}

struct Found<'t> {
    texts: [&'t str; 2],
    all: Vec<Difference>,
}

type Value<'a, 't> = &'a Spanned<DeValue<'t>>;

impl Found<'_> {
    fn tables(&mut self, key: &Key, one: &DeTable<'_>, other: &DeTable<'_>) {
        let of_other = other.keys().filter(|name| !one.contains_key(&**name.get_ref()));
        let mut names: Vec<&str> = one.keys().chain(of_other).map(|name| &**name.get_ref()).collect();
        names.sort_unstable();
        for name in names {
            self.values(&key.clone().at(name), one.get(name), other.get(name));
        }
    }

    fn values(&mut self, key: &Key, one: Option<Value<'_, '_>>, other: Option<Value<'_, '_>>) {
        let both = one.zip(other).map(|(one, other)| (one.get_ref(), other.get_ref()));
        match both {
            Some((DeValue::Table(one), DeValue::Table(other))) => return self.tables(key, one, other),
            Some((DeValue::Array(one), DeValue::Array(other)))
                if is_of_tables(one) && is_of_tables(other) =>
            {
                return self.lists(key, one, other);
            }
            _ => {}
        }
        let [before, after] =
            [(0, one), (1, other)].map(|(text, value)| value.map(|value| inline(self.texts[text], value)));
        if before != after {
            self.all.push(Difference { key: key.clone(), before, after });
        }
    }

    /// Lists of tables: those at the beginning and at the end that are the same stand across from each other, so that one that is removed
    /// in the middle is one difference.
    fn lists(&mut self, key: &Key, one: &[Spanned<DeValue<'_>>], other: &[Spanned<DeValue<'_>>]) {
        let written = |text: usize, list: &[Spanned<DeValue<'_>>]| -> Vec<String> {
            list.iter().map(|item| inline(self.texts[text], item)).collect()
        };
        let [first, second] = [written(0, one), written(1, other)];
        let start = first.iter().zip(&second).take_while(|(one, other)| one == other).count();
        let rest = first[start..].iter().rev().zip(second[start..].iter().rev());
        let same = if first.len() == second.len() { 0 } else { rest.take_while(|(a, b)| a == b).count() };
        let middle = |list: &[String]| -> Range<usize> { start..list.len() - same };
        let [one_of, other_of] = [middle(&first), middle(&second)];
        for index in start..one_of.end.max(other_of.end) {
            let [one, other] = [(one, &one_of), (other, &other_of)]
                .map(|(list, of)| list.get(index).filter(|_| of.contains(&index)));
            self.values(&key.clone().at(index), one, other);
        }
    }
}

fn is_of_tables(list: &[Spanned<DeValue<'_>>]) -> bool {
    !list.is_empty() && list.iter().all(|item| item.get_ref().is_table())
}
