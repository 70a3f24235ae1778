//! New tables: of the scene, and as the value of a key.

use assur_mechanism::Key;
use assur_scene::edit::quoted;
use assur_scene::reference;

use crate::change::{Change, Step};
use crate::field::Opening;
use crate::sort::word_key;
use crate::tables::{Tables, last, owner};

/// A new table of the scene with the keys that it needs, so that it reads: `[[force]]` acts on the first link, at its last point.
/// `header`: as the reference has it. The change is at the new table; where the scene does not allow one, [`Change::here`] says why.
pub fn added(text: &str, header: &str) -> Change {
    let mut step = Step::of(text);
    let list = Key::of(reference::table(header).name());
    let at = if header.starts_with("[[") { list.clone().at(Tables::of(text).count(&list)) } else { list };
    match assur_draft::append(text, &format!("{header}\n")) {
        Ok(text) => step.text = text,
        Err(message) => return Change::refused(text, &at, message),
    }
    step.complete(&at, &at);
    step.done(&at)
}

/// A table of a sort as the value of a key, with the keys that it needs, so that it reads: rows or a formula with the number that stands
/// there. A table of another sort that stands there becomes one of this sort, with its rows.
pub fn made(text: &str, at: &Key, opening: &Opening) -> Change {
    let (tables, mut step) = (Tables::of(text), Step::of(text));
    let at = tables.numbered(at);
    let known = reference::table(opening.header);
    let word = word_key(known).filter(|key| key.words().any(|word| Some(word) == opening.sort));
    let named = opening.sort.filter(|_| word.is_none()).and_then(|sort| known.key(sort));
    let first = |step: &Step| {
        let own = |key: &str| step.candidates(&at.clone().at(key)).into_iter().next();
        let (key, toml) = match (word, named, opening.sort) {
            (Some(word), _, Some(sort)) => (word.name, quoted(sort)),
            (_, Some(key), _) => (key.name, own(key.name)?),
            _ => return None,
        };
        Some((key, toml))
    };
    let (key, toml) = if tables.table(&at).is_some() {
        let Some((name, toml)) = first(&step) else { return step.done(&at) };
        (at.clone().at(name), toml)
    } else {
        // A law over time begins where the input did.
        let begins = || tables.written(&owner(&at).at("from")).filter(|_| last(&at) == "over_time");
        let number = tables.written(&at).or_else(begins);
        step.carried.extend(number.map(|written| (at.clone(), written.to_owned())));
        let inner = first(&step).map(|(key, toml)| format!(" {key} = {toml} ")).unwrap_or_default();
        (at.clone(), format!("{{{inner}}}"))
    };
    if let Err(message) = step.set(&key, &toml) {
        return Change::refused(text, &at, message);
    }
    step.settle(text, &key, true);
    step.done(&at)
}
