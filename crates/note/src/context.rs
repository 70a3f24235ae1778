//! What every part of the note is made from.

use assur_book::Document;
use assur_figure::Figure;
pub(super) use assur_picture::paper::{on_paper, still};
use assur_picture::{Found, Look, Results};
use assur_report::topic::Source;
use assur_words::{Text, joined, text};

/// A scene whose analysis is done, and what is told of it.
pub(super) struct Context<'a> {
    pub(super) results: &'a Results,
    pub(super) found: &'a Found,
    /// Numbers of the positions that are drawn and worked out, at least one.
    pub(super) positions: &'a [usize],
}

pub(super) type Topic = fn(&Source<'_>, &mut Document);

impl Context<'_> {
    /// The results, of which the tables show the chosen positions.
    pub(super) fn source(&self) -> Source<'_> {
        Source::of(&self.found.analysis, &self.results.linkage, Some(self.positions))
    }

    pub(super) fn tell(&self, page: &mut Document, topics: &[Topic]) {
        let source = self.source();
        for topic in topics {
            topic(&source, page);
        }
    }

    /// What is drawn of the first of the chosen positions.
    pub(super) fn first(&self) -> Look<'_> {
        look(self.positions[0])
    }

    pub(super) fn beside(&self, draw: impl Fn(&Look<'_>) -> Figure) -> Figure {
        let (mut panels, mut legend) = (Vec::new(), Vec::new());
        for &position in self.positions {
            let mut figure = on_paper(draw(&look(position)));
            let place = self.place(position);
            let bare = figure.panels.iter_mut().filter(|panel| panel.title.is_empty());
            bare.for_each(|panel| panel.title.clone_from(&place));
            if panels.is_empty() {
                legend = figure.legend;
            }
            panels.extend(figure.panels);
        }
        Figure { columns: panels.len().clamp(1, 2), panels, legend, ..Figure::default() }
    }

    /// `position 6, 45 deg`.
    pub(super) fn place(&self, position: usize) -> Text {
        self.results.place(position)
    }

    /// A caption that says to which position the values of the legend belong, the first of the chosen ones.
    pub(super) fn with_legend(&self, caption: Text) -> Text {
        text!("note-legend-at", caption, place = self.place(self.positions[0]))
    }

    pub(super) fn places(&self) -> Text {
        joined("; ", self.positions.iter().map(|position| self.place(*position)))
    }
}

/// A position, of which nothing else is chosen.
pub(super) fn look(position: usize) -> Look<'static> {
    Look { position, ..Look::default() }
}
