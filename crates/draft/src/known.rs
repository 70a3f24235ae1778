//! What the reference of the keys says of a key of a text.

use assur_mechanism::Step;
use assur_scene::reference::{KeyDefault, KeyTable, ValueKind, table};

/// What a name is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    Link,
    /// A point; of one link where `link.point` is written.
    Point,
    /// A point of the link in whose frame the place is.
    Place,
    Slide,
    /// A slide, or else a pin.
    Pair,
}

/// How a name stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum As {
    /// As the key by which a link or point is made.
    Definition,
    /// As the key of something else.
    Key,
    /// As a value.
    Value,
}

/// What the reference says of a key of a text.
pub(crate) struct Known {
    /// What its value may be.
    kinds: Vec<&'static ValueKind>,
    /// What the last step names, if the user chooses it, and whether this makes it.
    pub(crate) chosen: Option<(Of, As)>,
    /// The table with the key.
    pub(crate) table: &'static KeyTable,
    /// How many steps lead to the element of a list of tables that has the key.
    pub(crate) element: Option<usize>,
    /// Whether its table is refused without it.
    pub(crate) is_needed: bool,
}

/// What the reference says of a key; `None` where it has no such key.
pub(crate) fn known(path: &[Step]) -> Option<Known> {
    let mut known =
        Known { kinds: Vec::new(), chosen: None, table: table(""), element: None, is_needed: false };
    let mut is_table = true;
    for (depth, step) in path.iter().enumerate() {
        known.chosen = None;
        let header = |is_list: bool| {
            known.kinds.iter().find_map(|kind| match kind {
                ValueKind::Table(header) if header.starts_with("[[") == is_list => Some(*header),
                _ => None,
            })
        };
        match step {
            Step::Index(_) => {
                known.is_needed = false;
                if let Some(header) = header(true) {
                    (known.table, known.element, is_table) = (table(header), Some(depth + 1), true);
                } else {
                    known.kinds = known.kinds.into_iter().filter_map(item).collect();
                }
            }
            Step::Name(_) if !is_table && known.kinds.contains(&&ValueKind::Points) => {
                // The value of a point may be a table.
                known.kinds.retain(|kind| matches!(kind, ValueKind::Table(_)));
                known.chosen = Some((Of::Point, As::Definition));
                known.is_needed = false;
            }
            Step::Name(name) => {
                if !is_table {
                    let header = header(false)?;
                    known.table = table(header);
                    if header.ends_with(".NAME]") {
                        (known.chosen, is_table) = (Some((Of::Link, As::Definition)), true);
                        known.is_needed = false;
                        continue;
                    }
                }
                let chosen = known.table.keys.iter().find(|key| key.name == "POINT");
                let key = known.table.key(name).or(chosen)?;
                known.kinds = key.kinds.iter().collect();
                known.chosen = chosen.map(|_| (Of::Point, As::Key));
                (known.is_needed, is_table) = (key.default == KeyDefault::Needed, false);
            }
            Step::Range(..) => return None,
        }
    }
    Some(known)
}

fn item(kind: &'static ValueKind) -> Option<&'static ValueKind> {
    if let ValueKind::Two(kind) | ValueKind::List(kind) = kind { Some(kind) } else { None }
}

impl Known {
    /// Whether it is a key of the place of a point.
    fn is_place(&self) -> bool {
        self.table.name() == "points"
    }

    /// What a text is the name of; `None`: it is none.
    pub(crate) fn named(&self, text: &str) -> Option<Of> {
        let is_word = |kind: &&ValueKind| matches!(kind, ValueKind::Word(word) if *word == text);
        if self.kinds.iter().any(is_word) {
            return None;
        }
        self.kinds.iter().find_map(|kind| match kind {
            ValueKind::Named("link") => Some(Of::Link),
            // A place is given by points of the link that it is on.
            ValueKind::Named("point") if self.is_place() => Some(Of::Place),
            ValueKind::Named("point") => Some(Of::Point),
            ValueKind::Named("slide") => Some(Of::Slide),
            ValueKind::Named("pair") => Some(Of::Pair),
            ValueKind::Place => Some(Of::Place),
            _ => None,
        })
    }
}

/// The key of the point to whose place a key belongs: `link.rod.points.B` of `link.rod.points.B.about`.
pub(crate) fn point_with(path: &[Step]) -> Option<&[Step]> {
    let before = path.split_last()?.1;
    known(path).filter(Known::is_place)?;
    let is_point =
        |path: &&[Step]| known(path).is_some_and(|known| known.chosen == Some((Of::Point, As::Definition)));
    (1..=before.len()).map(|count| &before[..count]).find(is_point)
}
