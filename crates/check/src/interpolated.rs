//! Differences around a position on the interpolation across a change point, in 16 digits.

use assur_group::Order;
use assur_kinematics::Position;

use crate::differences::{LEVELS, SAMPLES, SPACING, rounding_of};
use crate::elements::Element;
use crate::numbers::{Numbers, numbers, quotients};
use crate::subject::{Solved, Subject};
use crate::surroundings::Surroundings;

/// First step of the differences in 16 digits, in units of the coordinate, at a position of determinant 1. The smaller
/// the determinant, the faster the functions change; the step shrinks with it, down to a hundredth.
const FIRST_STEP: f64 = 0.2;

/// Least initial step, as part of the first step.
const LEAST_PART: f64 = 0.01;

/// With steps below this, differences in 16 digits have no correct digits.
const LEAST_STEP: f64 = 1e-7;

/// Where the rounding is measured around a position, in units of the coordinate: at the position itself, and on both
/// sides just outside the interpolation across a change point, whose innermost nodes have the greatest weight.
const PLACES: [f64; 3] = [0.0, 0.013, -0.013];

/// Differences by the calculated motion itself: across a change point it is smooth, and steps may be wide. `None` where too few of them can be solved on both sides.
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
        Some(numbers(linkage, all, scratch, &one.position))
    };
    let steps = [FIRST_STEP * one.health.max(LEAST_PART) * unit, LEAST_STEP * unit];
    let quotients = quotients(steps, LEVELS, |step| {
        // The step is rounded so that q + h and q - h are exact.
        let (low, high) = (q - step, q + step);
        Some(at(low)?.quotient(&at(high)?, 0.5 * (high - low)))
    })?;
    let values = numbers(linkage, all, &one.position, &one.position);
    let change_point = linkage.nearest_change_point(q).filter(|_| subject.is_interpolated(one));
    let interpolation = change_point.and_then(|at| linkage.interpolation(at));
    let gain = interpolation.map_or(1.0, |interpolation| interpolation.gain);
    let below = measured(&values, q, unit, &mut at).scaled(gain);
    Some(Surroundings { quotients, own: below.clone(), below, floor: gain, values })
}

/// The greatest rounding measured at closely spaced coordinates around a position.
fn measured(
    like: &Numbers<f64>,
    q: f64,
    unit: f64,
    at: &mut impl FnMut(f64) -> Option<Numbers<f64>>,
) -> Numbers<f64> {
    let mut most = like.scaled(0.0);
    for shift in PLACES {
        let middle = 0.5 * (SAMPLES as f64 - 1.0);
        let places = (0..SAMPLES).map(|i| q + (shift + SPACING * (i as f64 - middle)) * unit);
        let Some(run) = places.map(&mut *at).collect::<Option<Vec<_>>>() else { continue };
        let number = |k: usize| rounding_of(&std::array::from_fn(|i| run[i].0[k]));
        most.raise(&Numbers((0..like.0.len()).map(number).collect()));
    }
    most
}
