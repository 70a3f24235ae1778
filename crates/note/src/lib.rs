//! The explanatory note: what was calculated, with its figures and tables, as HTML, Markdown or Typst.
//!
//! [`write`](fn@write) makes a [`Document`] from the topics of the report and pictures of the results (`parts`), and writes it in a
//! form (`html`, `markdown`, `typst`).

mod conclusions;
mod context;
mod cover;
mod forces;
mod formula;
mod html;
mod markdown;
mod parts;
mod pdf;
mod sheet;
mod symbols;
mod typst;
pub mod working;

use assur_book::Document;
use assur_figure::Element;
use assur_picture::{Results, mechanism};
use assur_scene::Note;
use assur_words::{Language, Text, name, text};

use context::Context;
use cover::Cover;
use formula::Formulas;
use sheet::NoteSheet;

assur_words::resources!();

/// Most positions times parts of the mechanism in a note, whose figures and texts are all in memory: with eight times as many
/// they took 4 GB.
const MOST_PARTS: usize = 100_000;

/// The form of a note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// One file with its figures, for reading and printing.
    Html,
    /// A text for editing, its figures in files beside it.
    Markdown,
    /// One file with its figures, for editing and typesetting.
    Typst,
}

impl Form {
    /// The form that the ending of a file name chooses.
    pub fn of(ending: &str) -> Option<Self> {
        let forms = [("html", Self::Html), ("md", Self::Markdown), ("typ", Self::Typst)];
        forms.into_iter().find(|(name, _)| ending.eq_ignore_ascii_case(name)).map(|(_, form)| form)
    }
}

/// A note in one form.
#[derive(Debug)]
pub struct Written {
    /// The text.
    pub text: String,
    /// Names and contents of the files of its figures, where they are not in the text.
    pub figures: Vec<(String, String)>,
}

/// What the note tells, with the positions of these numbers drawn and worked out, at least one.
///
/// # Errors
///
/// In words: no analysis, the first of these positions can't be worked out, or the results lack a column of `curves`.
pub fn document(results: &Results, note: &Note, positions: &[usize]) -> Result<Document, Text> {
    let found = results.found.as_ref().ok_or_else(|| text!("note-no-results"))?;
    let language = language(note);
    parts::document(&Context { results, found, positions, language, note, formulas: Formulas::default() })
}

/// The language with the digits of the note, and with the numbers of links in symbols.
fn in_print(results: &Results, note: &Note) -> Language {
    let numbers = mechanism::numbers(&results.linkage.mechanism);
    language(note).with_digits(note.digits).with_marks_in_indices(numbers)
}

fn language(note: &Note) -> &'static Language {
    note.language.and_then(Language::find).unwrap_or(Language::english())
}

/// The note of a scene whose analysis is done, in a form; `folder` is where the files of figures are, seen from the note.
///
/// # Errors
///
/// In words: as [`document`], or there are more positions than a note can show.
pub fn write(results: &Results, note: &Note, form: Form, folder: &str) -> Result<Written, Text> {
    let language = in_print(results, note);
    let mut sheet = sheet(results, note, &language)?;
    // Typst numbers headings, figures and tables itself.
    if form != Form::Typst {
        sheet.number();
    }
    Ok(match form {
        Form::Html => Written { text: html::write(&sheet), figures: Vec::new() },
        Form::Markdown => markdown::write(&sheet, folder),
        Form::Typst => Written { text: typst::write(&sheet), figures: Vec::new() },
    })
}

/// The note of a scene whose analysis is done, as PDF.
///
/// # Errors
///
/// In words: as [`write`](fn@write).
pub fn pdf(results: &Results, note: &Note) -> Result<Vec<u8>, Text> {
    let language = in_print(results, note);
    let mut sheet = sheet(results, note, &language)?;
    sheet.number();
    pdf::write(&sheet).ok_or_else(|| text!("note-no-font"))
}

/// What stands on the pages of the note as PDF, from the cover, at places in millimeters.
///
/// # Errors
///
/// In words: as [`write`](fn@write).
pub fn pages(results: &Results, note: &Note) -> Result<Vec<Vec<Element>>, Text> {
    let language = in_print(results, note);
    let mut sheet = sheet(results, note, &language)?;
    sheet.number();
    Ok(pdf::pages(&sheet))
}

/// What all forms write.
fn sheet<'a>(results: &Results, note: &Note, language: &'a Language) -> Result<NoteSheet<'a>, Text> {
    let mechanism = &results.linkage.mechanism;
    let (count, parts) = (results.positions(), mechanism.parts());
    if count * parts > MOST_PARTS {
        let [most, parts, count] = [MOST_PARTS / parts, parts, count].map(|number| name(number.to_string()));
        return Err(text!("note-too-many", most, parts, count));
    }
    let positions = results.chosen(&note.positions);
    let Document { blocks, .. } = document(results, note, &positions)?;
    let cover = Cover::of(note, Text::from(&mechanism.title));
    let numbered = language.with_marks(mechanism::numbers(mechanism));
    let mut sheet = NoteSheet { cover, blocks, language, numbered, digits: note.digits };
    sheet.formulas();
    Ok(sheet)
}
