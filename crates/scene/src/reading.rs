//! What the reader tells of each number of a scene besides the mechanism that it makes of all of them.

use std::collections::HashMap;
use std::fmt;
use std::ops::{Bound, Range, RangeBounds};
use std::sync::Arc;

use assur_mechanism::{Key, Mechanism, Step};
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use crate::note::Note;
use crate::units::{self, Dimension};

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

/// Sets a number, SI, in a mechanism: one by itself, or one of two coordinates. Says whether there is such a number.
type Set = dyn Fn(&mut Mechanism, Option<usize>, f64) -> bool + Send + Sync;

#[derive(Clone)]
struct Setter(Arc<Set>);

impl fmt::Debug for Setter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Setter")
    }
}

/// A number of a scene, or a word or name in whose place a number may stand.
#[derive(Debug, Clone)]
pub struct SceneNumber {
    /// Its key.
    pub key: Key,
    /// Bytes of the file that it takes, quotes included.
    pub span: Range<usize>,
    /// What it may measure, where there are several its unit decides; nothing: it is a count.
    pub kinds: Vec<Dimension>,
    limits: Vec<Limits>,
    /// All that it sets, and which coordinate it is there.
    sets: Vec<(Setter, Option<usize>)>,
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
        self.kinds.iter().any(|kind| units::within(value, "", *kind).is_ok())
            && self.limits.iter().all(|limits| limits.contains(&value))
    }

    /// Sets it in a mechanism of its scene, SI, wherever it has an effect there. Absolute values below [`LEAST`](crate::LEAST) are refused by a
    /// scene.
    pub fn set(&self, mechanism: &mut Mechanism, value: f64) {
        for (Setter(set), coordinate) in &self.sets {
            set(mechanism, *coordinate, value);
        }
    }
}

/// What is reported while reading: numbers with what they may be, and where in the mechanism they stand.
#[derive(Debug, Default)]
pub(crate) struct Told {
    numbers: Vec<(Range<usize>, Option<Dimension>, Option<Limits>)>,
    setters: Vec<(Range<usize>, Setter)>,
}

impl Told {
    pub(crate) fn number(&mut self, span: &Range<usize>, kind: Option<Dimension>, limits: Option<Limits>) {
        self.numbers.push((span.clone(), kind, limits));
    }

    /// Where the numbers of a table stand, by key, and with which sign; `path`: what stands before their keys.
    pub(crate) fn slots<S>(&mut self, table: &DeTable<'_>, path: &str, sign: f64, slot: &Arc<S>)
    where
        S: for<'m> Fn(&'m mut Mechanism, &str) -> Option<&'m mut f64> + Send + Sync + 'static,
    {
        for (key, value) in table {
            let (key, slot) = (format!("{path}{}", key.get_ref()), Arc::clone(slot));
            if let DeValue::Table(inner) = value.get_ref() {
                self.slots(inner, &format!("{key}."), sign, &slot);
                continue;
            }
            let set = move |mechanism: &mut Mechanism, coordinate: Option<usize>, number: f64| {
                let slot = slot(mechanism, &key).filter(|_| coordinate.is_none());
                slot.map(|slot| *slot = sign * number).is_some()
            };
            self.setters.push((value.span(), Setter(Arc::new(set))));
        }
    }

    /// How the number at a span is set, which stands in the mechanism with others.
    pub(crate) fn whole(
        &mut self,
        span: &Range<usize>,
        set: impl Fn(&mut Mechanism, f64) -> bool + Send + Sync + 'static,
    ) {
        let set = move |mechanism: &mut Mechanism, _: Option<usize>, number: f64| set(mechanism, number);
        self.setters.push((span.clone(), Setter(Arc::new(set))));
    }

    /// The place of two coordinates that stand at each of these spans; a single number is on the x axis.
    pub(crate) fn place(
        &mut self,
        spans: impl IntoIterator<Item = Range<usize>>,
        at: impl Fn(&mut Mechanism) -> Option<&mut [f64; 2]> + Send + Sync + 'static,
    ) {
        let setter = Setter(Arc::new(move |mechanism, coordinate, number| {
            let Some(at) = at(mechanism) else { return false };
            match coordinate {
                Some(coordinate) => at[coordinate.min(1)] = number,
                None => *at = [number, 0.0],
            }
            true
        }));
        self.setters.extend(spans.into_iter().map(|span| (span, setter.clone())));
    }

    /// All numbers with their keys and places in the mechanism, which is lost.
    pub(crate) fn numbers(self, root: &DeTable<'_>, mut mechanism: Mechanism) -> Vec<SceneNumber> {
        let keys = keys(root);
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
        for (span, setter) in self.setters {
            let first = all.partition_point(|number| number.span.start < span.start);
            let within = all[first..].iter_mut().take_while(|number| number.span.end <= span.end);
            for (index, number) in within.enumerate() {
                let coordinate = (number.span != span).then_some(index);
                if setter.0(&mut mechanism, coordinate, 0.0) {
                    number.sets.push((setter.clone(), coordinate));
                }
            }
        }
        all
    }
}

/// The key of every value of a file that is neither a table nor a list, by its first byte.
pub(crate) fn keys(table: &DeTable<'_>) -> HashMap<usize, Key> {
    let mut keys = HashMap::new();
    in_table(table, &mut Vec::new(), &mut keys);
    keys
}

fn in_table(table: &DeTable<'_>, steps: &mut Vec<Step>, keys: &mut HashMap<usize, Key>) {
    for (key, value) in table {
        within(Step::Name(key.get_ref().to_string()), value, steps, keys);
    }
}

fn within(step: Step, value: &Spanned<DeValue<'_>>, steps: &mut Vec<Step>, keys: &mut HashMap<usize, Key>) {
    steps.push(step);
    match value.get_ref() {
        DeValue::Table(table) => in_table(table, steps, keys),
        DeValue::Array(array) => {
            let names = element_names(steps, array);
            let mut counts: HashMap<&str, usize> = HashMap::new();
            for name in names.iter().flatten() {
                *counts.entry(name).or_default() += 1;
            }
            for (index, (item, name)) in array.iter().zip(&names).enumerate() {
                let own = name.as_ref().filter(|name| counts[name.as_str()] == 1);
                within(own.map_or(Step::Index(index), |name| name.as_str().into()), item, steps, keys);
            }
        }
        _ => {
            keys.insert(value.span().start, Key::from(&steps[..]));
        }
    }
    steps.pop();
}

/// The names by which keys find the elements of a list; `steps`: its own key.
pub(crate) fn element_names(steps: &[Step], array: &DeArray<'_>) -> Vec<Option<String>> {
    if matches!(steps, [Step::Name(list)] if list == "input") {
        return input_names(array);
    }
    array.iter().map(|item| element_name(item.get_ref())).collect()
}

/// The link, slide or pin of each input of a list; of a pin that several have, with the link that it turns: `K:shin`.
fn input_names(array: &DeArray<'_>) -> Vec<Option<String>> {
    let text = |item: &Spanned<DeValue<'_>>, key: &str| {
        item.get_ref().as_table()?.get(key)?.get_ref().as_str().map(str::to_owned)
    };
    let mut pins: HashMap<String, usize> = HashMap::new();
    for pin in array.iter().filter_map(|item| text(item, "pin")) {
        *pins.entry(pin).or_default() += 1;
    }
    let name = |item: &Spanned<DeValue<'_>>| {
        let pin = || match (text(item, "pin")?, text(item, "of")) {
            (pin, Some(of)) if pins[&pin] > 1 => Some(format!("{pin}:{of}")),
            (pin, _) => Some(pin),
        };
        text(item, "link").or_else(|| text(item, "slide")).or_else(pin)
    };
    array.iter().map(name).collect()
}

/// The name of a load; of a slide its name or default name; of a friction its pair.
fn element_name(value: &DeValue<'_>) -> Option<String> {
    let DeValue::Table(table) = value else { return None };
    let text = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str());
    let default = || Some(format!("{}/{}", text("link")?, text("on")?));
    let pair = || text("pair").map(str::to_owned);
    text("name").map(str::to_owned).or_else(default).or_else(pair)
}
