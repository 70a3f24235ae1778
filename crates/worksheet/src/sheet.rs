//! Collects the equations of a working and their symbols.

use std::collections::BTreeMap;

use assur_group::{Body, BuildError, GroupFrame};
use assur_plugin::RegistryError;
use assur_words::{Language, Text, text};

use crate::line::measured;
use crate::term::Show;
use crate::{Entry, Expr, Line, Point, Pose, Reaction, Section, Symbol, Term, WorkedLoad, figure::shortest};

/// Number of digits of a given quantity.
const GIVEN_DIGITS: usize = 9;

/// Names of bodies, places and pairs in a working.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Names {
    /// Names of the bodies, the ground first.
    pub bodies: Vec<Text>,
    /// Named places (body, coordinates in its frame, m). A place with one name in two bodies is a pin.
    pub places: Vec<(usize, [f64; 2], Symbol)>,
    /// Names of the pairs of the chain.
    pub pairs: Vec<Text>,
}

/// Units of what belongs to the input, and of derivatives with respect to its coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Units {
    /// Units of a length and of its first and second derivatives.
    pub length: [&'static str; 3],
    /// Units of an angle and of its first and second derivatives.
    pub angle: [&'static str; 3],
    /// Units of the coordinate, of its speed and of its acceleration.
    pub input: [&'static str; 3],
    /// Unit of what acts along the coordinate: a moment or a force.
    pub moment: &'static str,
    /// Units of the inertia reduced to the input, and of its derivative.
    pub inertia: [&'static str; 2],
}

impl Units {
    /// Units for a rotating input.
    pub const ANGULAR: Self = Self {
        length: ["m", "m/rad", "m/rad²"],
        angle: ["rad", "rad/rad", "rad/rad²"],
        input: ["rad", "rad/s", "rad/s²"],
        moment: "N·m",
        inertia: ["kg·m²", "kg·m²/rad"],
    };
    /// Units for a sliding input.
    pub const LINEAR: Self = Self {
        length: ["m", "m/m", "m/m²"],
        angle: ["rad", "rad/m", "rad/m²"],
        input: ["m", "m/s", "m/s²"],
        moment: "N",
        inertia: ["kg", "kg/m"],
    };
}

/// A working under construction.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// The sections already written.
    pub sections: Vec<Section>,
    /// Units of the input and of derivatives.
    pub units: Units,
    pub(crate) names: Names,
    /// Values of all symbols already written, by their English form.
    symbols: BTreeMap<String, f64>,
    pub(crate) points: Vec<Point>,
    pub(crate) poses: Vec<Option<Pose>>,
    pub(crate) loads: Vec<Vec<WorkedLoad>>,
    pub(crate) reactions: Vec<Reaction>,
    group: usize,
    unfit: bool,
}

impl Sheet {
    /// An empty sheet.
    pub fn new(names: Names, units: Units) -> Self {
        let bodies = names.bodies.len();
        Self {
            sections: Vec::new(),
            units,
            names,
            symbols: BTreeMap::new(),
            points: Vec::new(),
            poses: vec![None; bodies],
            loads: vec![Vec::new(); bodies],
            reactions: Vec::new(),
            group: 0,
            unfit: false,
        }
    }

    /// Begins a part under a heading.
    pub fn section(&mut self, title: Text) {
        self.sections.push(Section { title, entries: Vec::new() });
    }

    /// Sets the group (counted from 1) to which the next symbols belong; see [`local`](Self::local).
    pub fn begin_group(&mut self, number: usize) {
        self.group = number;
    }

    /// A symbol of the current group: `d` becomes `d_2` in group 2.
    pub fn local(&self, symbol: impl Into<Symbol>) -> Symbol {
        symbol.into().of(self.group)
    }

    /// Number of the current group, for symbols of several components: `V_x_2`.
    pub fn group_number(&self) -> Symbol {
        self.group.into()
    }

    /// Whether an equation already written has no finite result; the working is then not valid in this position.
    pub fn is_unfit(&self) -> bool {
        self.unfit
    }

    fn push(&mut self, entry: Entry) {
        if self.sections.is_empty() {
            self.section(text!("worksheet-working"));
        }
        if let Some(section) = self.sections.last_mut() {
            section.entries.push(entry);
        }
    }

    /// Writes a remark.
    pub fn note(&mut self, words: Text) {
        self.push(Entry::Note(words));
    }

    /// Writes an equation without numbers.
    pub fn equation(&mut self, left: Expr, right: Expr) {
        self.push(Entry::Equation([left, right].map(|side| side.terms(Show::Names)).into()));
    }

    /// The symbol, or one with a number that no other quantity has yet.
    fn free(&self, symbol: Symbol) -> Symbol {
        let numbered = (2_usize..).map(|i| symbol.clone().of(i));
        let mut all = std::iter::once(symbol.clone()).chain(numbered);
        all.find(|symbol| !self.symbols.contains_key(&key(symbol))).unwrap_or(symbol)
    }

    /// Introduces a given quantity; one with the same name and value is written only once.
    pub fn given(&mut self, symbol: impl Into<Symbol>, value: f64, unit: &'static str, what: Text) -> Expr {
        let symbol = symbol.into();
        if self.symbols.get(&key(&symbol)).is_some_and(|found| found.to_bits() == value.to_bits()) {
            return Expr::symbol(symbol, value);
        }
        let symbol = self.free(symbol);
        let mut shown = measured(&shortest(value, GIVEN_DIGITS), unit);
        shown.extend((!what.is_empty()).then_some(Term::Words(what)));
        self.symbols.insert(key(&symbol), value);
        self.unfit |= !value.is_finite();
        self.push(Entry::Equation(vec![vec![Term::Symbol(symbol.clone())], shown]));
        Expr::symbol(symbol, value)
    }

    /// Writes an equation and returns its result as a symbol. If the symbol is in use, a number is added to it.
    pub fn work(&mut self, symbol: impl Into<Symbol>, expr: &Expr, unit: &'static str) -> Expr {
        let line = Line::new(self.free(symbol.into()), expr, unit);
        self.symbols.insert(key(&line.symbol), line.value);
        self.unfit |= !line.value.is_finite();
        let symbol = Expr::symbol(&line.symbol, line.value);
        self.push(Entry::Line(line));
        symbol
    }

    /// Writes an equation and returns its result as a symbol; an expression that is zero by structure is not written.
    pub fn work_unless_zero(&mut self, symbol: impl Into<Symbol>, expr: &Expr, unit: &'static str) -> Expr {
        if expr.is_zero() { Expr::zero() } else { self.work(symbol, expr, unit) }
    }

    /// A symbol that is already written.
    pub fn find(&self, symbol: impl Into<Symbol>) -> Option<Expr> {
        let symbol = symbol.into();
        self.symbols.get(&key(&symbol)).map(|value| Expr::symbol(symbol, *value))
    }

    /// A symbol of this group that is already written; if there is none, the sheet becomes invalid.
    pub fn recall(&mut self, letter: &'static str) -> Expr {
        let symbol = self.local(letter);
        let found = self.find(&symbol);
        self.unfit |= found.is_none();
        found.unwrap_or_else(|| Expr::symbol(symbol, f64::NAN))
    }

    /// Name of a body.
    pub fn body_name(&self, body: usize) -> Text {
        self.names.bodies[body].clone()
    }

    /// Name of a pair.
    pub fn pair_name(&self, pair: usize) -> Text {
        self.names.pairs[pair].clone()
    }
}

/// What tells a symbol from all others.
fn key(symbol: &Symbol) -> String {
    symbol.plain(Language::english())
}

/// Writes a part of the working of one placed group.
///
/// `bodies` are solved; they only determine which assembly holds (the signs of roots).
pub type Write = fn(&mut Sheet, &GroupFrame, &[Body<f64>]) -> Result<(), BuildError>;

/// Entry of a kind's working in the registry: `inventory::submit! { WorkingPlugin { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct WorkingPlugin {
    /// Name of the group plugin: `rrr`.
    pub group: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// Writes positions, PF1 and PF2; it must set the pose of every link of the group.
    pub motion: Write,
    /// Writes the reactions in all pairs of the group; it must pass those of the outer pairs to the outer bodies.
    pub reactions: Write,
}

assur_plugin::registry!(WorkingPlugin, assur_plugin::Text::message("group-working-sort", Vec::new()), group);

/// The working of a kind of group; `None` if the kind provides none.
///
/// # Errors
///
/// [`RegistryError::Duplicate`] if two workings are registered for one kind.
pub fn plugin_for(group: &str) -> Result<Option<&'static WorkingPlugin>, RegistryError> {
    match assur_plugin::find(group) {
        Ok(plugin) => Ok(Some(plugin)),
        Err(RegistryError::Empty(_) | RegistryError::Unknown { .. }) => Ok(None),
        Err(fault) => Err(fault),
    }
}
