//! A formula that has been read.

use std::ops::Range;
use std::sync::Arc;

use crate::evaluate::evaluate;
use crate::number::{Number, on_side};
use crate::parse::{self, FormulaError};
use crate::program::{Kind, Operation};

pub use crate::program::Variable;

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

/// A place in a formula at which one smooth branch ends and another begins: the argument of `sign`, `step` or `abs`, or the
/// difference of the arguments of `min` or `max`, passes zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Switch {
    /// Variables on which it depends.
    pub used: Used,
    /// Operations of its arguments.
    pub(crate) operations: Range<usize>,
    /// Whether it is the difference of two arguments.
    pub(crate) is_difference: bool,
    /// Where it stands in the text, bytes.
    pub span: Range<usize>,
}

/// A formula.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    text: Arc<str>,
    operations: Arc<[Operation]>,
    switches: Arc<[Switch]>,
    used: Used,
}

impl Formula {
    /// Greatest number of switches; their sides are bits of a number.
    pub const MOST_SWITCHES: usize = 32;

    /// Reads a formula.
    ///
    /// # Errors
    ///
    /// [`FormulaError`] with the place in the text.
    ///
    /// # Examples
    ///
    /// ```
    /// use assur_formula::{Formula, Variables};
    ///
    /// let formula = Formula::read("5000 + 600*sin(2*q)").unwrap();
    /// let at = Variables { coordinate: std::f64::consts::FRAC_PI_4, ..Variables::default() };
    /// assert_eq!(formula.value(&at), 5600.0);
    /// assert_eq!(Formula::read("2*speed").unwrap_err().span, 2..7);
    /// ```
    pub fn read(text: &str) -> Result<Self, FormulaError> {
        let parse::Program { operations, switches } = parse::read(text)?;
        let used = used(&operations);
        let switches = switches
            .into_iter()
            .map(|switch| Switch { used: self::used(&operations[switch.operations.clone()]), ..switch });
        let switches = switches.collect();
        Ok(Self { text: text.into(), operations: operations.into(), switches, used })
    }

    /// The formula with the opposite speed in the place of `w`.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut operations = Vec::new();
        // Where each operation begins now, and the end.
        let mut starts = Vec::new();
        for operation in &*self.operations {
            starts.push(operations.len());
            operations.push(*operation);
            if *operation == Operation::Variable(Variable::Speed) {
                operations.push(Operation::Negate);
            }
        }
        starts.push(operations.len());
        let moved = |switch: &Switch| {
            let Range { start, end } = switch.operations;
            Switch { operations: starts[start]..starts[end], ..switch.clone() }
        };
        let switches = self.switches.iter().map(moved).collect();
        Self { operations: operations.into(), switches, ..self.clone() }
    }

    /// The text from which it was read.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Variables on which it depends.
    pub fn used(&self) -> Used {
        self.used
    }

    /// Its switches.
    pub fn switches(&self) -> &[Switch] {
        &self.switches
    }

    /// Its value, on a switch that of mathematics: `sign(0)` is 0, `step(0)` is 1.
    pub fn value(&self, at: &Variables) -> f64 {
        evaluate(&self.operations, |name| at.get(name), |kind, _, one, other| one.switch(kind, other))
    }

    /// Its value on given sides of its switches, continued smoothly beyond them.
    #[inline]
    pub fn value_on(&self, at: &Variables, branches: u32) -> f64 {
        let side = |kind, index: usize, one, other| on_side(kind, one, other, branches >> index & 1 == 1);
        evaluate(&self.operations, |name| at.get(name), side)
    }

    /// The sides of its switches: bit i is set where the argument of switch i is not negative.
    pub fn branches(&self, at: &Variables) -> u32 {
        let side = |bits, index| bits | u32::from(self.argument(index, at) >= 0.0) << index;
        (0..self.switches.len()).fold(0, side)
    }

    /// The argument of a switch.
    pub fn argument(&self, switch: usize, at: &Variables) -> f64 {
        self.argument_of(switch, |name| at.get(name))
    }

    /// The argument of a switch in numbers or intervals.
    pub(crate) fn argument_of<N: Number>(&self, switch: usize, variable: impl Fn(Variable) -> N) -> N {
        let Switch { operations, is_difference, .. } = &self.switches[switch];
        let natural = |kind: Kind, _: usize, one: N, other: N| one.switch(kind, other);
        let of = |range: Range<usize>| evaluate(&self.operations[range], &variable, natural);
        if !is_difference {
            return of(operations.clone());
        }
        let middle = second_argument(&self.operations, operations.clone());
        of(operations.start..middle).add(of(middle..operations.end).negate())
    }
}

/// Where the second of two arguments begins: the shortest end that leaves one number.
fn second_argument(operations: &[Operation], range: Range<usize>) -> usize {
    let mut missing = 1;
    for index in range.clone().rev() {
        missing = missing - 1 + operations[index].operands();
        if missing == 0 {
            return index;
        }
    }
    range.start
}

fn used(operations: &[Operation]) -> Used {
    let has = |variable| operations.contains(&Operation::Variable(variable));
    Used {
        coordinate: has(Variable::Coordinate),
        speed: has(Variable::Speed),
        time: has(Variable::Time),
        place: has(Variable::Place),
    }
}
