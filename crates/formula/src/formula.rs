//! A formula that has been read.

use std::{ops::Range, sync::Arc};

use assur_number::Dd;

use crate::number::{Number, Scalar};
use crate::parse::{self, FormulaError};
use crate::program::{Branches, DEPTH, Kind, Operation, Sign, Switch, Used, Variable, Variables};
use crate::rounded::Rounded;
use crate::slope::{Dual, Signed};

/// How far ahead of a place the side of a switch is looked for, in the least distance that counts. Further ones are
/// needed where the argument only touches zero at the place: `cos(q) - 1` is zero up to its rounding over 1e-8.
const DISTANCES: [f64; 5] = [1.0, 1e2, 1e4, 1e6, 1e8];

const VARIABLES: [Variable; 4] = [Variable::Coordinate, Variable::Speed, Variable::Time, Variable::Place];

/// Rounding of variables that follow from each other along a motion, relative to their sizes: some operations lead from
/// the coordinate to the time. A variable alone is what it is.
pub(crate) const OF_MOTION: f64 = 4.0 * f64::EPSILON;

/// A formula.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    text: Arc<str>,
    operations: Arc<[Operation]>,
    switches: Arc<[Switch]>,
    used: Used,
}

impl Formula {
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
        let (operations, switches) = parse::read(text)?;
        let used = Used::of(&operations);
        Ok(Self { text: text.into(), operations: operations.into(), switches: switches.into(), used })
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

    /// The value of a formula that depends on the time alone, and its first and second derivative with respect to it; at a bend or a
    /// jump, of one of its sides.
    pub fn over_time(&self, time: f64) -> [f64; 3] {
        self.twice_differentiated(time)
    }

    /// [`over_time`](Self::over_time) in about 32 digits.
    pub fn over_time_precise(&self, time: Dd) -> [Dd; 3] {
        self.twice_differentiated(time)
    }

    fn twice_differentiated<N: Scalar>(&self, time: N) -> [N; 3] {
        let [zero, one] = [0.0, 1.0].map(N::of);
        let slope = Dual { value: one, slope: zero };
        let variable = |name| match name {
            Variable::Time => Dual { value: Dual { value: time, slope: one }, slope },
            Variable::Coordinate | Variable::Speed | Variable::Place => Dual::of(0.0),
        };
        let Dual { value, slope } = self.number(Branches::default(), variable);
        [value.value, value.slope, slope.slope]
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

    /// The sign of the argument of a switch just ahead of a place, and the distance at which it shows; zero where the argument
    /// is zero identically. `None` where the argument has no value. `ahead` gives the variables at a distance, in the
    /// least distance that counts as ahead.
    ///
    /// An argument within its rounding has no sign.
    pub fn side_ahead(&self, switch: usize, ahead: impl Fn(f64) -> Variables) -> (Option<Sign>, f64) {
        let relative = if self.switches()[switch].used.count() > 1 { OF_MOTION } else { 0.0 };
        let argument = |distance: f64| {
            let at = ahead(distance);
            self.argument_of(switch, |name| Rounded::variable(at.get(name), relative))
        };
        let [least, further @ ..] = DISTANCES;
        let first = argument(least);
        for (found, distance) in [(first, least)]
            .into_iter()
            .chain(further.into_iter().map(|distance| (argument(distance), distance)))
        {
            if let Some(side) = found.sign() {
                return (Some(side), distance);
            }
        }
        // Where nothing moves, the number itself is all that is known.
        let [near, far] = [least, DISTANCES[DISTANCES.len() - 1]].map(&ahead);
        // A variable that is not known does not move.
        let moves = VARIABLES.iter().any(|name| near.get(*name).total_cmp(&far.get(*name)).is_ne());
        let side = if first.value.is_nan() {
            None
        } else if moves {
            Some(Sign::Zero)
        } else {
            Sign::of(first.value)
        };
        (side, least)
    }

    /// The sides of the jumps at a place, and as bits those whose arguments are zero within their rounding.
    pub fn jumps_at(&self, at: &Variables) -> (Branches, u32) {
        let (mut found, mut undecided) = (Branches::default(), 0);
        let jumps = self.jumps();
        for switch in (0..self.switches().len()).filter(|switch| jumps >> switch & 1 == 1) {
            let argument = self.argument_of(switch, |name| Rounded::variable(at.get(name), OF_MOTION));
            match argument.sign() {
                Some(side @ (Sign::Negative | Sign::Positive)) => found.set(switch, side),
                Some(Sign::Zero) | None => undecided |= u32::from(!argument.value.is_nan()) << switch,
            }
        }
        (found, undecided)
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

/// The result of operations that leave one number on the stack. `switch` gives the value of a function with a switch from
/// its number and its arguments.
#[inline]
fn evaluate<N: Number>(
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
