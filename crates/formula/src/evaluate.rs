//! Evaluates a sequence of operations.

use crate::number::Number;
use crate::program::{Kind, Operation, Variable};

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
