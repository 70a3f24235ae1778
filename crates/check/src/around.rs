//! The surroundings of a position: differences over several steps, and how much rounding what was differenced carries.

use assur_group::Order;
use assur_kinematics::Position;

use crate::differences::LEVELS;
use crate::elements::{Element, Motion};
use crate::kinetics;
use crate::noise::{SAMPLES, SPACING, noise_of};
use crate::subject::{Solved, Subject};

/// First step of the differences in 16 digits, in units of the coordinate, at a position of determinant 1. Functions bend the
/// faster, the smaller the determinant is; the step shrinks with it, down to a hundredth.
const FIRST_STEP: f64 = 0.2;

/// Least part of the first step that is begun with.
const LEAST_PART: f64 = 0.01;

/// Steps below this leave no digits to differences in 16 digits.
const LEAST_STEP: f64 = 1e-7;

/// Levels that an extrapolation needs.
const LEAST_LEVELS: usize = 4;

/// Where the rounding is measured around a position, in units of the coordinate: at the place itself, and on both sides just
/// beyond the bridge across a change point, whose innermost nodes carry the most.
const PLACES: [f64; 3] = [0.0, 0.013, -0.013];

/// A number for every element and order, J and J'.
#[derive(Debug, Clone)]
pub(crate) struct Numbers {
    pub(crate) motions: Vec<Motion>,
    pub(crate) inertia: [f64; 2],
}

/// Central differences over one step: the derivatives of PF0 and of PF1 of each element, and of J.
#[derive(Debug, Clone)]
pub(crate) struct Quotient {
    pub(crate) step: f64,
    pub(crate) motions: Vec<[[f64; 2]; 2]>,
    pub(crate) inertia: f64,
}

/// Differences around one position.
#[derive(Debug, Clone)]
pub(crate) struct Around {
    pub(crate) quotients: Vec<Quotient>,
    /// Rounding of what was differenced.
    pub(crate) below: Numbers,
    /// Rounding of the numbers that are judged.
    pub(crate) own: Numbers,
    /// What multiplies the least rounding of what was differenced, in that of f64.
    pub(crate) floor: f64,
    /// The numbers of the position as the differences see it; only their sizes are used.
    pub(crate) values: Numbers,
}

impl Numbers {
    fn each(&mut self) -> impl Iterator<Item = &mut f64> {
        self.motions.iter_mut().flatten().flatten().chain(&mut self.inertia)
    }

    /// Each the greater of both.
    pub(crate) fn raise(&mut self, other: &Self) {
        let others = other.motions.iter().flatten().flatten().chain(&other.inertia);
        // Not max(): that would drop a NaN, and here it must come through as a failed check.
        self.each().zip(others).for_each(|(mine, other)| {
            if *other > *mine || other.is_nan() {
                *mine = *other;
            }
        });
    }

    pub(crate) fn scale(&mut self, by: f64) {
        self.each().for_each(|number| *number *= by);
    }
}

/// The surroundings in 16 digits, for the bridge across a change point: there the motion is smooth, and steps may be wide.
/// `None` where too few of them can be solved on both sides.
pub(crate) fn narrow(
    subject: &Subject<'_>,
    all: &[Element],
    one: &Solved,
    scratch: &mut Position,
) -> Option<Around> {
    let (q, unit) = (one.position.coordinate, subject.linkage.coordinate_unit());
    let mut at = |coordinate: f64| {
        subject.linkage.solve(coordinate, Order::Second, scratch).ok()?;
        Some(numbers(subject, all, scratch, &one.position))
    };
    let (mut step, mut quotients) = (FIRST_STEP * one.health.max(LEAST_PART) * unit, Vec::new());
    while quotients.len() < LEVELS && step > LEAST_STEP * unit {
        // The step is made exact: q + h and q - h are the numbers that were meant.
        let (high, low) = (q + step, q - step);
        match (at(low), at(high)) {
            (Some(below), Some(above)) => quotients.push(quotient(0.5 * (high - low), &below, &above)),
            _ => quotients.clear(),
        }
        step *= 0.5;
    }
    if quotients.len() < LEAST_LEVELS {
        return None;
    }
    let values = numbers(subject, all, &one.position, &one.position);
    let change_point = subject.linkage.nearest_change_point(q).filter(|_| subject.is_bridged(one));
    let interpolation = change_point.and_then(|at| subject.linkage.interpolation(at));
    let gain = interpolation.map_or(1.0, |interpolation| interpolation.gain);
    let mut below = measured(&values, q, unit, &mut at);
    below.scale(gain);
    Some(Around { quotients, own: below.clone(), below, floor: gain, values })
}

/// The greatest rounding measured at closely spaced coordinates around a position.
fn measured(like: &Numbers, q: f64, unit: f64, at: &mut impl FnMut(f64) -> Option<Numbers>) -> Numbers {
    let mut most = like.clone();
    most.scale(0.0);
    for shift in PLACES {
        let middle = 0.5 * (SAMPLES as f64 - 1.0);
        let places = (0..SAMPLES).map(|i| q + (shift + SPACING * (i as f64 - middle)) * unit);
        let Some(run) = places.map(&mut *at).collect::<Option<Vec<_>>>() else { continue };
        let mut found = like.clone();
        for (i, motion) in found.motions.iter_mut().enumerate() {
            for (order, pair) in motion.iter_mut().enumerate() {
                for (k, number) in pair.iter_mut().enumerate() {
                    *number = noise_of(&std::array::from_fn(|sample| run[sample].motions[i][order][k]));
                }
            }
        }
        for (k, number) in found.inertia.iter_mut().enumerate() {
            *number = noise_of(&std::array::from_fn(|sample| run[sample].inertia[k]));
        }
        most.raise(&found);
    }
    most
}

/// The numbers as the program gives them; angles are counted from those of `reference`.
pub(crate) fn numbers(
    subject: &Subject<'_>,
    all: &[Element],
    position: &Position,
    reference: &Position,
) -> Numbers {
    let linkage = subject.linkage;
    let motions = all.iter().map(|element| element.motion(linkage, position, reference)).collect();
    Numbers { motions, inertia: kinetics::reduced(&linkage.mechanism, &position.bodies) }
}

fn quotient(step: f64, low: &Numbers, high: &Numbers) -> Quotient {
    let slope = |high: f64, low: f64| (high - low) / (2.0 * step);
    let motion = |(low, high): (&Motion, &Motion)| {
        [0, 1].map(|order| [0, 1].map(|k| slope(high[order][k], low[order][k])))
    };
    let motions = low.motions.iter().zip(&high.motions).map(motion).collect();
    Quotient { step, motions, inertia: slope(high.inertia[0], low.inertia[0]) }
}
