//! What a note consists of, whatever the form in which it is written.

use assur_figure::svg::lowered;
use assur_figure::{Figure, Frame};
use assur_scene::Note;
use assur_words::list;

use super::Context;
use crate::screen::state::{State, View};
use crate::screen::view;
use crate::words::Words;

/// The title page.
#[derive(Debug, Clone)]
pub(super) struct Cover {
    pub(super) title: String,
    /// Identifiers of what the author says, and the texts.
    pub(super) rows: Vec<(&'static str, String)>,
}

impl Cover {
    pub(super) fn of(title: &str, note: &Note) -> Self {
        let rows = [("author", &note.author), ("group-of-author", &note.group), ("variant", &note.variant)];
        let given = rows.into_iter().filter_map(|(id, text)| Some((id, text.clone()?)));
        Self { title: title.to_owned(), rows: given.collect() }
    }
}

/// One block of a note. `_{...}` in its texts is a subscript.
#[derive(Debug, Clone)]
pub(super) enum Block {
    /// The heading of a part.
    Heading(String),
    /// A heading within a part.
    Subheading(String),
    /// A paragraph.
    Text(String),
    /// A figure on a page of a width and height in mm, with its caption; several follow each other as an animation.
    Picture { frames: Vec<Figure>, size: [f64; 2], caption: String },
    /// A table with its caption.
    Table { caption: String, head: Vec<String>, rows: Vec<Vec<String>> },
    /// An equation.
    Equation(Vec<Term>),
}

/// A part of an equation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Term {
    /// A quantity: letters with primes, and its subscript, which may be empty.
    Name(String, String),
    /// A function: `sin`.
    Function(String),
    /// A number with the signs of print.
    Number(String),
    /// The exponent of what stands before it.
    Power(String),
    /// Operators, parentheses and spaces.
    Sign(String),
    /// A unit.
    Unit(String),
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

    /// A figure that does not move.
    pub(super) fn picture(figure: Figure, size: [f64; 2], caption: String) -> Self {
        Self::Picture { frames: vec![figure], size, caption }
    }
}

impl Context<'_> {
    /// The figure that a view shows in a position, without its title (the caption says what it is) and without what
    /// belongs to a position on a screen: the cursor and the value at it. With it, the title.
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
            figure.panels.iter_mut().for_each(still);
            let title = std::mem::take(&mut figure.title);
            (figure, title.render(self.words.spoken()))
        })
    }

    /// `position 6, 45 deg`.
    pub(super) fn place(&self, position: usize) -> String {
        let scene = self.state.scene.as_ref();
        scene.map_or_else(String::new, |scene| scene.place(position).render(self.words.spoken()))
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

/// A text with its subscripts in a form: what writes a text in which nothing is markup, and what writes a subscript.
pub(super) fn rich(text: &str, plain: impl Fn(&str) -> String, low: impl Fn(&str) -> String) -> String {
    let part = |(part, below): (&str, &str)| {
        plain(part) + &if below.is_empty() { String::new() } else { low(below) }
    };
    lowered(text).map(part).collect()
}
