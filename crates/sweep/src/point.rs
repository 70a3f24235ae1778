//! The calculation of one point after the other.

use std::ops::Range;

use assur_analysis::{AnalysisError, Calculation, InputMotion, Varied, unwatched};
use assur_dynamics::Instant;
use assur_group::Order;
use assur_mechanism::Mechanism;
use assur_words::{Describe, name, number, text};

use crate::between::add_rows;
use crate::measured::Measured;
use crate::positions::{Memory, Positions};
use crate::rows::{Failure, Rows};
use crate::{Status, Sweep};

/// Calculates points; keeps its memory from one to the next.
pub(crate) struct Worker<'a> {
    sweep: &'a Sweep,
    found: Measured,
    /// Parameters in the units of their ranges, and in SI.
    numbers: Vec<f64>,
    parameters: Vec<f64>,
    values: Vec<f64>,
    /// Solved positions; all points have the same links and groups.
    memory: Memory,
    /// The last point, with which the next one may have much in common; lost with a mechanism that can't be compiled.
    last: Option<Calculation>,
    /// The mechanism of an earlier point, in which numbers are set.
    spare: Option<Mechanism>,
}

impl<'a> Worker<'a> {
    pub(crate) fn new(sweep: &'a Sweep) -> Self {
        let parameters = vec![0.0; sweep.axes.len()];
        Self {
            sweep,
            found: Measured::new(&sweep.layout.gathered),
            numbers: parameters.clone(),
            parameters,
            values: Vec::new(),
            memory: Memory::default(),
            last: None,
            spare: None,
        }
    }

    pub(crate) fn rows(&mut self, points: Range<usize>) -> Rows {
        let mut rows = Rows::new(&self.sweep.columns, points.start, points.len());
        for index in points {
            let ended = self.calculate(index);
            rows.push(&self.parameters, &self.values, ended);
            if !self.sweep.holds(&rows, rows.len() - 1) {
                rows.leave_out();
            }
        }
        rows
    }

    /// Calculates a point and puts its values in order; returns the designation of its motor.
    pub(crate) fn calculate(&mut self, index: usize) -> Result<Option<String>, Failure> {
        self.sweep.points.numbers(&self.sweep.axes, index, &mut self.numbers);
        for ((axis, number), si) in self.sweep.axes.iter().zip(&self.numbers).zip(&mut self.parameters) {
            *si = axis.si(*number);
        }
        self.values.clear();
        let mut calculation = self.compiled()?;
        let positions = Positions::new(&calculation, &self.sweep.layout, &mut self.found);
        let result = positions.calculate(&mut self.memory);
        if result.is_ok() {
            add_rows(&mut self.found, &calculation, self.sweep);
        }
        self.found.last = last(&calculation);
        let motion = std::mem::replace(&mut calculation.motion, InputMotion::Prescribed);
        self.last = Some(calculation);
        result?;
        let mut designation = None;
        if let InputMotion::Steady(found) = motion {
            designation = found.motor.as_ref().map(|motor| motor.motor.designation.clone());
            self.found.steady = Some(found);
        }
        for value in &self.sweep.layout.values {
            let number = (value.find)(&self.found, value.of);
            if number.is_some_and(|number| !number.is_finite()) {
                let columns = &self.sweep.columns;
                let column = name(columns.names[columns.of_value(self.values.len())].clone());
                self.values.clear();
                let message = text!("sweep-not-finite", column);
                return Err(Failure { status: Status::Error, message, failed: Some(0) });
            }
            self.values.push(number.unwrap_or(f64::NAN));
        }
        Ok(designation)
    }

    /// The mechanism of the point, compiled.
    fn compiled(&mut self) -> Result<Calculation, Failure> {
        let sweep = self.sweep;
        let last = self.last.take();
        self.memory.keep(false);
        let spare = self.spare.take();
        let mechanism = sweep.variants.mechanism(&sweep.axes, &self.numbers, &self.parameters, spare);
        let mechanism = mechanism.map_err(|errors| {
            let first = errors.errors.first();
            let message = first
                .map(|error| text!("sweep-in-line", problem = &error.message, line = number(error.line)));
            Failure { status: Status::Refused, message: message.unwrap_or_default(), failed: None }
        })?;
        let calculation = match last {
            Some(last) if sweep.variants.sets_numbers() => {
                last.varied(mechanism, &sweep.options, &mut unwatched).map(|varied| {
                    let Varied { calculation, before, same_positions } = varied;
                    self.spare = Some(before);
                    self.memory.keep(same_positions);
                    calculation
                })
            }
            _ => Calculation::of(mechanism, &sweep.options, &mut unwatched),
        };
        calculation.map_err(|error: AnalysisError| {
            let status = if error.is_no_solution() { Status::NoSolution } else { Status::Error };
            Failure { status, message: error.describe(), failed: None }
        })
    }
}

/// The last state of a transient motion at which the mechanism can be assembled.
fn last(calculation: &Calculation) -> Option<Instant> {
    let InputMotion::Transient(motion) = &calculation.motion else { return None };
    let mut position = calculation.linkage.position();
    let mut solved =
        |at: &&Instant| calculation.linkage.solve(at.state.coordinate, Order::Place, &mut position).is_ok();
    motion.instants.iter().rev().find(|at| solved(at)).copied()
}
