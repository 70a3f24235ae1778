//! A formula as a sequence of operations on a stack.

use std::{cmp::Ordering, ops::Range};

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
    pub(crate) fn operands(self) -> usize {
        match self {
            Self::Number(_) | Self::Variable(_) => 0,
            Self::Negate | Self::Call(_) => 1,
            Self::Add | Self::Subtract | Self::Multiply | Self::Divide | Self::Power => 2,
            Self::Switch(kind, _) => kind.arguments(),
        }
    }
}

/// Greatest number of switches; their sides are bits of a number.
pub(crate) const MOST_SWITCHES: usize = 32;

/// Numbers that may wait on the stack; more nesting is refused when a formula is read.
pub(crate) const DEPTH: usize = 32;

/// Values of the variables of a formula, SI.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Variables {
    /// `q`: the input coordinate, rad or m.
    pub coordinate: f64,
    /// `w`: its speed, positive along the growing coordinate, rad/s or m/s.
    pub speed: f64,
    /// `t`: time, s.
    pub time: f64,
    /// `x`: place of a point between the extremes of its stroke, 0 to 1.
    pub place: f64,
}

impl Variables {
    /// The value of one variable.
    pub fn get(&self, variable: Variable) -> f64 {
        match variable {
            Variable::Coordinate => self.coordinate,
            Variable::Speed => self.speed,
            Variable::Time => self.time,
            Variable::Place => self.place,
        }
    }
}

/// Which variables are used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "one for each of four variables")]
pub struct Used {
    /// `q`.
    pub coordinate: bool,
    /// `w`.
    pub speed: bool,
    /// `t`.
    pub time: bool,
    /// `x`.
    pub place: bool,
}

impl Used {
    pub(crate) fn of(operations: &[Operation]) -> Self {
        let all = [Variable::Coordinate, Variable::Speed, Variable::Time, Variable::Place];
        let [coordinate, speed, time, place] =
            all.map(|variable| operations.contains(&Operation::Variable(variable)));
        Self { coordinate, speed, time, place }
    }

    /// How many of them.
    pub(crate) fn count(self) -> usize {
        [self.coordinate, self.speed, self.time, self.place].into_iter().filter(|used| *used).count()
    }

    /// The only variable, if it is one of those along which an integrator steps.
    pub fn only(self) -> Option<Variable> {
        match self {
            Self { place: true, .. } => None,
            Self { coordinate: true, speed: false, time: false, .. } => Some(Variable::Coordinate),
            Self { coordinate: false, speed: true, time: false, .. } => Some(Variable::Speed),
            Self { coordinate: false, speed: false, time: true, .. } => Some(Variable::Time),
            _ => None,
        }
    }
}

/// A place in a formula at which one smooth branch ends and another begins: the argument of `sign`, `step` or `abs`, the
/// difference of the arguments of `min` or `max`, or the first argument of `atan2` passes zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Switch {
    /// Variables on which it depends.
    pub used: Used,
    /// Operations of its arguments.
    pub(crate) operations: Range<usize>,
    /// The function that switches.
    pub(crate) kind: Kind,
    /// Where it stands in the text, bytes.
    pub span: Range<usize>,
}

/// The sign of a number that may be zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Zero.
    Zero,
    /// Greater than zero.
    Positive,
}

impl Sign {
    /// The sign of a number; `None` of what is not one.
    pub fn of(value: f64) -> Option<Self> {
        value.partial_cmp(&0.0).map(Self::from)
    }
}

impl From<Ordering> for Sign {
    fn from(order: Ordering) -> Self {
        match order {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

/// Given sides of some of the switches of a formula: the signs of their arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Branches {
    /// The switches whose side is given, as bits.
    given: u32,
    positive: u32,
    negative: u32,
}

impl Branches {
    /// Gives the side of a switch.
    pub fn set(&mut self, switch: usize, side: Sign) {
        let bit = 1 << switch;
        let mark = |bits: u32, set: bool| if set { bits | bit } else { bits & !bit };
        self.given |= bit;
        self.positive = mark(self.positive, side == Sign::Positive);
        self.negative = mark(self.negative, side == Sign::Negative);
    }

    /// The given side of a switch.
    #[inline]
    pub fn side(self, switch: usize) -> Option<Sign> {
        let has = |bits: u32| bits >> switch & 1 == 1;
        if !has(self.given) {
            return None;
        }
        Some(match (has(self.positive), has(self.negative)) {
            (true, _) => Sign::Positive,
            (false, true) => Sign::Negative,
            (false, false) => Sign::Zero,
        })
    }

    /// The sides of the switches of a mask alone.
    #[must_use]
    pub fn only(self, switches: u32) -> Self {
        let Self { given, positive, negative } = self;
        Self { given: given & switches, positive: positive & switches, negative: negative & switches }
    }
}
