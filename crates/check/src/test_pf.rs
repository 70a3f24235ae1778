//! `TestPf` (S, stage 3): PF1 and PF2 of every element against numerical differentiation of PF0 and PF1, and the derivative of
//! the reduced inertia against differences of the reduced inertia.

use std::ops::ControlFlow;

use assur_group::Order;
use assur_kinematics::Position;

use crate::differences::{LEVELS, extrapolated};
use crate::elements::{Element, Motion, elements};
use crate::kinetics;
use crate::noise::{SAMPLES, SPACING, noise_of};
use crate::subject::{Solved, Subject};
use crate::worst::{Check, Worst};

/// First step of the differences, in units of the coordinate, at a position of determinant 1. Functions bend the faster, the
/// smaller the determinant is; the step shrinks with it, down to a hundredth.
const FIRST_STEP: f64 = 0.2;

/// Least part of the first step that is begun with.
const LEAST_PART: f64 = 0.01;

/// Steps below this leave no digits to differences; a position so close to the end of assembly is left out.
const LEAST_STEP: f64 = 1e-7;

/// Levels that an extrapolation needs.
const LEAST_LEVELS: usize = 4;

/// The estimates are right within a small factor: a deviation from a few samples, an extrapolation from its neighbors.
const SAFETY: f64 = 8.0;

/// Least rounding of any value, in units of the last place of its own size and of a typical one.
const FLOOR: f64 = 4.0;

/// Where the rounding is measured around a position, in units of the coordinate: at the place itself, and on both sides just
/// beyond the bridge across a change point, whose innermost nodes carry the most.
const PLACES: [f64; 3] = [0.0, 0.013, -0.013];

const REASON: &str = "against numerical differentiation of the order below; limit: 8 times the error estimate of the \
                      extrapolation with the rounding measured there";

/// Sum of the absolute weights of the interpolation across a change point (six nodes on each side, in its middle): by so much
/// it may magnify the rounding of its nodes.
const BRIDGE_GAIN: f64 = 3.5;

/// A function value for differences: elements of one order, two numbers each, and the reduced inertia.
struct Sample {
    motions: Vec<Motion>,
    inertia: f64,
}

/// Samples around one position.
struct Around {
    center: Sample,
    slope: f64,
    /// Step and the samples on both sides.
    pairs: Vec<(f64, [Sample; 2])>,
    /// Values for the measurement of rounding.
    close: Vec<Vec<Sample>>,
}

pub(crate) fn checks<B>(
    subject: &Subject<'_>,
    solved: &[Solved],
    step: &mut impl FnMut() -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Check>> {
    let mut worst =
        [Worst::new("TestPf PF1", REASON), Worst::new("TestPf PF2", REASON), Worst::new("TestPf J'", REASON)];
    let all = elements(subject.linkage);
    let heavy =
        subject.linkage.mechanism.links.iter().skip(1).any(|link| link.mass > 0.0 || link.inertia > 0.0);
    let mut scratch = subject.linkage.position();
    for one in solved {
        step()?;
        let Some(around) = sampled(subject, &all, one, &mut scratch) else {
            worst.iter_mut().for_each(Worst::leave_out);
            continue;
        };
        for (i, element) in all.iter().enumerate() {
            for order in [1, 2] {
                compare(subject, one, &around, (i, *element), order, &mut worst[order - 1]);
            }
        }
        if heavy {
            compare_inertia(subject, one, &around, &mut worst[2]);
        }
    }
    ControlFlow::Continue(worst.into_iter().filter_map(Worst::into_check).collect())
}

fn sample(subject: &Subject<'_>, all: &[Element], position: &Position, reference: &Position) -> Sample {
    let linkage = subject.linkage;
    let motions = all.iter().map(|element| element.motion(linkage, position, reference)).collect();
    Sample { motions, inertia: kinetics::reduced(&linkage.mechanism, &position.bodies)[0] }
}

/// Solves around a position; `None` where too few steps can be solved on both sides.
fn sampled(subject: &Subject<'_>, all: &[Element], one: &Solved, scratch: &mut Position) -> Option<Around> {
    let (q, unit) = (one.position.coordinate, subject.coordinate_unit());
    let mut at = |coordinate: f64| {
        subject.linkage.solve(coordinate, Order::Second, scratch).ok()?;
        Some(sample(subject, all, scratch, &one.position))
    };
    let (mut step, mut pairs) = (FIRST_STEP * one.health.max(LEAST_PART) * unit, Vec::new());
    while pairs.len() < LEVELS && step > LEAST_STEP * unit {
        // The step is made exact: q + h and q - h are the numbers that were meant.
        let (high, low) = (q + step, q - step);
        match (at(low), at(high)) {
            (Some(below), Some(above)) => pairs.push((0.5 * (high - low), [below, above])),
            _ => pairs.clear(),
        }
        step *= 0.5;
    }
    let run = |shift: f64, at: &mut dyn FnMut(f64) -> Option<Sample>| {
        let middle = 0.5 * (SAMPLES as f64 - 1.0);
        let places = (0..SAMPLES).map(|i| q + (shift + SPACING * (i as f64 - middle)) * unit);
        places.map(at).collect::<Option<Vec<_>>>()
    };
    let close = PLACES.iter().filter_map(|shift| run(*shift, &mut at)).collect();
    let slope = kinetics::reduced(&subject.linkage.mechanism, &one.position.bodies)[1];
    let center = sample(subject, all, &one.position, &one.position);
    (pairs.len() >= LEAST_LEVELS).then_some(Around { center, slope, pairs, close })
}

/// The greatest rounding measured around a position of a number of the samples.
fn measured(around: &Around, number: &dyn Fn(&Sample) -> f64) -> f64 {
    let mut most = 0.0_f64;
    for run in &around.close {
        let mut values = [0.0; SAMPLES];
        values.iter_mut().zip(run).for_each(|(value, sample)| *value = number(sample));
        most = most.max(noise_of(&values));
    }
    most
}

/// Deviation and limit of a derivative: `below` is the function, `value` what was calculated for its derivative.
fn deviation(around: &Around, below: &dyn Fn(&Sample) -> f64, value: f64, noises: [f64; 2]) -> [f64; 2] {
    let quotient =
        |(step, [low, high]): &(f64, [Sample; 2])| (*step, (below(high) - below(low)) / (2.0 * step));
    let quotients: Vec<_> = around.pairs.iter().map(quotient).collect();
    let estimate = extrapolated(&quotients, noises[0]);
    [(value - estimate.value).abs(), SAFETY * (estimate.error + noises[1])]
}

fn compare(
    subject: &Subject<'_>,
    one: &Solved,
    around: &Around,
    (i, element): (usize, Element),
    order: usize,
    worst: &mut Worst,
) {
    let unit = subject.unit(order, element.is_length());
    let below_unit = subject.unit(order - 1, element.is_length());
    let gain = if subject.is_bridged(one) { BRIDGE_GAIN } else { 1.0 };
    for k in 0..2 {
        let below = |sample: &Sample| sample.motions[i][order - 1][k];
        let own = |sample: &Sample| sample.motions[i][order][k];
        let value = own(&around.center);
        let floor = |number: f64, unit: f64| FLOOR * f64::EPSILON * (number.abs() + unit);
        let noises = [
            measured(around, &below).max(floor(below(&around.center), below_unit)),
            measured(around, &own).max(floor(value, unit)),
        ];
        let [off, limit] = deviation(around, &below, value, noises.map(|noise| gain * noise));
        worst.offer(one.index, off / unit, limit / unit, || element.name(subject.linkage));
    }
}

fn compare_inertia(subject: &Subject<'_>, one: &Solved, around: &Around, worst: &mut Worst) {
    let below = |sample: &Sample| sample.inertia;
    let size = around.center.inertia.abs();
    if size == 0.0 {
        return;
    }
    let unit = size / subject.coordinate_unit();
    // J' sums products of PF1 and PF2; its rounding is that of J by the unit of the coordinate, and its own size.
    let floor = FLOOR * f64::EPSILON;
    let noises =
        [measured(around, &below).max(floor * size), floor * (around.slope.abs() + unit) * one.condition];
    let [off, limit] = deviation(around, &below, around.slope, noises);
    worst.offer(one.index, off / unit, limit / unit, || "all links".to_owned());
}
