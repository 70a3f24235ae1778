//! What-if changes: numbers of the open scene are changed in its text, which is then read like a file.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use assur_mechanism::Key;
use assur_scene::edit::{ParsedText, SceneValue, bare, decimal, quoted, replaced};

use super::scene::Scene;
use crate::session::Session;

/// Steps by which a key changes a value, in per cent of the number in the file.
pub(crate) const STEPS: [f64; 4] = [0.1, 1.0, 5.0, 10.0];
/// The step at the start: 1 %.
const FIRST_STEP: usize = 1;

/// TOML that replaces a value, by the value's number in the list.
pub(crate) type Edits = BTreeMap<usize, String>;

/// A change of a scene to be read.
#[derive(Debug, Clone)]
pub(crate) struct Change {
    /// Number of the opened file to which it belongs.
    pub(crate) opening: usize,
    pub(crate) edits: Edits,
    /// The scene before.
    pub(crate) session: Arc<Session>,
    /// The text with all changes.
    pub(crate) text: String,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Reading {
    #[default]
    Done,
    Runs,
    /// They make no valid scene; the one before is shown.
    Refused,
}

/// A point that is to have a place in `[assembly]`.
#[derive(Debug, Clone)]
pub(crate) struct Assembled {
    pub(crate) name: String,
    /// Where it is in the first position, m.
    pub(crate) present: [f64; 2],
    /// Where it is to be.
    pub(crate) place: [f64; 2],
}

impl Assembled {
    fn key(&self) -> String {
        let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if self.name.chars().all(is_bare) { self.name.clone() } else { quoted(&self.name) }
    }
}

/// The text of the open scene, its numbers, and their present values.
#[derive(Debug, Default)]
pub(crate) struct WhatIf {
    pub(crate) open: bool,
    pub(crate) chosen: usize,
    /// Index in [`STEPS`].
    pub(crate) step: usize,
    pub(crate) values: Vec<SceneValue>,
    text: String,
    /// The requested changes.
    pub(crate) wanted: Edits,
    /// The changes of the scene that is shown.
    pub(crate) shown: Edits,
    /// For each change, in order, the numbers of its values and what they were before.
    pub(crate) done: Vec<Vec<(usize, Option<String>)>>,
    pub(crate) reading: Reading,
    /// The changes that were last written to a file.
    pub(crate) saved: Edits,
    /// The user has been warned of unsaved changes, and may leave.
    pub(crate) warned: bool,
    /// Number of the opened file to which this belongs.
    pub(crate) opening: usize,
    /// The analyzer to whose results the difference is shown.
    pub(crate) compared: Option<String>,
}

impl WhatIf {
    /// The values of a scene as its file has them.
    pub(crate) fn of(scene: Option<&Scene>) -> Self {
        let text = scene.map(|scene| scene.session.text.clone()).unwrap_or_default();
        let values = ParsedText::of(&text).values();
        Self { step: FIRST_STEP, values, text, ..Self::default() }
    }

    /// The values of a scene that replaces another one; `again`: it is the same scene, reread, so the list stays open.
    pub(crate) fn next(&self, scene: &Scene, again: bool) -> Self {
        let fresh = Self { opening: self.opening + 1, ..Self::of(Some(scene)) };
        if again {
            let chosen = self.chosen.min(fresh.values.len().saturating_sub(1));
            Self { open: self.open, step: self.step, chosen, ..fresh }
        } else {
            fresh
        }
    }

    pub(crate) fn per_cent(&self) -> f64 {
        STEPS[self.step % STEPS.len()]
    }

    pub(crate) fn changes(&self) -> usize {
        self.wanted.len()
    }

    pub(crate) fn is_changed(&self, index: usize) -> bool {
        self.wanted.contains_key(&index)
    }

    pub(crate) fn now(&self, index: usize) -> &str {
        let own = self.values.get(index).map_or("", |value| value.written.as_str());
        self.wanted.get(&index).map_or(own, String::as_str)
    }

    /// A value and its change: `100 mm -> 101 mm`.
    pub(crate) fn shown(&self, index: usize) -> String {
        let old = self.values.get(index).map_or_else(String::new, |value| bare(&value.written));
        match self.wanted.get(&index) {
            Some(new) => format!("{old} -> {}", bare(new)),
            None => old,
        }
    }

    /// The value that was changed last, of those that are changed.
    pub(crate) fn last(&self) -> Option<usize> {
        let last =
            self.done.iter().rev().flatten().map(|(index, _)| index).find(|index| self.is_changed(**index));
        last.or(self.wanted.keys().next()).copied()
    }

    /// Whether the user may leave: nothing would be lost, or the warning was given.
    pub(crate) fn may_drop(&self) -> bool {
        self.wanted.is_empty() || self.wanted == self.saved || self.warned
    }

    /// Adds a table that stands in one line of the scene to the values, so that it can be replaced as a whole; its number.
    pub(crate) fn add_table(&mut self, key: &Key) -> Option<usize> {
        let value = ParsedText::of(&self.text).table(key)?;
        self.values.push(value);
        Some(self.values.len() - 1)
    }

    /// The text with the requested changes; comments, order and spelling are those of the file.
    pub(crate) fn changed_text(&self) -> String {
        let span = |index: &usize| self.values.get(*index).map(|value| &value.span);
        let wanted = self.wanted.iter().filter_map(|(index, toml)| Some((span(index)?, toml.as_str())));
        // What stands within a table that is replaced goes with it.
        let within = |inner: &Range<usize>| {
            let mut all = self.wanted.keys().filter_map(span);
            all.any(|outer| outer != inner && outer.start <= inner.start && inner.end <= outer.end)
        };
        replaced(&self.text, wanted.filter(|(span, _)| !within(span)))
    }

    /// Changes values in one step; returns whether any differs from the one before.
    pub(crate) fn put(&mut self, all: impl IntoIterator<Item = (usize, String)>) -> bool {
        let mut done = Vec::new();
        for (index, toml) in all {
            let Some(value) = self.values.get(index) else { continue };
            let next = Some(toml).filter(|toml| *toml != value.written);
            let before = self.wanted.get(&index).cloned();
            if next != before {
                self.set(index, next);
                done.push((index, before));
            }
        }
        let differs = !done.is_empty();
        if differs {
            self.done.push(done);
            self.warned = false;
        }
        differs
    }

    /// Gives points their places in `[assembly]`, m, in one step; returns whether any differs. A point that has none there gets
    /// its present one in the text first, which changes nothing.
    pub(crate) fn assemble(&mut self, points: &[Assembled]) -> bool {
        let missing: Vec<&Assembled> = points.iter().filter(|point| self.found(point).is_none()).collect();
        if !missing.is_empty() {
            self.insert(&missing);
        }
        let places = points.iter().filter_map(|point| Some((self.found(point)?, point.place)));
        let places: Vec<_> =
            places.flat_map(|(at, place)| [0, 1].map(|k| (at + k, decimal(place[k]).to_string()))).collect();
        self.put(places)
    }

    /// Whether places in `[assembly]` are among what these edits change of the scene that is shown.
    pub(crate) fn is_of_modes(&self, edits: &Edits) -> bool {
        let differs = |index: &&usize| edits.get(*index) != self.shown.get(*index);
        let mut changed = edits.keys().chain(self.shown.keys()).filter(differs);
        changed.any(|index| {
            self.values.get(*index).is_some_and(|value| value.key.steps().first() == Some(&"assembly".into()))
        })
    }

    /// The number of the first of the two values of a point in `[assembly]`.
    fn found(&self, point: &Assembled) -> Option<usize> {
        let key = Key::of("assembly").at(point.name.as_str()).at(0);
        self.values.iter().position(|value| value.key == key)
    }

    /// Writes points with their present places into the table `[assembly]` of the text.
    fn insert(&mut self, points: &[&Assembled]) {
        let line = |point: &&Assembled| {
            let [x, y] = point.present.map(decimal);
            format!("{} = [{x}, {y}]\n", point.key())
        };
        let lines: String = points.iter().map(line).collect();
        let is_header =
            |line: &str| line.split('#').next().is_some_and(|line| line.trim_end() == "[assembly]");
        let mut end = 0;
        let header = self.text.split_inclusive('\n').find_map(|line| {
            end += line.len();
            is_header(line).then_some(end)
        });
        let at = header.unwrap_or(self.text.len());
        let ends = at == 0 || self.text[..at].ends_with('\n');
        let start = match (header.is_some(), ends) {
            (true, true) => "",
            (true, false) => "\n",
            (false, true) => "\n[assembly]\n",
            (false, false) => "\n\n[assembly]\n",
        };
        let first = self.values.iter().filter(|value| value.span.start < at).count();
        let text = format!("{}{start}{lines}{}", &self.text[..at], &self.text[at..]);
        let values = ParsedText::of(&text).values();
        if values.len() != self.values.len() + 2 * points.len() {
            // The table is written in another way, such as in one line.
            return;
        }
        let moved = |index: usize| if index < first { index } else { index + 2 * points.len() };
        for edits in [&mut self.wanted, &mut self.shown, &mut self.saved] {
            *edits = std::mem::take(edits).into_iter().map(|(index, toml)| (moved(index), toml)).collect();
        }
        self.done.iter_mut().flatten().for_each(|(index, _)| *index = moved(*index));
        self.chosen = moved(self.chosen);
        (self.text, self.values) = (text, values);
    }

    /// Sets a value to this TOML, or to that of the file.
    pub(crate) fn set(&mut self, index: usize, toml: Option<String>) {
        match toml {
            Some(toml) => self.wanted.insert(index, toml),
            None => self.wanted.remove(&index),
        };
    }
}
