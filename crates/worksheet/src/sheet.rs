//! Collects the equations of a working and knows its symbols.

use std::collections::BTreeMap;

use crate::figure::shortest;
use crate::{Entry, Expr, Line, Load, Point, Pose, Reaction, Section};

/// Digits with which a given number is printed.
const GIVEN_DIGITS: usize = 9;

/// What bodies, places and pairs are called in a working.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Names {
    /// By body, the ground first.
    pub bodies: Vec<String>,
    /// Places (body, coordinates in its frame, m) that have a name. One name in two bodies is a pin.
    pub places: Vec<(usize, [f64; 2], String)>,
    /// By pair of the chain.
    pub pairs: Vec<String>,
}

/// Units of derivatives by the input coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Units {
    /// Of a length: the first and the second derivative.
    pub length: [&'static str; 3],
    /// Of an angle.
    pub angle: [&'static str; 3],
}

impl Units {
    /// Of a turning input.
    pub const ANGULAR: Self =
        Self { length: ["m", "m/rad", "m/rad²"], angle: ["rad", "rad/rad", "rad/rad²"] };
    /// Of a sliding input.
    pub const LINEAR: Self = Self { length: ["m", "m/m", "m/m²"], angle: ["rad", "rad/m", "rad/m²"] };
}

/// The working as it grows.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// What is written so far.
    pub sections: Vec<Section>,
    /// Units of derivatives.
    pub units: Units,
    pub(crate) names: Names,
    /// Values of all symbols so far.
    symbols: BTreeMap<String, f64>,
    pub(crate) points: Vec<Point>,
    pub(crate) poses: Vec<Option<Pose>>,
    pub(crate) loads: Vec<Vec<Load>>,
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
    pub fn section(&mut self, title: &str) {
        self.sections.push(Section { title: title.to_owned(), entries: Vec::new() });
    }

    /// Says which group (counted from 1) the next symbols belong to: see [`local`](Self::local).
    pub fn begin_group(&mut self, number: usize) {
        self.group = number;
    }

    /// A symbol of the group that is being worked: `d` becomes `d_2` in group 2.
    pub fn local(&self, name: &str) -> String {
        format!("{name}_{}", self.group)
    }

    /// Number of the group that is being worked, for symbols of several components: `Vx_2`.
    pub fn group_number(&self) -> String {
        self.group.to_string()
    }

    /// Whether an equation so far had no finite result: it does not hold in this position.
    pub fn is_unfit(&self) -> bool {
        self.unfit
    }

    fn push(&mut self, entry: Entry) {
        if self.sections.is_empty() {
            self.section("Working");
        }
        if let Some(section) = self.sections.last_mut() {
            section.entries.push(entry);
        }
    }

    /// Writes words, or an equation without numbers.
    pub fn note(&mut self, words: impl Into<String>) {
        self.push(Entry::Note(words.into()));
    }

    /// A name that no symbol has so far.
    fn free(&self, name: &str) -> String {
        let taken = |name: &str| self.symbols.contains_key(name);
        if !taken(name) {
            return name.to_owned();
        }
        let numbered = (2..).map(|i| format!("{name}_{i}"));
        numbered.into_iter().find(|name| !taken(name)).unwrap_or_default()
    }

    /// Introduces a quantity that is given; the same name and value twice is one quantity, written once.
    pub fn given(&mut self, name: &str, value: f64, unit: &str, what: &str) -> Expr {
        if self.symbols.get(name).is_some_and(|found| found.to_bits() == value.to_bits()) {
            return Expr::symbol(name, value);
        }
        let name = self.free(name);
        let result = shortest(value, GIVEN_DIGITS);
        self.symbols.insert(name.clone(), value);
        self.unfit |= !value.is_finite();
        let symbol = Expr::symbol(&name, value);
        self.push(Entry::Given { name, value, result, unit: unit.to_owned(), what: what.to_owned() });
        symbol
    }

    /// Writes an equation and gives its result as a symbol. A name that is taken gets a number.
    pub fn work(&mut self, name: &str, expr: &Expr, unit: &str) -> Expr {
        let line = Line::new(self.free(name), expr, unit);
        self.symbols.insert(line.name.clone(), line.value);
        self.unfit |= !line.value.is_finite();
        let symbol = Expr::symbol(&line.name, line.value);
        self.push(Entry::Line(line));
        symbol
    }

    /// As [`work`](Self::work); what vanishes by structure stays unwritten.
    pub fn work_unless_zero(&mut self, name: &str, expr: &Expr, unit: &str) -> Expr {
        if expr.is_zero() { Expr::zero() } else { self.work(name, expr, unit) }
    }

    /// A symbol that was written before.
    pub fn find(&self, name: &str) -> Option<Expr> {
        self.symbols.get(name).map(|value| Expr::symbol(name, *value))
    }

    /// A symbol of this group that was written before; without one, the sheet is unfit.
    pub fn recall(&mut self, name: &str) -> Expr {
        let name = self.local(name);
        let found = self.find(&name);
        self.unfit |= found.is_none();
        found.unwrap_or_else(|| Expr::symbol(&name, f64::NAN))
    }

    /// Name of a body as it stands in symbols.
    pub fn tag(&self, body: usize) -> String {
        symbol_of(&self.names.bodies[body])
    }

    /// Name of a body in words.
    pub fn body_name(&self, body: usize) -> &str {
        &self.names.bodies[body]
    }

    /// Name of a pair as it stands in symbols.
    pub fn pair_tag(&self, pair: usize) -> String {
        symbol_of(&self.names.pairs[pair])
    }
}

/// A name as it stands in symbols: signs that could be read as an operation are replaced.
pub fn symbol_of(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect()
}
