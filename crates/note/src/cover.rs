//! The cover of the note: what is left out of it is a ruled line, to be filled in by hand.

use assur_scene::Note;
use assur_words::{Text, text};

/// The rows of the cover from top to bottom; `None`: a ruled line.
pub(super) struct Cover {
    /// Ministry, university, department.
    pub(super) above: [Option<Text>; 3],
    /// What it is.
    pub(super) what: Text,
    /// The discipline, behind its word.
    pub(super) discipline: (Text, Option<Text>),
    /// The title of the scene.
    pub(super) title: Text,
    /// Who made it and who checks it, each behind its word.
    pub(super) people: [(Text, Option<Text>); 4],
    /// City and year.
    pub(super) below: [Option<Text>; 2],
}

impl Cover {
    pub(super) fn of(note: &Note, title: Text) -> Self {
        Self {
            above: [&note.ministry, &note.university, &note.department].map(Clone::clone),
            what: text!("note-title"),
            discipline: (text!("note-discipline"), note.discipline.clone()),
            title,
            people: [
                (text!("note-author"), note.author.clone()),
                (text!("note-group"), note.group.clone()),
                (text!("note-variant"), note.variant.clone()),
                (text!("note-supervisor"), note.supervisor.clone()),
            ],
            below: [&note.city, &note.year].map(Clone::clone),
        }
    }

    /// Its rows one after another, each behind its word where it has one.
    pub(super) fn rows(&self) -> impl Iterator<Item = (Option<&Text>, Option<&Text>)> {
        let above = self.above.iter().map(|row| (None, row.as_ref()));
        let middle = [
            (None, Some(&self.what)),
            (Some(&self.discipline.0), self.discipline.1.as_ref()),
            (None, Some(&self.title)),
        ];
        let people = self.people.iter().map(|(what, who)| (Some(what), who.as_ref()));
        above.chain(middle).chain(people).chain(self.below.iter().map(|row| (None, row.as_ref())))
    }
}
