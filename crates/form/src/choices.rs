//! What may be chosen for a key by name.

use assur_mechanism::Key;
use assur_scene::edit::quoted;
use assur_scene::reference::ValueKind;
use assur_words::{Text, name};

use crate::sort::is_possible;
use crate::tables::{Tables, last, owner};

/// A value that may be chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    /// The value as it is written in the file (TOML).
    pub toml: String,
    /// What a person reads.
    pub label: Text,
}

/// What the caller offers for keys whose values come from outside of the scene, by the name of the key: `motor`, `catalogue`,
/// `integrator`.
pub type Offers<'a> = &'a [(&'a str, Vec<Choice>)];

impl Choice {
    /// A text of the file, by its own letters.
    pub fn word(word: impl Into<String>) -> Self {
        let word = word.into();
        Self { toml: quoted(&word), label: name(word) }
    }

    fn flag(toml: &'static str) -> Self {
        Self { toml: toml.to_owned(), label: name(toml) }
    }
}

/// The choices for a key that takes these kinds of values.
pub(crate) fn choices(
    tables: &Tables<'_>,
    key: &Key,
    kinds: &[ValueKind],
    offers: Offers<'_>,
) -> Vec<Choice> {
    let of_kind = |kind: &ValueKind| match kind {
        ValueKind::Word(word) if last(key) == "over" && !is_possible(tables, &owner(key), word) => Vec::new(),
        ValueKind::Word(word) => vec![Choice::word(*word)],
        ValueKind::Flag => ["true", "false"].map(Choice::flag).into(),
        ValueKind::Named(_) | ValueKind::Place => {
            let offered = offers.iter().find(|(name, _)| *name == last(key));
            let own = named(tables, key, kind).into_iter().map(Choice::word);
            own.chain(offered.into_iter().flat_map(|(_, choices)| choices.clone())).collect()
        }
        _ => Vec::new(),
    };
    kinds.iter().flat_map(of_kind).collect()
}

/// The names that a value of a kind may be.
pub(crate) fn named(tables: &Tables<'_>, key: &Key, kind: &ValueKind) -> Vec<String> {
    let beside = |name: &str| tables.word(&owner(key).at(name));
    match kind {
        // The links of a pin that the same table names.
        ValueKind::Named("link") => match beside("pin").or(beside("pair")) {
            Some(pin) if !tables.holders(pin).is_empty() => {
                let moving = |link: &String| link != "ground";
                tables.holders(pin).into_iter().filter(moving).collect()
            }
            _ => tables.parts("link"),
        },
        // A place is given by other points of its link.
        ValueKind::Named("point") => tables.points_beside(key).unwrap_or_else(|| tables.parts("point")),
        ValueKind::Named(what) => tables.parts(what),
        ValueKind::Place => tables.points_of(&link_of(tables, key)),
        ValueKind::Two(kind) | ValueKind::List(kind) => named(tables, key, kind),
        _ => Vec::new(),
    }
}

/// The link in whose frame a place is.
pub(crate) fn link_of(tables: &Tables<'_>, key: &Key) -> String {
    let table = owner(key);
    // The guide line of a slide is on the link that carries it.
    let link = table.clone().at(if last(key) == "through" { "on" } else { "link" });
    tables.word(&link).unwrap_or_else(|| last(&table)).to_owned()
}
