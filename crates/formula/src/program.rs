//! A formula as a sequence of operations on a stack.

use crate::number::Number;

/// A quantity that a formula may use, all in SI.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variable {
    /// `q`: the input coordinate, rad or m.
    Coordinate,
    /// `w`: its speed, positive along the growing coordinate, rad/s or m/s.
    Speed,
    /// `t`: time, s.
    Time,
    /// `x`: place of a point between the extremes of its stroke, 0 to 1.
    Place,
}

/// A smooth function of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sqrt,
    Exp,
    Ln,
}

impl Function {
    /// Its name, if its argument is an angle.
    pub(crate) fn of_an_angle(self) -> Option<&'static str> {
        match self {
            Self::Sin => Some("sin"),
            Self::Cos => Some("cos"),
            Self::Tan => Some("tan"),
            _ => None,
        }
    }
}

/// A function that is smooth on either side of a switch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Sign,
    Step,
    Abs,
    Min,
    Max,
    /// `atan2`: on the negative half of the second argument it jumps by a turn where the first passes zero.
    Angle,
}

impl Kind {
    /// Number of arguments.
    pub(crate) fn arguments(self) -> usize {
        if matches!(self, Self::Min | Self::Max | Self::Angle) { 2 } else { 1 }
    }

    /// Whether the value jumps at the switch; else it only bends there.
    pub(crate) fn jumps(self) -> bool {
        matches!(self, Self::Sign | Self::Step | Self::Angle)
    }
}

/// One operation: takes its operands from the stack and puts its result there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Operation {
    Number(f64),
    Variable(Variable),
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Call(Function),
    /// The function and the number of its switch.
    Switch(Kind, usize),
}

impl Operation {
    /// Number of operands.
    pub(crate) fn operands(self) -> usize {
        match self {
            Self::Number(_) | Self::Variable(_) => 0,
            Self::Negate | Self::Call(_) => 1,
            Self::Add | Self::Subtract | Self::Multiply | Self::Divide | Self::Power => 2,
            Self::Switch(kind, _) => kind.arguments(),
        }
    }
}

/// Numbers that may wait on the stack; more nesting is refused when a formula is read.
pub(crate) const DEPTH: usize = 32;

/// The result of operations that leave one number on the stack. `switch` gives the value of a function with a switch from
/// its number and its arguments.
#[inline]
pub(crate) fn evaluate<N: Number>(
    operations: &[Operation],
    variable: impl Fn(Variable) -> N,
    switch: impl Fn(Kind, usize, N, N) -> N,
) -> N {
    let mut stack = [N::of(0.0); DEPTH];
    let mut top = 0;
    for operation in operations {
        let count = operation.operands();
        top -= count;
        let (one, other) = (stack[top], stack[(top + 1).min(DEPTH - 1)]);
        stack[top] = match *operation {
            Operation::Number(value) => N::of(value),
            Operation::Variable(name) => variable(name),
            Operation::Negate => one.negate(),
            Operation::Add => one.add(other),
            Operation::Subtract => one.add(other.negate()),
            Operation::Multiply => one.multiply(other),
            Operation::Divide => one.divide(other),
            Operation::Power => one.power(other),
            Operation::Call(function) => one.call(function),
            Operation::Switch(kind, index) => switch(kind, index, one, other),
        };
        top += 1;
    }
    stack[0]
}
