//! What every part of the note is made from.

use assur_book::{Block, Document};
use assur_figure::{Figure, Frame, Item, Panel};
pub(super) use assur_picture::paper::{on_paper, still};
use assur_picture::{Found, Look, Results};
use assur_report::topic::Source;
use assur_scene::Note;
use assur_words::{Language, Text, joined, number, text};

use crate::formula::Formulas;

/// A scene whose analysis is done, and what is told of it.
pub(super) struct Context<'a> {
    pub(super) results: &'a Results,
    pub(super) found: &'a Found,
    /// Numbers of the positions that are drawn and worked out, at least one.
    pub(super) positions: &'a [usize],
    /// The language in which columns may be named.
    pub(super) language: &'a Language,
    /// What the scene says of the note.
    pub(super) note: &'a Note,
    /// Where its formulas are, for the tables that refer to them.
    pub(super) formulas: Formulas,
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

    /// `over the cycle`; where the positions are not those of a cycle, `over the motion`.
    pub(super) fn over(&self) -> Text {
        if self.results.is_cycle() { text!("note-over-cycle") } else { text!("note-over-motion") }
    }

    /// A sentence that says over what the curves of a figure go.
    pub(super) fn told(&self, id: &'static str) -> Told {
        Told(id, vec![("over", self.over())])
    }

    pub(super) fn places(&self) -> Text {
        joined("; ", self.positions.iter().map(|position| self.place(*position)))
    }
}

/// The sentence before a figure: its identity, and its values beside the number of the figure.
#[derive(Debug, Clone)]
pub(super) struct Told(pub(super) &'static str, pub(super) Vec<(&'static str, Text)>);

impl From<&'static str> for Told {
    fn from(id: &'static str) -> Self {
        Self(id, Vec::new())
    }
}

/// Rows of planes in one figure: more of them don't fit on a page.
const ROWS: usize = 2;

/// A figure behind the sentence that names it by its number. Nothing where it has no panels, or only curves that are zero.
pub(super) fn show(
    page: &mut Document,
    told: impl Into<Told>,
    (figure, size): (Figure, [f64; 2]),
    caption: Text,
) {
    let told = told.into();
    let is_plane = |panel: &Panel| matches!(panel.frame, Frame::Plane { .. });
    let (rows, in_part) = (figure.rows(), ROWS * figure.columns.max(1));
    if rows <= ROWS || !figure.panels.iter().all(is_plane) {
        return show_frames(page, told, (vec![figure], size), caption);
    }
    for panels in figure.panels.chunks(in_part) {
        let part = Figure { panels: panels.to_vec(), ..figure.clone() };
        let size = [size[0], size[1] * part.rows() as f64 / rows as f64];
        show_frames(page, told.clone(), (vec![part], size), caption.clone());
    }
}

/// The same of a figure that moves on a screen.
pub(super) fn show_frames(
    page: &mut Document,
    told: impl Into<Told>,
    (frames, size): (Vec<Figure>, [f64; 2]),
    caption: Text,
) {
    if frames.first().is_some_and(|first| !first.panels.iter().all(is_zero)) {
        let before = page.blocks.iter().filter(|block| matches!(block, Block::Figure { .. })).count();
        let Told(id, mut values) = told.into();
        values.push(("figure", number(before + 1)));
        page.paragraph(Text::message(id, values));
        page.blocks.push(Block::Figure { frames, size, caption });
    }
}

/// Whether all curves of a panel are zero, and show nothing.
pub(super) fn is_zero(panel: &Panel) -> bool {
    let points = panel.items.iter().flat_map(Item::points);
    matches!(panel.frame, Frame::Axes { .. }) && points.into_iter().all(|[_, y]| y == 0.0 || !y.is_finite())
}

/// A position, of which nothing else is chosen.
pub(super) fn look(position: usize) -> Look<'static> {
    Look { position, ..Look::default() }
}
