//! What every part of the note is made from.

use assur_book::Document;
use assur_figure::{Figure, Frame};
use assur_report::topic::Source;
use assur_words::{Text, joined, list};

use super::NoteError;
use crate::screen::state::{Found, Scene, State, View, ViewPart};
use crate::screen::view;

/// The state of a scene whose analysis is done, and what is shown of it.
pub(super) struct Context<'a> {
    pub(super) state: &'a mut State,
    /// Numbers of the positions that are drawn and worked out, at least one.
    pub(super) positions: &'a [usize],
}

/// A topic of the report.
pub(super) type Topic = fn(&Source<'_>, &mut Document);

impl Context<'_> {
    pub(super) fn scene(&self) -> Result<&Scene, NoteError> {
        self.state.scene.as_ref().ok_or(NoteError::NoResults)
    }

    pub(super) fn found(&self) -> Result<&Found, NoteError> {
        self.state.found().ok_or(NoteError::NoResults)
    }

    /// The results, of which the tables show the chosen positions.
    pub(super) fn source(&self) -> Result<Source<'_>, NoteError> {
        Ok(Source::of(&self.found()?.analysis, &self.scene()?.linkage, Some(self.positions)))
    }

    /// Adds topics.
    pub(super) fn tell(&self, page: &mut Document, topics: &[Topic]) -> Result<(), NoteError> {
        let source = self.source()?;
        for topic in topics {
            topic(&source, page);
        }
        Ok(())
    }

    /// The figure that a view shows in a position, without its title (the caption says what it is) and without what
    /// belongs to a position on a screen: the cursor and the value at it. With it, the title.
    pub(super) fn figure(
        &mut self,
        shown: View,
        position: usize,
        set: impl FnOnce(&mut State),
    ) -> Option<(Figure, Text)> {
        let before =
            (self.state.position, self.state.chosen, self.state.parts.clone(), self.state.picked.clone());
        self.state.position = position;
        set(self.state);
        let figure = view::figure(self.state, shown);
        (self.state.position, self.state.chosen, self.state.parts, self.state.picked) = before;
        figure.map(|mut figure| {
            figure.panels.iter_mut().for_each(still);
            let title = std::mem::take(&mut figure.title);
            (figure, title)
        })
    }

    /// The figure in the first of the chosen positions, without its title.
    pub(super) fn first(&mut self, shown: View, set: impl FnOnce(&mut State)) -> Option<Figure> {
        self.figure(shown, self.positions[0], set).map(|(figure, _)| figure)
    }

    /// The figure of a part of a view in the first of the chosen positions.
    pub(super) fn part(&mut self, shown: View, part: ViewPart) -> Option<Figure> {
        self.first(shown, |state| {
            state.parts.insert(shown, part);
        })
    }

    /// The figures of a view in the chosen positions, beside each other.
    pub(super) fn beside(&mut self, shown: View, set: impl Fn(&mut State)) -> Option<Figure> {
        let mut whole: Option<Figure> = None;
        for &position in self.positions {
            let Some((mut figure, _)) = self.figure(shown, position, &set) else { continue };
            let place = self.place(position);
            let bare = figure.panels.iter_mut().filter(|panel| panel.title.is_empty());
            bare.for_each(|panel| panel.title.clone_from(&place));
            match &mut whole {
                Some(whole) => whole.panels.extend(figure.panels),
                None => whole = Some(figure),
            }
        }
        whole.map(|figure| Figure { columns: figure.panels.len().clamp(1, 2), ..figure })
    }

    /// `position 6, 45 deg`.
    pub(super) fn place(&self, position: usize) -> Text {
        self.source().map(|source| source.place(position)).unwrap_or_default()
    }

    /// The chosen positions in words.
    pub(super) fn places(&self) -> Text {
        joined("; ", self.positions.iter().map(|position| self.place(*position)))
    }
}

/// Takes the cursor from a plot, and the value at it; the unit stays in its heading.
pub(super) fn still(panel: &mut assur_figure::Panel) {
    let Frame::Axes { cursor, y, .. } = &mut panel.frame else { return };
    *cursor = None;
    if !y.label.is_empty() {
        panel.title = list([panel.title.clone(), y.label.clone()]);
    }
}
