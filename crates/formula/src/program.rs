//! A formula as a sequence of operations on a stack.

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
