//! A step of a form: from a text to another one, with what the reader says of it.

use assur_mechanism::Key;
use assur_scene::reference::KeyDefault;
use assur_words::Text;

use crate::fault::{Fault, faults, new};
use crate::field::Field;
use crate::sort::sort;
use crate::tables::{Tables, key_of, last, owner, table_at};
use crate::typed::typed;

/// What a step makes of a text.
#[derive(Debug, Clone)]
pub struct Change {
    /// The text after the step; as it was where the step can't be made.
    pub text: String,
    /// The key that was set, added or removed.
    pub at: Key,
    /// What is wrong with its value, to be shown at its field: a fault that was not there before.
    pub here: Option<Fault>,
    /// Faults at other keys that were not there before.
    pub elsewhere: Vec<Fault>,
    /// Other keys that the step set or removed, since they exclude it, belong to another sort of the table, or are needed by it.
    pub also: Vec<Key>,
}

impl Change {
    /// A step that can't be made at a key, and why.
    pub(crate) fn refused(text: &str, at: &Key, message: Text) -> Self {
        let here = Some(Fault::of(at, message));
        Self { text: text.to_owned(), at: at.clone(), here, elsewhere: Vec::new(), also: Vec::new() }
    }
}

/// Gives a field the value that was typed, as [`typed`] understands it; where nothing was typed, the key is removed.
///
/// Keys of the same table that exclude it, or that belong to another sort than the table has then, are removed; those that it makes needed
/// are set. While the value is refused, the text has it nevertheless, so that it can be shown, and nothing else changes: see
/// [`Change::here`].
pub fn put(text: &str, field: &Field, typed_text: &str) -> Change {
    value(text, &field.key, &typed(field, typed_text))
}

/// Gives a key a value (TOML), or removes it where that is empty.
pub(crate) fn value(text: &str, key: &Key, toml: &str) -> Change {
    let mut step = Step::of(text);
    if let Err(message) = step.set(key, toml) {
        return Change::refused(text, key, message);
    }
    let is_default =
        key_of(key.steps()).is_some_and(|known| matches!(known.default, KeyDefault::Is(own) if own == toml));
    let alone = step.text.clone();
    step.settle(text, key, !toml.is_empty() && !is_default);
    let change = step.done(key);
    if change.here.is_some() { Change { text: alone, also: Vec::new(), ..change } } else { change }
}

/// Faults of keys that have no effect beside others.
const OUT_OF_PLACE: [&str; 3] =
    ["scene-key-of-motor", "scene-key-of-catalogue", "scene-friction-without-length"];

/// A text on its way.
#[derive(Debug, Clone)]
pub(crate) struct Step {
    pub(crate) text: String,
    /// The faults at the beginning.
    before: Vec<Fault>,
    pub(crate) also: Vec<Key>,
    /// Values that were removed, by their keys, to be used for others of the same kinds.
    pub(crate) carried: Vec<(Key, String)>,
    /// Whether other values are tried for a key that is set, and other keys in its place.
    pub(crate) tries_others: bool,
}

impl Step {
    pub(crate) fn of(text: &str) -> Self {
        Self {
            text: text.to_owned(),
            before: faults(text),
            also: Vec::new(),
            carried: Vec::new(),
            tries_others: true,
        }
    }

    /// The faults that were not there at the beginning.
    pub(crate) fn faults(&self) -> Vec<Fault> {
        new(&self.text, &self.before)
    }

    /// Gives a key a value (TOML), or removes it where that is empty.
    pub(crate) fn set(&mut self, key: &Key, toml: &str) -> Result<(), Text> {
        self.text = if toml.is_empty() {
            assur_draft::remove(&self.text, key)
        } else {
            assur_draft::set(&self.text, key, toml)?
        };
        Ok(())
    }

    /// Removes the keys that can't stand beside one that was set in place of others (`is_instead`), or that belong to another sort than
    /// their table has now, and sets those that are needed now. `before`: the text without it.
    pub(crate) fn settle(&mut self, before: &str, key: &Key, is_instead: bool) {
        let at = owner(key);
        let rivals = table_at(at.steps()).map(|known| known.rivals(last(key))).unwrap_or_default();
        for rival in rivals.into_iter().filter(|_| is_instead) {
            self.remove(&at.clone().at(rival));
        }
        let (old, new) = (Tables::of(before), self.text.clone());
        let new = Tables::of(&new);
        // Of which sort a motion or a friction is does not depend on its own keys alone.
        let frictions = (0..new.count(&Key::of("friction"))).map(|index| Key::of("friction").at(index));
        let others = frictions.chain([Key::of("motion")]).filter(|other| *other != at && new.stands(other));
        for at in others.chain([at.clone()]) {
            let Some(known) = table_at(at.steps()) else { continue };
            let own = sort(&new, &at, known);
            if sort(&old, &at, known) != own {
                for other in known.keys.iter().filter(|key| !key.is_of(own)) {
                    self.remove(&at.clone().at(other.name));
                }
                self.remove_wrong(&at, key);
                self.complete(&at, key);
            }
        }
        self.complete(&at, key);
        for fault in self.faults() {
            let is_out_of_place = fault.message.identity().is_some_and(|own| OUT_OF_PLACE.contains(&own));
            if let Some(own) = fault.key.filter(|own| is_out_of_place && owner(own) == at && own != key) {
                self.remove(&own);
            }
        }
    }

    /// Removes what the table had before it became another sort and what is wrong in this one: rows over an angle, if it is a time now.
    fn remove_wrong(&mut self, at: &Key, kept: &Key) {
        let depth = at.steps().len();
        let of_table = |fault: Fault| {
            let steps = fault.key.as_ref()?.steps().get(..=depth)?.to_vec();
            steps.starts_with(at.steps()).then(|| Key::from(&steps[..]))
        };
        for key in self.faults().into_iter().filter_map(of_table).filter(|key| key != kept) {
            self.remove(&key);
        }
    }

    /// Removes a key, and keeps its value for others.
    fn remove(&mut self, key: &Key) {
        let tables = Tables::of(&self.text);
        let Some(written) = tables.written(key).map(str::to_owned) else { return };
        self.carried.push((key.clone(), written));
        self.also.push(key.clone());
        self.text = assur_draft::remove(&self.text, key);
    }

    /// What the step has made at a key.
    pub(crate) fn done(mut self, key: &Key) -> Change {
        self.also.sort();
        self.also.dedup();
        let (mut here, mut elsewhere) = (None, Vec::new());
        for fault in self.faults() {
            if here.is_none() && fault.concerns(key) {
                here = Some(fault);
            } else {
                elsewhere.push(fault);
            }
        }
        Change { text: self.text, at: key.clone(), here, elsewhere, also: self.also }
    }
}
