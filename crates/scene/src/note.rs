//! `[note]`: title page, language and positions of the explanatory note.

use crate::walk::Section;

const KEYS: &[&str] = &["author", "group", "variant", "language", "positions"];

/// Languages of the note: the word in the scene.
const LANGUAGES: [(&str, &str); 3] = [("en", "en"), ("uk", "uk"), ("ru", "ru")];

/// Most positions that a note draws and works out.
const MOST_POSITIONS: usize = 12;

/// What a scene says about its explanatory note.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// Who wrote it.
    pub author: Option<String>,
    /// The group of the author.
    pub group: Option<String>,
    /// The variant of the task.
    pub variant: Option<String>,
    /// Its language: `en`, `uk` or `ru`.
    pub language: &'static str,
    /// Numbers of the positions that are drawn and worked out; empty: chosen by the program.
    pub positions: Vec<usize>,
}

/// Reads `[note]`; `positions` is the number of positions of the scene, where it is known.
pub(crate) fn read(root: &Section<'_>, positions: Option<usize>) -> Note {
    let mut note = Note { author: None, group: None, variant: None, language: "en", positions: Vec::new() };
    let Some(section) = root.get("note").and_then(|entry| entry.section("the note", KEYS)) else {
        return note;
    };
    let line = |key: &str| section.get(key).and_then(|entry| entry.line());
    (note.author, note.group, note.variant) = (line("author"), line("group"), line("variant"));
    if let Some(language) = section.get("language").and_then(|entry| entry.choice(&LANGUAGES)) {
        note.language = language;
    }
    if let Some(entry) = section.get("positions") {
        let listed = entry.list("a list of numbers of positions");
        if listed.len() > MOST_POSITIONS {
            entry.fault(
                format!("a note has at most {MOST_POSITIONS} positions"),
                format!("here are {}", listed.len()),
            );
        }
        let most = positions.unwrap_or(usize::MAX).saturating_sub(1);
        note.positions = listed.iter().filter_map(|entry| entry.count(0, most)).collect();
    }
    note
}
