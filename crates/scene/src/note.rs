//! `[note]`: what stands on the cover of the explanatory note, and which of its parts are wanted.

use assur_words::{Text, text};

use crate::sheet::{self, Sheet};
use crate::walk::{Entry, Section};

/// What a scene says about its explanatory note. What it leaves out of the cover is for writing by hand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// Who wrote it.
    pub author: Option<Text>,
    /// The group of the author.
    pub group: Option<Text>,
    /// The variant of the task.
    pub variant: Option<Text>,
    /// The ministry of the university.
    pub ministry: Option<Text>,
    /// The university.
    pub university: Option<Text>,
    /// The department.
    pub department: Option<Text>,
    /// The discipline.
    pub discipline: Option<Text>,
    /// Who supervises the work.
    pub supervisor: Option<Text>,
    /// The city.
    pub city: Option<Text>,
    /// The year.
    pub year: Option<Text>,
    /// The text of the task; an empty line divides its paragraphs.
    pub task: Option<Text>,
    /// Its language: `en`, `uk` or `ru`; `None`: as the program is configured.
    pub language: Option<&'static str>,
    /// Numbers of the positions that are drawn and worked out; empty: chosen by the program.
    pub positions: Vec<usize>,
    /// Further diagrams: the columns of each, which lie over each other.
    pub curves: Vec<Vec<String>>,
    /// Its chapters; `None`: all that the scene has.
    pub chapters: Option<Vec<Chapter>>,
    /// Significant digits of its numbers.
    pub digits: usize,
    /// What the scene says about its drawing sheet.
    pub sheet: Sheet,
}

impl Default for Note {
    fn default() -> Self {
        Self {
            author: None,
            group: None,
            variant: None,
            ministry: None,
            university: None,
            department: None,
            discipline: None,
            supervisor: None,
            city: None,
            year: None,
            task: None,
            language: None,
            positions: Vec::new(),
            curves: Vec::new(),
            chapters: None,
            digits: DIGITS,
            sheet: Sheet::default(),
        }
    }
}

impl Note {
    /// Whether it has a chapter.
    pub fn has(&self, chapter: Chapter) -> bool {
        self.chapters.as_ref().is_none_or(|chapters| chapters.contains(&chapter))
    }
}

/// A chapter of the note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chapter {
    /// The main results.
    Results,
    /// The task: the mechanism as it is given.
    Task,
    /// Mobility, pairs and groups.
    Structure,
    /// Positions, velocities, accelerations.
    Kinematics,
    /// Reactions and the balancing load.
    Forces,
    /// The motion or the steady regime, motor and flywheel.
    Dynamics,
    /// The motion in energy form.
    Energy,
    /// A position written out.
    Working,
    /// What proves the numbers.
    Checks,
    /// What the model leaves out.
    Model,
    /// The works by which it is calculated.
    Sources,
    /// What follows from the numbers.
    Conclusions,
}

/// Languages of the note: the word in the scene.
const LANGUAGES: [(&str, &str); 3] = [("en", "en"), ("uk", "uk"), ("ru", "ru")];

/// Chapters of the note: the word in the scene.
const CHAPTERS: [(&str, Chapter); 12] = [
    ("results", Chapter::Results),
    ("task", Chapter::Task),
    ("structure", Chapter::Structure),
    ("kinematics", Chapter::Kinematics),
    ("forces", Chapter::Forces),
    ("dynamics", Chapter::Dynamics),
    ("energy", Chapter::Energy),
    ("working", Chapter::Working),
    ("checks", Chapter::Checks),
    ("model", Chapter::Model),
    ("sources", Chapter::Sources),
    ("conclusions", Chapter::Conclusions),
];

/// Most positions that a note draws and works out.
const MOST_POSITIONS: usize = 12;

/// Most further diagrams of a note.
const MOST_CURVES: usize = 50;

/// Significant digits of a note that says nothing of them, and the fewest and most.
const DIGITS: usize = 4;
const FEWEST_DIGITS: usize = 2;
const MOST_DIGITS: usize = 12;

/// Reads `[note]`; `positions` is the number of positions of the scene, where it is known.
pub(crate) fn read(root: &Section<'_>, positions: Option<usize>) -> Note {
    let sheet = sheet::read(root, positions);
    let Some(section) = root.inner("note") else { return Note { sheet, ..Note::default() } };
    let most = positions.unwrap_or(usize::MAX).saturating_sub(1);
    let digits = section.get("digits").and_then(|entry| entry.count(FEWEST_DIGITS, MOST_DIGITS));
    Note {
        sheet,
        author: section.words("author"),
        group: section.words("group"),
        variant: section.words("variant"),
        ministry: section.words("ministry"),
        university: section.words("university"),
        department: section.words("department"),
        discipline: section.words("discipline"),
        supervisor: section.words("supervisor"),
        city: section.words("city"),
        year: section.words("year"),
        task: section.paragraphs("task"),
        language: section.get("language").and_then(|entry| entry.choice(&LANGUAGES)),
        positions: each(&section, "positions", MOST_POSITIONS, |entry| entry.count(0, most)),
        curves: each(&section, "curves", MOST_CURVES, columns),
        chapters: section
            .get("chapters")
            .map(|_| each(&section, "chapters", CHAPTERS.len(), |entry| entry.choice(&CHAPTERS))),
        digits: digits.unwrap_or(DIGITS),
    }
}

/// The columns of a diagram, with commas between them.
fn columns(entry: &Entry<'_>) -> Option<Vec<String>> {
    let columns =
        entry.text(text!("scene-columns-of-a-diagram"))?.split(',').map(|name| name.trim().to_owned());
    Some(columns.filter(|name| !name.is_empty()).collect())
}

/// The elements of a list, at most so many.
fn each<T>(section: &Section<'_>, key: &str, most: usize, read: impl Fn(&Entry<'_>) -> Option<T>) -> Vec<T> {
    let Some(entry) = section.get(key) else { return Vec::new() };
    let wanted = match key {
        "positions" => text!("scene-list-of-positions"),
        "curves" => text!("scene-list-of-diagrams"),
        _ => text!("scene-list-of-chapters"),
    };
    let listed = entry.list(wanted);
    if listed.len() > most {
        entry.fault(
            text!("scene-many-of-note", key = crate::text::shown(key), most),
            text!("scene-here-are", count = listed.len()),
        );
    }
    listed.iter().filter_map(read).collect()
}
