//! The elements of a working.

use crate::expr::Expr;
use crate::figure::{significant, zero};
use crate::show::Show;

/// Significant digits of a printed result.
pub const RESULT_DIGITS: usize = 6;

/// Number of digits that always suffices: 17 digits give a double exactly.
const ALL_DIGITS: usize = 17;

/// A value smaller than this fraction of the terms added to get it is rounding, and counts as zero.
const ROUNDING: f64 = 1e-12;

/// One equation: name = text = substituted = result unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The quantity.
    pub name: String,
    /// Its formula in symbols.
    pub text: String,
    /// The formula with numbers substituted; they recompute to `result`.
    pub substituted: String,
    /// Its value, all digits.
    pub value: f64,
    /// The value as printed.
    pub result: String,
    /// Half a unit of the last printed digit.
    pub half_unit: f64,
    /// Unit; may be empty.
    pub unit: String,
    /// Significant digits of the substituted numbers.
    pub digits: usize,
}

impl Line {
    pub(crate) fn new(name: String, expr: &Expr, unit: &str) -> Self {
        let exact = expr.evaluate(None);
        let is_zero = exact.value.abs() <= ROUNDING * exact.size;
        let value = if is_zero { 0.0 } else { exact.value };
        let (result, half_unit) =
            if is_zero { zero(exact.size, RESULT_DIGITS) } else { significant(value, RESULT_DIGITS) };
        let printed = result.parse().unwrap_or(value);
        let recomputes = |digits: &usize| {
            let found: f64 = expr.evaluate(Some(*digits)).value;
            (found - printed).abs() <= half_unit * (1.0 - 1e-6)
        };
        let digits = (RESULT_DIGITS..ALL_DIGITS).find(recomputes).unwrap_or(ALL_DIGITS);
        Self {
            text: expr.show(Show::Names),
            substituted: expr.show(Show::Digits(digits)),
            name,
            value,
            result,
            half_unit,
            unit: unit.to_owned(),
            digits,
        }
    }
}

/// A row of a working.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// Text, or an equation without numbers.
    Note(String),
    /// A given quantity, with its value as printed and its unit.
    Given {
        /// The quantity.
        name: String,
        /// Its value, all digits.
        value: f64,
        /// The value as printed.
        result: String,
        /// Unit; may be empty.
        unit: String,
        /// Description; may be empty.
        what: String,
    },
    /// An equation.
    Line(Line),
}

/// A part of a working under one heading.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The heading.
    pub title: String,
    /// Its rows.
    pub entries: Vec<Entry>,
}

impl Section {
    /// Its equations.
    pub fn lines(&self) -> impl Iterator<Item = &Line> {
        self.entries.iter().filter_map(|entry| match entry {
            Entry::Line(line) => Some(line),
            _ => None,
        })
    }
}
