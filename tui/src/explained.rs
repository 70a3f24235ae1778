//! What is told of a word of the field and of a key of the scene: the same in the help and in `assur keys`.

use assur_book::glossary::{Chapter, Entry};
use assur_scene::reference::{KeyDefault, SceneKey};
use assur_words::{Language, Text, joined, name, text, to_ascii};

/// Its formula, and where it comes from and stands in the note, a line each; without those that it lacks.
pub(crate) fn beside(entry: &Entry, ascii: bool) -> Vec<Text> {
    let formula = if ascii { to_ascii(entry.formula) } else { entry.formula.into() };
    let formula = (!formula.is_empty()).then(|| text!("glossary-formula", formula = name(formula)));
    let source = entry.source.map(|source| text!("structure-source", source = source.text()));
    let chapter = entry.chapter.map(|chapter| text!("glossary-chapter", chapter = heading(chapter)));
    let places: Vec<Text> = source.into_iter().chain(chapter).collect();
    formula.into_iter().chain((!places.is_empty()).then(|| joined("; ", places))).collect()
}

/// The heading of a part of the note.
fn heading(chapter: Chapter) -> Text {
    text!(match chapter {
        Chapter::Results => "report-results",
        Chapter::Task => "report-task",
        Chapter::Structure => "report-structure",
        Chapter::Kinematics => "note-kinematics",
        Chapter::Forces => "note-forces",
        Chapter::Dynamics => "note-dynamics",
        Chapter::Checks => "report-checks",
    })
}

/// Whether the word itself has these letters, which are in lower case.
pub(crate) fn is_called(entry: &Entry, wanted: &str, language: &Language) -> bool {
    entry.word.render(language).to_lowercase().contains(wanted)
}

/// Whether the word, or what is told of it, has these letters, which are in lower case.
pub(crate) fn speaks_of(entry: &Entry, wanted: &str, language: &Language) -> bool {
    let has = |text: &str| text.to_lowercase().contains(wanted);
    let beside = [false, true].map(|ascii| beside(entry, ascii)).concat();
    is_called(entry, wanted, language)
        || beside.into_iter().chain([entry.meaning.clone()]).any(|text| has(&text.render(language)))
}

/// What a key of the scene may be, its limits, and what holds without it, in one line.
pub(crate) fn values(key: &SceneKey) -> Text {
    let parts = [key.values(), key.limits(), default(key)].into_iter().filter(|part| !part.is_empty());
    joined("; ", parts)
}

/// What holds without a key.
fn default(key: &SceneKey) -> Text {
    let of = name(key.sorts);
    match (key.default, key.sorts.is_empty()) {
        (KeyDefault::Needed, true) => text!("cli-key-needed"),
        (KeyDefault::Needed, false) => text!("cli-key-needed-of", sorts = of),
        (KeyDefault::Absent, true) => Text::default(),
        (KeyDefault::Absent, false) => text!("cli-key-of", sorts = of),
        (KeyDefault::Is(value), true) => text!("cli-key-default", value = name(value)),
        (KeyDefault::Is(value), false) => text!("cli-key-default-of", value = name(value), sorts = of),
    }
}
