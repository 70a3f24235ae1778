//! What a report, a note or a view says, whatever the form in which it is written.

use assur_analysis::results::Column as Quantity;
use assur_figure::Figure;
use assur_mechanism::{Driver, LinkId, Mechanism, Name};
use assur_words::{Text, joined, text, unit};
use assur_worksheet::Term;

use crate::catalogue::Unit;
use crate::number::zero_if_rounding;
use crate::table::{Cell, Column, Table};

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

impl Document {
    /// The title of the whole.
    pub fn title(&mut self, title: Text) {
        self.blocks.push(Block::Title(title));
    }

    /// The title of a scene, where it has one.
    pub fn scene(&mut self, title: &Name) {
        if !title.is_empty() {
            self.title(title.into());
        }
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

    /// A figure that does not move; nothing where it has no panels.
    pub fn figure(&mut self, figure: Figure, size: [f64; 2], caption: Text) {
        if !figure.panels.is_empty() {
            self.blocks.push(Block::Figure { frames: vec![figure], size, caption });
        }
    }
}

impl Block {
    /// A block that is a table, or can be shown as one: facts as quantity, value, unit and place.
    pub fn as_table(&self) -> Option<Table> {
        match self {
            Self::Table(table) => Some(table.by_owner()),
            Self::Facts { caption, facts } => Some(table_of(caption.clone(), facts)),
            _ => None,
        }
    }
}

/// One number: what it is, of whom, and where it occurs. Whatever shows it takes it from here.
#[derive(Debug, Clone, PartialEq)]
pub struct Fact {
    /// Identity of the text that says what it is.
    pub id: &'static str,
    /// The values of this text: whose it is.
    pub of: Vec<(&'static str, Text)>,
    /// The value.
    pub value: Value,
    /// Its unit.
    pub unit: Unit,
    /// The coordinates at which it occurs, SI; none where it belongs to the whole motion.
    pub at: Vec<f64>,
    /// Their unit.
    pub at_unit: Unit,
    /// Whether the value is the same everywhere.
    pub is_constant: bool,
    /// The quantity of the results whose value it is, if it is one.
    pub column: Option<Quantity>,
}

/// The value of a fact.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number in SI.
    Number(f64),
    /// The least and the greatest number in SI.
    Range([f64; 2]),
    /// A text: a name, a count.
    Text(Text),
}

impl Fact {
    /// A fact that is a text.
    pub fn text(id: &'static str, value: Text) -> Self {
        let (value, unit) = (Value::Text(value), Unit::NONE);
        Self {
            id,
            of: Vec::new(),
            value,
            unit,
            at: Vec::new(),
            at_unit: unit,
            is_constant: false,
            column: None,
        }
    }

    /// A number in SI.
    pub fn number(id: &'static str, value: f64, unit: Unit) -> Self {
        Self { value: Value::Number(value), unit, ..Self::text(id, Text::default()) }
    }

    /// A range in SI.
    pub fn range(id: &'static str, value: [f64; 2], unit: Unit) -> Self {
        Self { value: Value::Range(value), ..Self::number(id, 0.0, unit) }
    }

    /// Whose it is.
    #[must_use]
    pub fn of(mut self, value: &'static str, owner: Text) -> Self {
        self.of.push((value, owner));
        self
    }

    /// The coordinates at which it occurs, SI.
    #[must_use]
    pub fn at(self, at: &[f64], at_unit: Unit) -> Self {
        Self { at: at.to_vec(), at_unit, ..self }
    }

    /// The quantity of the results whose value it is.
    #[must_use]
    pub fn about(self, column: Quantity) -> Self {
        Self { column: Some(column), ..self }
    }

    /// Its number less that of another one of the same unit; `None` where one of them is no number.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Option<Self> {
        let (Value::Number(own), Value::Number(theirs)) = (&self.value, &other.value) else { return None };
        let apart = zero_if_rounding(own - theirs, own.abs().max(theirs.abs()));
        (self.unit == other.unit).then(|| Self { value: Value::Number(apart), ..self.clone() })
    }

    /// What it is.
    pub fn what(&self) -> Text {
        Text::message(self.id, self.of.clone())
    }

    /// Its value without the unit.
    pub fn value(&self) -> Text {
        match &self.value {
            Value::Number(value) => self.unit.number(*value),
            Value::Range([least, most]) => {
                text!("fact-range", least = self.unit.number(*least), most = self.unit.number(*most))
            }
            Value::Text(text) => text.clone(),
        }
    }

    /// Its value with the unit.
    pub fn with_unit(&self) -> Text {
        if self.unit.name.is_empty() {
            self.value()
        } else {
            joined(" ", [self.value(), unit(self.unit.name)])
        }
    }

    /// Where it occurs; empty where it belongs to the whole motion.
    pub fn place(&self) -> Text {
        match (self.is_constant, &self.at[..]) {
            (true, _) => text!("fact-constant"),
            (_, []) => Text::default(),
            (_, at) => self.at_unit.show_all(at),
        }
    }
}

/// Facts as a table: quantity, value, unit and place; what every row lacks is left out.
fn table_of(caption: Text, facts: &[Fact]) -> Table {
    let has_place = facts.iter().any(|fact| !fact.at.is_empty());
    let heads = [text!("fact-quantity"), text!("fact-value"), text!("fact-unit"), text!("fact-place")];
    let heads = heads.into_iter().take(if has_place { 4 } else { 3 });
    let row = |fact: &Fact| [fact.what(), fact.value(), unit(fact.unit.name), fact.place()].map(Cell::Text);
    Table::list(caption, heads.map(Column::of)).rows(facts.iter().map(row))
}

/// The name of a link.
pub fn link_name(mechanism: &Mechanism, link: LinkId) -> Text {
    mechanism.links.get(link).map_or_else(Text::default, |link| Text::from(&link.name))
}

/// The name of the input link; where it is driven against another one, with that: `rod against barrel`. Of several inputs all.
pub fn driven_link(mechanism: &Mechanism) -> Text {
    let named = |driver: &Driver| {
        let [link, on] = [driver.link, driver.on].map(|link| link_name(mechanism, link));
        if driver.is_relative() { text!("driven-link-against", link, on) } else { link }
    };
    assur_words::list(mechanism.input.drivers.iter().map(named))
}
