//! Collects the equations of a working and their symbols.

use std::collections::BTreeMap;

use crate::figure::shortest;
use crate::{Entry, Expr, Line, Load, Point, Pose, Reaction, Section};

/// Number of digits of a given quantity.
const GIVEN_DIGITS: usize = 9;

/// Names of bodies, places and pairs in a working.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Names {
    /// Names of the bodies, the ground first.
    pub bodies: Vec<String>,
    /// Named places (body, coordinates in its frame, m). A place with one name in two bodies is a pin.
    pub places: Vec<(usize, [f64; 2], String)>,
    /// Names of the pairs of the chain.
    pub pairs: Vec<String>,
}

/// Units of derivatives with respect to the input coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Units {
    /// Units of a length and of its first and second derivatives.
    pub length: [&'static str; 3],
    /// Units of an angle and of its first and second derivatives.
    pub angle: [&'static str; 3],
}

impl Units {
    /// Units for a rotating input.
    pub const ANGULAR: Self =
        Self { length: ["m", "m/rad", "m/rad²"], angle: ["rad", "rad/rad", "rad/rad²"] };
    /// Units for a sliding input.
    pub const LINEAR: Self = Self { length: ["m", "m/m", "m/m²"], angle: ["rad", "rad/m", "rad/m²"] };
}

/// A working under construction.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// The sections already written.
    pub sections: Vec<Section>,
    /// Units of derivatives.
    pub units: Units,
    pub(crate) names: Names,
    /// Values of all symbols already written.
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

    /// Sets the group (counted from 1) to which the next symbols belong; see [`local`](Self::local).
    pub fn begin_group(&mut self, number: usize) {
        self.group = number;
    }

    /// A symbol of the current group: `d` becomes `d_2` in group 2.
    pub fn local(&self, name: &str) -> String {
        format!("{name}_{}", self.group)
    }

    /// Number of the current group, for symbols of several components: `Vx_2`.
    pub fn group_number(&self) -> String {
        self.group.to_string()
    }

    /// Whether an equation already written has no finite result; the working is then not valid in this position.
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

    /// Writes a note: text, or an equation without numbers.
    pub fn note(&mut self, words: impl Into<String>) {
        self.push(Entry::Note(words.into()));
    }

    /// A name that no symbol has yet.
    fn free(&self, name: &str) -> String {
        let taken = |name: &str| self.symbols.contains_key(name);
        if !taken(name) {
            return name.to_owned();
        }
        let numbered = (2..).map(|i| format!("{name}_{i}"));
        numbered.into_iter().find(|name| !taken(name)).unwrap_or_default()
    }

    /// Introduces a given quantity; one with the same name and value is written only once.
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

    /// Writes an equation and returns its result as a symbol. If the name is in use, a number is added to it.
    pub fn work(&mut self, name: &str, expr: &Expr, unit: &str) -> Expr {
        let line = Line::new(self.free(name), expr, unit);
        self.symbols.insert(line.name.clone(), line.value);
        self.unfit |= !line.value.is_finite();
        let symbol = Expr::symbol(&line.name, line.value);
        self.push(Entry::Line(line));
        symbol
    }

    /// Writes an equation and returns its result as a symbol; an expression that is zero by structure is not written.
    pub fn work_unless_zero(&mut self, name: &str, expr: &Expr, unit: &str) -> Expr {
        if expr.is_zero() { Expr::zero() } else { self.work(name, expr, unit) }
    }

    /// A symbol that is already written.
    pub fn find(&self, name: &str) -> Option<Expr> {
        self.symbols.get(name).map(|value| Expr::symbol(name, *value))
    }

    /// A symbol of this group that is already written; if there is none, the sheet becomes invalid.
    pub fn recall(&mut self, name: &str) -> Expr {
        let name = self.local(name);
        let found = self.find(&name);
        self.unfit |= found.is_none();
        found.unwrap_or_else(|| Expr::symbol(&name, f64::NAN))
    }

    /// Name of a body as used in symbols.
    pub fn tag(&self, body: usize) -> String {
        symbol_of(&self.names.bodies[body])
    }

    /// Name of a body as used in text.
    pub fn body_name(&self, body: usize) -> &str {
        &self.names.bodies[body]
    }

    /// Name of a pair as used in symbols.
    pub fn pair_tag(&self, pair: usize) -> String {
        symbol_of(&self.names.pairs[pair])
    }
}

/// A name as used in symbols: characters that could be read as an operation are replaced.
pub fn symbol_of(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect()
}
