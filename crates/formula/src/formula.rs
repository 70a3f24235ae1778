//! A formula that has been read.

use std::ops::Range;
use std::sync::Arc;

use assur_number::Dd;

use crate::branches::Branches;
use crate::number::Number;
use crate::parse::{self, FormulaError};
use crate::program::evaluate;
use crate::program::{Kind, Operation};
use crate::rounded::Rounded;
use crate::slope::{Dual, Signed};

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

impl Used {
    /// How many of them.
    pub(crate) fn count(self) -> usize {
        [self.coordinate, self.speed, self.time, self.place].into_iter().filter(|used| *used).count()
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

    /// The name of a function of an angle whose argument looks like degrees: a number that a turn in radians does not reach, or the
    /// input coordinate times 180/pi.
    pub fn takes_degrees(&self) -> Option<&'static str> {
        let mut stack: Vec<(f64, f64)> = Vec::new();
        for operation in &*self.operations {
            let operands = stack.split_off(stack.len().saturating_sub(operation.operands()));
            // Value at the coordinate 0 and slope, where the operation keeps them linear; NaN elsewhere.
            let linear = match (*operation, &operands[..]) {
                (Operation::Number(number), _) => (number, 0.0),
                (Operation::Variable(Variable::Coordinate), _) => (0.0, 1.0),
                (Operation::Negate, [(a, s)]) => (-a, -s),
                (Operation::Add, [(a, s), (b, t)]) => (a + b, s + t),
                (Operation::Subtract, [(a, s), (b, t)]) => (a - b, s - t),
                (Operation::Multiply, [(a, s), (b, t)]) if *s == 0.0 || *t == 0.0 => (a * b, a * t + b * s),
                (Operation::Divide, [(a, s), (b, t)]) if *t == 0.0 => (a / b, s / b),
                (Operation::Call(function), [(a, s)]) => {
                    let whole = a.fract() == 0.0 && a.abs() > std::f64::consts::TAU;
                    let in_degrees = (s.abs() - 180.0 / std::f64::consts::PI).abs() < 0.01;
                    if let Some(name) = function.of_an_angle().filter(|_| whole || in_degrees) {
                        return Some(name);
                    }
                    (f64::NAN, f64::NAN)
                }
                _ => (f64::NAN, f64::NAN),
            };
            stack.push(linear);
        }
        None
    }

    /// Its value: on a switch that of mathematics, so that `sign(0)` is 0 and `step(0)` is 1.
    pub fn value(&self, at: &Variables) -> f64 {
        self.value_on(at, Branches::default())
    }

    /// Its value on given sides of its switches, continued smoothly beyond them; the other switches go by their arguments.
    ///
    /// Beyond a bend the branch may have no value, as that of `sqrt(abs(q))` has none: there the formula itself counts, by the
    /// given sides of its jumps. A root or an inverse function whose argument misses its domain by no more than what a
    /// place may miss a switch is taken at the end of the domain.
    #[inline]
    pub fn value_on(&self, at: &Variables, branches: Branches) -> f64 {
        let value = self.number(branches, |name| at.get(name));
        if value.is_finite() { value } else { self.value_at_an_end(at, branches) }
    }

    #[cold]
    fn value_at_an_end(&self, at: &Variables, branches: Branches) -> f64 {
        let branches = branches.only(self.jumps());
        let value = self.number(branches, |name| at.get(name));
        if value.is_finite() {
            value
        } else {
            self.number(branches, |name| Rounded::near(at.get(name))).value
        }
    }

    /// A bound of the rounding of its value, from the sizes of all terms of which it is computed: where the value is zero, the
    /// bound is not. Infinite where the formula has a pole within that rounding.
    pub fn rounding(&self, at: &Variables, branches: Branches) -> f64 {
        self.number(branches, |name| Rounded::variable(at.get(name), f64::EPSILON)).error
    }

    /// The value of a formula that depends on the coordinate alone, and its derivative with respect to the coordinate; at a bend or a jump, of
    /// one of its sides.
    pub fn with_slope(&self, coordinate: f64) -> [f64; 2] {
        self.differentiated(coordinate)
    }

    /// Bounds of the rounding of both numbers of [`with_slope`](Self::with_slope) at exactly this coordinate.
    pub fn rounding_with_slope(&self, coordinate: f64) -> [f64; 2] {
        self.differentiated(Rounded::of(coordinate)).map(|number| number.error)
    }

    /// [`with_slope`](Self::with_slope) in about 32 digits.
    pub fn precise(&self, coordinate: Dd) -> [Dd; 2] {
        self.differentiated(coordinate)
    }

    fn differentiated<N: Signed>(&self, coordinate: N) -> [N; 2] {
        let variable = |name| match name {
            Variable::Coordinate => Dual { value: coordinate, slope: N::of(1.0) },
            Variable::Speed | Variable::Time | Variable::Place => Dual::of(0.0),
        };
        let Dual { value, slope } = self.number(Branches::default(), variable);
        [value, slope]
    }

    #[inline]
    pub(crate) fn number<N: Number>(&self, branches: Branches, variable: impl Fn(Variable) -> N) -> N {
        let switch = |kind: Kind, index: usize, one: N, other: N| match branches.side(index) {
            Some(side) => one.on_side(kind, other, side),
            None => one.switch(kind, other),
        };
        evaluate(&self.operations, variable, switch)
    }

    /// The switches at which the value jumps, as bits; at the others it bends.
    pub fn jumps(&self) -> u32 {
        self.switches.iter().enumerate().map(|(index, switch)| u32::from(switch.kind.jumps()) << index).sum()
    }

    /// The argument of a switch.
    pub fn argument(&self, switch: usize, at: &Variables) -> f64 {
        self.argument_of(switch, |name| at.get(name))
    }

    /// The argument of a switch in numbers or intervals.
    pub(crate) fn argument_of<N: Number>(&self, switch: usize, variable: impl Fn(Variable) -> N) -> N {
        let Switch { operations, kind, .. } = &self.switches[switch];
        let natural = |kind: Kind, _: usize, one: N, other: N| one.switch(kind, other);
        let of = |range: Range<usize>| evaluate(&self.operations[range], &variable, natural);
        if kind.arguments() == 1 {
            return of(operations.clone());
        }
        let middle = second_argument(&self.operations, operations.clone());
        let first = of(operations.start..middle);
        if *kind == Kind::Angle { first } else { first.add(of(middle..operations.end).negate()) }
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
