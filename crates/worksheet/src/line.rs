//! The elements of a working.

use crate::expr::{Expr, Node};
use crate::figure::{shortest, significant, zero};

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

/// How symbols are printed.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Show {
    /// By name.
    Names,
    /// By value, with so many digits.
    Digits(usize),
}

/// Binding strength of the context: a part with a weaker operator needs parentheses.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const DIVISOR: u8 = 3;
const POWER: u8 = 4;

impl Expr {
    pub(crate) fn show(&self, show: Show) -> String {
        let mut out = String::new();
        write(self, show, SUM, true, &mut out);
        out
    }
}

/// `first`: whether the part is the first one within its parentheses; its minus then needs no parentheses of its own.
fn write(expr: &Expr, show: Show, tight: u8, first: bool, out: &mut String) {
    let own = binding(expr, show);
    let minus = own == SUM && !matches!(&*expr.0, Node::Sum(..) | Node::Difference(..));
    let bare = if minus { first && tight < DIVISOR } else { own >= tight };
    if bare {
        return body(expr, show, first, out);
    }
    out.push('(');
    body(expr, show, true, out);
    out.push(')');
}

fn binding(expr: &Expr, show: Show) -> u8 {
    match (&*expr.0, show) {
        (Node::Symbol { value, .. }, Show::Digits(_)) if *value < 0.0 => SUM,
        (Node::Number(value), _) if *value < 0.0 => SUM,
        (Node::Sum(..) | Node::Difference(..) | Node::Negative(_), _) => SUM,
        (Node::Product(..) | Node::Quotient(..), _) => PRODUCT,
        (Node::Square(_), _) => DIVISOR,
        _ => POWER,
    }
}

fn body(expr: &Expr, show: Show, first: bool, out: &mut String) {
    let mut two = |a: &Expr, sign: &str, b: &Expr, left: u8, right: u8| {
        write(a, show, left, first, out);
        out.push_str(sign);
        write(b, show, right, false, out);
    };
    match &*expr.0 {
        Node::Sum(a, b) => two(a, " + ", b, SUM, SUM),
        Node::Difference(a, b) => two(a, " - ", b, SUM, PRODUCT),
        Node::Product(a, b) => two(a, "*", b, PRODUCT, PRODUCT),
        Node::Quotient(a, b) => two(a, "/", b, PRODUCT, DIVISOR),
        Node::Negative(a) => {
            out.push('-');
            write(a, show, PRODUCT, false, out);
        }
        Node::Square(a) => {
            write(a, show, POWER, false, out);
            out.push_str("^2");
        }
        Node::Call(function, arguments) => call(function, arguments, show, out),
        Node::Number(value) => out.push_str(&value.to_string()),
        Node::Pi => out.push_str("pi"),
        Node::Symbol { name, value } => match show {
            Show::Names => out.push_str(name),
            Show::Digits(digits) => out.push_str(&shortest(*value, digits)),
        },
    }
}

fn call(function: &str, arguments: &[Expr], show: Show, out: &mut String) {
    out.push_str(function);
    out.push('(');
    for (i, argument) in arguments.iter().enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        write(argument, show, SUM, true, out);
    }
    out.push(')');
}
