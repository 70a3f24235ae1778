//! All numbers of a position that have derivatives, and their differences around it.

use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_number::Real;

use crate::differences::LEVELS;
use crate::elements::Element;
use crate::kinetics;
use crate::rounding::{SAMPLES, SPACING, rounding_of};
use crate::subject::{Solved, Subject};

/// First step of the differences in 16 digits, in units of the coordinate, at a position of determinant 1. The smaller
/// the determinant, the faster the functions change; the step shrinks with it, down to a hundredth.
const FIRST_STEP: f64 = 0.2;

/// Least initial step, as part of the first step.
const LEAST_PART: f64 = 0.01;

/// With steps below this, differences in 16 digits have no correct digits.
const LEAST_STEP: f64 = 1e-7;

/// Levels that an extrapolation needs.
const LEAST_LEVELS: usize = 4;

/// Where the rounding is measured around a position, in units of the coordinate: at the position itself, and on both
/// sides just outside the interpolation across a change point, whose innermost nodes have the greatest weight.
const PLACES: [f64; 3] = [0.0, 0.013, -0.013];

/// PF0, PF1 and PF2 of all elements (two components each), then J and J'.
#[derive(Debug, Clone)]
pub(crate) struct Sample<T>(Vec<T>);

impl<T: Real> Sample<T> {
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
    pub(crate) fn map<U>(&self, number: impl Fn(T) -> U) -> Sample<U> {
        Sample(self.0.iter().map(|value| number(*value)).collect())
    }

    /// The difference of each number from that of another sample.
    pub(crate) fn off(&self, other: &Self) -> Sample<f64> {
        Sample(self.0.iter().zip(&other.0).map(|(a, b)| (*a - *b).to_f64().abs()).collect())
    }

    /// Central differences between this sample and the one at the greater coordinate.
    pub(crate) fn quotient(&self, high: &Self, step: f64) -> Quotient {
        let slopes = self.0.iter().zip(&high.0).map(|(low, high)| (*high - *low).to_f64() / (2.0 * step));
        Quotient { step, slopes: Sample(slopes.collect()) }
    }
}

impl Sample<f64> {
    /// For each number the greater of both.
    pub(crate) fn raise(&mut self, other: &Self) {
        // Not max(): it would drop a NaN, which must appear as a failed check.
        self.0.iter_mut().zip(&other.0).for_each(|(mine, other)| {
            if *other > *mine || other.is_nan() {
                *mine = *other;
            }
        });
    }

    pub(crate) fn scaled(&self, by: f64) -> Self {
        self.map(|number| by * number)
    }
}

/// Central differences of all numbers over one step.
#[derive(Debug, Clone)]
pub(crate) struct Quotient {
    pub(crate) step: f64,
    pub(crate) slopes: Sample<f64>,
}

/// Differences around one position.
#[derive(Debug, Clone)]
pub(crate) struct Surroundings {
    pub(crate) quotients: Vec<Quotient>,
    /// Rounding of the numbers that were differenced.
    pub(crate) below: Sample<f64>,
    /// Rounding of the numbers that are checked.
    pub(crate) own: Sample<f64>,
    /// Factor from the rounding unit of f64 to the least rounding of the differenced numbers.
    pub(crate) floor: f64,
    /// The numbers of the position as the differences see it; only their sizes are used.
    pub(crate) values: Sample<f64>,
}

/// Differences with steps that are halved from `step` down to `least`, until there are enough consecutive ones; `None`
/// where too few of them exist.
pub(crate) fn quotients(
    mut step: f64,
    least: f64,
    mut over: impl FnMut(f64) -> Option<Quotient>,
) -> Option<Vec<Quotient>> {
    let mut found = Vec::with_capacity(LEVELS);
    while found.len() < LEVELS && step > least {
        match over(step) {
            Some(quotient) => found.push(quotient),
            None => found.clear(),
        }
        step *= 0.5;
    }
    (found.len() >= LEAST_LEVELS).then_some(found)
}

/// Differences around a position in 16 digits, for the interpolation across a change point: there the motion is smooth,
/// and steps may be wide. `None` where too few of them can be solved on both sides.
pub(crate) fn interpolated(
    subject: &Subject<'_>,
    all: &[Element],
    one: &Solved,
    scratch: &mut Position,
) -> Option<Surroundings> {
    let linkage = subject.linkage;
    let (q, unit) = (one.position.coordinate, linkage.coordinate_unit());
    let mut at = |coordinate: f64| {
        linkage.solve(coordinate, Order::Second, scratch).ok()?;
        Some(sample(linkage, all, scratch, &one.position))
    };
    let quotients = quotients(FIRST_STEP * one.health.max(LEAST_PART) * unit, LEAST_STEP * unit, |step| {
        // The step is rounded so that q + h and q - h are exact.
        let (low, high) = (q - step, q + step);
        Some(at(low)?.quotient(&at(high)?, 0.5 * (high - low)))
    })?;
    let values = sample(linkage, all, &one.position, &one.position);
    let change_point = linkage.nearest_change_point(q).filter(|_| subject.is_interpolated(one));
    let interpolation = change_point.and_then(|at| linkage.interpolation(at));
    let gain = interpolation.map_or(1.0, |interpolation| interpolation.gain);
    let below = measured(&values, q, unit, &mut at).scaled(gain);
    Some(Surroundings { quotients, own: below.clone(), below, floor: gain, values })
}

/// The greatest rounding measured at closely spaced coordinates around a position.
fn measured(
    like: &Sample<f64>,
    q: f64,
    unit: f64,
    at: &mut impl FnMut(f64) -> Option<Sample<f64>>,
) -> Sample<f64> {
    let mut most = like.scaled(0.0);
    for shift in PLACES {
        let middle = 0.5 * (SAMPLES as f64 - 1.0);
        let places = (0..SAMPLES).map(|i| q + (shift + SPACING * (i as f64 - middle)) * unit);
        let Some(run) = places.map(&mut *at).collect::<Option<Vec<_>>>() else { continue };
        let number = |k: usize| rounding_of(&std::array::from_fn(|i| run[i].0[k]));
        most.raise(&Sample((0..like.0.len()).map(number).collect()));
    }
    most
}

/// The numbers of the program; angles are counted from those of `reference`.
pub(crate) fn sample(
    linkage: &Linkage,
    all: &[Element],
    position: &Position,
    reference: &Position,
) -> Sample<f64> {
    let motions = all.iter().map(|element| element.motion(linkage, position, reference));
    Sample::new(motions, kinetics::reduced(&linkage.mechanism, &position.bodies))
}
