//! The blocks of a note.

use assur_figure::Figure;
use assur_scene::Note;

use super::Context;
use super::words::Words;
use crate::screen::state::{State, View};
use crate::screen::view;

/// The title page.
#[derive(Debug, Clone)]
pub(super) struct Cover {
    pub(super) title: String,
    /// Identifiers of what is told, and the texts.
    pub(super) rows: Vec<(&'static str, String)>,
}

impl Cover {
    pub(super) fn of(title: &str, note: &Note) -> Self {
        let rows = [("author", &note.author), ("group-of-author", &note.group), ("variant", &note.variant)];
        let told = rows.into_iter().filter_map(|(id, text)| Some((id, text.clone()?)));
        Self { title: title.to_owned(), rows: told.collect() }
    }
}

/// One block of a note.
#[derive(Debug, Clone)]
pub(super) enum Block {
    /// The heading of a part.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// A figure on a page of a width and height in mm, with its caption; several follow each other as an animation.
    Picture { frames: Vec<Figure>, size: [f64; 2], caption: String },
    /// A table with its caption.
    Table { caption: String, head: Vec<String>, rows: Vec<Vec<String>> },
    /// An equation as HTML.
    Equation(String),
    /// A heading within a part.
    Subheading(String),
}

impl Block {
    /// A table whose caption has an identifier.
    pub(super) fn table(
        words: &Words,
        caption: &str,
        head: impl IntoIterator<Item = String>,
        rows: Vec<Vec<String>>,
    ) -> Self {
        Self::Table { caption: words.get(caption), head: head.into_iter().collect(), rows }
    }
}

impl Context<'_> {
    /// The figure that a view shows in a position, without its title: the caption says what it is; with it, the title.
    pub(super) fn figure(
        &mut self,
        shown: View,
        position: usize,
        set: impl FnOnce(&mut State),
    ) -> Option<(Figure, String)> {
        let before = (self.state.position, self.state.chosen, self.state.parts.clone());
        self.state.position = position;
        set(self.state);
        let figure = view::figure(self.state, shown);
        (self.state.position, self.state.chosen, self.state.parts) = before;
        figure.map(|mut figure| {
            let title = std::mem::take(&mut figure.title);
            (figure, title)
        })
    }

    /// A picture block of a view.
    pub(super) fn picture(
        &mut self,
        shown: View,
        position: usize,
        size: [f64; 2],
        caption: impl FnOnce(&Words, &str) -> String,
        set: impl FnOnce(&mut State),
    ) -> Option<Block> {
        let words = self.words;
        let (figure, title) = self.figure(shown, position, set)?;
        Some(Block::Picture { frames: vec![figure], size, caption: caption(words, &title) })
    }

    /// The coordinate of a position with its unit.
    pub(super) fn coordinate(&self, position: usize) -> String {
        let series = self.state.scene.as_ref().map(|scene| &scene.series[0]);
        let text =
            series.map(|series| format!("{} {}", crate::number::plain(series.at(position)), series.unit));
        self.words.phrase(&text.unwrap_or_default())
    }
}
