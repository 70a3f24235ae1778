//! What a report, a note or a view says, whatever the form in which it is written.

use assur_figure::Figure;
use assur_words::Text;

use crate::Table;
use crate::fact::{self, Fact};

/// Blocks one after another, of which each is a text, a table or a drawing.
#[derive(Debug, Clone, Default)]
pub struct Document {
    /// The blocks in their order.
    pub blocks: Vec<Block>,
}

/// One block. `_{...}` in its texts is a subscript.
#[derive(Debug, Clone)]
pub enum Block {
    /// The title of the whole.
    Title(Text),
    /// The heading of a part.
    Heading(Text),
    /// A heading within a part.
    Subheading(Text),
    /// A paragraph.
    Paragraph(Text),
    /// Numbers that are reported one by one, with their caption.
    Facts {
        /// The caption; may be empty.
        caption: Text,
        /// The numbers.
        facts: Vec<Fact>,
    },
    /// A table.
    Table(Table),
    /// A figure; several frames follow each other as an animation.
    Figure {
        /// The frames.
        frames: Vec<Figure>,
        /// Width and height on paper, mm.
        size: [f64; 2],
        /// The caption.
        caption: Text,
    },
    /// An equation.
    Equation(Vec<Term>),
}

/// A part of an equation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Term {
    /// A quantity: letters with primes, and its subscript, which may be empty.
    Name(Text, Text),
    /// A function: `sin`.
    Function(&'static str),
    /// A number.
    Number(Text),
    /// The exponent of what stands before it.
    Power(String),
    /// Operators, parentheses and spaces.
    Sign(Text),
    /// A unit.
    Unit(Text),
    /// What the quantity is, in words behind the equation.
    Words(Text),
}

impl Document {
    /// The title of the whole.
    pub fn title(&mut self, title: Text) {
        self.blocks.push(Block::Title(title));
    }

    /// The heading of a part.
    pub fn heading(&mut self, heading: Text) {
        self.blocks.push(Block::Heading(heading));
    }

    /// A paragraph.
    pub fn paragraph(&mut self, words: Text) {
        self.blocks.push(Block::Paragraph(words));
    }

    /// A table; nothing where it has no numbers.
    pub fn table(&mut self, table: Table) {
        if !table.is_empty() {
            self.blocks.push(Block::Table(table));
        }
    }

    /// Numbers that are reported one by one; nothing where there is none.
    pub fn facts(&mut self, caption: Text, facts: Vec<Fact>) {
        if !facts.is_empty() {
            self.blocks.push(Block::Facts { caption, facts });
        }
    }

    /// A figure that does not move; nothing where there is none.
    pub fn figure(&mut self, figure: Option<Figure>, size: [f64; 2], caption: Text) {
        self.blocks.extend(figure.map(|figure| Block::Figure { frames: vec![figure], size, caption }));
    }
}

impl Block {
    /// A block that is a table, or can be shown as one: facts as quantity, value, unit and place.
    pub fn as_table(&self) -> Option<Table> {
        match self {
            Self::Table(table) => Some(table.by_owner()),
            Self::Facts { caption, facts } => Some(fact::table(caption.clone(), facts)),
            _ => None,
        }
    }
}
