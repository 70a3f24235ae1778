//! What if: numbers of the open scene changed in its text, which is then read as a file is.

use std::collections::BTreeMap;

use assur_scene::edit::{SceneValue, bare, replaced};

use super::scene::{Scene, Source};

/// Per cent of the file's number by which a key changes it.
pub(crate) const STEPS: [f64; 3] = [0.1, 1.0, 10.0];
/// The step at the start: 1 %.
const FIRST_STEP: usize = 1;

/// TOML that stands in the place of a value, by the value's number in the list.
pub(crate) type Edits = BTreeMap<usize, String>;

/// A changed scene to be read.
#[derive(Debug, Clone)]
pub(crate) struct Change {
    /// Number of the opening of a file that it belongs to.
    pub(crate) opening: usize,
    pub(crate) edits: Edits,
    pub(crate) source: Source,
    pub(crate) text: String,
}

/// Whether the changes are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reading {
    /// They are shown.
    Done,
    /// They are being read beside.
    Runs,
    /// They make no scene; the one before is shown.
    Refused,
}

/// The text of the open scene, its numbers, and what they are now.
#[derive(Debug)]
pub(crate) struct WhatIf {
    /// Whether the list is asked for.
    pub(crate) open: bool,
    pub(crate) chosen: usize,
    /// Index in [`STEPS`].
    pub(crate) step: usize,
    pub(crate) values: Vec<SceneValue>,
    text: String,
    /// What is asked for.
    pub(crate) wanted: Edits,
    /// What the open scene has.
    pub(crate) shown: Edits,
    /// Number of the value, and what it was before, of each change; the last one last.
    pub(crate) done: Vec<(usize, Option<String>)>,
    pub(crate) reading: Reading,
    /// What was written to a file last.
    saved: Edits,
    /// The user knows that changes are not saved, and may leave.
    pub(crate) warned: bool,
    /// Number of the opening of a file that this belongs to.
    pub(crate) opening: usize,
    /// The analyzer to whose result the difference is shown.
    pub(crate) compared: Option<String>,
}

impl WhatIf {
    /// The values of a scene as its file has them.
    pub(crate) fn of(scene: Option<&Scene>) -> Self {
        Self {
            open: false,
            chosen: 0,
            step: FIRST_STEP,
            values: scene.map_or_else(Vec::new, |scene| scene.values.clone()),
            text: scene.map_or_else(String::new, |scene| scene.text.clone()),
            wanted: Edits::new(),
            shown: Edits::new(),
            done: Vec::new(),
            reading: Reading::Done,
            saved: Edits::new(),
            warned: false,
            opening: 0,
            compared: None,
        }
    }

    /// The values of a scene opened after another one; `again`: the same scene, so that the list is left as it is.
    pub(crate) fn next(&self, scene: &Scene, again: bool) -> Self {
        let fresh = Self { opening: self.opening + 1, ..Self::of(Some(scene)) };
        if again {
            let chosen = self.chosen.min(fresh.values.len().saturating_sub(1));
            Self { open: self.open, step: self.step, chosen, ..fresh }
        } else {
            fresh
        }
    }

    /// Per cent by which the keys change a value.
    pub(crate) fn per_cent(&self) -> f64 {
        STEPS[self.step % STEPS.len()]
    }

    /// How many values are not as in the file.
    pub(crate) fn changes(&self) -> usize {
        self.wanted.len()
    }

    /// Whether what is asked for makes no scene.
    pub(crate) fn refused(&self) -> bool {
        self.reading == Reading::Refused
    }

    /// Whether a value is not as in the file.
    pub(crate) fn is_changed(&self, index: usize) -> bool {
        self.wanted.contains_key(&index)
    }

    /// TOML of a value now.
    pub(crate) fn now(&self, index: usize) -> &str {
        let own = self.values.get(index).map_or("", |value| value.written.as_str());
        self.wanted.get(&index).map_or(own, String::as_str)
    }

    /// A value, and what it is changed to: `100 mm -> 101 mm`.
    pub(crate) fn shown(&self, index: usize) -> String {
        let old = self.values.get(index).map_or_else(String::new, |value| bare(&value.written));
        match self.wanted.get(&index) {
            Some(new) => format!("{old} -> {}", bare(new)),
            None => old,
        }
    }

    /// The value that was changed last, of those that are changed.
    pub(crate) fn last(&self) -> Option<usize> {
        let last = self.done.iter().rev().map(|(index, _)| index).find(|index| self.is_changed(**index));
        last.or(self.wanted.keys().next()).copied()
    }

    /// Whether there are changes that no file has.
    pub(crate) fn unsaved(&self) -> bool {
        !self.wanted.is_empty() && self.wanted != self.saved
    }

    /// What is asked for was written to a file.
    pub(crate) fn keep_saved(&mut self) {
        self.saved.clone_from(&self.wanted);
    }

    /// The text with what is asked for; comments, order and spelling are those of the file.
    pub(crate) fn changed_text(&self) -> String {
        let span = |index: &usize| self.values.get(*index).map(|value| &value.span);
        replaced(
            &self.text,
            self.wanted.iter().filter_map(|(index, toml)| Some((span(index)?, toml.as_str()))),
        )
    }

    /// Changes a value; returns whether it was another one before.
    pub(crate) fn put(&mut self, index: usize, toml: String) -> bool {
        let Some(value) = self.values.get(index) else { return false };
        let next = Some(toml).filter(|toml| *toml != value.written);
        let before = self.wanted.get(&index).cloned();
        if next == before {
            return false;
        }
        self.set(index, next);
        self.done.push((index, before));
        self.warned = false;
        true
    }

    /// Gives a value this TOML, or the one of the file.
    pub(crate) fn set(&mut self, index: usize, toml: Option<String>) {
        match toml {
            Some(toml) => self.wanted.insert(index, toml),
            None => self.wanted.remove(&index),
        };
    }
}
