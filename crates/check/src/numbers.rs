//! All numbers of a position that have derivatives, and their differences around it.

use assur_kinematics::{Linkage, Position};
use assur_number::{Real, greater};

use crate::elements::Element;
use crate::kinetics;

/// Levels that an extrapolation needs.
const LEAST_LEVELS: usize = 4;

/// PF0, PF1 and PF2 of all elements (two components each), then J and J'.
#[derive(Debug, Clone)]
pub(crate) struct Numbers<T>(pub(crate) Vec<T>);

impl<T: Real> Numbers<T> {
    /// From the motions of the elements and the reduced inertia.
    pub(crate) fn new(motions: impl Iterator<Item = [[T; 2]; 3]>, inertia: [T; 2]) -> Self {
        Self(motions.flatten().flatten().chain(inertia).collect())
    }

    /// A component of the transfer function of this order of an element.
    pub(crate) fn motion(&self, element: usize, order: usize, component: usize) -> T {
        self.0[6 * element + 2 * order + component]
    }

    /// J for order 0, J' for order 1.
    pub(crate) fn inertia(&self, order: usize) -> T {
        self.0[self.0.len() - 2 + order]
    }

    /// Each number, transformed by a function.
    pub(crate) fn map<U>(&self, number: impl Fn(T) -> U) -> Numbers<U> {
        Numbers(self.0.iter().map(|value| number(*value)).collect())
    }

    /// The difference of each number from that of another place.
    pub(crate) fn off(&self, other: &Self) -> Numbers<f64> {
        Numbers(self.0.iter().zip(&other.0).map(|(a, b)| (*a - *b).to_f64().abs()).collect())
    }

    /// Central differences between these numbers and those at the greater coordinate.
    pub(crate) fn quotient(&self, high: &Self, step: f64) -> Quotient {
        let slopes = self.0.iter().zip(&high.0).map(|(low, high)| (*high - *low).to_f64() / (2.0 * step));
        Quotient { step, slopes: Numbers(slopes.collect()) }
    }
}

impl Numbers<f64> {
    /// For each number the greater of both.
    pub(crate) fn raise(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(mine, other)| *mine = greater(*mine, *other));
    }

    pub(crate) fn scaled(&self, by: f64) -> Self {
        self.map(|number| by * number)
    }
}

/// Central differences of all numbers over one step.
#[derive(Debug, Clone)]
pub(crate) struct Quotient {
    pub(crate) step: f64,
    pub(crate) slopes: Numbers<f64>,
}

/// Differences with steps that are halved from `step` down to `least`, until there are `levels` consecutive ones; `None`
/// where too few of them exist.
pub(crate) fn quotients(
    [mut step, least]: [f64; 2],
    levels: usize,
    mut over: impl FnMut(f64) -> Option<Quotient>,
) -> Option<Vec<Quotient>> {
    let mut found = Vec::with_capacity(levels);
    while found.len() < levels && step > least {
        match over(step) {
            Some(quotient) => found.push(quotient),
            None => found.clear(),
        }
        step *= 0.5;
    }
    (found.len() >= LEAST_LEVELS).then_some(found)
}

/// The numbers of the program; angles are counted from those of `reference`.
pub(crate) fn numbers(
    linkage: &Linkage,
    all: &[Element],
    position: &Position,
    reference: &Position,
) -> Numbers<f64> {
    let motions = all.iter().map(|element| element.motion(linkage, position, reference));
    Numbers::new(motions, kinetics::reduced(&linkage.mechanism, position.coordinate, &position.bodies))
}
