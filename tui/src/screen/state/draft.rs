//! The open scene while it is changed: its text is the only state, every step makes another one, which is then read like a file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use assur_mechanism::Key;
use assur_scene::edit::{ParsedText, SceneValue, bare, decimal, replaced};
use assur_words::Text;

use super::scene::Scene;
use crate::session::{Session, Source};

/// Steps by which a key changes a value, in per cent of the number in the file.
pub(crate) const STEPS: [f64; 4] = [0.1, 1.0, 5.0, 10.0];
/// The step at the start: 1 %.
const FIRST_STEP: usize = 1;

/// A changed text to be read.
#[derive(Debug, Clone)]
pub(crate) struct Change {
    /// Number of the opened file to which it belongs.
    pub(crate) opening: usize,
    /// The text with all changes.
    pub(crate) text: Arc<str>,
    /// What of it is read: all, or of a scene that is being built and has faults what is without any.
    pub(crate) readable: Arc<str>,
    /// The scene before, if there is one.
    pub(crate) session: Option<Arc<Session>>,
    pub(crate) source: Source,
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
    /// Where it is to be, m.
    pub(crate) place: [f64; 2],
}

/// Unsaved changes that a program has left behind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Recovered {
    /// The file in which they are.
    pub(crate) path: PathBuf,
    /// Of which scene.
    pub(crate) source: Source,
    pub(crate) text: Arc<str>,
}

/// The text of the open scene, its numbers, and the steps since it was opened.
#[derive(Debug, Default)]
pub(crate) struct Draft {
    /// Whether the list of values is open.
    pub(crate) open: bool,
    pub(crate) chosen: usize,
    /// Index in [`STEPS`].
    pub(crate) step: usize,
    /// The numbers of the text, or of the last one that could be read.
    pub(crate) values: Vec<SceneValue>,
    /// The values of the scene as it was opened, as written there.
    own: BTreeMap<Key, String>,
    opened: Arc<str>,
    /// The text with all changes.
    text: Arc<str>,
    /// The text of the scene that is shown.
    pub(crate) shown: Arc<str>,
    /// The texts before each step, and those after each step that was undone.
    done: Vec<Arc<str>>,
    undone: Vec<Arc<str>>,
    /// The value that was changed last.
    last: Option<Key>,
    /// Whether places in `[assembly]` are among what changes the scene that is shown.
    pub(crate) of_modes: bool,
    pub(crate) reading: Reading,
    /// The text that was last written to a file.
    pub(crate) saved: Option<Arc<str>>,
    /// The user has been warned of unsaved changes, and may leave.
    pub(crate) warned: bool,
    /// Number of the opened file to which this belongs.
    pub(crate) opening: usize,
    /// Where the text comes from.
    pub(crate) source: Source,
    /// The analyzer to whose results the difference is shown.
    pub(crate) compared: Option<String>,
}

impl Draft {
    /// A scene as its file has it, or the beginning of a new one.
    pub(crate) fn of(scene: Option<&Scene>) -> Self {
        let source = scene.map_or(Source::New, |scene| scene.session.source.clone());
        Self::from(0, source, scene.map_or("", |scene| &scene.session.text))
    }

    /// A text from its source, as the file of this number that is opened.
    pub(crate) fn from(opening: usize, source: Source, text: &str) -> Self {
        let text: Arc<str> = text.into();
        let values = ParsedText::of(&text).values();
        let own = written(&values);
        let (opened, shown) = (Arc::clone(&text), Arc::clone(&text));
        Self { step: FIRST_STEP, values, own, opened, shown, text, source, opening, ..Self::default() }
    }

    /// The draft of a scene that replaces another one; `again`: it is the same scene, reread, so the list stays open, and the changes that
    /// are dropped are a step that can be taken back.
    pub(crate) fn next(&self, scene: &Scene, again: bool) -> Self {
        let fresh = Self { opening: self.opening + 1, ..Self::of(Some(scene)) };
        if again {
            let chosen = self.chosen.min(fresh.values.len().saturating_sub(1));
            let mut done = self.done.clone();
            done.extend(Some(&self.text).filter(|text| **text != fresh.text).cloned());
            Self { open: self.open, step: self.step, chosen, done, ..fresh }
        } else {
            fresh
        }
    }

    pub(crate) fn text(&self) -> &Arc<str> {
        &self.text
    }

    pub(crate) fn per_cent(&self) -> f64 {
        STEPS[self.step % STEPS.len()]
    }

    /// Whether the text differs from that of the file.
    pub(crate) fn is_changed(&self) -> bool {
        self.text != self.opened
    }

    /// Whether a file has the text as it was opened, or as it was last saved.
    pub(crate) fn is_known(&self, path: &Path) -> bool {
        let Ok(now) = std::fs::read(path) else { return false };
        [Some(&self.opened), self.saved.as_ref()].into_iter().flatten().any(|text| text.as_bytes() == now)
    }

    /// Whether the scene that is shown is that of the file.
    pub(crate) fn is_shown_as_opened(&self) -> bool {
        self.shown == self.opened
    }

    /// How many values differ from those of the file; of a text that differs elsewhere at least 1.
    pub(crate) fn changes(&self) -> usize {
        let values = (0..self.values.len()).filter(|index| self.is_value_changed(*index)).count();
        if self.is_changed() { values.max(1) } else { 0 }
    }

    pub(crate) fn is_value_changed(&self, index: usize) -> bool {
        self.values.get(index).is_some_and(|value| self.own.get(&value.key) != Some(&value.written))
    }

    pub(crate) fn now(&self, index: usize) -> &str {
        self.values.get(index).map_or("", |value| &value.written)
    }

    /// A value and its change: `100 mm -> 101 mm`.
    pub(crate) fn shown_value(&self, index: usize) -> String {
        let Some(value) = self.values.get(index) else { return String::new() };
        match self.own.get(&value.key).filter(|own| **own != value.written) {
            Some(own) => format!("{} -> {}", bare(own), bare(&value.written)),
            None => bare(&value.written),
        }
    }

    /// The value that was changed last, of those that the file has and that are changed.
    pub(crate) fn last(&self) -> Option<usize> {
        let is_of_file = |index: &usize| self.own.contains_key(&self.values[*index].key);
        let mut changed =
            (0..self.values.len()).filter(is_of_file).filter(|index| self.is_value_changed(*index));
        let first = changed.clone().next();
        changed.find(|index| Some(&self.values[*index].key) == self.last.as_ref()).or(first)
    }

    /// Whether a file has the text.
    pub(crate) fn is_kept(&self) -> bool {
        !self.is_changed() || self.saved.as_ref() == Some(&self.text)
    }

    /// Whether the user may leave: nothing would be lost, or the warning was given.
    pub(crate) fn may_drop(&self) -> bool {
        self.is_kept() || self.warned
    }

    /// A file has the text now; if it is its own, that is the text from which changes count.
    pub(crate) fn save(&mut self, path: &Path) {
        self.saved = Some(Arc::clone(&self.text));
        let is_own = match &self.source {
            Source::New => true,
            Source::File(own) => own == path,
            Source::Shipped(_) => false,
        };
        if is_own {
            self.source = Source::File(path.to_owned());
            self.opened = Arc::clone(&self.text);
            self.own = written(&self.values);
        }
    }

    /// Makes another text of it in one step; returns whether it differs.
    pub(crate) fn take(&mut self, text: &str) -> bool {
        let differs = *text != *self.text;
        if differs {
            let before = std::mem::replace(&mut self.text, text.into());
            self.done.push(before);
            self.undone.clear();
            self.renew();
        }
        differs
    }

    /// The same as a part of the last step.
    pub(crate) fn amend(&mut self, text: &str) -> bool {
        let before = self.done.pop();
        let differs = self.take(text);
        if let Some(before) = before {
            if differs {
                self.done.pop();
            }
            self.done.push(before);
        }
        differs
    }

    /// Sets a value to this TOML in one step; returns whether it differs.
    pub(crate) fn put(&mut self, index: usize, toml: &str) -> bool {
        let Some(value) = self.values.get(index) else { return false };
        self.of_modes |= value.key.steps().first() == Some(&"assembly".into());
        if self.text.get(value.span.clone()) != Some(value.written.as_str()) {
            // The text has had faults since the values were read, so they may stand elsewhere now.
            let text = assur_draft::set(&self.text, &value.key, toml);
            return text.is_ok_and(|text| self.take(&text));
        }
        let text = replaced(&self.text, [(&value.span, toml)]);
        self.last = Some(value.key.clone());
        if text == *self.text {
            return false;
        }
        // The other values stay, moved by what this one grows.
        let (old, new) = (value.span.clone(), toml.len());
        for value in &mut self.values {
            if value.span.start >= old.end {
                let [start, end] = [value.span.start, value.span.end].map(|at| at + new - old.len());
                value.span = start..end;
            }
        }
        let value = &mut self.values[index];
        (value.span, value.written) = (old.start..old.start + new, toml.to_owned());
        let before = std::mem::replace(&mut self.text, text.into());
        self.done.push(before);
        (self.warned, self.undone) = (false, Vec::new());
        true
    }

    /// Gives points their places in `[assembly]`; the text with them.
    pub(crate) fn assembled(&self, points: &[Assembled]) -> Result<String, Text> {
        points.iter().try_fold(self.text.to_string(), |text, point| {
            let [x, y] = point.place.map(decimal);
            assur_draft::set(&text, &Key::of("assembly").at(&*point.name), &format!("[{x}, {y}]"))
        })
    }

    /// Takes the last step back; returns whether there was one.
    pub(crate) fn undo(&mut self) -> bool {
        let Some(before) = self.done.pop() else { return false };
        self.undone.push(std::mem::replace(&mut self.text, before));
        self.renew();
        true
    }

    /// Takes the step again that was undone last; returns whether there was one.
    pub(crate) fn redo(&mut self) -> bool {
        let Some(after) = self.undone.pop() else { return false };
        self.done.push(std::mem::replace(&mut self.text, after));
        self.renew();
        true
    }

    /// Whether there is a step to undo, and one to redo.
    pub(crate) fn has_steps(&self) -> [bool; 2] {
        [!self.done.is_empty(), !self.undone.is_empty()]
    }

    /// The text before the last step.
    pub(crate) fn before(&self) -> Option<&Arc<str>> {
        self.done.last()
    }

    /// Reads the values of a text that was changed in any way.
    fn renew(&mut self) {
        self.warned = false;
        let values = ParsedText::of(&self.text).values();
        // A text with faults has no values: those before stay, so that the list does.
        if values.is_empty() && !self.text.is_empty() {
            return;
        }
        let of_assembly = |values: &[SceneValue]| -> Vec<String> {
            let is_place = |value: &&SceneValue| value.key.steps().first() == Some(&"assembly".into());
            values.iter().filter(is_place).map(|value| value.written.clone()).collect()
        };
        self.of_modes |= of_assembly(&self.values) != of_assembly(&values);
        self.chosen = self.chosen.min(values.len().saturating_sub(1));
        self.values = values;
    }
}

/// Values as they are written, by their keys.
fn written(values: &[SceneValue]) -> BTreeMap<Key, String> {
    values.iter().map(|value| (value.key.clone(), value.written.clone())).collect()
}
