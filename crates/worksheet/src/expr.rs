//! Right sides of equations.

use std::borrow::Borrow;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

use crate::{Symbol, figure::rounded};

/// An expression of named quantities; cheap to clone.
///
/// Parts that vanish by structure (the velocity of a fixed point) are [`Expr::zero`] and are dropped when an
/// expression is built, as in a calculation by hand.
#[derive(Debug, Clone, PartialEq)]
pub struct Expr(pub(crate) Arc<Node>);

/// A node of the tree.
#[derive(Debug, PartialEq)]
pub(crate) enum Node {
    /// A constant of the formula: 2, 180.
    Number(f64),
    Pi,
    /// A named quantity.
    Symbol {
        symbol: Symbol,
        value: f64,
    },
    Sum(Expr, Expr),
    Difference(Expr, Expr),
    Product(Expr, Expr),
    Quotient(Expr, Expr),
    Negative(Expr),
    Square(Expr),
    /// sqrt, sin, cos, atan2.
    Call(&'static str, Vec<Expr>),
}

/// A value, and the size of the terms added to get it, which determines its rounding error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Measured {
    pub(crate) value: f64,
    pub(crate) size: f64,
}

impl Expr {
    fn new(node: Node) -> Self {
        Self(Arc::new(node))
    }

    /// A constant of the formula.
    pub fn number(value: f64) -> Self {
        Self::new(Node::Number(value))
    }

    /// An expression that vanishes by structure.
    pub fn zero() -> Self {
        Self::number(0.0)
    }

    /// The number pi.
    pub fn pi() -> Self {
        Self::new(Node::Pi)
    }

    /// A named quantity.
    pub fn symbol(symbol: impl Into<Symbol>, value: f64) -> Self {
        Self::new(Node::Symbol { symbol: symbol.into(), value })
    }

    /// Whether it vanishes by structure.
    pub fn is_zero(&self) -> bool {
        matches!(&*self.0, Node::Number(value) if *value == 0.0)
    }

    fn is_one(&self) -> bool {
        matches!(&*self.0, Node::Number(value) if (*value - 1.0).abs() == 0.0)
    }

    /// Square of the expression.
    #[must_use]
    pub fn squared(&self) -> Self {
        if self.is_zero() || self.is_one() {
            return self.clone();
        }
        Self::new(Node::Square(self.clone()))
    }

    /// Square root of the expression.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        self.called("sqrt")
    }

    /// Sine of the expression (rad).
    #[must_use]
    pub fn sin(&self) -> Self {
        if self.is_zero() { Self::zero() } else { self.called("sin") }
    }

    /// Cosine of the expression (rad).
    #[must_use]
    pub fn cos(&self) -> Self {
        if self.is_zero() { Self::number(1.0) } else { self.called("cos") }
    }

    /// Angle of the vector (x, y) = (`x`, self), rad.
    #[must_use]
    pub fn atan2(&self, x: &Self) -> Self {
        Self::new(Node::Call("atan2", vec![self.clone(), x.clone()]))
    }

    fn called(&self, function: &'static str) -> Self {
        Self::new(Node::Call(function, vec![self.clone()]))
    }

    /// Its value, all digits.
    pub fn value(&self) -> f64 {
        self.evaluate(None).value
    }

    /// Value and size of the expression; with `digits`, from the symbols as printed.
    pub(crate) fn evaluate(&self, digits: Option<usize>) -> Measured {
        let of = |part: &Self| part.evaluate(digits);
        match &*self.0 {
            Node::Number(value) => Measured { value: *value, size: value.abs() },
            Node::Pi => Measured { value: std::f64::consts::PI, size: std::f64::consts::PI },
            Node::Symbol { value, .. } => {
                let value = digits.map_or(*value, |digits| rounded(*value, digits));
                Measured { value, size: value.abs() }
            }
            Node::Sum(a, b) => of(a).plus(of(b)),
            Node::Difference(a, b) => of(a).plus(of(b).times(-1.0)),
            Node::Negative(a) => of(a).times(-1.0),
            Node::Product(a, b) => {
                let (a, b) = (of(a), of(b));
                let size = (a.size * b.value.abs()).max(a.value.abs() * b.size);
                Measured { value: a.value * b.value, size }
            }
            Node::Quotient(a, b) => {
                let (a, b) = (of(a), of(b));
                let value = a.value / b.value;
                let size = (a.size / b.value).abs().max((value * b.size / b.value).abs());
                Measured { value, size }
            }
            Node::Square(a) => {
                let a = of(a);
                Measured { value: a.value * a.value, size: a.size * a.value.abs() }
            }
            Node::Call(function, arguments) => called(function, arguments, digits),
        }
    }
}

impl Measured {
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size.max(other.size) }
    }

    fn times(self, k: f64) -> Self {
        Self { value: k * self.value, size: self.size * k.abs() }
    }
}

fn called(function: &str, arguments: &[Expr], digits: Option<usize>) -> Measured {
    let at = |i: usize| {
        let found = arguments.get(i).map(|argument| argument.evaluate(digits));
        found.unwrap_or(Measured { value: f64::NAN, size: f64::NAN })
    };
    let first = at(0);
    match function {
        "sqrt" => Measured { value: first.value.sqrt(), size: first.size.sqrt() },
        "sin" => Measured { value: first.value.sin(), size: first.size.max(1.0) },
        "cos" => Measured { value: first.value.cos(), size: first.size.max(1.0) },
        _ => {
            let x = at(1);
            let length = first.value.hypot(x.value);
            let size = first.size.max(x.size) / length;
            Measured { value: first.value.atan2(x.value), size }
        }
    }
}

fn add(a: &Expr, b: &Expr) -> Expr {
    if a.is_zero() {
        return b.clone();
    }
    if b.is_zero() {
        return a.clone();
    }
    match &*b.0 {
        Node::Negative(b) => Expr::new(Node::Difference(a.clone(), b.clone())),
        // Evaluated from left to right, so that no sum needs parentheses.
        Node::Sum(c, d) => add(&add(a, c), d),
        Node::Difference(c, d) => subtract(&add(a, c), d),
        _ => Expr::new(Node::Sum(a.clone(), b.clone())),
    }
}

fn subtract(a: &Expr, b: &Expr) -> Expr {
    if b.is_zero() {
        return a.clone();
    }
    if a.is_zero() {
        return negative(b);
    }
    match &*b.0 {
        Node::Negative(b) => Expr::new(Node::Sum(a.clone(), b.clone())),
        _ => Expr::new(Node::Difference(a.clone(), b.clone())),
    }
}

fn multiply(a: &Expr, b: &Expr) -> Expr {
    if a.is_zero() || b.is_zero() {
        return Expr::zero();
    }
    if a.is_one() {
        return b.clone();
    }
    if b.is_one() {
        return a.clone();
    }
    match (&*a.0, &*b.0) {
        (Node::Negative(a), Node::Negative(b)) => multiply(a, b),
        (Node::Negative(a), _) => negative(&multiply(a, b)),
        (_, Node::Negative(b)) => negative(&multiply(a, b)),
        _ => Expr::new(Node::Product(a.clone(), b.clone())),
    }
}

fn divide(a: &Expr, b: &Expr) -> Expr {
    if a.is_zero() || b.is_one() {
        return a.clone();
    }
    match &*a.0 {
        Node::Negative(a) => negative(&divide(a, b)),
        _ => Expr::new(Node::Quotient(a.clone(), b.clone())),
    }
}

fn negative(a: &Expr) -> Expr {
    match &*a.0 {
        Node::Number(value) if *value == 0.0 => a.clone(),
        Node::Negative(a) => a.clone(),
        Node::Difference(b, c) => Expr::new(Node::Difference(c.clone(), b.clone())),
        _ => Expr::new(Node::Negative(a.clone())),
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $call:ident) => {
        impl<Other: Borrow<Expr>> $trait<Other> for &Expr {
            type Output = Expr;
            fn $method(self, other: Other) -> Expr {
                $call(self, other.borrow())
            }
        }
        impl<Other: Borrow<Expr>> $trait<Other> for Expr {
            type Output = Expr;
            fn $method(self, other: Other) -> Expr {
                $call(&self, other.borrow())
            }
        }
    };
}
operator!(Add, add, add);
operator!(Sub, sub, subtract);
operator!(Mul, mul, multiply);
operator!(Div, div, divide);

impl Neg for &Expr {
    type Output = Expr;
    fn neg(self) -> Expr {
        negative(self)
    }
}

impl Neg for Expr {
    type Output = Expr;
    fn neg(self) -> Expr {
        negative(&self)
    }
}
