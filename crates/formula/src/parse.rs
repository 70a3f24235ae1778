//! Reads the text of a formula.

use std::ops::Range;

use assur_words::{Describe, Text, name as words, text};
use winnow::ascii::{float, space0};
use winnow::combinator::{
    Infix, Prefix, alt, cut_err, delimited, dispatch, expression, fail, opt, separated,
};
use winnow::error::{ContextError, ErrMode};
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location};
use winnow::token::{any, take_while};

use crate::program::{DEPTH, Function, Kind, MOST_SWITCHES, Operation, Switch, Used, Variable};

/// What a formula may use, for messages.
pub const FUNCTIONS: &str =
    "q w t x pi; + - * / ^; sin cos tan asin acos atan atan2 sqrt exp ln abs sign min max step";

/// Longest text.
const MOST_BYTES: usize = 2000;

/// Greatest number of parentheses, signs and powers: each may nest what follows.
const MOST_NESTED: usize = 200;

/// Why a text is no formula.
#[derive(Clone, PartialEq, Eq)]
pub struct FormulaError {
    /// Bytes of the text that are wrong.
    pub span: Range<usize>,
    /// What is wrong there.
    pub what: Text,
}

assur_words::errors!(FormulaError);

impl Describe for FormulaError {
    fn describe(&self) -> Text {
        self.what.clone()
    }
}

type Input<'i> = LocatingSlice<&'i str>;
type Failure = ErrMode<ContextError>;

/// A formula as it is written.
enum Tree {
    Number(Range<usize>, f64),
    Name(Range<usize>),
    Call(Range<usize>, Vec<Self>),
    Negate(Box<Self>),
    Two(Operation, Box<[Self; 2]>),
}

/// Letters of the formula, which no language changes.
fn letters(of: impl Into<String>) -> Text {
    words(of.into())
}

/// A formula as operations, with its switches.
pub(crate) fn read(text: &str) -> Result<(Vec<Operation>, Vec<Switch>), FormulaError> {
    let fault = |span: Range<usize>, what: Text| Err(FormulaError { span, what });
    if text.len() > MOST_BYTES {
        return fault(0..text.len(), text!("formula-too-long", most = MOST_BYTES, count = text.len()));
    }
    if text.bytes().filter(|byte| b"(^-+".contains(byte)).count() > MOST_NESTED {
        return fault(0..text.len(), text!("formula-many-signs", most = MOST_NESTED));
    }
    if let Some(found) = slip(text) {
        return Err(found);
    }
    match delimited(space0, whole, space0).parse(LocatingSlice::new(text)) {
        Ok(tree) => {
            let mut writer = Writer { text, operations: Vec::new(), switches: Vec::new() };
            let depth = writer.write(&tree)?;
            if depth > DEPTH {
                return fault(0..text.len(), text!("formula-too-deep", most = DEPTH));
            }
            Ok((writer.operations, writer.switches))
        }
        Err(error) => {
            let at = error.offset();
            let end = text[at..].chars().next().map_or(at, |c| at + c.len_utf8());
            let what = match text[at..].chars().next() {
                None => text!("formula-ends-early"),
                Some(',') => text!("formula-decimal-comma"),
                Some('<' | '>' | '=') => text!("formula-condition"),
                Some(sign) if ends_with_function(&text[..at]) => {
                    text!("formula-parentheses", sign = letters(sign))
                }
                Some(sign) => {
                    text!("formula-misplaced-sign", sign = letters(sign), known = letters(FUNCTIONS))
                }
            };
            fault(at..end.max(at), what)
        }
    }
}

/// What people write in a formula by habit: letters of another alphabet, `**`, `2q`.
fn slip(text: &str) -> Option<FormulaError> {
    let fault = |at: usize, long: usize, what: Text| Some(FormulaError { span: at..at + long, what });
    if let Some((at, sign)) = text.char_indices().find(|(_, c)| !c.is_ascii()) {
        return fault(at, sign.len_utf8(), text!("formula-foreign-sign", sign = letters(sign)));
    }
    if let Some(at) = text.find("**") {
        return fault(at, 2, text!("formula-power-sign"));
    }
    let is_part = |c: char| c.is_ascii_alphanumeric() || "._".contains(c);
    text.char_indices().filter(|(_, c)| c.is_ascii_alphabetic()).find_map(|(at, _)| {
        let before = text[..at].trim_end();
        let number = &before[before.trim_end_matches(is_part).len()..];
        let is_exponent = text[at..].starts_with(['e', 'E'])
            && text[at + 1..].starts_with(|c: char| c.is_ascii_digit() || "+-".contains(c));
        let is_number =
            number.parse::<f64>().is_ok() && number.starts_with(|c: char| !c.is_ascii_alphabetic());
        let fault = || fault(at, 1, text!("formula-missing-sign", number = letters(number)));
        if is_number && !is_exponent { fault() } else { None }
    })
}

/// Whether a text ends with the name of a function.
fn ends_with_function(text: &str) -> bool {
    let before = text.trim_end();
    let name = &before[before.trim_end_matches(|c: char| c.is_ascii_alphanumeric()).len()..];
    name.len() > 1 && name != "pi" && FUNCTIONS.split([' ', ';']).any(|known| known == name)
}

fn two(operation: Operation) -> impl Fn(Tree, Tree) -> Tree {
    move |a, b| Tree::Two(operation, Box::new([a, b]))
}

/// An expression with operators.
fn whole(input: &mut Input<'_>) -> Result<Tree, Failure> {
    expression(delimited(space0, operand, space0))
        .prefix(dispatch! { delimited(space0, any, space0);
            '-' => Prefix(9, |_: &mut _, a| Ok(Tree::Negate(Box::new(a)))),
            '+' => Prefix(9, |_: &mut _, a| Ok(a)),
            _ => fail,
        })
        .infix(dispatch! { delimited(space0, any, space0);
            '+' => Infix::Left(5, |_: &mut _, a, b| Ok(two(Operation::Add)(a, b))),
            '-' => Infix::Left(5, |_: &mut _, a, b| Ok(two(Operation::Subtract)(a, b))),
            '*' => Infix::Left(7, |_: &mut _, a, b| Ok(two(Operation::Multiply)(a, b))),
            '/' => Infix::Left(7, |_: &mut _, a, b| Ok(two(Operation::Divide)(a, b))),
            '^' => Infix::Right(11, |_: &mut _, a, b| Ok(two(Operation::Power)(a, b))),
            _ => fail,
        })
        .parse_next(input)
}

fn operand(input: &mut Input<'_>) -> Result<Tree, Failure> {
    alt((number, name, delimited('(', cut_err(whole), cut_err(')')))).parse_next(input)
}

/// A number without sign.
fn number(input: &mut Input<'_>) -> Result<Tree, Failure> {
    if !input.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return fail.parse_next(input);
    }
    float.with_span().map(|(value, span)| Tree::Number(span, value)).parse_next(input)
}

/// A variable, or a function with its arguments.
fn name(input: &mut Input<'_>) -> Result<Tree, Failure> {
    let start = input.current_token_start();
    let _: &str = (
        take_while(1, |c: char| c.is_ascii_alphabetic()),
        take_while(0.., |c: char| c.is_ascii_alphanumeric() || c == '_'),
    )
        .take()
        .parse_next(input)?;
    let span = start..input.previous_token_end();
    let mut arguments = opt(delimited((space0, '('), cut_err(separated(1.., whole, ',')), cut_err(')')));
    Ok(match arguments.parse_next(input)? {
        Some(arguments) => Tree::Call(span, arguments),
        None => Tree::Name(span),
    })
}

/// Names that people write by habit, and what stands for them here.
const HABITS: [(&str, &str); 13] = [
    ("phi", "q"),
    ("fi", "q"),
    ("angle", "q"),
    ("omega", "w"),
    ("time", "t"),
    ("tg", "tan"),
    ("arctg", "atan"),
    ("arctan", "atan"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("log", "ln"),
    ("sgn", "sign"),
    ("if", "step"),
];

/// What a name stands for, with its number of arguments.
fn operation(name: &str) -> Option<(usize, Operation)> {
    let call = |function| Some((1, Operation::Call(function)));
    let switch = |kind: Kind| Some((kind.arguments(), Operation::Switch(kind, 0)));
    let variable = |variable| Some((0, Operation::Variable(variable)));
    match name {
        "q" => variable(Variable::Coordinate),
        "w" => variable(Variable::Speed),
        "t" => variable(Variable::Time),
        "x" => variable(Variable::Place),
        "pi" => Some((0, Operation::Number(std::f64::consts::PI))),
        "sin" => call(Function::Sin),
        "cos" => call(Function::Cos),
        "tan" => call(Function::Tan),
        "asin" => call(Function::Asin),
        "acos" => call(Function::Acos),
        "atan" => call(Function::Atan),
        "sqrt" => call(Function::Sqrt),
        "exp" => call(Function::Exp),
        "ln" => call(Function::Ln),
        "sign" => switch(Kind::Sign),
        "step" => switch(Kind::Step),
        "abs" => switch(Kind::Abs),
        "atan2" => switch(Kind::Angle),
        "min" => switch(Kind::Min),
        "max" => switch(Kind::Max),
        _ => None,
    }
}

/// Writes a tree as operations.
struct Writer<'t> {
    text: &'t str,
    operations: Vec<Operation>,
    switches: Vec<Switch>,
}

impl Writer<'_> {
    /// Returns how many numbers wait on the stack while it is evaluated.
    fn write(&mut self, tree: &Tree) -> Result<usize, FormulaError> {
        match tree {
            Tree::Number(span, value) if !value.is_finite() => Err(FormulaError {
                span: span.clone(),
                what: text!("formula-great-number", number = letters(&self.text[span.clone()])),
            }),
            Tree::Number(_, value) => {
                self.operations.push(Operation::Number(*value));
                Ok(1)
            }
            Tree::Negate(of) => {
                let depth = self.write(of)?;
                self.operations.push(Operation::Negate);
                Ok(depth)
            }
            Tree::Two(operation, operands) => {
                let [a, b] = &**operands;
                let depth = self.write(a)?.max(1 + self.write(b)?);
                self.operations.push(*operation);
                Ok(depth)
            }
            Tree::Name(span) => self.call(span, &[]),
            Tree::Call(span, arguments) => self.call(span, arguments),
        }
    }

    fn call(&mut self, span: &Range<usize>, arguments: &[Tree]) -> Result<usize, FormulaError> {
        let name = &self.text[span.clone()];
        let fault = |what| Err(FormulaError { span: span.clone(), what });
        let Some((count, operation)) = operation(name) else {
            if let Some((_, meant)) = HABITS.iter().find(|habit| habit.0.eq_ignore_ascii_case(name)) {
                return fault(text!("formula-meant", name = letters(name), meant = letters(*meant)));
            }
            return fault(text!("formula-unknown-name", name = letters(name), known = letters(FUNCTIONS)));
        };
        if arguments.len() != count {
            let got = arguments.len();
            return fault(text!("formula-arguments", name = letters(name), count, got));
        }
        let start = self.operations.len();
        let mut depth = 1;
        for (index, argument) in arguments.iter().enumerate() {
            depth = depth.max(index + self.write(argument)?);
        }
        let operations = start..self.operations.len();
        let operation = match operation {
            Operation::Switch(..) if self.switches.len() == MOST_SWITCHES => {
                return fault(text!("formula-many-switches", most = MOST_SWITCHES));
            }
            Operation::Switch(kind, _) => {
                let used = Used::of(&self.operations[operations.clone()]);
                self.switches.push(Switch { used, operations, kind, span: span.clone() });
                Operation::Switch(kind, self.switches.len() - 1)
            }
            other => other,
        };
        self.operations.push(operation);
        Ok(depth)
    }
}
