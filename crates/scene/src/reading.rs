//! What the reader tells of each number of a scene besides the mechanism that it makes of all of them.

use std::collections::HashMap;
use std::fmt;
use std::ops::{Bound, Range, RangeBounds};
use std::sync::Arc;

use assur_mechanism::{Key, Mechanism, Step};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::Note;
use crate::edit::element_name;
use crate::units::{Dimension, within};
use crate::walk::Section;

/// A scene that was read.
#[derive(Debug)]
pub struct Reading {
    /// What it describes.
    pub mechanism: Mechanism,
    /// What it says about its explanatory note.
    pub note: Note,
    /// Its numbers, and the words in whose place a number may stand, in the order of the file.
    pub numbers: Vec<SceneNumber>,
}

impl Reading {
    /// The number that takes these bytes of the file.
    pub fn number(&self, span: &Range<usize>) -> Option<&SceneNumber> {
        let found = self.numbers.binary_search_by_key(&span.start, |number| number.span.start).ok()?;
        Some(&self.numbers[found])
    }
}

/// Both ends of what a number may be.
type Limits = (Bound<f64>, Bound<f64>);
/// Sets a number, SI, in a mechanism.
type Set = Arc<dyn Fn(&mut Mechanism, f64) + Send + Sync>;
/// Two coordinates in a mechanism, m; `None` in a mechanism that has no such place.
type At = Arc<dyn Fn(&mut Mechanism) -> Option<&mut [f64; 2]> + Send + Sync>;

/// A number of a scene, or a word or name in whose place a number may stand.
#[derive(Clone)]
pub struct SceneNumber {
    /// Its key.
    pub key: Key,
    /// Bytes of the file that it takes, quotes included.
    pub span: Range<usize>,
    /// What it may measure, where there are several its unit decides; nothing: it is a count.
    pub kinds: Vec<Dimension>,
    limits: Vec<Limits>,
    sets: Vec<Set>,
}

impl fmt::Debug for SceneNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SceneNumber")
            .field("key", &self.key)
            .field("kinds", &self.kinds)
            .finish_non_exhaustive()
    }
}

impl SceneNumber {
    /// Whether it is a whole number without a unit.
    pub fn is_count(&self) -> bool {
        self.kinds.is_empty()
    }

    /// Whether the mechanism of a scene with another value, SI, that is within the limits of this one differs in this number alone:
    /// then it can be [`set`](Self::set). What is counted, or tied to other numbers by more than limits, can't.
    pub fn is_free(&self) -> bool {
        !self.sets.is_empty()
    }

    /// Whether a value, SI, is within its limits.
    pub fn admits(&self, value: f64) -> bool {
        self.kinds.iter().any(|kind| within(value, "", *kind).is_ok())
            && self.limits.iter().all(|limits| limits.contains(&value))
    }

    /// Sets it in a mechanism of its scene, SI, wherever it has an effect there. Absolute values below [`LEAST`](crate::LEAST) are refused by a
    /// scene.
    pub fn set(&self, mechanism: &mut Mechanism, value: f64) {
        self.sets.iter().for_each(|set| set(mechanism, value));
    }
}

/// What is told while reading: numbers with what they may be, and where in the mechanism those of a part of the file stand.
#[derive(Default)]
pub(crate) struct Told {
    numbers: Vec<(Range<usize>, Option<Dimension>, Option<Limits>)>,
    places: Vec<(Range<usize>, Place)>,
}

/// Where the numbers of a part of the file stand in a mechanism.
enum Place {
    One(Set),
    /// One number is on the x axis, two are both coordinates.
    Two(At),
}

impl fmt::Debug for Told {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Told").field("numbers", &self.numbers).finish_non_exhaustive()
    }
}

impl Told {
    pub(crate) fn number(&mut self, span: &Range<usize>, kind: Option<Dimension>, limits: Option<Limits>) {
        self.numbers.push((span.clone(), kind, limits));
    }

    pub(crate) fn set(
        &mut self,
        span: &Range<usize>,
        set: impl Fn(&mut Mechanism, f64) + Send + Sync + 'static,
    ) {
        self.places.push((span.clone(), Place::One(Arc::new(set))));
    }

    /// The place of two coordinates that stand at each of these spans.
    pub(crate) fn place(
        &mut self,
        spans: impl IntoIterator<Item = Range<usize>>,
        at: impl Fn(&mut Mechanism) -> Option<&mut [f64; 2]> + Send + Sync + 'static,
    ) {
        let at: At = Arc::new(at);
        self.places.extend(spans.into_iter().map(|span| (span, Place::Two(Arc::clone(&at)))));
    }

    /// All numbers with their keys and places.
    pub(crate) fn numbers(self, root: &Section<'_>) -> Vec<SceneNumber> {
        if self.numbers.is_empty() {
            return Vec::new();
        }
        let keys = keys(root.table());
        let mut all: Vec<SceneNumber> = Vec::with_capacity(self.numbers.len());
        let mut told = self.numbers;
        told.sort_by_key(|(span, ..)| span.start);
        for (span, kind, limits) in told {
            let Some(key) = keys.get(&span.start) else { continue };
            if all.last().is_none_or(|last| last.span != span) {
                all.push(SceneNumber {
                    key: key.clone(),
                    span,
                    kinds: Vec::new(),
                    limits: Vec::new(),
                    sets: Vec::new(),
                });
            }
            if let Some(last) = all.last_mut() {
                last.limits.extend(limits);
                last.kinds.extend(kind.filter(|kind| !last.kinds.contains(kind)));
            }
        }
        for (span, place) in self.places {
            let first = all.partition_point(|number| number.span.start < span.start);
            let within = all[first..].iter_mut().take_while(|number| number.span.end <= span.end);
            for (index, number) in within.enumerate() {
                let is_whole = number.span == span;
                number.sets.push(match &place {
                    Place::One(set) => Arc::clone(set),
                    Place::Two(at) => coordinate(Arc::clone(at), if is_whole { None } else { Some(index) }),
                });
            }
        }
        all
    }
}

/// Sets one of two coordinates; without an index the point is on the x axis.
fn coordinate(at: At, index: Option<usize>) -> Set {
    Arc::new(move |mechanism, value| {
        let Some(at) = at(mechanism) else { return };
        match index {
            Some(index) => at[index.min(1)] = value,
            None => *at = [value, 0.0],
        }
    })
}

/// The key of every value of a file that is neither a table nor a list, by its first byte.
pub(crate) fn keys(table: &DeTable<'_>) -> HashMap<usize, Key> {
    let mut keys = HashMap::new();
    in_table(table, &mut Vec::new(), &mut keys);
    keys
}

fn in_table(table: &DeTable<'_>, steps: &mut Vec<Step>, keys: &mut HashMap<usize, Key>) {
    for (key, value) in table {
        steps.push(Step::Name(key.get_ref().to_string()));
        in_value(value, steps, keys);
        steps.pop();
    }
}

fn in_value(value: &Spanned<DeValue<'_>>, steps: &mut Vec<Step>, keys: &mut HashMap<usize, Key>) {
    match value.get_ref() {
        DeValue::Table(table) => in_table(table, steps, keys),
        DeValue::Array(array) => {
            let names: Vec<_> = array.iter().map(|item| element_name(item.get_ref())).collect();
            for (index, item) in array.iter().enumerate() {
                let name = names[index].clone();
                let own = name.filter(|_| names.iter().filter(|other| **other == names[index]).count() == 1);
                steps.push(own.map_or(Step::Index(index), Step::Name));
                in_value(item, steps, keys);
                steps.pop();
            }
        }
        _ => {
            keys.insert(value.span().start, Key::from(&steps[..]));
        }
    }
}
