//! The elements of a working.

use assur_words::Text;

use crate::Symbol;
use crate::expr::{Expr, Node};
use crate::figure::{self, shortest, zero};
use crate::term::{Show, Term};

/// Significant digits of a printed result.
pub const RESULT_DIGITS: usize = 6;

/// Number of digits that always suffices: 17 digits give a double exactly.
const ALL_DIGITS: usize = 17;

/// A value so close to the middle between two printed numbers, in half units, could be printed as either.
const TIE: f64 = 1e-6;

/// A value smaller than this fraction of the terms added to get it is rounding, and counts as zero.
const ROUNDING: f64 = 1e-12;

/// One equation: a symbol, its formula, the formula with numbers, the result.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The quantity.
    pub symbol: Symbol,
    /// Its formula.
    pub formula: Expr,
    /// Its value, all digits.
    pub value: f64,
    /// The value as printed in English.
    pub result: String,
    /// Half a unit of the last printed digit.
    pub half_unit: f64,
    /// Unit; may be empty.
    pub unit: &'static str,
    /// Significant digits of the substituted numbers, which recompute to `result`.
    pub digits: usize,
}

impl Line {
    pub(crate) fn new(symbol: Symbol, formula: &Expr, unit: &'static str) -> Self {
        Self::with_digits(symbol, formula, unit, RESULT_DIGITS)
    }

    /// An equation whose result has so many significant digits.
    fn with_digits(symbol: Symbol, formula: &Expr, unit: &'static str, significant: usize) -> Self {
        let exact = formula.evaluate(None);
        let is_zero = exact.value.abs() <= ROUNDING * exact.size;
        let value = if is_zero { 0.0 } else { exact.value };
        let shown = |digits: usize| {
            let (result, half_unit) =
                if is_zero { zero(exact.size, digits) } else { figure::significant(value, digits) };
            let printed: f64 = result.parse().unwrap_or(value);
            (result, half_unit, printed)
        };
        let (mut result, mut half_unit, mut printed) = shown(significant);
        if (value - printed).abs() >= half_unit * (1.0 - TIE) {
            // Halfway between two numbers, where readers may round either way.
            (result, half_unit, printed) = shown(significant + 1);
        }
        let recomputes = |digits: &usize| {
            let found: f64 = formula.evaluate(Some(*digits)).value;
            (found - printed).abs() <= half_unit * (1.0 - TIE)
        };
        let digits = (significant..ALL_DIGITS).find(recomputes).unwrap_or(ALL_DIGITS);
        Self { symbol, formula: formula.clone(), value, result, half_unit, unit, digits }
    }

    /// The formula in symbols and with numbers, without what would only repeat the result.
    fn middle(&self) -> Vec<Vec<Term>> {
        let shown = [Show::Names, Show::Digits(self.digits)].map(|show| self.formula.terms(show));
        let single = match &*self.formula.0 {
            Node::Negative(part) => part,
            _ => &self.formula,
        };
        match &*single.0 {
            Node::Number(_) => Vec::new(),
            Node::Symbol { .. } => shown.into_iter().take(1).collect(),
            _ => shown.into_iter().collect(),
        }
    }
}

/// A row of a working.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// A remark.
    Note(Text),
    /// An equation without numbers, or a given quantity: what stands between the signs of equality.
    Equation(Vec<Vec<Term>>),
    /// An equation.
    Line(Line),
}

impl Entry {
    /// The same with so many significant digits in its result, and two more in what is given.
    #[must_use]
    pub fn with_digits(&self, digits: usize) -> Self {
        let given = |term: &Term| match term {
            Term::Number(own) => {
                Term::Number(own.parse().map_or_else(|_| own.clone(), |value| shortest(value, digits + 2)))
            }
            other => other.clone(),
        };
        match self {
            Self::Note(text) => Self::Note(text.clone()),
            Self::Equation(sides) => {
                Self::Equation(sides.iter().map(|side| side.iter().map(given).collect()).collect())
            }
            Self::Line(own) => {
                Self::Line(Line::with_digits(own.symbol.clone(), &own.formula, own.unit, digits))
            }
        }
    }

    /// What stands between the signs of equality; nothing for a remark.
    pub fn sides(&self) -> Vec<Vec<Term>> {
        match self {
            Self::Note(_) => Vec::new(),
            Self::Equation(sides) => sides.clone(),
            Self::Line(line) => {
                let mut sides = vec![vec![Term::Symbol(line.symbol.clone())]];
                sides.extend(line.middle());
                sides.push(measured(&line.result, line.unit));
                sides
            }
        }
    }
}

/// A number as printed in English, and its unit, which may be empty.
pub(crate) fn measured(digits: &str, unit: &'static str) -> Vec<Term> {
    let unit = (!unit.is_empty()).then_some(Term::Unit(unit));
    std::iter::once(Term::Number(digits.to_owned())).chain(unit).collect()
}

/// A part of a working under one heading.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The heading.
    pub title: Text,
    /// Its rows.
    pub entries: Vec<Entry>,
}
