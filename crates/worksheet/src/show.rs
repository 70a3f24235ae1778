//! Prints an expression in symbols or with numbers substituted.

use crate::expr::{Expr, Node};
use crate::figure::shortest;

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
