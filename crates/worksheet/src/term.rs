//! An expression as a row of terms, from which every form of it is printed.

use assur_words::{Text, joined, name, number, text, unit};

use crate::Symbol;
use crate::expr::{Expr, Node};
use crate::figure::shortest;

/// A part of a printed expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Term {
    /// A quantity.
    Symbol(Symbol),
    /// A number by its digits in English.
    Number(String),
    /// sqrt, sin, cos, atan2.
    Function(&'static str),
    /// Operator with its spaces, or a parenthesis.
    Sign(&'static str),
    /// What separates the arguments of a function.
    Comma,
    /// The exponent 2 of what stands before it.
    Square,
    /// The unit of the number before it.
    Unit(&'static str),
    /// What the quantity is, in words behind the equation.
    Words(Text),
}

impl Term {
    /// The term as plain text with the signs of programs: `*`, `^2`.
    pub fn text(&self) -> Text {
        match self {
            Self::Symbol(symbol) => symbol.into(),
            Self::Number(digits) => number(digits),
            Self::Function(name_of) => name(*name_of),
            Self::Sign(sign) if sign.contains('-') => number(sign),
            Self::Sign(sign) => name(*sign),
            Self::Comma => text!("worksheet-between-arguments"),
            Self::Square => name("^2"),
            Self::Unit(symbol) => joined("", [name(" "), unit(*symbol)]),
            Self::Words(words) => joined("", [name("  ("), words.clone(), name(")")]),
        }
    }
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
    /// The expression as it is printed.
    pub(crate) fn terms(&self, show: Show) -> Vec<Term> {
        let mut out = Vec::new();
        write(self, show, SUM, true, &mut out);
        out
    }
}

/// `first`: whether the part is the first one within its parentheses; its minus then needs no parentheses of its own.
fn write(expr: &Expr, show: Show, tight: u8, first: bool, out: &mut Vec<Term>) {
    let own = binding(expr, show);
    let minus = own == SUM && !matches!(&*expr.0, Node::Sum(..) | Node::Difference(..));
    let bare = if minus { first && tight < DIVISOR } else { own >= tight };
    if bare {
        return body(expr, show, first, out);
    }
    out.push(Term::Sign("("));
    body(expr, show, true, out);
    out.push(Term::Sign(")"));
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

fn body(expr: &Expr, show: Show, first: bool, out: &mut Vec<Term>) {
    let mut two = |a: &Expr, sign: &'static str, b: &Expr, left: u8, right: u8| {
        write(a, show, left, first, out);
        out.push(Term::Sign(sign));
        write(b, show, right, false, out);
    };
    match &*expr.0 {
        Node::Sum(a, b) => two(a, " + ", b, SUM, SUM),
        Node::Difference(a, b) => two(a, " - ", b, SUM, PRODUCT),
        Node::Product(a, b) => two(a, "*", b, PRODUCT, PRODUCT),
        Node::Quotient(a, b) => two(a, "/", b, PRODUCT, DIVISOR),
        Node::Negative(a) => {
            out.push(Term::Sign("-"));
            write(a, show, PRODUCT, false, out);
        }
        Node::Square(a) => {
            write(a, show, POWER, false, out);
            out.push(Term::Square);
        }
        Node::Call(function, arguments) => call(function, arguments, show, out),
        Node::Number(value) => out.push(Term::Number(value.to_string())),
        Node::Pi => out.push(Term::Symbol("π".into())),
        Node::Symbol { symbol, value } => out.push(match show {
            Show::Names => Term::Symbol(symbol.clone()),
            Show::Digits(digits) => Term::Number(shortest(*value, digits)),
        }),
    }
}

fn call(function: &'static str, arguments: &[Expr], show: Show, out: &mut Vec<Term>) {
    out.extend([Term::Function(function), Term::Sign("(")]);
    for (i, argument) in arguments.iter().enumerate() {
        if i > 0 {
            out.push(Term::Comma);
        }
        write(argument, show, SUM, true, out);
    }
    out.push(Term::Sign(")"));
}
